// The parts of a glTF file that the reader uses, as C++ structs.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/scene/readers/gltf/json.h"

namespace pineda::scene {

enum class GltfType {  // component type, by its number in the file
  kI8 = 5120,
  kU8 = 5121,
  kI16 = 5122,
  kU16 = 5123,
  kU32 = 5125,
  kF32 = 5126
};

struct GltfSparse {
  size_t count = 0;
  int indices_view = 0, values_view = 0;
  size_t indices_offset = 0, values_offset = 0;
  int indices_type = 0;
};

struct GltfAccessor {
  std::optional<int> view;  // none: zeros
  size_t offset = 0, count = 0;
  int component_type = 0;
  int columns = 0;  // 1: SCALAR, 3: VEC3, ...; 0: unknown type
  bool is_normalized = false;
  std::optional<GltfSparse> sparse;
};

struct GltfBufferView {
  int buffer = 0;
  size_t offset = 0, bytes = 0, stride = 0;  // stride 0: values lie side by side
};

struct GltfBuffer {
  size_t bytes = 0;
  std::optional<std::string> uri;
};

struct GltfPrimitive {
  std::optional<int> position, normal, color, indices, material;
  int mode = 4;
  bool has_targets = false;
  bool is_draco = false;  // also has its triangles in KHR_draco_mesh_compression
};

struct GltfNode {
  std::vector<int> children;
  std::optional<int> mesh, camera;
  bool has_skin = false;
  bool is_visible = true;                                    // KHR_node_visibility
  std::vector<double> matrix, translation, rotation, scale;  // empty if not given
};

struct GltfMaterial {
  std::array<double, 4> base_color{1, 1, 1, 1};
  bool has_texture = false;
};

struct GltfCamera {
  bool is_orthographic = false;
  double yfov = 0;  // radians, the full angle
  double ymag = 0;  // half the height of an orthographic one's view
  double near = 0;
  std::optional<double> far;  // none: infinite
  std::string wrong;          // why it cannot be used, with its place; else empty
};

struct GltfDocument {
  std::optional<int> scene;
  std::vector<std::vector<int>> scenes;  // root nodes of each scene
  std::vector<GltfNode> nodes;
  std::vector<std::vector<GltfPrimitive>> meshes;
  std::vector<GltfAccessor> accessors;
  std::vector<GltfBufferView> views;
  std::vector<GltfBuffer> buffers;
  std::vector<GltfMaterial> materials;
  std::vector<GltfCamera> cameras;
  size_t animations = 0;
  std::vector<std::string> extensions;  // used or required, each once
};

/// In       the JSON of a glTF 2.0 file; its strings are moved from.
/// Out      indices of other parts are not checked. For an invalid camera GltfCamera::wrong is set.
/// Errors   InputError with the place: another version, a required extension that changes what is
///          drawn, or a property that the reader uses and that is of a wrong type.
GltfDocument read_document(const std::string& file, Json* json);

}  // namespace pineda::scene
