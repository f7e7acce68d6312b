// What the reciprocal ROM holds.
#pragma once

#include "model/spec/design.h"

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

}  // namespace pineda::spec
