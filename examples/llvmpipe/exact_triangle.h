// A snapped triangle in exact arithmetic, for explain_llvmpipe.
#pragma once

#include <array>
#include <cstdint>

#include "model/scene/scene.h"

namespace pineda::llvmpipe {

/// What a triangle has at a sample: depth in codes, with its bias, and colour of 255.
struct Values {
  double depth = 0;
  std::array<double, 4> rgba{};
};

/// Bits     positions in units of 2^-8 px, so edges are exact in 64 bits; values are weighted means in
///          long doubles, within 2^-30 of a code.
class ExactTriangle {
 public:
  /// `snapped` with 8 subpixel bits and depths of 24.
  ExactTriangle(const spec::Triangle& snapped, const scene::ScreenTriangle& stated,
                const spec::FrameState& frame);

  bool is_drawn() const { return is_drawn_; }  // neither of zero area nor culled
  bool covers(int x, int y) const;
  Values values(int x, int y) const;
  /// How far the sample is inside of the triangle, negative outside, and from the edge of which corner on.
  std::pair<double, size_t> inside_px(int x, int y) const;
  /// Columns and rows of its box, a px wider, within the frame: first x, last x, first y, last y.
  const std::array<int, 4>& box() const { return box_; }

 private:
  int64_t inside(size_t corner, int x, int y) const;
  bool is_top_left(size_t corner) const;

  std::array<spec::Vertex, 3> v_;
  scene::ScreenTriangle stated_;
  spec::FrameState frame_;
  int64_t area_ = 0;  // doubled; positive when clockwise on the screen
  bool is_drawn_ = false;
  double bias_codes_ = 0;
  std::array<int, 4> box_{};
};

}  // namespace pineda::llvmpipe
