// Writes pictures and frame dumps. A file is never left incomplete: it is written under a temporary
// name in the same folder and then renamed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pineda::scene {

/// A finished frame, row-major, top row first.
struct Frame {
  int width = 0;
  int height = 0;
  int attributes = 4;               // values a sample in `color`: r, g, b, a and more
  int attribute_bits = 8;           // of each value
  uint32_t clear_depth = 0xffffff;  // the code of a sample without depth
  std::vector<uint32_t> depth;
  std::vector<uint16_t> color;
  std::vector<uint16_t> hits;
};

/// Writes `bytes` to `path`, making the folder if it is missing.
/// Errors   InputError in one line when it cannot be written; nothing is left behind, and an older
///          file of that name stays as it was.
void write_file(const std::string& path, std::string_view bytes);

/// 8-bit red, green and blue of each pixel, row-major, top row first.
/// Errors   std::invalid_argument: `rgb` is not of that size.
void write_rgb_png(const std::string& path, int width, int height, const std::vector<uint8_t>& rgb);

/// 8-bit RGB; samples on which nothing was drawn are black. Channels that the design lacks are 0.
/// Alpha is left out: it is an attribute like the others, and nothing is blended.
void write_color_png(const std::string& path, const Frame& frame);

/// 8-bit grey: the nearest sample is 255, the farthest 40, linear between. The scale depends on the
/// depths that occur, so greys of two pictures cannot be compared. Samples at the clear depth are
/// black. The nearest code is the least one, or the greatest if depth is cleared to 0 (reversed z).
void write_depth_png(const std::string& path, const Frame& frame);

/// hits.u16, depth.u32 and color.rgba in `folder`, little-endian. Values of other than eight bits
/// are scaled to 8 bits; missing colours are 0, a missing alpha is 255. If `frame.hits` is empty
/// (they are not always known) hits.u16 is not written, and an existing one is removed.
void write_dump(const std::string& folder, const Frame& frame);

}  // namespace pineda::scene
