// Piecewise quadratic approximation: a ROM of coefficients, a square, two products and a sum.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/spec/fixed.h"
#include "model/spec/reciprocal/scheme.h"

namespace pineda::spec {

/// Entry of the quadratic ROM, in units of 2^-(k+2): 1/(2m) = c0 - c1*t + c2*t^2 for
/// m = (2^l + index + t) / 2^(l+1), 0 <= t < 1.
struct Parabola {
  int64_t c0;
  int64_t c1;
  int64_t c2;
};

/// The parabola that equals 1/(2m) at t = 1/16, 1/2 and 15/16, coefficients rounded to the nearest.
/// Before that rounding its error is below 2^-3l / 31: a sixth of the third derivative is at most
/// 2^-3l, and |(t-1/16)(t-1/2)(t-15/16)| at most .0323. The Chebyshev points would give .03125.
constexpr Parabola reciprocal_parabola(const Design& d, int index) {
  const int l = d.reciprocal_lut_bits;
  const int bits = reciprocal_working_bits(d);
  // With a = 2^l + index, f(t) = 2^l / (a + t), in sixteenths at the three points. Divided
  // differences: f01 = -256*2^l / (p*q), f012 = 4096*2^l / (p*q*r).
  const int128_t a16 = ((int64_t{1} << l) + index) * int128_t{16};
  const int128_t p = a16 + 1;
  const int128_t q = a16 + 8;
  const int128_t r = a16 + 15;
  const auto coefficient = [&](int128_t numerator) {
    const int128_t denominator = p * q * r;
    return static_cast<int64_t>(((numerator << (l + bits + 1)) + denominator) / (2 * denominator));
  };
  // In the first interval c0 is just below 1 and must not round up to 1.
  return {std::min(coefficient(16 * q * r + 16 * r + 128), (int64_t{1} << bits) - 1),
          coefficient(256 * r + 2304), coefficient(4096)};
}

/// Widths of the coefficients in the ROM, and of a whole entry. c0 is in [1/2, 1), so its leading 1
/// is implied. Before rounding c1 < 2^-l and c2 < 2^-2l, but in large tables they can round up to
/// that. Both are greatest in entry 0, which therefore gives their widths.
constexpr int parabola_c0_bits(const Design& d) { return reciprocal_working_bits(d) - 1; }
constexpr int parabola_c1_bits(const Design& d) {
  return bit_length(static_cast<uint64_t>(reciprocal_parabola(d, 0).c1));
}
constexpr int parabola_c2_bits(const Design& d) {
  return bit_length(static_cast<uint64_t>(reciprocal_parabola(d, 0).c2));
}
constexpr int parabola_bits(const Design& d) {
  return parabola_c0_bits(d) + parabola_c1_bits(d) + parabola_c2_bits(d);
}

namespace quadratic {

/// As many cycles as a product to align the argument, then the square beside the coefficients,
/// products, and the sum.
constexpr int cycles(const Design&, int multiplier_stages) { return 1 + 3 * multiplier_stages; }

/// Products: the square of t, the linear term, the quadratic term.
constexpr int serial_setup_steps(const Design&) { return 3; }

/// The parabola: 2^-3l / 31. Rounded coefficients and truncated products: 6t. The truncated
/// argument and the last rounding: 6t, see Scheme::error_bound.
inline double error_bound(const Design& d) {
  const double t = std::exp2(-reciprocal_working_bits(d));
  return std::exp2(-3 * d.reciprocal_lut_bits) / 31 + 12 * t;
}

/// k must leave bits for c2, which has about k + 2 - 2*lut_bits of them.
inline std::string invalid_reason(const Design& d) {
  if (d.reciprocal_bits >= 2 * d.reciprocal_lut_bits) return {};
  return "reciprocal_bits must be at least 2*reciprocal_lut_bits in a quadratic reciprocal";
}

inline std::vector<Constant> constants(const Design& d) {
  return {{"RECIPROCAL_LUT_BITS", d.reciprocal_lut_bits, "index of the ROM"},
          {"RECIPROCAL_C0_BITS", parabola_c0_bits(d), "constant, leading 1 implied"},
          {"RECIPROCAL_C1_BITS", parabola_c1_bits(d), "coefficient of -t"},
          {"RECIPROCAL_C2_BITS", parabola_c2_bits(d), "coefficient of t^2"},
          {"RECIPROCAL_ROM_BITS", parabola_bits(d),
           "entry of the ROM: the three, the constant on top"}};
}

inline std::vector<RomPart> rom_entry(const Design& d, int index) {
  const Parabola c = reciprocal_parabola(d, index);
  const int64_t leading_one = int64_t{1} << parabola_c0_bits(d);
  return {{parabola_c0_bits(d), c.c0 - leading_one},
          {parabola_c1_bits(d), c.c1},
          {parabola_c2_bits(d), c.c2}};
}

inline std::string rom_meaning(const Design& d) {
  return "1/(2m) = c0 - c1*t + c2*t^2 in units of 2^-" +
         std::to_string(reciprocal_working_bits(d)) + ", m = 0.1<index><t>.";
}

inline constexpr ReciprocalRom kRom{parabola_bits, rom_entry, rom_meaning};

/// t * t, and the products with c1 and c2.
constexpr int64_t logic_bits(const Design& d, int) {
  const int64_t t = reciprocal_working_bits(d) - 1 - d.reciprocal_lut_bits;
  return t * (t + parabola_c1_bits(d) + parabola_c2_bits(d));
}

inline constexpr Scheme kScheme{
    ReciprocalScheme::kQuadratic, "quadratic", "QUADRATIC",    true,      false,      true, cycles,
    serial_setup_steps,           error_bound, invalid_reason, constants, logic_bits, kRom};

}  // namespace quadratic
}  // namespace pineda::spec
