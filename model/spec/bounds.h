// What a design promises of its values, from its own parameters.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/spec/design.h"
#include "model/spec/widths.h"

namespace pineda::spec {

/// Greatest relative error of the reciprocal.
/// LUT7 + 2 Newton at k = 30: 2^-29.41, found over every mantissa (tests/core/reciprocal_test.cpp).
/// Others: the ROM's error, squared by each step, and the truncations of k+2 bits and the last
/// rounding on top.
inline double reciprocal_error_bound(const Design& d) {
  if (d.reciprocal_lut_bits == 7 && d.reciprocal_newton_steps == 2 && d.reciprocal_bits == 30) {
    return std::exp2(-29.41);
  }
  const double rom = .625 * std::exp2(-d.reciprocal_lut_bits);
  return std::pow(rom, std::exp2(d.reciprocal_newton_steps)) + 2.5 * std::exp2(-d.reciprocal_bits);
}

/// Largest error of a depth code and of an attribute against exact arithmetic on the snapped
/// vertices, final rounding included; in units of the last place.
struct ErrorBounds {
  double depth_ulp;
  double attribute_lsb;
};

/// |error| <= range*r + (|Dx|+|Dy|+2) * 2^-(F+1) + steps inside the tile + 1/2: the range of the
/// value times the reciprocal's error; offsets of up to 2^(guard+1) px from the anchor times the
/// rounding of the gradients, and that of the references; inside the tile 2(T-1) steps and one
/// reference rounded to F' bits; the final rounding. Depth bears 2^-9 more for a vertex's own z.
/// No term grows as the triangle's area shrinks.
inline ErrorBounds error_bounds(const Design& d) {
  const double reciprocal = reciprocal_error_bound(d);
  const double span_px = std::exp2(d.guard_bits + 1);
  const double planes = (2 * span_px + 2) * std::exp2(-(d.gradient_fraction_bits + 1));
  const double steps =
      d.tile_fraction_bits == d.gradient_fraction_bits
          ? 0
          : (2 * ((1 << d.tile_log2) - 1) + 1) * std::exp2(-(d.tile_fraction_bits + 1));
  const auto bound = [&](int bits) { return std::exp2(bits) * reciprocal + planes + steps + .5; };
  return {bound(d.depth_bits) + std::exp2(-(kDepthInputFractionBits + 1)), bound(d.attribute_bits)};
}

}  // namespace pineda::spec
