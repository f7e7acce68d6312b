// Written from the rules only, with other formulas than model/core: coverage by computing half-open
// spans with divisions, not by signs of edge functions; values by barycentric weights, not by
// planes.
#include "model/exact/exact.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace exact {

namespace {

__extension__ typedef __int128 Int128;

// Widths. With |x|, |y| <= 2^26 a difference takes 27 bits and a sign, so products of two, doubled
// areas and the numerators of crossings stay below 2^56 and fit into int64_t. Weights times a z
// below 2^60, and codes times 256 doubled areas, stay below 2^126 and fit into Int128.
constexpr int64_t kMaxCoordinate = int64_t{1} << 26;
constexpr int64_t kMaxValue = int64_t{1} << 60;

int64_t ceil_divide(int64_t numerator, int64_t denominator) {  // denominator > 0
  const int64_t quotient = numerator / denominator;
  return quotient + (numerator > quotient * denominator ? 1 : 0);
}

int64_t centre(int pixel, int subpixel_bits) {
  return (2 * int64_t{pixel} + 1) * (int64_t{1} << (subpixel_bits - 1));
}

// First pixel whose centre lies at or beyond numerator/denominator, a position in subpixels.
int64_t first_centre_from(int64_t numerator, int64_t denominator, int subpixel_bits) {
  const int64_t half = int64_t{1} << (subpixel_bits - 1);
  return ceil_divide(numerator - half * denominator, denominator << subpixel_bits);
}

// The pixels in [first, end) that lie in [low, high).
Span clip(int64_t first, int64_t end, int low, int high) {
  first = std::max<int64_t>(first, low);
  end = std::min<int64_t>(end, high);
  if (first >= end) return {};
  return {static_cast<int>(first), static_cast<int>(end - 1)};
}

int64_t cross(const Vertex& o, int64_t x1, int64_t y1, int64_t x2, int64_t y2) {
  return (x1 - o.x) * (y2 - o.y) - (x2 - o.x) * (y1 - o.y);
}

void check_vertex(const Vertex& v) {
  if (std::abs(v.x) > kMaxCoordinate || std::abs(v.y) > kMaxCoordinate) {
    throw std::out_of_range("exact: a vertex lies beyond 2^26 subpixels");
  }
  if (v.z < 0 || v.z > kMaxValue) throw std::out_of_range("exact: z must be 0 to 2^60");
}

// `measured` minus the weighted mean of three values that carry `fraction_bits`.
double difference(const std::array<int64_t, 3>& weights, int64_t area2,
                  const std::array<int64_t, 3>& value, int fraction_bits, int64_t measured) {
  if (measured < -(kMaxValue >> 8) || measured > kMaxValue >> 8) {
    throw std::out_of_range("exact: a code must lie within 2^52");
  }
  Int128 weighted = 0;
  for (size_t i = 0; i < 3; ++i) weighted += Int128{weights[i]} * value[i];
  const Int128 denominator = Int128{area2} << fraction_bits;
  const Int128 numerator = Int128{measured} * denominator - weighted;
  return static_cast<double>(static_cast<long double>(numerator) /
                             static_cast<long double>(denominator));
}

}  // namespace

Judge::Judge(Triangle triangle, int subpixel_bits, const Frame& frame)
    : v_(std::move(triangle)), subpixel_bits_(subpixel_bits), frame_(frame) {
  frame_.x0 = std::max(frame.x0, 0);
  frame_.y0 = std::max(frame.y0, 0);
  frame_.x1 = std::min(frame.x1, frame.width);
  frame_.y1 = std::min(frame.y1, frame.height);
  if (subpixel_bits < 1 || subpixel_bits > 12) {
    throw std::out_of_range("exact: subpixel bits must be 1 to 12");
  }
  for (const Vertex& v : v_) check_vertex(v);
  area2_ = cross(v_[0], v_[1].x, v_[1].y, v_[2].x, v_[2].y);
  // Counter-clockwise on screen is front-facing. A triangle without area is never drawn.
  culled_ = area2_ == 0 || (frame.cull == Cull::kFront && area2_ < 0) ||
            (frame.cull == Cull::kBack && area2_ > 0);
}

int64_t Judge::doubled_area() const { return area2_; }

bool Judge::culled() const { return culled_; }

bool Judge::covers(int x, int y) const {
  const Span s = span(y);
  return s.first <= x && x <= s.last;
}

// The top-left rule by half-open intervals. An edge crosses a row of samples if it starts at or
// above the row's centre and ends below it: so horizontal edges cross no row, samples on a top edge
// are covered, and samples on a bottom edge are not. Of the row's two crossings the left one is
// included and the right one excluded. Neither orientation nor signs of edge functions are needed.
Span Judge::span(int y) const {
  if (culled_ || y < frame_.y0 || y >= frame_.y1) return {};
  const int64_t row = centre(y, subpixel_bits_);
  int64_t first = INT64_MAX;
  int64_t end = INT64_MIN;
  for (size_t i = 0; i < 3; ++i) {
    const Vertex* top = &v_[i];
    const Vertex* bottom = &v_[(i + 1) % 3];
    if (top->y > bottom->y) std::swap(top, bottom);
    if (row < top->y || row >= bottom->y) continue;
    const int64_t height = bottom->y - top->y;
    const int64_t crossing = top->x * height + (row - top->y) * (bottom->x - top->x);
    const int64_t pixel = first_centre_from(crossing, height, subpixel_bits_);
    first = std::min(first, pixel);
    end = std::max(end, pixel);
  }
  return clip(first, end, frame_.x0, frame_.x1);
}

Span Judge::rows() const {
  if (culled_) return {};
  const auto [top, bottom] = std::minmax({v_[0].y, v_[1].y, v_[2].y});
  return clip(first_centre_from(top, 1, subpixel_bits_),
              first_centre_from(bottom, 1, subpixel_bits_), frame_.y0, frame_.y1);
}

int64_t Judge::samples() const {
  int64_t count = 0;
  const Span r = rows();
  for (int y = r.first; y <= r.last; ++y) {
    const Span s = span(y);
    count += s.last - s.first + 1;
  }
  return count;
}

std::array<int64_t, 3> Judge::weights(int x, int y) const {
  std::array<int64_t, 3> weights{};
  for (size_t i = 0; i < 3; ++i) {
    const Vertex& to = v_[(i + 2) % 3];
    const int64_t area2 =
        cross(v_[(i + 1) % 3], to.x, to.y, centre(x, subpixel_bits_), centre(y, subpixel_bits_));
    weights[i] = area2_ < 0 ? -area2 : area2;
    if (weights[i] < 0) throw std::domain_error("exact: the sample is not covered");
  }
  return weights;
}

double Judge::depth_error(int x, int y, int64_t code) const {
  return difference(weights(x, y), std::abs(area2_), {v_[0].z, v_[1].z, v_[2].z}, 8, code);
}

double Judge::attribute_error(int x, int y, int attribute, int64_t value) const {
  const auto a = static_cast<size_t>(attribute);
  return difference(weights(x, y), std::abs(area2_),
                    {v_[0].attr.at(a), v_[1].attr.at(a), v_[2].attr.at(a)}, 0, value);
}

int64_t snap(float value, int subpixel_bits, int guard_bits, bool* saturated) {
  // A double holds the scaled float, its floor and their difference without rounding.
  const double scaled = std::ldexp(static_cast<double>(value), subpixel_bits);
  const double high = std::ldexp(1.0, guard_bits + subpixel_bits) - 1;
  const double low = -high - 1;
  // Clamped to more than a unit outside the range before rounding, so that infinities become finite
  // and still count as saturated.
  const double held = std::clamp(scaled, low - 2, high + 2);
  const double below = std::floor(held);
  const double rest = held - below;
  const bool odd = std::fmod(below, 2.0) != 0;
  const double rounded = below + (rest > .5 || (rest == .5 && odd) ? 1 : 0);
  *saturated = rounded < low || rounded > high;
  return static_cast<int64_t>(std::clamp(rounded, low, high));
}

int64_t depth_input(float z, int depth_bits, bool* clamped) {
  *clamped = z < 0 || z > 1;
  int exponent = 0;
  const float fraction = std::frexp(std::clamp(z, 0.0f, 1.0f), &exponent);
  const auto mantissa = static_cast<int64_t>(std::ldexp(fraction, 24));
  // z = mantissa / 2^shift. With a shift above 90 the result below is less than half a unit, so 0.
  const int shift = 24 - exponent;
  if (shift > 90) return 0;
  const Int128 top_code = (Int128{1} << depth_bits) - 1;
  const Int128 scaled = (mantissa * top_code) << 8;
  return static_cast<int64_t>((scaled + (Int128{1} << (shift - 1))) >> shift);
}

}  // namespace exact
