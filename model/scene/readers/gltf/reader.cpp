#include "model/scene/readers/gltf/reader.h"

#include <fmt/format.h>

#include <utility>

#include "model/scene/error.h"
#include "model/scene/readers/gltf/data.h"
#include "model/scene/readers/gltf/extensions.h"
#include "model/scene/readers/gltf/nodes.h"
#include "model/scene/readers/gltf/primitive.h"
#include "model/scene/readers/lines.h"

namespace pineda::scene {
namespace {

constexpr size_t kGreatest = size_t{1} << 25;      // most triangles, and most primitives
constexpr size_t kGreatestZero = size_t{1} << 18;  // most triangles without bytes in the file

class Reader {
 public:
  Reader(const std::string& file, std::vector<std::string>* warnings)
      : file_(file), data_(file), primitives_(&data_, &counts_), warnings_(warnings) {}

  Mesh read() {
    const auto nodes = place_nodes(file_, data_.document());
    check_size(nodes);
    for (const PlacedNode& placed : nodes) {
      if (placed.node->camera) mesh_.camera.push_back(place_camera(data_.document(), placed));
      if (!placed.node->mesh) continue;
      hidden_ += placed.is_visible ? 0 : 1;
      skins_ += placed.is_visible && placed.node->has_skin ? 1 : 0;
      for_each_primitive(
          placed, [&](const Place& place) { append(primitives_.read(place, placed.world)); });
    }
    if (mesh_.triangle.empty()) {
      throw InputError(file_, "expected triangles, got none" +
                                  std::string(others_ > 0 ? " but points or lines" : ""));
    }
    if (!counts_.has_vertex_colors && !counts_.has_base_colors) mesh_.color.clear();
    mesh_.is_lit = !mesh_.color.empty() && !counts_.has_vertex_colors;
    warn();
    return std::move(mesh_);
  }

 private:
  using Place = GltfPrimitiveReader::Place;

  // The primitives of a node; nullptr if it has no mesh or is not visible.
  const std::vector<GltfPrimitive>* primitives_of(const PlacedNode& placed) const {
    if (!placed.node->mesh || !placed.is_visible) return nullptr;
    const auto at = static_cast<size_t>(*placed.node->mesh);
    const auto& meshes = data_.document().meshes;
    if (at >= meshes.size()) {
      throw InputError(file_, fmt::format("meshes[{}]: expected one of {}", at, meshes.size()));
    }
    return &meshes[at];
  }

  // Visits the primitives of a node that consist of triangles.
  template <class Visit>
  void for_each_primitive(const PlacedNode& placed, Visit&& visit) {
    const auto* primitives = primitives_of(placed);
    if (primitives == nullptr) return;
    for (size_t i = 0; i < primitives->size(); ++i) {
      const GltfPrimitive& primitive = (*primitives)[i];
      if (!topology_of(primitive)) continue;
      visit(Place{&primitive, fmt::format("meshes[{}].primitives[{}]", *placed.node->mesh, i)});
    }
  }

  // Checks the size before any triangle is made, since a few bytes can ask for billions of
  // triangles.
  void check_size(const std::vector<PlacedNode>& nodes) {
    size_t primitives = 0, triangles = 0, zero = 0;
    for (const PlacedNode& placed : nodes) {
      const auto* all = primitives_of(placed);
      if (all == nullptr) continue;
      primitives += all->size();
      if (primitives > kGreatest) {
        throw InputError(file_, fmt::format("expected at most {} primitives", kGreatest));
      }
      count_others(*all);
      for_each_primitive(placed, [&](const Place& place) {
        const auto size = primitives_.size(place);
        triangles += size.triangles;
        zero += size.costs_bytes ? 0 : size.triangles;
        if (triangles > kGreatest) {
          throw InputError(file_, fmt::format("expected at most {} triangles", kGreatest));
        }
        if (zero > kGreatestZero) {
          throw InputError(
              file_, fmt::format("expected at most {} triangles of accessors without a bufferView",
                                 kGreatestZero));
        }
      });
    }
  }

  void count_others(const std::vector<GltfPrimitive>& primitives) {
    for (const auto& primitive : primitives) {
      others_ += topology_of(primitive) ? 0 : 1;
    }
  }

  void append(const Mesh& part) {
    const auto first = static_cast<uint32_t>(mesh_.position.size());
    const auto add = [](const auto& from, auto* to) {
      to->insert(to->end(), from.begin(), from.end());
    };
    add(part.position, &mesh_.position);
    add(part.normal, &mesh_.normal);
    add(part.color, &mesh_.color);
    append_provoking(part, first);
    for (MeshPolygon list : part.polygon) {
      list.first_corner += static_cast<uint32_t>(mesh_.corner.size());
      list.first_triangle += static_cast<uint32_t>(mesh_.triangle.size());
      mesh_.polygon.push_back(list);
    }
    for (const uint32_t corner : part.corner) mesh_.corner.push_back(first + corner);
    for (const auto& t : part.triangle) {
      mesh_.triangle.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }

  // Appends the provoking vertices. The list stays empty as long as all are first corners.
  void append_provoking(const Mesh& part, uint32_t first) {
    if (part.provoking.empty() && mesh_.provoking.empty()) return;
    if (mesh_.provoking.empty()) {
      for (const auto& t : mesh_.triangle) mesh_.provoking.push_back(t[0]);
    }
    for (size_t i = 0; i < part.triangle.size(); ++i) {
      const uint32_t vertex = part.provoking.empty() ? part.triangle[i][0] : part.provoking[i];
      mesh_.provoking.push_back(first + vertex);
    }
  }

  void warn() const {
    const auto count = [&](uint64_t n, const char* text) {
      if (n > 0) warnings_->push_back(fmt::format("{}: {} {}", file_, n, text));
    };
    const GltfDocument& document = data_.document();
    count(others_, "primitives left out: points or lines");
    count(hidden_, "nodes with a mesh left out: hidden by KHR_node_visibility");
    count(counts_.textures, "primitives without their base colour's texture");
    count(skins_, "nodes with a skin, drawn as modelled");
    count(counts_.morphs, "primitives with morph targets, drawn as modelled");
    count(document.animations, "animations not used");
    count(counts_.clamped, "components of colours outside of 0 to 1, clamped");
    count(counts_.normals, "normals that are no directions, made from the triangles around");
    if (document.scenes.size() > 1) count(document.scenes.size() - 1, "further scenes left out");
    for (const auto& name : document.extensions) {
      const GltfExtension extension = gltf_extension(name);
      if (extension.effect == GltfEffect::kRead) continue;
      warnings_->push_back(
          fmt::format("{}: extension {} not used ({})", file_, quoted(name), extension.reason));
    }
  }

  std::string file_;
  GltfData data_;
  GltfCounts counts_;
  GltfPrimitiveReader primitives_;
  std::vector<std::string>* warnings_;
  Mesh mesh_;
  uint64_t others_ = 0;              // primitives of points or lines
  uint64_t hidden_ = 0, skins_ = 0;  // nodes that are hidden, that have a skin
};

}  // namespace

Mesh read_gltf(const std::string& file, std::vector<std::string>* warnings) {
  return Reader(file, warnings).read();
}

}  // namespace pineda::scene
