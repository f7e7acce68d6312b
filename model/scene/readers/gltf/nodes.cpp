#include "model/scene/readers/gltf/nodes.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/scene/error.h"

namespace pineda::scene {
namespace {

// Converts a column-major matrix; false if it is not affine, which its last row tells.
bool from_matrix(const std::vector<double>& m, Affine* local) {
  for (size_t row = 0; row < 3; ++row) {
    for (size_t column = 0; column < 3; ++column) local->linear[row][column] = m[4 * column + row];
    local->offset[row] = m[12 + row];
  }
  return m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1;
}

bool from_quaternion(const std::vector<double>& q, std::array<Vec3, 3>* rows) {
  const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  if (!(square > 0) || !std::isfinite(square)) return false;
  const double x = q[0], y = q[1], z = q[2], w = q[3], s = 2 / square;
  *rows = {{{1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)},
            {s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)},
            {s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)}}};
  return true;
}

class Graph {
 public:
  Graph(const std::string& file, const GltfDocument& document)
      : file_(file), document_(document), is_seen_(document.nodes.size()) {}

  std::vector<PlacedNode> place() {
    // An explicit stack instead of recursion, since node chains may be very long.
    struct Waiting {
      int node;
      Affine parent;
      bool is_visible;
    };
    std::vector<Waiting> waiting;
    const auto add = [&](const std::vector<int>& nodes, const Affine& parent, bool is_visible) {
      for (auto i = nodes.rbegin(); i != nodes.rend(); ++i) {
        waiting.push_back({*i, parent, is_visible});
      }
    };
    add(roots(), Affine{}, true);
    std::vector<PlacedNode> all;
    while (!waiting.empty()) {
      const Waiting next = waiting.back();
      waiting.pop_back();
      const auto& node = visit(next.node);
      all.push_back({static_cast<size_t>(next.node), &node, next.parent * local(next.node, node),
                     next.is_visible && node.is_visible});
      add(node.children, all.back().world, all.back().is_visible);
    }
    return all;
  }

 private:
  [[noreturn]] void fail(int node, const std::string& expected) const {
    throw InputError(file_, fmt::format("nodes[{}]: expected {}", node, expected));
  }

  const GltfNode& visit(int i) {
    const auto at = static_cast<size_t>(i);
    if (at >= is_seen_.size()) fail(i, fmt::format("one of {} nodes", is_seen_.size()));
    if (is_seen_[at]) fail(i, "a tree, got a node that is reached twice");
    is_seen_[at] = true;
    return document_.nodes[at];
  }

  std::vector<int> roots() const {
    const auto& scenes = document_.scenes;
    if (!scenes.empty()) {
      const auto at = static_cast<size_t>(document_.scene.value_or(0));
      if (at < scenes.size()) return scenes[at];
      throw InputError(file_, fmt::format("scene: expected one of {}, got {}", scenes.size(), at));
    }
    std::vector<bool> is_child(is_seen_.size());
    for (const auto& node : document_.nodes) {
      for (const int child : node.children) {
        const auto at = static_cast<size_t>(child);
        if (at < is_child.size()) is_child[at] = true;
      }
    }
    std::vector<int> all;
    for (size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i]) all.push_back(static_cast<int>(i));
    }
    return all;
  }

  Affine local(int i, const GltfNode& node) const {
    Affine result;
    if (!node.matrix.empty()) {
      if (!from_matrix(node.matrix, &result)) fail(i, "an affine matrix, its last row 0 0 0 1");
      return result;
    }
    if (!node.rotation.empty() && !from_quaternion(node.rotation, &result.linear)) {
      fail(i, "a rotation of length 1");
    }
    for (Vec3& row : result.linear) {
      for (size_t k = 0; k < node.scale.size(); ++k) row[k] *= node.scale[k];
    }
    std::copy(node.translation.begin(), node.translation.end(), result.offset.begin());
    return result;
  }

  const std::string& file_;
  const GltfDocument& document_;
  std::vector<bool> is_seen_;
};

}  // namespace

Vec3 Affine::point(const Vec3& p) const {
  return Vec3{dot(linear[0], p), dot(linear[1], p), dot(linear[2], p)} + offset;
}

Vec3 Affine::normal(const Vec3& n) const {
  // The cofactor matrix is the inverse transposed matrix times the determinant.
  const Vec3 turned = {dot(cross(linear[1], linear[2]), n), dot(cross(linear[2], linear[0]), n),
                       dot(cross(linear[0], linear[1]), n)};
  return normalized(determinant() < 0 ? -1 * turned : turned);
}

double Affine::determinant() const { return dot(linear[0], cross(linear[1], linear[2])); }

Affine operator*(const Affine& a, const Affine& b) {
  Affine c;
  for (size_t row = 0; row < 3; ++row) {
    const Vec3& r = a.linear[row];
    c.linear[row] = r[0] * b.linear[0] + r[1] * b.linear[1] + r[2] * b.linear[2];
  }
  c.offset = a.point(b.offset);
  return c;
}

std::vector<PlacedNode> place_nodes(const std::string& file, const GltfDocument& document) {
  return Graph(file, document).place();
}

FileCamera place_camera(const GltfDocument& document, const PlacedNode& placed) {
  FileCamera camera;
  const auto at = static_cast<size_t>(*placed.node->camera);
  if (at >= document.cameras.size()) {
    camera.wrong = fmt::format("cameras[{}]: expected one of {}", at, document.cameras.size());
    return camera;
  }
  const GltfCamera& lens = document.cameras[at];
  camera.is_orthographic = lens.is_orthographic;
  camera.yfov = lens.yfov;
  camera.ymag = lens.ymag;
  camera.near = lens.near;
  camera.far = lens.far;
  camera.wrong = lens.wrong;
  const auto& rows = placed.world.linear;
  camera.eye = placed.world.offset;
  camera.back = normalized({rows[0][2], rows[1][2], rows[2][2]});
  camera.right = normalized(cross(normalized({rows[0][1], rows[1][1], rows[2][1]}), camera.back));
  camera.up = cross(camera.back, camera.right);
  const bool stands = scene::is_finite(camera.eye) && length(camera.back) > .5 &&
                      length(camera.right) > .5 && length(camera.up) > .5;
  if (!stands && camera.wrong.empty()) {
    camera.wrong = fmt::format(
        "nodes[{}]: expected a transform that keeps a camera's -Z and +Y apart, got a singular one",
        placed.index);
  }
  return camera;
}

}  // namespace pineda::scene
