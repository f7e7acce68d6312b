// Designs and triangles at the limits of setup's numbers.
#pragma once

#include <vector>

#include "tests/core/support.h"

namespace pineda::test {

/// high_tile with other formats.
spec::Design variant(const char* name, int subpixel_bits, int attribute_bits, int attributes,
                     int reciprocal_bits);

/// At, and beyond, what words hold; groups of attributes that are not full; every reciprocal.
std::vector<spec::Design> limit_designs();

/// Corners at a border of the guard band, anywhere in it, or near one sample; values at an end of
/// their range, or any.
spec::Triangle hard_triangle(Random& random, const spec::Design& design);

/// As large as the guard band; culling, shading and scissors of every kind.
spec::FrameState hard_frame(Random& random, const spec::Design& design);

}  // namespace pineda::test
