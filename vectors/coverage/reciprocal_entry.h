// Which entry of the reciprocal's table a number takes.
#pragma once

#include "model/spec/reciprocal/schemes.h"
#include "vectors/coverage/point.h"

namespace pineda::vectors {

/// A bin an entry; none for a scheme without a table.
inline Bins reciprocal_entries(const spec::Contract& c) {
  using spec::ReciprocalScheme;
  const auto scheme = c.design.reciprocal_scheme;
  const bool has_table =
      scheme == ReciprocalScheme::kNewton || scheme == ReciprocalScheme::kQuadratic;
  return where(has_table, numbered(0, (1 << c.design.reciprocal_lut_bits) - 1, "is taken"));
}

/// The entry, from 0: the bits behind the first one.
inline int reciprocal_entry(const spec::Contract& c, int64_t value) {
  const int bits = c.design.reciprocal_lut_bits;
  const int shift = length_of(value) - 1 - bits;
  const int64_t index = shift >= 0 ? value >> shift : value << -shift;
  return static_cast<int>(index & ((int64_t{1} << bits) - 1));
}

}  // namespace pineda::vectors
