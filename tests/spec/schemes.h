// Designs for tests without a name in the program: each reciprocal scheme that no named design has,
// and corner cases of the others.
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

/// Setups that no named design has: each style without the parts that the named ones have, at the
/// greatest widths, and with every scheme that it may have.
constexpr Design setup_design(const char* name, SetupStyle style, Design d) {
  d.name = name;
  d.setup_style = style;
  return d;
}

/// The widest of all formats: 32 bits of depth, so numerators beyond 64 bits. With hierarchical z
/// of few tiles: Yosys takes minutes for the flags of 32,768.
constexpr Design z32(Design d) {
  d.hierarchical_z = true;
  d.hierarchical_z_tiles = 40;
  d.subpixel_bits = 12;
  d.depth_bits = 32;
  d.attributes = 1;
  d.attribute_bits = 16;
  d.gradient_fraction_bits = d.tile_fraction_bits = 20;
  return d;
}

/// Hierarchical z of more tiles than the largest frame has, with every bit of a depth.
constexpr Design hidden(Design d) {
  d.hierarchical_z = true;
  d.hierarchical_z_bits = d.depth_bits = 16;
  return small(d);
}

constexpr Design z16(Design d) {
  d.depth_bits = 16;
  d.attributes = 0;
  d.flat_attributes = 1;
  return d;
}

/// Attributes alone; k = F + S, so that a gradient's shift can be 0.
constexpr Design affine(Design d) {
  d.depth_test = false;
  d.attributes = 3;
  d.attribute_bits = 10;
  d.flat_attributes = 2;
  d.subpixel_bits = d.reciprocal_bits - d.gradient_fraction_bits;
  return d;
}

constexpr Design perspective(Design d, bool depth_test) {
  d.perspective = true;
  d.depth_test = depth_test;
  return d;
}

/// Products in two cycles.
constexpr Design slow_products(Design d) {
  d.multiplier_stages = 2;
  return d;
}

/// No planes.
constexpr Design edges(Design d) {
  d.depth_test = false;
  d.attributes = 0;
  d.flat_attributes = 4;
  return d;
}

inline constexpr Design kNewton32 = scheme_design("", ReciprocalScheme::kNewton, 8, 2, 32);
inline constexpr Design kRestoring32 = scheme_design("", ReciprocalScheme::kRestoring4, 0, 0, 32);
inline constexpr Design kSetups[] = {
    setup_design("stepped_z32", SetupStyle::kStepped, z32(kNewton32)),
    setup_design("stepped_hidden", SetupStyle::kStepped, hidden(kNewton32)),
    setup_design("stepped_affine", SetupStyle::kStepped, affine(kSchemes[2])),
    setup_design("pipelined_z32", SetupStyle::kPipelined, z32(kNewton32)),
    setup_design("pipelined_z16", SetupStyle::kPipelined, z16(kSchemes[0])),
    setup_design("pipelined_affine", SetupStyle::kPipelined, affine(kSchemes[2])),
    setup_design("pipelined_persp", SetupStyle::kPipelined, perspective(kHighTile, true)),
    setup_design("pipelined_edges", SetupStyle::kPipelined, edges(kHighTile)),
    setup_design("slow_z32", SetupStyle::kPipelined, slow_products(z32(kNewton32))),
    setup_design("slow_affine", SetupStyle::kPipelined, slow_products(affine(kSchemes[2]))),
    setup_design("slow_persp", SetupStyle::kPipelined, slow_products(perspective(kHighTile, true))),
    setup_design("slow_edges", SetupStyle::kPipelined, slow_products(edges(kHighTile))),
    setup_design("serial_z32", SetupStyle::kSerial, z32(kRestoring32)),
    setup_design("serial_z16", SetupStyle::kSerial, z16(kSchemes[0])),
    setup_design("serial_high", SetupStyle::kSerial, kHighTile),
    setup_design("serial_affine", SetupStyle::kSerial, affine(kSchemes[2])),
    setup_design("serial_persp", SetupStyle::kSerial, perspective(kHighTile, false)),
};

}  // namespace pineda::spec
