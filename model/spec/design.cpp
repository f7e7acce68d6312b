#include "model/spec/design.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/spec/parameters.h"

namespace pineda::spec {

namespace {

/// A design on the Pareto front of speed against error, given by its reciprocal, k and F. Planes
/// are not narrowed inside a tile: F' = F.
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

constexpr Design persp() {
  Design d;
  d.name = "persp";
  d.summary = "high_tile with perspective-correct attributes";
  d.perspective = true;
  return d;
}

constexpr Design flat() {
  Design d;
  d.name = "flat";
  d.summary = "high_tile without depth and interpolation: a colour a triangle";
  d.depth_test = false;
  d.attributes = 0;
  d.flat_attributes = 4;
  return d;
}

constexpr Design dense() {
  Design d;
  d.name = "dense";
  d.summary = "high_tile with 4x4 stamps: the most triangles and samples a mm^2";
  d.tile_fifo_depth = 2;
  d.plane_slots = 8;
  d.stamp_width_log2 = d.stamp_height_log2 = 2;
  return d;
}

constexpr Design wide() {
  Design d;
  d.name = "wide";
  d.summary = "high_tile with 4x4 stamps and a triangle a cycle";
  d.setup_style = SetupStyle::kPipelined;
  d.multiplier_stages = 2;
  d.prim_fifo_depth = 2;  // with one of depth 1 setup stops every other cycle
  d.tile_fifo_depth = 4;  // a tile has four stamps at most
  d.plane_slots = 12;
  d.stamp_width_log2 = d.stamp_height_log2 = 2;
  return d;
}

// Its error bounds are below one code, for frames of up to 1024 px: see error_bounds(). Buffers are as
// small as they may be for 60 frames/s of each scene of `study cycles`, on ASAP7 (docs/hardware.md).
constexpr Design tiny() {
  Design d = point("tiny", "the smallest that is right for 640x480: one multiplier, 16-bit depth",
                   9, 1, 23, 13);
  d.subpixel_bits = 4;
  d.guard_bits = 10;
  d.depth_bits = 16;
  d.setup_style = SetupStyle::kSerial;
  d.tile_fraction_bits = 7;
  d.stamp_width_log2 = d.stamp_height_log2 = d.tested_stamps_log2 = 0;
  d.tile_fifo_depth = 0;
  d.stamp_fifo_depth = 2;
  d.plane_slots = 2;
  d.max_depth_latency_cycles = 8;
  return d;
}

// One memory word holds a depth for each stamp of a tile; all of them are compared in one cycle.
constexpr int kMaxHiddenStampsLog2 = 6;

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
      persp(),
      flat(),
      dense(),
      wide(),
      tiny(),
      exact(),
  };
  return all;
}

const Design* find_design(const std::string& name) {
  for (const auto& design : designs()) {
    if (name == design.name) return &design;
  }
  return nullptr;
}

namespace {

/// "newton or quadratic": the schemes with a throughput of one number a cycle.
std::string quick_schemes() {
  std::vector<std::string> words;
  for (const Scheme& scheme : kReciprocalSchemes) {
    if (scheme.every_cycle) words.emplace_back(scheme.word);
  }
  return joined(words, ", ", " or ");
}

/// Why a combination of parameters cannot be built; empty if it can.
std::string combination_reason(const Design& d) {
  const bool has_planes = has_reciprocal(d);
  if (d.hierarchical_z && (!d.depth_test || !has_planes)) {
    return "hierarchical_z needs depth_test, and planes of depth";
  }
  if (d.hierarchical_z &&
      (d.tile_log2 <= std::max(d.stamp_width_log2, d.stamp_height_log2) ||
       2 * d.tile_log2 - d.stamp_width_log2 - d.stamp_height_log2 > kMaxHiddenStampsLog2)) {
    return fmt::format("hierarchical_z needs stamps smaller than the tile, at most {} of them",
                       1 << kMaxHiddenStampsLog2);
  }
  if (d.perspective && d.attributes == 0) {
    return "perspective needs attributes that are interpolated";
  }
  // Perspective needs one reciprocal per lane and cycle, pipelined setup one per cycle.
  if (!scheme_of(d).every_cycle &&
      (d.perspective || (has_planes && d.setup_style == SetupStyle::kPipelined))) {
    return fmt::format("{} needs reciprocal_scheme {}: {} takes many cycles",
                       d.perspective ? "perspective" : "setup_style pipelined", quick_schemes(),
                       scheme_of(d).word);
  }
  // The gradient's shift (k + bit_length(area2) - 1 - F - S for an attribute) must not be negative.
  if (has_planes && d.reciprocal_bits < d.gradient_fraction_bits + d.subpixel_bits) {
    return "reciprocal_bits must be at least gradient_fraction_bits + subpixel_bits";
  }
  return has_planes ? scheme_of(d).invalid_reason(d) : "";
}

}  // namespace

std::string invalid_reason(const Design& d) {
  const std::string reason = range_reason(d);
  return reason.empty() ? combination_reason(d) : reason;
}

std::string no_cycles_reason(const Design& d) {
  if (d.reciprocal_scheme != ReciprocalScheme::kNone) return {};
  return "planes by quotient and remainder exist in the functional model alone";
}

std::string no_rtl_reason(const Design& d) { return no_cycles_reason(d); }

}  // namespace pineda::spec
