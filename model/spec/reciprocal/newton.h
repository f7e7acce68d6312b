// Newton's iteration: a first guess from a ROM, then 0 or more steps x <- 2x(1 - mx).
#pragma once

#include <cmath>

#include "model/spec/reciprocal/scheme.h"

namespace pineda::spec {

/// Bits of a ROM entry. Its leading 1 is implied: the value is (2^bits + entry) / 2^(bits+1), in
/// [1/2, 1).
constexpr int reciprocal_rom_bits(const Design& d) { return d.reciprocal_lut_bits + 1; }

/// First guess of 1/(2m) for m = 0.1iiiiiii..., i = `index`: 1/(m_low + m_high) of the interval,
/// which gives the same relative error at both ends, rounded to the nearest. |relative error| <
/// 2^-lut_bits / 1.7.
constexpr int64_t reciprocal_rom(const Design& d, int index) {
  const int l = d.reciprocal_lut_bits;
  // (m_low + m_high) * 2^(l+1)
  const int64_t denominator = (int64_t{2} << l) + 1 + 2 * int64_t{index};
  const int64_t scaled = int64_t{1} << (2 * l + 3);
  return (2 * scaled + denominator) / (2 * denominator) - (int64_t{2} << l);
}

namespace newton {

/// As many cycles as a product to align the argument, one for the ROM, two products for each step.
constexpr int cycles(const Design& d, int multiplier_stages) {
  return 1 + (1 + 2 * d.reciprocal_newton_steps) * multiplier_stages;
}

/// Two products for each step; the second one waits for the first.
constexpr int serial_setup_steps(const Design& d) {
  return d.reciprocal_newton_steps > 0 ? 3 * d.reciprocal_newton_steps - 1 : 0;
}

/// The ROM's guess is within .625 * 2^-l. Each step squares the error, which makes the result too
/// small, and its two truncations make it up to t too great or up to 2t too small. The ROM sizes
/// and k of named designs have a tighter bound, found by trying every mantissa
/// (`pineda study reciprocals --exhaustive`).
inline double error_bound(const Design& d) {
  struct Found {
    int lut_bits, newton_steps, k;
    double good_bits;
  };
  static constexpr Found kFound[] = {{8, 1, 19, 17.29},   // low
                                     {10, 1, 22, 21.04},  // med
                                     {12, 1, 26, 24.97},  // med_plus
                                     {7, 2, 30, 29.41},   // high, high_tile
                                     {8, 2, 32, 31.41}};  // high_plus
  for (const Found& f : kFound) {
    if (f.lut_bits == d.reciprocal_lut_bits && f.newton_steps == d.reciprocal_newton_steps &&
        f.k == d.reciprocal_bits) {
      return std::exp2(-f.good_bits);
    }
  }
  const double t = std::exp2(-reciprocal_working_bits(d));
  double error = .625 * std::exp2(-d.reciprocal_lut_bits);
  for (int i = 0; i < d.reciprocal_newton_steps; ++i) error = error * error + 2 * t;
  return error + 6 * t;
}

inline std::string invalid_reason(const Design&) { return {}; }

inline std::vector<Constant> constants(const Design& d) {
  return {{"RECIPROCAL_LUT_BITS", d.reciprocal_lut_bits, "index of the ROM"},
          {"RECIPROCAL_ROM_BITS", reciprocal_rom_bits(d), "entry of the ROM, leading 1 implied"},
          {"RECIPROCAL_NEWTON_STEPS", d.reciprocal_newton_steps, ""}};
}

inline std::vector<RomPart> rom_entry(const Design& d, int index) {
  return {{reciprocal_rom_bits(d), reciprocal_rom(d, index)}};
}

inline std::string rom_meaning(const Design& d) {
  const std::string bits = std::to_string(reciprocal_rom_bits(d));
  const std::string shift = std::to_string(reciprocal_rom_bits(d) + 1);
  return "First guess of 1/(2m), m = 0.1<index>...: value (2^" + bits + " + entry) / 2^" + shift +
         ".";
}

inline constexpr ReciprocalRom kRom{reciprocal_rom_bits, rom_entry, rom_meaning};

/// Two products of k + 2 by k + 2 bits for each step.
constexpr int64_t logic_bits(const Design& d, int) {
  const int64_t bits = reciprocal_working_bits(d);
  return int64_t{2} * d.reciprocal_newton_steps * bits * bits;
}

inline constexpr Scheme kScheme{
    ReciprocalScheme::kNewton, "newton",    "NEWTON",       true,      true,       true, cycles,
    serial_setup_steps,        error_bound, invalid_reason, constants, logic_bits, kRom};

}  // namespace newton
}  // namespace pineda::spec
