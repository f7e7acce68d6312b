// The arithmetic of Mesa 22.3's llvmpipe, step by step in the same binary32: what it makes of a triangle
// between clip space and the frame. For explain_llvmpipe, which compares it with what Mesa draws.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "examples/llvmpipe/clip_space.h"

namespace pineda::llvmpipe {

/// As long as it lives, denormal numbers are zero, as they are in llvmpipe's threads. On x86 alone.
class DenormalsAreZero {
 public:
  DenormalsAreZero();
  ~DenormalsAreZero();
  DenormalsAreZero(const DenormalsAreZero&) = delete;
  DenormalsAreZero& operator=(const DenormalsAreZero&) = delete;

 private:
  unsigned before_ = 0;  // the control word
};

/// A corner of what is drawn.
struct Corner {
  std::array<float, 4> clip;    // position in clip space
  std::array<float, 4> window;  // x, y in px, z from 0 to 1, 1/w
  std::array<float, 4> rgba;    // 0 to 1
};

/// A triangle that lies within the frame: a whole one, or one of the fan that clipping leaves.
using Piece = std::array<Corner, 3>;

/// The pieces of a triangle. There is no guard band: what reaches out of the frame is clipped at its
/// borders, plane by plane, in binary32.
///
/// Bits     a corner on a border is a + t*(b - a) in clip space, with a the corner nearer to the border
///          and t its share of both distances; it is then divided and taken to the window without fused
///          steps, which the vertex shader has.
std::vector<Piece> pieces_of(const std::array<Vertex, 3>& triangle, const spec::FrameState& frame);

/// A linear function of the sample: value at the sample of pixel (0, 0), and its steps.
struct FloatPlane {
  float origin, dx, dy;

  float at(int x, int y) const;
};

/// A piece that is ready to be drawn.
///
/// Bits     positions are snapped to 1/256 px, to nearest even, so coverage is exact from there on.
///          Values are planes through unsnapped positions: steps from differences to the first corner,
///          and a value at pixel (0, 0) that may lie far outside of the range, however far the piece is
///          from there.
class Drawable {
 public:
  Drawable(const Piece& piece, const spec::FrameState& frame);

  bool is_drawn() const { return is_drawn_; }  // neither of zero area nor culled
  bool covers(int x, int y) const;
  /// How far the sample is inside of the piece, negative outside.
  double inside_px(int x, int y) const;
  /// Pixels that may be covered: first and last column and row, within frame and scissor.
  const std::array<int, 4>& box() const { return box_; }
  uint32_t depth(int x, int y) const;
  std::array<uint8_t, 4> color(int x, int y) const;
  const FloatPlane& z() const { return z_; }

 private:
  int64_t inside(size_t corner, int x, int y) const;

  bool is_drawn_ = false;
  bool is_flat_;
  std::array<int64_t, 3> x_{},
      y_{};  // of the corners, clockwise on the screen, from the first sample
  std::array<int, 4> box_{};
  FloatPlane z_{}, inverse_w_{};
  std::array<FloatPlane, 4> rgba_{};
  float offset_ = 0;  // of the depth
};

}  // namespace pineda::llvmpipe
