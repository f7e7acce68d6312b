#include <algorithm>
#include <utility>

#include "model/baseline/common.h"
#include "model/baseline/makers.h"

namespace pineda::baseline {

using spec::Triangle;
using spec::Vertex;

namespace {

int64_t floor_divide(int64_t numerator, int64_t denominator) {  // denominator > 0
  return numerator / denominator - (numerator % denominator < 0 ? 1 : 0);
}

// Steps along one edge from row to row. The first pixel at or right of the edge is an integer with
// a remainder (a DDA); the exact crossing and the interpolated values are doubles.
class Walk {
 public:
  // Starts at the centre of row y; the edge goes down from `top` to `bottom`.
  Walk(const Vertex& top, const Vertex& bottom, const Parameters& at_top,
       const Parameters& at_bottom, int y, int subpixel_bits) {
    const int64_t half = int64_t{1} << (subpixel_bits - 1);
    const int64_t height = int64_t{bottom.y} - top.y;
    const int64_t width = int64_t{bottom.x} - top.x;
    const int64_t below = 2 * half * y + half - top.y;  // subpixel prestep
    // The pixel is the ceiling of numerator / (height * 2^S).
    const int64_t numerator = (top.x - half) * height + below * width;
    unit_ = 2 * half * height;
    pixel_ = -floor_divide(-numerator, unit_);
    remainder_ = pixel_ * unit_ - numerator;
    pixel_step_ = floor_divide(width, height);
    remainder_step_ = 2 * half * (width - pixel_step_ * height);
    const double share = static_cast<double>(below) / static_cast<double>(height);
    x_ = (static_cast<double>(top.x) + share * static_cast<double>(width)) /
         static_cast<double>(2 * half);
    x_step_ = static_cast<double>(width) / static_cast<double>(height);
    for (size_t i = 0; i < kParameters; ++i) {
      const double change = at_bottom[i] - at_top[i];
      value_[i] = at_top[i] + share * change;
      value_step_[i] = change * static_cast<double>(2 * half) / static_cast<double>(height);
    }
  }

  int64_t pixel() const { return pixel_; }
  double x() const { return x_; }  // px
  const Parameters& value() const { return value_; }

  void step() {
    pixel_ += pixel_step_;
    remainder_ -= remainder_step_;
    if (remainder_ < 0) {
      remainder_ += unit_;
      ++pixel_;
    }
    x_ += x_step_;
    for (size_t i = 0; i < kParameters; ++i) value_[i] += value_step_[i];
  }

 private:
  int64_t pixel_, pixel_step_;
  int64_t remainder_, remainder_step_, unit_;
  double x_, x_step_;
  Parameters value_{}, value_step_{};
};

// As printed  vertices sorted by y; the middle vertex on the left or right side; values
//             interpolated along the edges, then along the span, with the offset from edge to
//             pixel centre.
// Mended      spans ceil(left) .. ceil(right)-1, since inclusive ends hit a shared edge twice; the
//             same for rows; the offset in y too (prestep); coverage in integers.
class EdgeWalk final : public Common {
 public:
  using Common::Common;

  void draw(const Triangle& t, Sink* sink) override {
    if (dropped(doubled_area(t))) return;
    std::array<const Vertex*, 3> v{&t.v[0], &t.v[1], &t.v[2]};
    std::stable_sort(v.begin(), v.end(),
                     [](const Vertex* a, const Vertex* b) { return a->y < b->y; });
    const Triangle sorted{t.id, {*v[0], *v[1], *v[2]}};
    const bool break_on_right = doubled_area(sorted) > 0;
    section(sorted, 0, break_on_right, sink);
    section(sorted, 1, break_on_right, sink);
  }

 private:
  // Draws the rows between vertices `upper` and `upper` + 1: between their edge and the edge 0-2.
  void section(const Triangle& t, size_t upper, bool break_on_right, Sink* sink) {
    const auto& v = t.v;
    // The rows of the frame whose centres lie in [top, bottom).
    const Box rows = box(0, v[upper].y, 0, v[upper + 1].y);
    if (rows.y0 > rows.y1) return;
    const std::array<Parameters, 3> value = parameters(t);
    Walk whole(v[0], v[2], value[0], value[2], rows.y0, subpixel_bits_);
    Walk part(v[upper], v[upper + 1], value[upper], value[upper + 1], rows.y0, subpixel_bits_);
    const Walk& left = break_on_right ? whole : part;
    const Walk& right = break_on_right ? part : whole;
    for (int y = rows.y0; y <= rows.y1; ++y) {
      span(y, left, right, sink);
      whole.step();
      part.step();
    }
  }

  void span(int y, const Walk& left, const Walk& right, Sink* sink) {
    const auto first = static_cast<int>(std::max<int64_t>(left.pixel(), 0));
    const auto end = static_cast<int>(std::min<int64_t>(right.pixel(), frame_.width));
    if (first >= end) return;
    visited_ += static_cast<uint64_t>(end - first);
    const double width = right.x() - left.x();
    const double scale = width > 0 ? 1 / width : 0;  // 0: both crossings round to the same double
    const double offset = first + .5 - left.x();
    Parameters value;
    Parameters step;
    for (size_t i = 0; i < kParameters; ++i) {
      step[i] = (right.value()[i] - left.value()[i]) * scale;
      value[i] = left.value()[i] + offset * step[i];
    }
    for (int x = first; x < end; ++x) {
      emit(x, y, value, sink);
      for (size_t i = 0; i < kParameters; ++i) value[i] += step[i];
    }
  }
};

}  // namespace

std::unique_ptr<Rasterizer> make_edge_walk(const spec::Contract& c, const spec::FrameState& frame) {
  return std::make_unique<EdgeWalk>(c, frame);
}

}  // namespace pineda::baseline
