// A frame that some rasterizer drew, as --dump leaves it in a folder.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pineda::studies {

/// Of each sample, row by row from the top: how many triangles cover it, its depth code, and its red,
/// green, blue and alpha. What the rasterizer did not write is missing.
struct FrameDump {
  std::optional<std::vector<uint16_t>> hits;
  std::optional<std::vector<uint32_t>> depth;
  std::optional<std::vector<std::array<uint8_t, 4>>> color;
};

/// Reads those of hits.u16, depth.u32 and color.rgba that are in `folder`, little-endian.
///
/// Errors   scene::InputError: none of them is there, or one is not of this size.
FrameDump read_dump(const std::string& folder, int width, int height);

}  // namespace pineda::studies
