// Designs that no name stands for: each scheme of the reciprocal that no named design has, and the
// corners of the others.
#pragma once

#include "model/spec/design.h"

namespace pineda::spec {

/// A design by its reciprocal; as many fraction bits as k allows, up to the default's.
constexpr Design scheme_design(const char* name, ReciprocalScheme scheme, int lut_bits,
                               int newton_steps, int k) {
  Design d;
  d.name = name;
  d.reciprocal_scheme = scheme;
  d.reciprocal_lut_bits = lut_bits;
  d.reciprocal_newton_steps = newton_steps;
  d.reciprocal_bits = k;
  const int fraction_bits = k - d.subpixel_bits;
  if (fraction_bits < d.gradient_fraction_bits) {
    d.gradient_fraction_bits = d.tile_fraction_bits = fraction_bits;
  }
  return d;
}

/// The same in a guard band of 32 px at 4 subpixel bits: areas of 18 bits, so all can be tried.
constexpr Design small(Design d) {
  d.subpixel_bits = d.guard_bits = 4;
  return d;
}

inline constexpr Design kSchemes[] = {
    scheme_design("rom", ReciprocalScheme::kNewton, 12, 0, 18),  // the largest ROM, nothing else
    small(scheme_design("newton_small", ReciprocalScheme::kNewton, 4, 2, 32)),  // area short of m
    scheme_design("quadratic", ReciprocalScheme::kQuadratic, 7, 0, 26),
    scheme_design("quadratic_large", ReciprocalScheme::kQuadratic, 12, 0, 24),  // c1, c2 round up
    small(scheme_design("quadratic_small", ReciprocalScheme::kQuadratic, 4, 0, 32)),
    scheme_design("restoring4", ReciprocalScheme::kRestoring4, 0, 0, 28),
    scheme_design("restoring4_odd", ReciprocalScheme::kRestoring4, 0, 0, 29),
    small(scheme_design("restoring2_small", ReciprocalScheme::kRestoring2, 0, 0, 19)),
};

}  // namespace pineda::spec
