// Where the samples of a frame lie in a memory of bytes.
#pragma once

#include <cstdint>

#include "model/spec/structs.h"

namespace pineda::memory {

/// A depth code: four bytes, little-endian.
inline constexpr int kDepthBytes = 4;

/// A sample's colour: its channels in order, each of one byte, or of two, little-endian, if it has
/// more than 8 bits. Without any channel one byte, 0xff where something was drawn.
constexpr int color_bytes(const spec::Design& d) {
  const int bytes = spec::channels(d) * (d.attribute_bits > 8 ? 2 : 1);
  return bytes > 0 ? bytes : 1;
}

/// Stamps lie in raster order, and the samples of a stamp by lane. So the stamp in column x, row y
/// is one contiguous burst at
///   base + (y * columns + x) * stamp_bytes
/// and its lane l lies l * sample_bytes after that. Stamps cut by the frame's border still take
/// their full size; their samples outside the frame are never read or written.
struct FrameLayout {
  int columns = 0, rows = 0;  // of the frame, in stamps
  int sample_bytes = 0;
  int stamp_bytes = 0;

  FrameLayout() = default;
  FrameLayout(const spec::Contract& c, const spec::FrameState& frame, int bytes)
      : columns(((frame.width - 1) >> c.design.stamp_width_log2) + 1),
        rows(((frame.height - 1) >> c.design.stamp_height_log2) + 1),
        sample_bytes(bytes),
        stamp_bytes(bytes * c.width.lanes) {}

  uint64_t bytes() const {
    return static_cast<uint64_t>(columns) * static_cast<uint64_t>(rows) *
           static_cast<uint64_t>(stamp_bytes);
  }
  /// Byte offset from the base of the stamp in column x, row y.
  uint64_t offset(int x, int y) const {
    return (static_cast<uint64_t>(y) * static_cast<uint64_t>(columns) + static_cast<uint64_t>(x)) *
           static_cast<uint64_t>(stamp_bytes);
  }
};

}  // namespace pineda::memory
