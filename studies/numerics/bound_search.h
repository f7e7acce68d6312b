// A directed search for a design's worst triangle, to test its derived error bounds.
#pragma once

#include <cstdint>

#include "model/spec/bounds.h"
#include "studies/numerics/random_triangles.h"

namespace pineda::studies {

enum class Value { kDepth, kColor };

/// A triangle, one of its samples, and the error there.
struct WorstCase {
  spec::Triangle triangle;
  int x = 0;  // px
  int y = 0;
  /// |value before the final rounding - exact|, ulp or LSB; less than 0 where it is not covered.
  double error = -1;
};

/// Error before the final rounding at the sample of pixel (x, y), in a frame of the greatest size.
double error_before_rounding(const spec::Contract& contract, Value value,
                             const spec::Triangle& triangle, int x, int y);

/// Hill climbing from `starts` triangles as large as the guard band. The sample lies in the corner
/// opposite to the anchor, where each term of the bound is largest. Attributes have 8 bits.
///
/// In       a design with planes of depth, or of attributes.
WorstCase search_worst(const spec::Contract& contract, Value value, int starts, int steps,
                       uint64_t seed);

}  // namespace pineda::studies
