#include "model/fast/reciprocal.h"

#include <algorithm>
#include <array>

#include "model/fast/lanes.h"
#include "model/spec/reciprocal/schemes.h"

namespace pineda::fast {

using spec::Design;
using spec::int128_t;
using spec::ReciprocalScheme;

namespace {

// In newton() and quadratic() m and 1/(2m) are fractions of `bits` bits, m in [1/2, 1).

// a * b / 2^bits, rounded down; 0 <= a, b < 2^(bits + 1). Takes the upper word of a pre-shifted
// product, which saves a two-word shift by a variable number of bits.
PINEDA_INLINE int64_t product(int64_t a, int64_t b, int bits) {
  const auto raised = static_cast<uint64_t>(b) << (63 - bits);
  return static_cast<int64_t>((int128_t{static_cast<uint64_t>(2 * a)} * raised) >> 64);
}

int64_t low_bits(int64_t value, int bits) { return value & ((int64_t{1} << bits) - 1); }

// The ROMs of every size, each entry with its leading 1. The ROM of l index bits begins at 2^l, so
// the top l + 1 bits of m, the first of which is 1, are the index of its first guess.
constexpr int kMaxLutBits = 12;  // of a valid design
constexpr std::array<uint16_t, 2 << kMaxLutBits> make_roms() {
  std::array<uint16_t, 2 << kMaxLutBits> roms{};
  for (int l = 1; l <= kMaxLutBits; ++l) {
    Design d;
    d.reciprocal_lut_bits = l;
    const int64_t leading = int64_t{1} << spec::reciprocal_rom_bits(d);
    const auto begin = size_t{1} << l;
    for (size_t i = 0; i < begin; ++i) {
      const int64_t entry = spec::reciprocal_rom(d, static_cast<int>(i));
      roms[begin + i] = static_cast<uint16_t>(leading + entry);
    }
  }
  return roms;
}
constexpr auto kRoms = make_roms();

PINEDA_INLINE int64_t newton(const Design& d, int64_t m, int bits) {
  const int64_t guess = kRoms[static_cast<size_t>(m >> (bits - 1 - d.reciprocal_lut_bits))];
  int64_t x = guess << (bits - spec::reciprocal_rom_bits(d) - 1);
  for (int i = 0; i < d.reciprocal_newton_steps; ++i) {
    // 2 - 2mx in UQ1.bits, then the product; both truncated.
    const int64_t mx2 = product(2 * m, x, bits);
    x = product(x, (int64_t{2} << bits) - mx2, bits);
  }
  return x;
}

[[gnu::noinline]] int64_t quadratic(const Design& d, int64_t m, int bits) {
  const int t_bits = bits - 1 - d.reciprocal_lut_bits;
  const int64_t index = low_bits(m >> t_bits, d.reciprocal_lut_bits);
  const int64_t t = low_bits(m, t_bits);
  const spec::Parabola c = spec::reciprocal_parabola(d, static_cast<int>(index));
  const int64_t square = (t * t) >> t_bits;
  return c.c0 - ((c.c1 * t) >> t_bits) + ((c.c2 * square) >> t_bits);
}

// 1/(2m) with k+1 bits, from all bits of m: as many bits as a restoring divider finds in k steps,
// since the first one is known.
[[gnu::noinline]] int64_t quotient(const Design& d, int64_t area2, int length) {
  return static_cast<int64_t>((int128_t{1} << (length + d.reciprocal_bits)) / area2);
}

}  // namespace

PINEDA_KERNEL(core::Reciprocal, reciprocal, (const spec::Contract& c, int64_t area2), (c, area2)) {
  const Design& d = c.design;
  const int length = spec::bit_length(static_cast<uint64_t>(area2));
  const int64_t limit = (int64_t{1} << d.reciprocal_bits) - 1;
  if (d.reciprocal_scheme == ReciprocalScheme::kRestoring2 ||
      d.reciprocal_scheme == ReciprocalScheme::kRestoring4) {
    return {std::min(spec::round_half_up(quotient(d, area2, length), 1), limit), length};
  }
  const int bits = spec::reciprocal_working_bits(d);
  // Shifts in two steps, so that 0 works: area2 is a sum of weights that may all be 0.
  const uint64_t leading = static_cast<uint64_t>(area2) << (63 - length) << 1;
  const auto m = static_cast<int64_t>(leading >> (64 - bits));
  const int64_t x = d.reciprocal_scheme == ReciprocalScheme::kQuadratic ? quadratic(d, m, bits)
                                                                        : newton(d, m, bits);
  return {std::min(spec::round_half_up(x, 2), limit), length};
}

}  // namespace pineda::fast
