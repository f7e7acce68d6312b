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
///
/// With t = 2^-(k+2): cutting m off makes the result up to 2t greater, the last rounding moves it
/// by up to 4t. A Newton step squares the error, downwards, and its two truncations add up to t
/// upwards and 2t downwards; the ROM's first guess is within .625 * 2^-l. A parabola is within
/// 2^-3l / 31, and its coefficients and truncations within 6t. A quotient is the nearest one.
inline double reciprocal_error_bound(const Design& d) {
  struct Found {
    int lut_bits, newton_steps, k;
    double good_bits;
  };
  static constexpr Found kFound[] = {{8, 1, 19, 17.29},   // low
                                     {10, 1, 22, 21.04},  // med
                                     {12, 1, 26, 24.97},  // med_plus
                                     {7, 2, 30, 29.41},   // high, high_tile
                                     {8, 2, 32, 31.41}};  // high_plus
  const double t = std::exp2(-(d.reciprocal_bits + 2));
  switch (d.reciprocal_scheme) {
    case ReciprocalScheme::kNewton: {
      for (const Found& f : kFound) {
        if (f.lut_bits == d.reciprocal_lut_bits && f.newton_steps == d.reciprocal_newton_steps &&
            f.k == d.reciprocal_bits) {
          return std::exp2(-f.good_bits);
        }
      }
      double error = .625 * std::exp2(-d.reciprocal_lut_bits);
      for (int i = 0; i < d.reciprocal_newton_steps; ++i) error = error * error + 2 * t;
      return error + 6 * t;
    }
    case ReciprocalScheme::kQuadratic:
      return std::exp2(-3 * d.reciprocal_lut_bits) / 31 + 12 * t;
    case ReciprocalScheme::kRestoring2:
    case ReciprocalScheme::kRestoring4:
      return 4 * t;
    case ReciprocalScheme::kNone:
      break;
  }
  return 0;
}

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
inline ErrorBounds error_bounds_before_rounding(const Design& d) {
  if (d.reciprocal_scheme == ReciprocalScheme::kNone) return {0, 0};
  const double reciprocal = reciprocal_error_bound(d);
  const double span_px = std::exp2(d.guard_bits + 1);
  const double planes = (2 * span_px + 2) * std::exp2(-(d.gradient_fraction_bits + 1));
  const double steps =
      d.tile_fraction_bits == d.gradient_fraction_bits
          ? 0
          : (2 * ((1 << d.tile_log2) - 1) + 1) * std::exp2(-(d.tile_fraction_bits + 1));
  const auto bound = [&](int bits) { return std::exp2(bits) * reciprocal + planes + steps; };
  return {bound(d.depth_bits), bound(d.attribute_bits)};
}

/// The final rounding included, which is 1/2; and for depth 2^-9, by which a vertex's z in UQ.8 may
/// differ from the float that it was: the bound holds against either.
inline ErrorBounds error_bounds(const Design& d) {
  const ErrorBounds before = error_bounds_before_rounding(d);
  return {before.depth_ulp + std::exp2(-(kDepthInputFractionBits + 1)) + .5,
          before.attribute_lsb + .5};
}

}  // namespace pineda::spec
