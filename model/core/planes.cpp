#include "model/core/planes.h"

#include <algorithm>

namespace pineda::core {

using spec::Contract;
using spec::int128_t;
using spec::round_half_up;
using spec::wrap;

namespace {

// gradient * area2 in units of 2^-(S + fraction of the values), in x and y.
struct Numerators {
  int128_t x;
  int128_t y;
};
Numerators numerators(const PlaneSetup& s, const std::array<int64_t, 3>& value) {
  const int64_t d1 = value[1] - value[0];
  const int64_t d2 = value[2] - value[0];
  return {int128_t{d1} * s.dy[1] - int128_t{d2} * s.dy[0],
          int128_t{d2} * s.dx[0] - int128_t{d1} * s.dx[1]};
}

// numerator * 2^(S - fraction_bits) / area2 in units of 2^-f.
int128_t gradient(const Contract& c, const Reciprocal& reciprocal, int128_t numerator,
                  int fraction_bits, int f) {
  const int shift =
      c.design.reciprocal_bits + reciprocal.length - 1 - f - c.design.subpixel_bits + fraction_bits;
  return round_half_up(numerator * reciprocal.mantissa, shift);
}

}  // namespace

spec::Plane plane(const Contract& c, const PlaneSetup& s, const std::array<int64_t, 3>& value,
                  int fraction_bits, int bits) {
  const int f = c.design.gradient_fraction_bits;
  const int subpixel_bits = c.design.subpixel_bits;
  const Numerators n = numerators(s, value);
  const int128_t dx = gradient(c, s.reciprocal, n.x, fraction_bits, f);
  const int128_t dy = gradient(c, s.reciprocal, n.y, fraction_bits, f);
  // Up to 92 bits; wraps only at the end. With 32 depth bits and 12 subpixel bits the reference has
  // more than 64 bits before its low S bits are rounded off.
  const int128_t at_ref =
      int128_t{value[0]} * (int128_t{1} << (f - fraction_bits + subpixel_bits)) + dx * s.ref_x +
      dy * s.ref_y;
  return {wrap(dx, bits), wrap(dy, bits), wrap(round_half_up(at_ref, subpixel_bits), bits)};
}

int64_t depth_magnitude(const Contract& c, const PlaneSetup& s, const std::array<int64_t, 3>& z) {
  const Numerators n = numerators(s, z);
  const int128_t limit = int128_t{1} << (c.width.bias_magnitude - 1);
  const auto magnitude = [&](int128_t numerator) {
    const int128_t g = gradient(c, s.reciprocal, numerator, spec::kDepthInputFractionBits,
                                spec::kBiasFactorFractionBits);
    return g < 0 ? std::min(-g, limit) : std::min(g, limit - 1);
  };
  return static_cast<int64_t>(std::max(magnitude(n.x), magnitude(n.y)));
}

int64_t depth_bias(const Contract& c, const spec::FrameState& frame, int64_t magnitude) {
  const int128_t bias = int128_t{frame.bias_constant} * (1 << spec::kBiasFractionBits) +
                        int128_t{frame.bias_slope} * magnitude;
  const int128_t greatest = (int128_t{1} << (c.width.depth_bias - 1)) - 1;
  return static_cast<int64_t>(std::clamp(bias, -greatest - 1, greatest));
}

}  // namespace pineda::core
