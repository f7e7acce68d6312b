// What depth is cleared to: a number from 0 to 1 in the frame's state, a code in a design's memory.
#pragma once

#include "model/spec/structs.h"

namespace pineda::spec {

/// floor(z * (2^depth_bits - 1) + 1/2) of the z that was given, in exact integers.
///
/// In       0 <= z <= 1, depth_bits up to 32.
/// Errors   std::invalid_argument: another z, NaN too.
uint32_t depth_code(double z, int depth_bits);

/// A z of this code: depth_code() of it is the code again. A binary32 has too few bits for all
/// codes of a design with more than 24.
double depth_of_code(uint32_t code, int depth_bits);

/// The code of a cleared sample; without depth in the design 0xFFFFFF.
uint32_t cleared_depth(const Design& design, const FrameState& frame);

}  // namespace pineda::spec
