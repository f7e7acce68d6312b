// Measures every reciprocal scheme's error on every mantissa that it distinguishes.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "model/spec/design.h"

namespace pineda::studies {

/// The greatest relative error of a reciprocal, and where.
struct ReciprocalError {
  double error = 0;
  int64_t area2 = 0;
  bool exhaustive = false;  // every mantissa was tried
  double good_bits() const;
};

/// Tries each mantissa of k+2 bits, with the bits below all 0 and all 1; in between the error is
/// monotonic. If there are more than `most`: those near the ends of each ROM cell, and others
/// evenly spread.
ReciprocalError reciprocal_error(const spec::Design& design, int64_t most);

/// A scheme as the study lists it, and what a prototype in software measured.
struct ReciprocalRow {
  const char* name;
  spec::Design design;
  double prototype_good_bits;
};
std::vector<ReciprocalRow> reciprocal_rows();

}  // namespace pineda::studies
