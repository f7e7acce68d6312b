// What the reciprocal ROM holds.
#pragma once

#include <algorithm>

#include "model/spec/design.h"
#include "model/spec/fixed.h"

namespace pineda::spec {

/// Bits of an entry; its value has an implied leading 1: (2^bits + entry) / 2^(bits+1), in [1/2,
/// 1).
constexpr int reciprocal_rom_bits(const Design& d) { return d.reciprocal_lut_bits + 1; }

/// First guess of 1/(2m) for m = 0.1iiiiiii..., i = `index`: the constant that halves the relative
/// error over the interval, 1/(m_low + m_high), to the nearest. |relative error| < 2^-lut_bits
/// / 1.7.
constexpr int64_t reciprocal_rom(const Design& d, int index) {
  const int l = d.reciprocal_lut_bits;
  // (m_low + m_high) * 2^(l+1)
  const int64_t denominator = (int64_t{2} << l) + 1 + 2 * int64_t{index};
  const int64_t scaled = int64_t{1} << (2 * l + 3);
  return (2 * scaled + denominator) / (2 * denominator) - (int64_t{2} << l);
}

/// Fraction bits while a reciprocal is computed: two more than it has in the end.
constexpr int reciprocal_working_bits(const Design& d) { return d.reciprocal_bits + 2; }

/// Entry of the quadratic ROM, in units of 2^-(k+2): 1/(2m) = c0 - c1*t + c2*t^2 for
/// m = (2^l + index + t) / 2^(l+1), 0 <= t < 1.
struct Parabola {
  int64_t c0;
  int64_t c1;
  int64_t c2;
};

/// The parabola through 1/(2m) at t = 1/16, 1/2 and 15/16, its coefficients to the nearest. Before
/// they are rounded its error is below 2^-3l / 31: a sixth of the third derivative is at most 2^-3l
/// and |(t-1/16)(t-1/2)(t-15/16)| at most .0323; Chebyshev's three points would give .03125.
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
  // In the first interval c0 is just below 1: it must not round up to it.
  return {std::min(coefficient(16 * q * r + 16 * r + 128), (int64_t{1} << bits) - 1),
          coefficient(256 * r + 2304), coefficient(4096)};
}

/// Bits of its coefficients in the ROM, and of the whole entry. c0 lies in [1/2, 1): its leading 1
/// is implied. c1 < 2^-l and c2 < 2^-2l before they are rounded, but in a long table they round up
/// to it; both are greatest in the first interval.
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

}  // namespace pineda::spec
