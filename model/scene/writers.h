// Pictures and frame dumps. Each file is complete or absent: it is written beside its place under
// another name and then renamed.
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

/// 8-bit RGB; what nothing was drawn on is black. Channels that the design lacks are 0, and alpha,
/// which is an attribute like the others and blends nothing, is left out.
void write_color_png(const std::string& path, const Frame& frame);

/// 8-bit grey, the nearest sample 255, the farthest 40, evenly between: the contrast is that of the
/// depths that occur, so codes of two pictures cannot be compared. Cleared samples are black. The
/// nearest has the least code; where depth is cleared to 0 (reversed z) it has the greatest.
void write_depth_png(const std::string& path, const Frame& frame);

/// hits.u16, depth.u32 and color.rgba in `folder`, little-endian. Values of other than eight bits
/// are scaled to 8 bits; missing colours are 0, a missing alpha is 255. With no hits in the frame
/// (a design may not know them) hits.u16 is left out, and an older one removed.
void write_dump(const std::string& folder, const Frame& frame);

}  // namespace pineda::scene
