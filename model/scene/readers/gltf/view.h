// The values behind a glTF accessor.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "model/scene/readers/gltf/data.h"

namespace pineda::scene {

/// The values of an accessor: zeros if it has no bufferView; sparse values replace those of the
/// view.
///
/// Errors   InputError, "accessors[3]: ..." or "bufferViews[1]: ...": an index out of range, bytes
///          outside the view or the buffer, an unknown component type, no values, sparse indices
///          that do not increase or are out of range.
class GltfView {
 public:
  GltfView(GltfData* data, int accessor);

  size_t rows() const { return rows_; }
  int columns() const { return columns_; }  // 1: scalar, 3: VEC3, ...
  GltfType type() const { return type_; }
  bool is_float() const { return type_ == GltfType::kF32; }
  bool is_signed() const { return type_ == GltfType::kI8 || type_ == GltfType::kI16; }
  bool is_normalized() const { return is_normalized_; }
  /// True without a bufferView: the rows, all zero but for sparse values, take no bytes in the
  /// file.
  bool has_no_bytes() const { return bytes_ == nullptr; }

  /// A component as it is stored; normalized integers become 0 to 1 or -1 to 1.
  double value(size_t at, int column) const;
  /// The value of a row as an index; the type must be unsigned.
  uint32_t index(size_t row) const;

 private:
  struct Sparse {
    size_t count = 0;
    GltfType index_type = GltfType::kU8;
    const char* indices = nullptr;
    const char* values = nullptr;
    size_t row(size_t i) const;
  };

  void read_sparse(GltfData* data, const std::string& where, const GltfSparse& sparse,
                   bool is_first_use);
  const char* row(size_t row) const;  // nullptr: zeros

  size_t rows_ = 0;
  int columns_ = 0;
  GltfType type_ = GltfType::kF32;
  bool is_normalized_ = false;
  size_t component_bytes_ = 0;
  size_t stride_bytes_ = 0;
  const char* bytes_ = nullptr;
  std::optional<Sparse> sparse_;
};

}  // namespace pineda::scene
