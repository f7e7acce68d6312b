// Fixed-point primitives. All wrapping, rounding and counting of bits in the project uses these.
#pragma once

#include <cstdint>

namespace pineda::spec {

__extension__ typedef __int128 int128_t;

/// Keeps the low `bits` bits of `value` and sign-extends them: two's-complement wrap-around.
/// 1 <= bits <= 64; exact for every value.
constexpr int64_t wrap(int64_t value, int bits) {
  return static_cast<int64_t>(static_cast<uint64_t>(value) << (64 - bits)) >> (64 - bits);
}

/// The same for a wide intermediate; the result must fit 64 bits.
constexpr int64_t wrap(int128_t value, int bits) { return wrap(static_cast<int64_t>(value), bits); }

/// value / 2^shift rounded to the nearest integer, halves towards +infinity; shift >= 0.
/// The error is at most half a unit. value + 2^(shift-1) must be representable.
template <class Integer>
constexpr Integer round_half_up(Integer value, int shift) {
  return shift == 0 ? value : (value + (Integer{1} << (shift - 1))) >> shift;
}

/// Number of bits that an unsigned value needs; 0 for 0.
constexpr int bit_length(uint64_t value) { return value == 0 ? 0 : 64 - __builtin_clzll(value); }

/// Least n with 2^n >= value, value >= 1.
constexpr int ceil_log2(uint64_t value) { return bit_length(value - 1); }

}  // namespace pineda::spec
