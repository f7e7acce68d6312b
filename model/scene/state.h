// Raster state as .tri lines and options say it; its words stand in spec/raster_state.h.
#pragma once

#include <optional>
#include <string>

#include "model/spec/structs.h"

namespace pineda::scene {

/// Samples of a rectangle alone; it may reach beyond the frame on every side. Width and height are
/// not negative.
void set_scissor(int x_px, int y_px, int width_px, int height_px, spec::FrameState* frame);

/// A whole number of depth codes, less than 2^depth_bits in magnitude.
std::optional<int64_t> parse_bias_constant(const char* word, int depth_bits);
std::string expected_bias_constant(int depth_bits);

/// The factor of a depth bias for the slope of a triangle.
struct BiasSlope {
  int32_t units = 0;     // 2^-8
  bool rounded = false;  // it was no multiple of 2^-8
};

/// -128 <= slope < 128, to the nearest multiple of 2^-8, halves to even; below 128 in the end.
std::optional<BiasSlope> parse_bias_slope(const char* word);
inline constexpr const char* kExpectedBiasSlope = "a slope factor from -128 to less than 128";

/// What depth is cleared to: a binary32 from 0 to 1, in any form that C's strtof reads.
std::optional<float> parse_clear_depth(const char* word);
inline constexpr const char* kExpectedClearDepth = "a clear depth from 0 to 1";

struct DepthBias {
  int64_t constant = 0;  // depth codes
  BiasSlope slope;
};

/// What of the state, beyond cull and depth function, is not as it is by default: "scissor
/// 1,2,30,40 px, shade flat". Empty if nothing is. A scissor is shown as the frame cuts it.
std::string unusual_state(const spec::FrameState& frame);

/// Does the scissor leave out samples of the frame?
inline bool is_cut(const spec::FrameState& frame) {
  return frame.clip_x0() > 0 || frame.clip_y0() > 0 || frame.clip_x1() < frame.width ||
         frame.clip_y1() < frame.height;
}

}  // namespace pineda::scene
