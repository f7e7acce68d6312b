#include "model/core/exact_planes.h"

#include <algorithm>

#include "model/core/lanes.h"

namespace pineda::core {

using spec::Contract;
using spec::int128_t;
using spec::Triangle;

namespace {

// Calls visit(lane, x, y) for each lane of `lanes`; x, y: px.
template <class Visitor>
void for_each_pixel(const Contract& c, const spec::Stamp& stamp, uint32_t lanes, Visitor&& visit) {
  for_each_lane(c.design, lanes, [&](size_t lane, int column, int row) {
    visit(lane, (stamp.x << c.design.stamp_width_log2) + column,
          (stamp.y << c.design.stamp_height_log2) + row);
  });
}

}  // namespace

ExactPlanes::Step ExactPlanes::divide(int128_t numerator, int64_t denominator) {
  int128_t quotient = numerator / denominator;
  auto remainder = static_cast<int64_t>(numerator % denominator);
  if (remainder < 0) {
    --quotient;
    remainder += denominator;
  }
  return {static_cast<uint64_t>(quotient), remainder};
}

ExactPlanes::ExactPlanes(const Contract& c, const spec::FrameState& frame, const Triangle& t) {
  const auto& v = t.v;
  area2_ = (int64_t{v[1].x} - v[0].x) * (int64_t{v[2].y} - v[0].y) -
           (int64_t{v[2].x} - v[0].x) * (int64_t{v[1].y} - v[0].y);
  if (c.design.depth_test) {
    // In finer units, which hold a bias too.
    constexpr int kFiner = 1 << spec::kBiasFactorFractionBits;
    z_ = plane(c, t, {v[0].z * kFiner, v[1].z * kFiner, v[2].z * kFiner},
               spec::kDepthInputFractionBits + spec::kBiasFactorFractionBits);
    if (frame.has_bias()) {
      const Step bias = depth_bias(c, frame, t);
      z_.ref.quotient += bias.quotient;
      z_.ref.remainder += bias.remainder;
    }
  }
  const bool flat = frame.shade == spec::Shade::kFlat;
  for (size_t i = 0; i < static_cast<size_t>(c.design.attributes); ++i) {
    attr_[i] = plane(c, t, {v[0].attr[i], v[flat ? 0 : 1].attr[i], v[flat ? 0 : 2].attr[i]}, 0);
  }
}

// Widths: a step is the doubled area of a triangle in a box of 2^(depth_in) by 2^(guard+1+S), so
// below 2^76 with the extra bits of a bias; times an offset inside the guard band, below 2^104. So
// numerators fit into 128 bits, and the denominator into 63.
ExactPlanes::Plane ExactPlanes::plane(const Contract& c, const Triangle& t,
                                      const std::array<int64_t, 3>& value,
                                      int fraction_bits) const {
  const auto& v = t.v;
  const int128_t d1 = value[1] - value[0];
  const int128_t d2 = value[2] - value[0];
  const int sign = area2_ > 0 ? 1 : -1;
  // The change per subpixel, in units of 1/area2.
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

// Constant + slope * max(|dz/dx|, |dz/dy|). Steps are in 2^-8 codes per subpixel and the slope
// factor in 2^-8, so their product has the unit of the plane's numerators.
ExactPlanes::Step ExactPlanes::depth_bias(const Contract& c, const spec::FrameState& frame,
                                          const Triangle& t) const {
  const auto& v = t.v;
  const int128_t d1 = v[1].z - v[0].z;
  const int128_t d2 = v[2].z - v[0].z;
  const int128_t step_x = d1 * (int64_t{v[2].y} - v[0].y) - d2 * (int64_t{v[1].y} - v[0].y);
  const int128_t step_y = d2 * (int64_t{v[1].x} - v[0].x) - d1 * (int64_t{v[2].x} - v[0].x);
  const int128_t step = std::max(step_x < 0 ? -step_x : step_x, step_y < 0 ? -step_y : step_y);
  const int128_t numerator = frame.bias_slope * step * (1 << c.design.subpixel_bits);
  // Clamped to twice the range of depth: that moves every code to an end already, and cannot wrap.
  const int128_t limit = int128_t{2} << c.design.depth_bits;
  const int128_t whole =
      std::clamp(numerator / z_.denominator, -limit, limit) + frame.bias_constant;
  const Step rest = divide(numerator % z_.denominator, z_.denominator);
  return {static_cast<uint64_t>(whole) + rest.quotient, rest.remainder};
}

void ExactPlanes::depth(const Contract& c, const spec::Stamp& stamp,
                        spec::Fragment* fragment) const {
  std::fill_n(fragment->z.begin(), c.width.lanes, 0);
  if (!c.design.depth_test) return;
  const int64_t top = (int64_t{1} << c.design.depth_bits) - 1;
  for_each_pixel(c, stamp, stamp.mask, [&](size_t lane, int x, int y) {
    fragment->z[lane] = static_cast<uint32_t>(std::clamp<int64_t>(nearest(z_, x, y), 0, top));
  });
}

void ExactPlanes::attributes(const Contract& c, const spec::Stamp& stamp, uint32_t lanes,
                             spec::Fragment* fragment) const {
  const auto n = static_cast<size_t>(c.design.attributes);
  for (size_t lane = 0; lane < static_cast<size_t>(c.width.lanes); ++lane) {
    if ((lanes >> lane & 1) == 0) std::fill_n(fragment->attr[lane].begin(), n, 0);
  }
  for_each_pixel(c, stamp, lanes, [&](size_t lane, int x, int y) {
    for (size_t a = 0; a < n; ++a) {
      fragment->attr[lane][a] = static_cast<int32_t>(nearest(attr_[a], x, y));
    }
  });
}

}  // namespace pineda::core
