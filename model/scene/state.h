// Parsing of raster state for .tri lines and options; the words are in spec/raster_state.h.
#pragma once

#include <optional>
#include <string>

#include "model/spec/structs.h"

namespace pineda::scene {

/// Restricts drawing to a rectangle, which may reach beyond the frame on every side. Width and
/// height are not negative.
void set_scissor(int x_px, int y_px, int width_px, int height_px, spec::FrameState* frame);

/// Parses an integer number of depth codes, less than 2^depth_bits in magnitude.
std::optional<int64_t> parse_bias_constant(const char* word, int depth_bits);
std::string expected_bias_constant(int depth_bits);

/// The slope factor of a depth bias.
struct BiasSlope {
  int32_t units = 0;     // in units of 2^-8
  bool rounded = false;  // the given factor was no multiple of 2^-8
};

/// Parses a slope factor, -128 <= slope < 128, and rounds it to the nearest multiple of 2^-8 below
/// 128, halves to even.
std::optional<BiasSlope> parse_bias_slope(const char* word);
inline constexpr const char* kExpectedBiasSlope = "a slope factor from -128 to less than 128";

/// Parses a clear depth: a binary32 from 0 to 1, in any form that strtof reads.
std::optional<float> parse_clear_depth(const char* word);
inline constexpr const char* kExpectedClearDepth = "a clear depth from 0 to 1";

struct DepthBias {
  int64_t constant = 0;  // depth codes
  BiasSlope slope;
};

/// The parts of the state that differ from their defaults, except cull and depth function: "scissor
/// 1,2,30,40 px, shade flat". Empty if there are none. A scissor is shown clipped to the frame.
std::string unusual_state(const spec::FrameState& frame);

/// Does the scissor exclude samples of the frame?
inline bool is_cut(const spec::FrameState& frame) {
  return frame.clip_x0() > 0 || frame.clip_y0() > 0 || frame.clip_x1() < frame.width ||
         frame.clip_y1() < frame.height;
}

}  // namespace pineda::scene
