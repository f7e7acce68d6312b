// Restoring division: one or two bits of the quotient a cycle.
#pragma once

#include <cmath>

#include "model/spec/reciprocal/scheme.h"

namespace pineda::spec::restoring {

/// One cycle to align the argument, one for the quotient's first bit, and one for each digit of the
/// k bits that follow.
template <int RadixBits>
constexpr int cycles(const Design& d, int) {
  return 2 + (d.reciprocal_bits + RadixBits - 1) / RadixBits;
}

/// Steps in which serial setup waits for the divider, which runs from step 5 on without using the
/// multiplier. Planes could start in step 9 and need the mantissa 4 products later.
template <int RadixBits>
constexpr int serial_setup_steps(const Design& d) {
  const int wait = 5 + cycles<RadixBits>(d, 1) - 4 - 9;
  return wait > 0 ? wait : 0;
}

/// Only the last rounding: the divider uses all bits of the doubled area.
inline double error_bound(const Design& d) { return 4 * std::exp2(-reciprocal_working_bits(d)); }

inline std::string invalid_reason(const Design&) { return {}; }

template <int RadixBits>
std::vector<Constant> constants(const Design&) {
  return {{"RECIPROCAL_RADIX_BITS", RadixBits, "of the quotient a cycle"}};
}

/// One subtractor for each quotient bit of a cycle.
template <int RadixBits>
constexpr int64_t logic_bits(const Design&, int area2_bits) {
  return int64_t{area2_bits} * RadixBits;
}

template <int RadixBits>
constexpr Scheme scheme(ReciprocalScheme value, const char* word) {
  return {value,       word,           "RESTORING",          false,
          false,       false,          cycles<RadixBits>,    serial_setup_steps<RadixBits>,
          error_bound, invalid_reason, constants<RadixBits>, logic_bits<RadixBits>};
}

inline constexpr Scheme kScheme2 = scheme<1>(ReciprocalScheme::kRestoring2, "restoring2");
inline constexpr Scheme kScheme4 = scheme<2>(ReciprocalScheme::kRestoring4, "restoring4");

}  // namespace pineda::spec::restoring
