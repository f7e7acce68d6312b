#include "model/scene/readers/gltf/primitive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "model/scene/error.h"
#include "model/scene/readers/normals.h"

namespace pineda::scene {
namespace {

constexpr int kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6;

uint8_t srgb(double linear) {
  const double encoded =
      linear <= .0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - .055;
  return static_cast<uint8_t>(std::lround(encoded * 255));
}

Rgba rgba(const std::array<double, 4>& color) {
  return {srgb(color[0]), srgb(color[1]), srgb(color[2]),
          static_cast<uint8_t>(std::lround(color[3] * 255))};
}

Vec3 read_vector(const GltfView& view, size_t row) {
  return {view.value(row, 0), view.value(row, 1), view.value(row, 2)};
}

// Builds the mesh of one primitive, with vertices in the order of their first use.
class Builder {
 public:
  Builder(const GltfView& position, const std::optional<GltfView>& normal, const Affine& world)
      : position_(position), normal_(normal), world_(world) {}

  template <class Color>
  uint32_t vertex(uint32_t i, Color&& color) {
    const auto [at, is_new] = known_.try_emplace(i, static_cast<uint32_t>(known_.size()));
    if (is_new) {
      part_.position.push_back(world_.point(read_vector(position_, i)));
      if (normal_) add_normal(read_vector(*normal_, i));
      part_.color.push_back(color(i));
    }
    return at->second;
  }
  void add(const std::array<uint32_t, 3>& triangle) { part_.triangle.push_back(triangle); }
  void add_provoking(uint32_t vertex) { part_.provoking.push_back(vertex); }
  /// Adds the corner list of a strip or fan as the file states it; all corners were added before.
  void add_list(const std::vector<uint32_t>& corners, MeshPolygon::Kind kind, bool is_mirrored) {
    for (const uint32_t i : corners) part_.corner.push_back(known_.at(i));
    part_.polygon.push_back({0, static_cast<uint32_t>(corners.size()), 0,
                             static_cast<uint32_t>(part_.triangle.size()), kind, is_mirrored});
  }

  /// The finished mesh. Normals that the file lacks, or that are no directions, are computed; the
  /// latter are counted.
  Mesh finish(uint64_t* bad_normals) {
    *bad_normals += bad_normals_.size();
    if (normal_ && bad_normals_.empty()) return std::move(part_);
    const auto means = mean_normals(part_.position, part_.triangle);
    if (!normal_) part_.normal = means;
    for (const size_t i : bad_normals_) part_.normal[i] = means[i];
    return std::move(part_);
  }

 private:
  void add_normal(const Vec3& normal) {
    if (!is_direction(normal)) bad_normals_.push_back(part_.normal.size());
    part_.normal.push_back(world_.normal(normal));
  }

  const GltfView& position_;
  const std::optional<GltfView>& normal_;
  const Affine& world_;
  Mesh part_;
  std::unordered_map<uint32_t, uint32_t> known_;
  std::vector<size_t> bad_normals_;
};

}  // namespace

std::optional<Topology> topology_of(const GltfPrimitive& primitive) {
  switch (primitive.mode) {
    case kTriangles:
      return Topology::kTriangles;
    case kTriangleStrip:
      return Topology::kStrip;
    case kTriangleFan:
      return Topology::kFan;
    default:
      return {};
  }
}

GltfPrimitiveReader::GltfPrimitiveReader(GltfData* data, GltfCounts* counts)
    : data_(data), counts_(counts) {
  const auto& extensions = data->document().extensions;
  is_quantized_ =
      std::find(extensions.begin(), extensions.end(), "KHR_mesh_quantization") != extensions.end();
}

void GltfPrimitiveReader::fail(const std::string& where, const std::string& expected) const {
  throw InputError(data_->file(), fmt::format("{}: expected {}", where, expected));
}

GltfPrimitiveReader::Size GltfPrimitiveReader::size(const Place& place) const {
  const GltfPrimitive& primitive = *place.primitive;
  if (!primitive.position) fail(place.name, "an attribute POSITION");
  const GltfView corners(data_, primitive.indices.value_or(*primitive.position));
  return {triangle_count(*topology_of(primitive), corners.rows()), !corners.has_no_bytes()};
}

Mesh GltfPrimitiveReader::read(const Place& place, const Affine& world) {
  const GltfPrimitive& primitive = *place.primitive;
  const Topology topology = *topology_of(primitive);
  counts_->morphs += primitive.has_targets ? 1 : 0;
  const Source source = open(place);
  const auto corners = read_corners(primitive, source.position->rows());
  if (corners.size() < 3 || (topology == Topology::kTriangles && corners.size() % 3 != 0)) {
    fail(place.name, fmt::format("whole triangles, got {} corners", corners.size()));
  }
  Builder builder(*source.position, source.normal, world);
  const auto color = [&](uint32_t i) {
    return source.color ? read_color(*source.color, i, source.base) : rgba(source.base);
  };
  const bool is_mirrored = world.determinant() < 0;
  for (size_t i = 0; i < triangle_count(topology, corners.size()); ++i) {
    auto at = triangle_corners(topology, i);
    if (is_mirrored) std::swap(at[1], at[2]);
    std::array<uint32_t, 3> triangle;
    for (size_t k = 0; k < 3; ++k) triangle[k] = builder.vertex(corners[at[k]], color);
    builder.add(triangle);
    // By 3.7.2.1 the first vertex of a fan's triangle i is the one after the hub. Mirroring has
    // swapped it to place 2.
    if (topology == Topology::kFan) builder.add_provoking(triangle[is_mirrored ? 2 : 1]);
  }
  if (topology == Topology::kStrip) {
    builder.add_list(corners, MeshPolygon::Kind::kStrip, is_mirrored);
  } else if (topology == Topology::kFan) {
    builder.add_list(corners, MeshPolygon::Kind::kFan, is_mirrored);
  }
  return builder.finish(&counts_->normals);
}

GltfPrimitiveReader::Source GltfPrimitiveReader::open(const Place& place) {
  const GltfPrimitive& primitive = *place.primitive;
  Source source;
  source.position = vectors(*primitive.position, "POSITION");
  if (primitive.normal) source.normal = vectors(*primitive.normal, "NORMAL");
  if (primitive.color) source.color = colors(*primitive.color);
  if (primitive.is_draco && source.position->has_no_bytes()) {
    fail(place.name, "triangles beside those of KHR_draco_mesh_compression, got none");
  }
  for (const auto* other : {&source.normal, &source.color}) {
    if (*other && (*other)->rows() != source.position->rows()) {
      fail(place.name, fmt::format("as many values as POSITION has, {}, got {}",
                                   source.position->rows(), (*other)->rows()));
    }
  }
  counts_->has_vertex_colors = counts_->has_vertex_colors || source.color;
  source.base = base_color(primitive.material);
  return source;
}

GltfView GltfPrimitiveReader::vectors(int accessor, const char* name) const {
  const GltfView view(data_, accessor);
  const bool is_normal = std::string(name) == "NORMAL";
  const bool is_small = is_normal ? view.is_signed() && view.is_normalized()
                                  : !view.is_float() && view.type() != GltfType::kU32;
  if (view.columns() != 3 || !(view.is_float() || (is_quantized_ && is_small))) {
    const char* integers = is_normal ? "normalized i8 or i16" : "i8, u8, i16 or u16";
    fail(fmt::format("accessors[{}]", accessor),
         is_quantized_ ? fmt::format("{} as VEC3 of float, or {}", name, integers)
                       : fmt::format("{} as float VEC3", name));
  }
  return view;
}

GltfView GltfPrimitiveReader::colors(int accessor) const {
  const GltfView view(data_, accessor);
  const bool is_unit = view.is_float() || (view.is_normalized() && !view.is_signed());
  if ((view.columns() != 3 && view.columns() != 4) || !is_unit) {
    fail(fmt::format("accessors[{}]", accessor),
         "COLOR_0 as VEC3 or VEC4, float or normalized u8 or u16");
  }
  return view;
}

std::vector<uint32_t> GltfPrimitiveReader::read_corners(const GltfPrimitive& primitive,
                                                        size_t vertices) const {
  std::vector<uint32_t> corners;
  if (!primitive.indices) {
    for (size_t i = 0; i < vertices; ++i) corners.push_back(static_cast<uint32_t>(i));
    return corners;
  }
  const GltfView view(data_, *primitive.indices);
  const auto where = fmt::format("accessors[{}]", *primitive.indices);
  if (view.columns() != 1 || view.is_float() || view.is_signed() || view.is_normalized()) {
    fail(where, "indices as u8, u16 or u32 scalars");
  }
  corners.reserve(view.rows());
  for (size_t i = 0; i < view.rows(); ++i) {
    corners.push_back(view.index(i));
    if (corners.back() >= vertices) {
      fail(where, fmt::format("an index of {} vertices, got {}", vertices, corners.back()));
    }
  }
  return corners;
}

Rgba GltfPrimitiveReader::read_color(const GltfView& view, size_t row, const Linear& base) {
  Linear color = base;
  for (int k = 0; k < view.columns(); ++k) {
    const double stored = view.value(row, k);
    const double used = stored > 0 ? std::min(stored, 1.) : 0;  // 0 for a NaN
    if (!(stored == used)) ++counts_->clamped;
    color[static_cast<size_t>(k)] *= used;
  }
  return rgba(color);
}

GltfPrimitiveReader::Linear GltfPrimitiveReader::base_color(const std::optional<int>& material) {
  Linear base = {1, 1, 1, 1};
  if (!material) return base;
  const auto& materials = data_->document().materials;
  const auto where = fmt::format("materials[{}]", *material);
  if (static_cast<size_t>(*material) >= materials.size()) {
    fail(where, fmt::format("one of {}", materials.size()));
  }
  const GltfMaterial& used = materials[static_cast<size_t>(*material)];
  counts_->textures += used.has_texture ? 1 : 0;
  base = used.base_color;
  for (const double component : base) {
    if (!(component >= 0 && component <= 1)) fail(where, "a baseColorFactor from 0 to 1");
    counts_->has_base_colors = counts_->has_base_colors || component != 1;
  }
  return base;
}

}  // namespace pineda::scene
