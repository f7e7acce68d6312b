#include "model/core/exact_planes.h"

namespace pineda::core {

using spec::Contract;
using spec::int128_t;
using spec::Triangle;

ExactPlanes::Step ExactPlanes::divide(int128_t numerator, int64_t denominator) {
  int128_t quotient = numerator / denominator;
  auto remainder = static_cast<int64_t>(numerator % denominator);
  if (remainder < 0) {
    --quotient;
    remainder += denominator;
  }
  return {static_cast<uint64_t>(quotient), remainder};
}

ExactPlanes::ExactPlanes(const Contract& c, const Triangle& t) {
  const auto& v = t.v;
  area2_ = (int64_t{v[1].x} - v[0].x) * (int64_t{v[2].y} - v[0].y) -
           (int64_t{v[2].x} - v[0].x) * (int64_t{v[1].y} - v[0].y);
  z_ = plane(c, t, {v[0].z, v[1].z, v[2].z}, spec::kDepthInputFractionBits);
  for (size_t i = 0; i < static_cast<size_t>(c.design.attributes); ++i) {
    attr_[i] = plane(c, t, {v[0].attr[i], v[1].attr[i], v[2].attr[i]}, 0);
  }
}

// A step is the doubled area of a triangle in a box of 2^(depth_in) by 2^(guard+1+S), so below
// 2^68; times an offset within the guard band, below 2^96: 128 bits hold all numerators.
ExactPlanes::Plane ExactPlanes::plane(const Contract& c, const Triangle& t,
                                      const std::array<int64_t, 3>& value,
                                      int fraction_bits) const {
  const auto& v = t.v;
  const int128_t d1 = value[1] - value[0];
  const int128_t d2 = value[2] - value[0];
  const int sign = area2_ > 0 ? 1 : -1;
  // What a subpixel adds, in units of 1/area2.
  const int128_t step_x =
      sign * (d1 * (int64_t{v[2].y} - v[0].y) - d2 * (int64_t{v[1].y} - v[0].y));
  const int128_t step_y =
      sign * (d2 * (int64_t{v[1].x} - v[0].x) - d1 * (int64_t{v[2].x} - v[0].x));
  const int64_t half = int64_t{1} << (c.design.subpixel_bits - 1);
  const int128_t at_origin =
      int128_t{value[0]} * sign * area2_ + step_x * (half - v[0].x) + step_y * (half - v[0].y);
  Plane p;
  p.denominator = (sign * area2_) << fraction_bits;
  p.dx = divide(step_x * (1 << c.design.subpixel_bits), p.denominator);
  p.dy = divide(step_y * (1 << c.design.subpixel_bits), p.denominator);
  p.ref = divide(at_origin, p.denominator);
  return p;
}

int64_t ExactPlanes::nearest(const Plane& p, int x, int y) {
  const auto column = static_cast<uint64_t>(x);
  const auto row = static_cast<uint64_t>(y);
  const uint64_t quotients = p.ref.quotient + column * p.dx.quotient + row * p.dy.quotient;
  const int128_t remainders =
      p.ref.remainder + int128_t{x} * p.dx.remainder + int128_t{y} * p.dy.remainder;
  const Step rest = divide(remainders, p.denominator);
  const uint64_t up = rest.remainder >= p.denominator - rest.remainder ? 1 : 0;
  return static_cast<int64_t>(quotients + rest.quotient + up);
}

void ExactPlanes::interpolate(const Contract& c, const spec::Stamp& stamp,
                              spec::Fragment* fragment) const {
  const int width = 1 << c.design.stamp_width_log2;
  const auto attributes = static_cast<size_t>(c.design.attributes);
  for (int lane = 0; lane < c.width.lanes; ++lane) {
    const auto l = static_cast<size_t>(lane);
    const bool covered = (stamp.mask >> lane & 1) != 0;
    const int x = stamp.x * width + lane % width;
    const int y = (stamp.y << c.design.stamp_height_log2) + lane / width;
    fragment->z[l] = covered ? static_cast<uint32_t>(nearest(z_, x, y)) : 0;
    for (size_t a = 0; a < attributes; ++a) {
      fragment->attr[l][a] = covered ? static_cast<int32_t>(nearest(attr_[a], x, y)) : 0;
    }
  }
}

}  // namespace pineda::core
