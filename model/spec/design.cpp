#include "model/spec/design.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/spec/widths.h"

namespace pineda::spec {

namespace {

/// A point on the front of speed against error: reciprocal, k and F; no narrowing inside a tile.
constexpr Design point(const char* name, const char* summary, int lut_bits, int newton_steps, int k,
                       int f) {
  Design d;
  d.name = name;
  d.summary = summary;
  d.reciprocal_lut_bits = lut_bits;
  d.reciprocal_newton_steps = newton_steps;
  d.reciprocal_bits = k;
  d.gradient_fraction_bits = d.tile_fraction_bits = f;
  return d;
}

constexpr Design div28() {
  Design d = point("div28", "restoring division of 28 bits in place of a ROM", 0, 0, 28, 18);
  d.reciprocal_scheme = ReciprocalScheme::kRestoring2;
  return d;
}

constexpr Design exact() {
  Design d =
      point("exact", "quotient and remainder planes: every code is the nearest one", 0, 0, 0, 0);
  d.reciprocal_scheme = ReciprocalScheme::kNone;
  return d;
}

}  // namespace

const std::vector<Design>& designs() {
  static const std::vector<Design> all{
      point("low", "one Newton step, 19 bits: for a depth buffer of 16 bits", 8, 1, 19, 10),
      point("med", "one Newton step, 22 bits", 10, 1, 22, 14),
      point("med_plus", "one Newton step from a large ROM, 26 bits", 12, 1, 26, 16),
      point("high", "two Newton steps, 30 bits", 7, 2, 30, 18),
      kHighTile,
      point("high_plus", "two Newton steps, 32 bits", 8, 2, 32, 20),
      div28(),
      exact(),
  };
  return all;
}

const char* reciprocal_scheme_name(ReciprocalScheme scheme) {
  static constexpr const char* kNames[] = {"newton", "quadratic", "restoring2", "restoring4",
                                           "none"};
  return kNames[static_cast<int>(scheme)];
}

const Design* find_design(const std::string& name) {
  for (const auto& design : designs()) {
    if (name == design.name) return &design;
  }
  return nullptr;
}

std::string invalid_reason(const Design& d) {
  const auto outside = [](const char* what, int value, int low, int high) {
    return value < low || value > high
               ? fmt::format("{} is {}, must be {} to {}", what, value, low, high)
               : std::string();
  };
  const bool newton = d.reciprocal_scheme == ReciprocalScheme::kNewton;
  const bool has_rom = newton || d.reciprocal_scheme == ReciprocalScheme::kQuadratic;
  const bool has_planes = d.reciprocal_scheme != ReciprocalScheme::kNone;
  const auto outside_if = [&](bool used, const char* what, int value, int low, int high) {
    return used ? outside(what, value, low, high) : std::string();
  };
  for (const auto& reason :
       {outside("subpixel_bits", d.subpixel_bits, 4, 12),
        outside("guard_bits", d.guard_bits, 4, 14), outside("depth_bits", d.depth_bits, 16, 24),
        outside("attributes", d.attributes, 1, kMaxAttributes),
        outside("attribute_bits", d.attribute_bits, 1, 16),
        outside_if(has_rom, "reciprocal_lut_bits", d.reciprocal_lut_bits, 4, 12),
        outside_if(newton, "reciprocal_newton_steps", d.reciprocal_newton_steps, 0, 2),
        outside_if(has_planes, "reciprocal_bits", d.reciprocal_bits, 12, 32),
        outside_if(has_planes, "gradient_fraction_bits", d.gradient_fraction_bits, 8, 20),
        outside_if(has_planes, "tile_fraction_bits", d.tile_fraction_bits, 1,
                   d.gradient_fraction_bits),
        outside("tile_log2", d.tile_log2, 2, std::min(6, d.guard_bits - 1)),
        outside("prim_fifo_depth", d.prim_fifo_depth, 1, 1024),
        outside("tile_fifo_depth", d.tile_fifo_depth, 1, 1024),
        outside("stamp_fifo_depth", d.stamp_fifo_depth, 1, 1024),
        outside("stamp_width_log2", d.stamp_width_log2, 0, 2),
        outside("stamp_height_log2", d.stamp_height_log2, 0, 2),
        outside("depth_latency_cycles", d.depth_latency_cycles, 1, d.max_depth_latency_cycles)}) {
    if (!reason.empty()) return reason;
  }
  // The gradient's shift (k + bit_length(area2) - 1 - F - S for an attribute) must not be negative.
  if (has_planes && d.reciprocal_bits < d.gradient_fraction_bits + d.subpixel_bits) {
    return "reciprocal_bits must be at least gradient_fraction_bits + subpixel_bits";
  }
  // The coefficient of the square has k + 2 - 2*lut_bits bits.
  if (d.reciprocal_scheme == ReciprocalScheme::kQuadratic &&
      d.reciprocal_bits < 2 * d.reciprocal_lut_bits) {
    return "reciprocal_bits must be at least 2*reciprocal_lut_bits in a quadratic reciprocal";
  }
  return {};
}

std::string no_cycles_reason(const Design& d) {
  if (d.reciprocal_scheme != ReciprocalScheme::kNone) return {};
  return "planes by quotient and remainder exist in the functional model alone";
}

std::string no_rtl_reason(const Design& d) { return no_cycles_reason(d); }

}  // namespace pineda::spec
