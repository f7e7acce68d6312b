// The coverage of setup that one bit alone decides.
#pragma once

#include "vectors/coverage/points.h"

namespace pineda::vectors {

/// Two vertices that differ in one bit of a coordinate alone, which moves the box.
Bins lone_bits(const spec::Contract& contract);
void see_lone_bits(const SeenTriangle& seen, Hits* hits);

/// Edges whose width or height is a power of two, where their direction hangs on it.
Bins powers_of_two(const spec::Contract& contract);
void see_powers_of_two(const SeenTriangle& seen, Hits* hits);

/// Sides of the box at a vertex on a row or column of samples, by the bits of its number.
Bins far_samples(const spec::Contract& contract);
void see_far_samples(const SeenTriangle& seen, Hits* hits);

}  // namespace pineda::vectors
