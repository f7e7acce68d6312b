// The values behind a glTF accessor.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <string>

namespace pineda::scene {

/// Errors   InputError, "accessors[3]: ..." or "bufferViews[1]: ...": an index out of range, bytes
///          outside of the view or the buffer, a component type that is not u8, u16, u32 or float,
///          sparse storage, no values.
class GltfView {
 public:
  GltfView(const std::string& file, const tinygltf::Model& model, int accessor);

  size_t rows() const { return rows_; }
  int columns() const { return columns_; }  // 1: scalar, 3: VEC3, ...
  bool is_float() const { return component_type_ == TINYGLTF_COMPONENT_TYPE_FLOAT; }
  bool is_normalized() const { return is_normalized_; }

  /// As it is stored; normalized integers as 0 to 1.
  double value(size_t row, int column) const;
  /// Of an unsigned type.
  uint32_t index(size_t row) const;

 private:
  size_t rows_ = 0;
  int columns_ = 0;
  int component_type_ = 0;
  bool is_normalized_ = false;
  size_t component_bytes_ = 0;
  size_t stride_bytes_ = 0;
  const unsigned char* bytes_ = nullptr;
};

}  // namespace pineda::scene
