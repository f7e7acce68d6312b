#include "model/spec/design.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/spec/widths.h"

namespace pineda::spec {

const std::vector<Design>& designs() {
  static const std::vector<Design> all{kHighTile};
  return all;
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
  for (const auto& reason :
       {outside("subpixel_bits", d.subpixel_bits, 4, 12),
        outside("guard_bits", d.guard_bits, 4, 14), outside("depth_bits", d.depth_bits, 16, 24),
        outside("attributes", d.attributes, 1, kMaxAttributes),
        outside("attribute_bits", d.attribute_bits, 1, 16),
        outside("reciprocal_lut_bits", d.reciprocal_lut_bits, 4, 12),
        outside("reciprocal_newton_steps", d.reciprocal_newton_steps, 1, 2),
        outside("reciprocal_bits", d.reciprocal_bits, 8, 30),
        outside("gradient_fraction_bits", d.gradient_fraction_bits, 8, 20),
        outside("tile_fraction_bits", d.tile_fraction_bits, 1, d.gradient_fraction_bits),
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
  if (d.reciprocal_bits < d.gradient_fraction_bits + d.subpixel_bits) {
    return "reciprocal_bits must be at least gradient_fraction_bits + subpixel_bits";
  }
  return {};
}

}  // namespace pineda::spec
