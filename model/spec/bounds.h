// What a design promises of its values, from its own parameters. docs/accuracy.md has the
// derivation.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/spec/design.h"
#include "model/spec/widths.h"

namespace pineda::spec {

/// Greatest relative error of core::reciprocal(), proven for every parameter; for the named ROMs
/// and k a smaller one, found by trying every mantissa (`pineda study reciprocals --exhaustive`).
inline double reciprocal_error_bound(const Design& d) { return scheme_of(d).error_bound(d); }

/// Largest error of a depth code and of an attribute against exact arithmetic on the snapped
/// vertices, in units of the last place.
struct ErrorBounds {
  double depth_ulp;
  double attribute_lsb;
};

/// Before the final rounding: |error| <= range*r + (|Dx|+|Dy|+2) * 2^-(F+1) + (2T-1) * 2^-(F'+1).
/// The range of the value times the reciprocal's error; offsets of up to 2^(guard+1) px from the
/// anchor times the rounding of the gradients, and that of the references; inside the tile 2(T-1)
/// steps and one reference rounded to F' bits, nothing if F' = F. No term grows as the triangle's
/// area shrinks. A design without a reciprocal rounds nothing.
///
/// With perspective the attribute is a mean of the vertices' values with weights E/w over their
/// sum. A relative error u of each weight moves it by u * range/2, since mean deviations from a
/// mean are no more than half the range: u = 2^-n from n mantissa bits of 1/w rounded (2^-n at
/// 1/2). Products cut off at 2^-25 of the greatest move it by three of those, the reciprocal by
/// itself, and two weights rounded by 2^-25 each by that.
inline ErrorBounds error_bounds_before_rounding(const Design& design) {
  const Design d = tamed(design);
  if (!has_reciprocal(d)) return {0, 0};
  const double reciprocal = reciprocal_error_bound(d);
  const double span_px = std::exp2(d.guard_bits + 1);
  const double planes = (2 * span_px + 2) * std::exp2(-(d.gradient_fraction_bits + 1));
  const double steps =
      d.tile_fraction_bits == d.gradient_fraction_bits
          ? 0
          : (2 * ((1 << d.tile_log2) - 1) + 1) * std::exp2(-(d.tile_fraction_bits + 1));
  const auto bound = [&](int bits) { return std::exp2(bits) * reciprocal + planes + steps; };
  const double weight = std::exp2(-(kWeightFractionBits + 1));
  const double corrected = std::exp2(d.attribute_bits) *
                           (std::exp2(-d.inverse_w_bits) / 2 * (1 + std::exp2(-4)) +
                            3 * 2 * std::exp2(-kWeightProductBits) + reciprocal + 2 * weight);
  return {d.depth_test ? bound(d.depth_bits) : 0, d.attributes == 0 ? 0
                                                  : d.perspective   ? corrected
                                                                    : bound(d.attribute_bits)};
}

/// The final rounding included, which is 1/2; and for depth 2^-9, by which a vertex's z in UQ.8 may
/// differ from the float that it was: the bound holds against either.
inline ErrorBounds error_bounds(const Design& d) {
  const ErrorBounds before = error_bounds_before_rounding(d);
  return {d.depth_test ? before.depth_ulp + std::exp2(-(kDepthInputFractionBits + 1)) + .5 : 0,
          d.attributes > 0 ? before.attribute_lsb + .5 : 0};
}

/// What a depth bias adds to the bound of a triangle's depth codes, in ulp. `slope` is the factor
/// of the state; `gradient` = max(|dz/dx|, |dz/dy|) of the triangle, exact, in codes a px.
///
/// bias = constant + slope * magnitude, where constant and slope are exact, and so are the product
/// and the sum at 2^-16 codes. The magnitude is a gradient times the reciprocal's error, rounded to
/// 8 fraction bits, and saturated below 2^(depth_bits+2): neither the greater of two magnitudes nor
/// saturating makes an error greater, but beyond that limit the rest of the gradient is lost. The
/// bias itself saturates where every code is at an end of the range, and clamping to the range
/// brings two values no farther apart.
inline double depth_bias_error_bound(const Design& d, double slope, double gradient) {
  if (!has_reciprocal(d) || !d.depth_test || slope == 0) return 0;
  const double limit = std::exp2(widths(d).bias_magnitude - 1 - kBiasFactorFractionBits) -
                       std::exp2(-kBiasFactorFractionBits);
  return std::abs(slope) * (std::exp2(-(kBiasFactorFractionBits + 1)) +
                            gradient * reciprocal_error_bound(d) + std::max(0., gradient - limit));
}

}  // namespace pineda::spec
