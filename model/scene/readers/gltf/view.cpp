#include "model/scene/readers/gltf/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "model/scene/error.h"

namespace pineda::scene {
namespace {

template <class Row>
const Row& element(const std::string& file, const std::vector<Row>& rows, int i, const char* name) {
  if (static_cast<size_t>(i) >= rows.size()) {
    throw InputError(file, fmt::format("{}[{}]: expected one of {}", name, i, rows.size()));
  }
  return rows[static_cast<size_t>(i)];
}

size_t component_bytes(int type) {
  switch (static_cast<GltfType>(type)) {
    case GltfType::kI8:
    case GltfType::kU8:
      return 1;
    case GltfType::kI16:
    case GltfType::kU16:
      return 2;
    case GltfType::kU32:
    case GltfType::kF32:
      return 4;
  }
  return 0;
}

template <class T>
T load(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

double integer(GltfType type, const char* at) {
  switch (type) {
    case GltfType::kI8:
      return load<int8_t>(at);
    case GltfType::kU8:
      return load<uint8_t>(at);
    case GltfType::kI16:
      return load<int16_t>(at);
    case GltfType::kU16:
      return load<uint16_t>(at);
    default:
      return load<uint32_t>(at);
  }
}

double full_scale(GltfType type) {
  switch (type) {
    case GltfType::kI8:
      return 0x7f;
    case GltfType::kU8:
      return 0xff;
    case GltfType::kI16:
      return 0x7fff;
    case GltfType::kU16:
      return 0xffff;
    default:
      return 0xffffffff;
  }
}

// The layout of values in a buffer view.
struct Layout {
  std::string where;  // for a message: "accessors[3]"
  int view;
  size_t offset, rows, row_bytes;
  size_t stride = 0;  // bytes from row to row; 0: tightly packed
};

const char* bytes_of(GltfData* data, Layout* layout) {
  const std::string& file = data->file();
  const auto& view = element(file, data->document().views, layout->view, "bufferViews");
  const std::string_view buffer = data->buffer(view.buffer);
  if (view.offset > buffer.size() || view.bytes > buffer.size() - view.offset) {
    throw InputError(file,
                     fmt::format("bufferViews[{}]: expected bytes inside of the {} of buffer {}",
                                 layout->view, buffer.size(), view.buffer));
  }
  const size_t row_bytes = layout->row_bytes;
  layout->stride = view.stride != 0 ? view.stride : row_bytes;
  if (layout->stride < row_bytes) {
    throw InputError(
        file, fmt::format("{}: expected a stride of {} bytes or more", layout->where, row_bytes));
  }
  if (layout->offset > view.bytes || row_bytes > view.bytes - layout->offset ||
      (layout->rows - 1) > (view.bytes - layout->offset - row_bytes) / layout->stride) {
    throw InputError(file,
                     fmt::format("{}: expected {} values inside of the {} bytes of bufferView {}",
                                 layout->where, layout->rows, view.bytes, layout->view));
  }
  return buffer.data() + view.offset + layout->offset;
}

}  // namespace

GltfView::GltfView(GltfData* data, int accessor) {
  const std::string& file = data->file();
  const auto& a = element(file, data->document().accessors, accessor, "accessors");
  const std::string where = fmt::format("accessors[{}]", accessor);
  const auto fail = [&](const std::string& expected) {
    throw InputError(file, fmt::format("{}: expected {}", where, expected));
  };
  component_bytes_ = component_bytes(a.component_type);
  if (component_bytes_ == 0)
    fail(fmt::format("i8, u8, i16, u16, u32 or float, got type {}", a.component_type));
  if (a.columns == 0) fail("a type from SCALAR to MAT4");
  if (a.count == 0) fail("a count above 0");
  rows_ = a.count;
  columns_ = a.columns;
  type_ = static_cast<GltfType>(a.component_type);
  is_normalized_ = a.is_normalized;
  if (a.view) {
    Layout layout{where, *a.view, a.offset, rows_,
                  component_bytes_ * static_cast<size_t>(columns_)};
    bytes_ = bytes_of(data, &layout);
    stride_bytes_ = layout.stride;
  }
  if (a.sparse) {
    read_sparse(data, where, *a.sparse, data->is_first_use(static_cast<size_t>(accessor)));
  }
}

void GltfView::read_sparse(GltfData* data, const std::string& where, const GltfSparse& sparse,
                           bool is_first_use) {
  const auto fail = [&](const char* key, const std::string& expected) {
    throw InputError(data->file(), fmt::format("{}.sparse.{}: expected {}", where, key, expected));
  };
  if (sparse.count < 1 || sparse.count > rows_) {
    fail("count", fmt::format("1 to {}, got {}", rows_, sparse.count));
  }
  const auto type = static_cast<GltfType>(sparse.indices_type);
  if (type != GltfType::kU8 && type != GltfType::kU16 && type != GltfType::kU32) {
    fail("indices", fmt::format("u8, u16 or u32, got type {}", sparse.indices_type));
  }
  Layout indices{where + ".sparse.indices", sparse.indices_view, sparse.indices_offset,
                 sparse.count, component_bytes(sparse.indices_type)};
  Layout values{where + ".sparse.values", sparse.values_view, sparse.values_offset, sparse.count,
                component_bytes_ * static_cast<size_t>(columns_)};
  Sparse read{sparse.count, type, bytes_of(data, &indices), bytes_of(data, &values)};
  if (indices.stride != indices.row_bytes) fail("indices", "a bufferView without a stride");
  if (values.stride != values.row_bytes) fail("values", "a bufferView without a stride");
  for (size_t i = 0; is_first_use && i < read.count; ++i) {
    if (read.row(i) >= rows_) {
      fail("indices", fmt::format("indices of {} values, got {}", rows_, read.row(i)));
    }
    if (i > 0 && read.row(i) <= read.row(i - 1)) {
      fail("indices",
           fmt::format("indices that rise, got {} after {}", read.row(i), read.row(i - 1)));
    }
  }
  sparse_ = read;
}

size_t GltfView::Sparse::row(size_t i) const {
  const size_t bytes = component_bytes(static_cast<int>(index_type));
  return static_cast<size_t>(integer(index_type, indices + i * bytes));
}

const char* GltfView::row(size_t row) const {
  if (sparse_) {
    size_t first = 0, end = sparse_->count;  // binary search among the indices
    while (first < end) {
      const size_t middle = first + (end - first) / 2;
      const size_t found = sparse_->row(middle);
      if (found == row) {
        return sparse_->values + middle * component_bytes_ * static_cast<size_t>(columns_);
      }
      if (found < row) {
        first = middle + 1;
      } else {
        end = middle;
      }
    }
  }
  return bytes_ == nullptr ? nullptr : bytes_ + row * stride_bytes_;
}

double GltfView::value(size_t at, int column) const {
  const char* bytes = row(at);
  if (bytes == nullptr) return 0;
  bytes += static_cast<size_t>(column) * component_bytes_;
  if (is_float()) return static_cast<double>(load<float>(bytes));
  const double stored = integer(type_, bytes);
  return is_normalized_ ? std::max(stored / full_scale(type_), -1.) : stored;
}

uint32_t GltfView::index(size_t row) const { return static_cast<uint32_t>(value(row, 0)); }

}  // namespace pineda::scene
