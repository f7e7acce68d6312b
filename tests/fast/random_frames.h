// Frames of random triangles, drawn by core and by fast.
#pragma once

#include <string>

#include "model/spec/random.h"
#include "model/spec/structs.h"

namespace pineda::test {

/// Up to 90 x 70 px, any state.
spec::FrameState random_frame(spec::Random* random);

/// From needles that wrap their gradients to triangles over the whole guard band.
spec::Triangle random_triangle(const spec::Contract& contract, const spec::FrameState& frame,
                               spec::Random* random);

/// Draws a frame stamp by stamp with one design, and quickly with the other. What differs first, a
/// counter or a memory; empty if nothing does. Adds the samples that passed to *drawn.
std::string compare(const spec::Contract& contract, const spec::Contract& of_tiles, uint64_t seed,
                    uint64_t* drawn);

}  // namespace pineda::test
