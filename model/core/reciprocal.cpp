#include "model/core/reciprocal.h"

#include <algorithm>

#include "model/spec/reciprocal/schemes.h"

namespace pineda::core {

using spec::Design;
using spec::int128_t;
using spec::ReciprocalScheme;

namespace {

// In newton() and quadratic() m and 1/(2m) are fractions of `bits` bits, m in [1/2, 1).

int64_t low_bits(int64_t value, int bits) { return value & ((int64_t{1} << bits) - 1); }

int64_t newton(const Design& d, int64_t m, int bits) {
  const int64_t index = low_bits(m >> (bits - 1 - d.reciprocal_lut_bits), d.reciprocal_lut_bits);
  const int rom_bits = spec::reciprocal_rom_bits(d);
  const int64_t entry = spec::reciprocal_rom(d, static_cast<int>(index));
  int64_t x = ((int64_t{1} << rom_bits) + entry) << (bits - rom_bits - 1);
  for (int i = 0; i < d.reciprocal_newton_steps; ++i) {
    // 2 - 2mx in UQ1.bits, then the product; both truncated.
    const auto mx2 = static_cast<int64_t>((int128_t{m} * x) >> (bits - 1));
    x = static_cast<int64_t>((int128_t{x} * ((int64_t{2} << bits) - mx2)) >> bits);
  }
  return x;
}

int64_t quadratic(const Design& d, int64_t m, int bits) {
  const int t_bits = bits - 1 - d.reciprocal_lut_bits;
  const int64_t index = low_bits(m >> t_bits, d.reciprocal_lut_bits);
  const int64_t t = low_bits(m, t_bits);
  const spec::Parabola c = spec::reciprocal_parabola(d, static_cast<int>(index));
  const int64_t square = (t * t) >> t_bits;
  return c.c0 - ((c.c1 * t) >> t_bits) + ((c.c2 * square) >> t_bits);
}

// 1/(2m) truncated to k+1 bits, from all bits of m. Its first bit is always 1 unless area2 is a
// power of two, so a restoring divider has k bits left to find.
int64_t quotient(const Design& d, int64_t area2, int length) {
  return static_cast<int64_t>((int128_t{1} << (length + d.reciprocal_bits)) / area2);
}

}  // namespace

Reciprocal reciprocal(const spec::Contract& c, int64_t area2) {
  const Design& d = c.design;
  const int length = spec::bit_length(static_cast<uint64_t>(area2));
  const int64_t limit = (int64_t{1} << d.reciprocal_bits) - 1;
  if (d.reciprocal_scheme == ReciprocalScheme::kRestoring2 ||
      d.reciprocal_scheme == ReciprocalScheme::kRestoring4) {
    return {std::min(spec::round_half_up(quotient(d, area2, length), 1), limit), length};
  }
  const int bits = spec::reciprocal_working_bits(d);
  const int64_t m = length <= bits ? area2 << (bits - length) : area2 >> (length - bits);
  const int64_t x = d.reciprocal_scheme == ReciprocalScheme::kQuadratic ? quadratic(d, m, bits)
                                                                        : newton(d, m, bits);
  return {std::min(spec::round_half_up(x, 2), limit), length};
}

}  // namespace pineda::core
