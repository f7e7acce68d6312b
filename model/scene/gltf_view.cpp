#include "model/scene/gltf_view.h"

#include <fmt/format.h>

#include <cstring>

#include "model/scene/error.h"

namespace pineda::scene {
namespace {

template <class Row>
const Row& element(const std::string& file, const std::vector<Row>& rows, int i, const char* name) {
  if (i < 0 || static_cast<size_t>(i) >= rows.size()) {
    throw InputError(file, fmt::format("{}[{}]: expected one of {}", name, i, rows.size()));
  }
  return rows[static_cast<size_t>(i)];
}

size_t component_bytes(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

template <class T>
T load(const unsigned char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

}  // namespace

GltfView::GltfView(const std::string& file, const tinygltf::Model& model, int accessor) {
  const auto& a = element(file, model.accessors, accessor, "accessors");
  const auto fail = [&](const std::string& what) {
    throw InputError(file, fmt::format("accessors[{}]: expected {}", accessor, what));
  };
  component_bytes_ = component_bytes(a.componentType);
  if (component_bytes_ == 0)
    fail(fmt::format("u8, u16, u32 or float, got type {}", a.componentType));
  if (a.sparse.isSparse || a.bufferView < 0) fail("a bufferView and no sparse storage");
  if (a.count == 0) fail("a count above 0");
  const auto& view = element(file, model.bufferViews, a.bufferView, "bufferViews");
  const auto& buffer = element(file, model.buffers, view.buffer, "buffers").data;
  if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset) {
    throw InputError(file,
                     fmt::format("bufferViews[{}]: expected bytes inside of the {} of buffer {}",
                                 a.bufferView, buffer.size(), view.buffer));
  }
  rows_ = a.count;
  columns_ = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(a.type));
  component_type_ = a.componentType;
  is_normalized_ = a.normalized;
  const size_t row_bytes = component_bytes_ * static_cast<size_t>(columns_);
  stride_bytes_ = view.byteStride != 0 ? view.byteStride : row_bytes;
  if (stride_bytes_ < row_bytes) fail(fmt::format("a stride of {} bytes or more", row_bytes));
  if (a.byteOffset > view.byteLength || row_bytes > view.byteLength - a.byteOffset ||
      (rows_ - 1) > (view.byteLength - a.byteOffset - row_bytes) / stride_bytes_) {
    fail(fmt::format("{} values inside of the {} bytes of bufferView {}", rows_, view.byteLength,
                     a.bufferView));
  }
  bytes_ = buffer.data() + view.byteOffset + a.byteOffset;
}

double GltfView::value(size_t row, int column) const {
  const unsigned char* at =
      bytes_ + row * stride_bytes_ + static_cast<size_t>(column) * component_bytes_;
  if (is_float()) return static_cast<double>(load<float>(at));
  double value = 0;
  double full_scale = 0;
  switch (component_bytes_) {
    case 1:
      value = *at, full_scale = 0xff;
      break;
    case 2:
      value = load<uint16_t>(at), full_scale = 0xffff;
      break;
    default:
      value = load<uint32_t>(at), full_scale = 0xffffffff;
      break;
  }
  return is_normalized_ ? value / full_scale : value;
}

uint32_t GltfView::index(size_t row) const { return static_cast<uint32_t>(value(row, 0)); }

}  // namespace pineda::scene
