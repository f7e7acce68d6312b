#include "model/scene/gltf_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <unordered_map>
#include <utility>

#include "model/scene/error.h"
#include "model/scene/gltf_file.h"
#include "model/scene/gltf_nodes.h"
#include "model/scene/gltf_view.h"
#include "model/scene/lines.h"
#include "model/scene/normals.h"
#include "model/scene/topology.h"

namespace pineda::scene {
namespace {

constexpr size_t kGreatest = size_t{1} << 25;  // triangles, and primitives

uint8_t srgb(double linear) {
  const double encoded =
      linear <= .0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - .055;
  return static_cast<uint8_t>(std::lround(encoded * 255));
}

using Linear = std::array<double, 4>;  // a colour

// What is said of the whole file, counted while it is read.
struct Unused {
  uint64_t other_modes = 0, textures = 0, cameras = 0, skins = 0, morphs = 0, clamped = 0;
};

class Reader {
 public:
  Reader(const std::string& file, std::vector<std::string>* warnings)
      : file_(file), model_(load_gltf(file)), warnings_(warnings) {}

  Mesh read() {
    const auto nodes = place_nodes(file_, model_);
    check_size(nodes);
    for (const PlacedNode& placed : nodes) {
      unused_.cameras += placed.node->camera >= 0 ? 1 : 0;
      unused_.skins += placed.node->skin >= 0 ? 1 : 0;
      for_each_primitive(*placed.node, [&](const auto& p) { add_primitive(p, placed.world); });
    }
    if (mesh_.triangle.empty()) throw InputError(file_, "expected triangles, got none");
    if (!has_vertex_colors_ && !has_base_colors_) mesh_.color.clear();
    mesh_.is_lit = !mesh_.color.empty() && !has_vertex_colors_;
    warn();
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& where, const std::string& expected) const {
    throw InputError(file_, fmt::format("{}: expected {}", where, expected));
  }

  template <class Visit>
  void for_each_primitive(const tinygltf::Node& node, Visit&& visit) {
    if (node.mesh < 0) return;
    const auto at = static_cast<size_t>(node.mesh);
    if (at >= model_.meshes.size()) {
      fail(fmt::format("meshes[{}]", at), fmt::format("one of {}", model_.meshes.size()));
    }
    const auto& primitives = model_.meshes[at].primitives;
    for (size_t i = 0; i < primitives.size(); ++i) {
      where_ = fmt::format("meshes[{}].primitives[{}]", at, i);
      visit(primitives[i]);
    }
  }

  // Before the first triangle is made, since a few bytes can ask for billions.
  void check_size(const std::vector<PlacedNode>& nodes) {
    size_t primitives = 0, triangles = 0;
    for (const PlacedNode& placed : nodes) {
      for_each_primitive(*placed.node, [&](const tinygltf::Primitive& primitive) {
        triangles += triangle_count_of(primitive);
        if (++primitives > kGreatest || triangles > kGreatest) {
          throw InputError(file_, fmt::format("expected at most {} triangles", kGreatest));
        }
      });
    }
  }

  size_t triangle_count_of(const tinygltf::Primitive& primitive) const {
    const auto topology = topology_of(primitive);
    if (!topology) return 0;
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) fail(where_, "an attribute POSITION");
    const int corners = primitive.indices < 0 ? position->second : primitive.indices;
    return triangle_count(*topology, GltfView(file_, model_, corners).rows());
  }

  // None for points and lines.
  std::optional<Topology> topology_of(const tinygltf::Primitive& primitive) const {
    switch (primitive.mode) {
      case -1:  // not given
      case TINYGLTF_MODE_TRIANGLES:
        return Topology::kTriangles;
      case TINYGLTF_MODE_TRIANGLE_STRIP:
        return Topology::kStrip;
      case TINYGLTF_MODE_TRIANGLE_FAN:
        return Topology::kFan;
      default:
        break;
    }
    if (primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) fail(where_ + ".mode", "0 to 6");
    return {};
  }

  void add_primitive(const tinygltf::Primitive& primitive, const Affine& world) {
    const auto topology = topology_of(primitive);
    if (!topology) {
      ++unused_.other_modes;
      return;
    }
    unused_.morphs += primitive.targets.empty() ? 0 : 1;
    const Source source = open(primitive);
    const auto corners = read_corners(primitive, source.position->rows());
    check_count(*topology, corners.size());
    append(build(source, *topology, corners, world));
  }

  // What a primitive's vertices are made of.
  struct Source {
    std::optional<GltfView> position, normal, color;
    Linear base;
  };

  Source open(const tinygltf::Primitive& primitive) {
    Source source;
    source.position = attribute(primitive, "POSITION");
    source.normal = attribute(primitive, "NORMAL");
    source.color = attribute(primitive, "COLOR_0");
    for (const auto* other : {&source.normal, &source.color}) {
      if (*other && (*other)->rows() != source.position->rows()) {
        fail(where_, fmt::format("as many values as POSITION has, {}, got {}",
                                 source.position->rows(), (*other)->rows()));
      }
    }
    has_vertex_colors_ = has_vertex_colors_ || source.color;
    source.base = base_color(primitive.material);
    return source;
  }

  Mesh build(const Source& source, Topology topology, const std::vector<uint32_t>& corners,
             const Affine& world) {
    Mesh part;
    std::unordered_map<uint32_t, uint32_t> known;  // only what is used is kept
    const auto vertex = [&](uint32_t i) {
      const auto [at, is_new] = known.try_emplace(i, static_cast<uint32_t>(known.size()));
      if (is_new) {
        part.position.push_back(world.point(read_vector(*source.position, i)));
        if (source.normal) part.normal.push_back(world.normal(read_vector(*source.normal, i)));
        part.color.push_back(source.color ? read_color(*source.color, i, source.base)
                                          : rgba(source.base));
      }
      return at->second;
    };
    const bool is_mirrored = world.determinant() < 0;
    for (size_t i = 0; i < triangle_count(topology, corners.size()); ++i) {
      auto at = triangle_corners(topology, i);
      if (is_mirrored) std::swap(at[1], at[2]);
      std::array<uint32_t, 3> triangle;
      for (size_t k = 0; k < 3; ++k) triangle[k] = vertex(corners[at[k]]);
      part.triangle.push_back(triangle);
    }
    if (!source.normal) part.normal = mean_normals(part.position, part.triangle);
    return part;
  }

  void check_count(Topology topology, size_t corners) const {
    if (corners < 3 || (topology == Topology::kTriangles && corners % 3 != 0)) {
      fail(where_, fmt::format("whole triangles, got {} corners", corners));
    }
  }

  std::optional<GltfView> attribute(const tinygltf::Primitive& primitive, const char* name) const {
    const auto at = primitive.attributes.find(name);
    if (at == primitive.attributes.end()) return {};
    const GltfView view(file_, model_, at->second);
    const bool is_color = std::strcmp(name, "COLOR_0") == 0;
    const bool fits = is_color ? (view.columns() == 3 || view.columns() == 4) &&
                                     (view.is_float() || view.is_normalized())
                               : view.columns() == 3 && view.is_float();
    if (!fits) {
      fail(fmt::format("accessors[{}]", at->second),
           is_color ? "COLOR_0 as VEC3 or VEC4, float or normalized"
                    : fmt::format("{} as float VEC3", name));
    }
    return view;
  }

  std::vector<uint32_t> read_corners(const tinygltf::Primitive& primitive, size_t vertices) const {
    std::vector<uint32_t> corners;
    if (primitive.indices < 0) {
      for (size_t i = 0; i < vertices; ++i) corners.push_back(static_cast<uint32_t>(i));
      return corners;
    }
    const GltfView view(file_, model_, primitive.indices);
    const auto where = fmt::format("accessors[{}]", primitive.indices);
    if (view.columns() != 1 || view.is_float() || view.is_normalized()) {
      fail(where, "indices as u8, u16 or u32 scalars");
    }
    for (size_t i = 0; i < view.rows(); ++i) {
      corners.push_back(view.index(i));
      if (corners.back() >= vertices) {
        fail(where, fmt::format("an index of {} vertices, got {}", vertices, corners.back()));
      }
    }
    return corners;
  }

  static Vec3 read_vector(const GltfView& view, size_t row) {
    return {view.value(row, 0), view.value(row, 1), view.value(row, 2)};
  }

  Rgba read_color(const GltfView& view, size_t row, const Linear& base) {
    Linear color = base;
    for (int k = 0; k < view.columns(); ++k) {
      const double stored = view.value(row, k);
      const double used = stored > 0 ? std::min(stored, 1.) : 0;  // 0 for a NaN
      if (!(stored == used)) ++unused_.clamped;
      color[static_cast<size_t>(k)] *= used;
    }
    return rgba(color);
  }

  static Rgba rgba(const Linear& color) {
    return {srgb(color[0]), srgb(color[1]), srgb(color[2]),
            static_cast<uint8_t>(std::lround(color[3] * 255))};
  }

  Linear base_color(int material) {
    Linear base = {1, 1, 1, 1};
    if (material < 0) return base;
    const auto where = fmt::format("materials[{}]", material);
    if (static_cast<size_t>(material) >= model_.materials.size()) {
      fail(where, fmt::format("one of {}", model_.materials.size()));
    }
    const auto& pbr = model_.materials[static_cast<size_t>(material)].pbrMetallicRoughness;
    unused_.textures += pbr.baseColorTexture.index >= 0 ? 1 : 0;
    for (size_t k = 0; k < base.size(); ++k) {
      base[k] = pbr.baseColorFactor[k];
      if (!(base[k] >= 0 && base[k] <= 1)) fail(where, "a baseColorFactor from 0 to 1");
      has_base_colors_ = has_base_colors_ || base[k] != 1;
    }
    return base;
  }

  void append(const Mesh& part) {
    const auto first = static_cast<uint32_t>(mesh_.position.size());
    const auto add = [](const auto& from, auto* to) {
      to->insert(to->end(), from.begin(), from.end());
    };
    add(part.position, &mesh_.position);
    add(part.normal, &mesh_.normal);
    add(part.color, &mesh_.color);
    for (const auto& t : part.triangle) {
      mesh_.triangle.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }

  void warn() const {
    const auto count = [&](uint64_t n, const char* text) {
      if (n > 0) warnings_->push_back(fmt::format("{}: {} {}", file_, n, text));
    };
    count(unused_.other_modes, "primitives left out: points or lines");
    count(unused_.textures, "primitives without their base colour's texture");
    count(unused_.cameras, "cameras not used");
    count(unused_.skins, "nodes with a skin, drawn as modelled");
    count(unused_.morphs, "primitives with morph targets, drawn as modelled");
    count(model_.animations.size(), "animations not used");
    count(unused_.clamped, "components of colours outside of 0 to 1, clamped");
    if (model_.scenes.size() > 1) count(model_.scenes.size() - 1, "further scenes left out");
    for (const auto& name : model_.extensionsUsed) {
      warnings_->push_back(fmt::format("{}: extension {} not used", file_, quoted(name)));
    }
  }

  std::string file_;
  tinygltf::Model model_;
  std::vector<std::string>* warnings_;
  Mesh mesh_;
  std::string where_;  // the primitive that is read
  bool has_vertex_colors_ = false;
  bool has_base_colors_ = false;  // other than white
  Unused unused_;
};

}  // namespace

Mesh read_gltf(const std::string& file, std::vector<std::string>* warnings) {
  return Reader(file, warnings).read();
}

}  // namespace pineda::scene
