// Reads one primitive of a glTF mesh as triangles in world space.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/scene/mesh.h"
#include "model/scene/readers/gltf/data.h"
#include "model/scene/readers/gltf/nodes.h"
#include "model/scene/readers/gltf/view.h"
#include "model/scene/readers/topology.h"

namespace pineda::scene {

/// How a primitive's corners make triangles; nothing for points and lines.
std::optional<Topology> topology_of(const GltfPrimitive& primitive);

/// Counts for messages about the whole file, made while its primitives are read.
struct GltfCounts {
  uint64_t textures = 0, morphs = 0;  // primitives that have them
  uint64_t clamped = 0;               // components of colours outside [0, 1]
  uint64_t normals = 0;               // normals that are no directions
  bool has_vertex_colors = false;
  bool has_base_colors = false;  // other than white
};

/// Errors   InputError with the place in the file: an index, an offset or a count out of range, a
///          wrong type, a number of corners that makes no whole triangles.
class GltfPrimitiveReader {
 public:
  GltfPrimitiveReader(GltfData* data, GltfCounts* counts);

  /// A primitive of triangles, and its name for messages.
  struct Place {
    const GltfPrimitive* primitive;
    std::string name;
  };

  struct Size {
    size_t triangles = 0;
    bool costs_bytes = true;  // their corners are stored in the file, not implied
  };
  /// Determines the size without reading any vertex.
  Size size(const Place& place) const;

  /// Reads the primitive. The mesh has each used vertex once, in the order of first use.
  Mesh read(const Place& place, const Affine& world);

 private:
  using Linear = std::array<double, 4>;  // a colour
  // Where the data of a primitive's vertices come from.
  struct Source {
    std::optional<GltfView> position, normal, color;
    Linear base;
  };

  [[noreturn]] void fail(const std::string& where, const std::string& expected) const;
  Source open(const Place& place);
  GltfView vectors(int accessor, const char* name) const;
  GltfView colors(int accessor) const;
  std::vector<uint32_t> read_corners(const GltfPrimitive& primitive, size_t vertices) const;
  Linear base_color(const std::optional<int>& material);
  Rgba read_color(const GltfView& view, size_t row, const Linear& base);

  GltfData* data_;
  GltfCounts* counts_;
  bool is_quantized_;  // KHR_mesh_quantization
};

}  // namespace pineda::scene
