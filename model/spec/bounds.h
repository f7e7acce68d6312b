// Error bounds of a design's depth and attribute values, computed from its parameters.
// docs/accuracy.md derives them.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/spec/design.h"
#include "model/spec/widths.h"

namespace pineda::spec {

/// Upper bound of the relative error of core::reciprocal(), proven for all parameters. The ROM
/// sizes and k of the named designs have a tighter one, found by trying every mantissa
/// (`pineda study reciprocals --exhaustive`).
inline double reciprocal_error_bound(const Design& d) { return scheme_of(d).error_bound(d); }

/// Largest error of a depth code and of an attribute against exact arithmetic on the snapped
/// vertices, in units of the last place.
struct ErrorBounds {
  double depth_ulp;
  double attribute_lsb;
};

/// Before the final rounding: |error| <= range*r + (|Dx|+|Dy|+2) * 2^-(F+1) + (2T-1) * 2^-(F'+1).
/// First term: the value's range times the relative error r of the reciprocal. Second: the rounding
/// of the gradients, times an offset of up to 2^(guard+1) px from the anchor in x and in y, plus
/// the rounding of the reference. Third: 2(T-1) steps inside the tile and one reference, rounded to
/// F' bits; 0 if F' = F. No term grows as the triangle's area shrinks. A design without a
/// reciprocal rounds nothing before the end.
///
/// With perspective the attribute is the mean of the vertices' values, weighted by E/w. A relative
/// error u of each weight moves the mean by at most u * range/2, since the mean deviation from a
/// mean is at most half the range; u = 2^-n for 1/w rounded to n mantissa bits. Added to that: the
/// three products E/w, each truncated at 2^-25 of the greatest; the error of the reciprocal; and
/// two weights rounded by up to 2^-25.
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

/// Adds the final rounding, 1/2. Depth gets another 2^-9, the rounding of a vertex's z to 8
/// fraction bits: so the bound holds against the scene's floats as well as against the snapped
/// vertices.
inline ErrorBounds error_bounds(const Design& d) {
  const ErrorBounds before = error_bounds_before_rounding(d);
  return {d.depth_test ? before.depth_ulp + std::exp2(-(kDepthInputFractionBits + 1)) + .5 : 0,
          d.attributes > 0 ? before.attribute_lsb + .5 : 0};
}

/// What a depth bias adds to the bound of a triangle's depth codes, in ulp. `slope` is the factor
/// of the state; `gradient` = max(|dz/dx|, |dz/dy|) of the triangle, exact, in codes a px.
///
/// bias = constant + slope * magnitude. Constant, slope, product and sum are exact in units of
/// 2^-16 codes. The magnitude has the relative error of the reciprocal, is rounded to 8 fraction
/// bits, and saturates below 2^(depth_bits+2). Taking the maximum of two magnitudes and saturating
/// do not increase an error, but the part of the gradient beyond the limit is lost. The bias itself
/// saturates only where it moves every code to an end of the range, and clamping to the range
/// brings two values no farther apart.
inline double depth_bias_error_bound(const Design& d, double slope, double gradient) {
  if (!has_reciprocal(d) || !d.depth_test || slope == 0) return 0;
  const double limit = std::exp2(widths(d).bias_magnitude - 1 - kBiasFactorFractionBits) -
                       std::exp2(-kBiasFactorFractionBits);
  return std::abs(slope) * (std::exp2(-(kBiasFactorFractionBits + 1)) +
                            gradient * reciprocal_error_bound(d) + std::max(0., gradient - limit));
}

}  // namespace pineda::spec
