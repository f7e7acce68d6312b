// The table of the reciprocal schemes, and queries on a design's scheme.
#pragma once

#include "model/spec/reciprocal/newton.h"
#include "model/spec/reciprocal/quadratic.h"
#include "model/spec/reciprocal/remainders.h"
#include "model/spec/reciprocal/restoring.h"

namespace pineda::spec {

/// The table, in the order of the enumeration.
inline constexpr Scheme kReciprocalSchemes[] = {
    newton::kScheme,     quadratic::kScheme,  restoring::kScheme2,
    restoring::kScheme4, remainders::kScheme,
};
constexpr const auto& names(ReciprocalScheme) { return kReciprocalSchemes; }

constexpr const Scheme& scheme_of(const Design& d) { return row_of(d.reciprocal_scheme); }
constexpr bool has_rom(const Design& d) { return scheme_of(d).has_rom; }
/// Cycles of a reciprocal of which one starts every cycle: in pipelined setup, and with perspective.
constexpr int pipelined_reciprocal_cycles(const Design& d) {
  return scheme_of(d).cycles(d, multiplier_stages(d));
}
/// Cycles of the reciprocal of the doubled area.
constexpr int reciprocal_cycles(const Design& d) {
  return d.setup_style == SetupStyle::kPipelined ? pipelined_reciprocal_cycles(d)
                                                 : scheme_of(d).cycles(d, 1);
}

/// Bits of the ROM; 0 if there is none.
constexpr int64_t reciprocal_rom_size_bits(const Design& d) {
  return has_rom(d) ? (int64_t{1} << d.reciprocal_lut_bits) * scheme_of(d).rom.entry_bits(d) : 0;
}

}  // namespace pineda::spec
