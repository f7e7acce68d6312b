// The clear depth: a number from 0 to 1 in the frame's state, a code in a design's memory.
#pragma once

#include "model/spec/structs.h"

namespace pineda::spec {

/// floor(z * (2^depth_bits - 1) + 1/2), in exact integers.
///
/// In       0 <= z <= 1, depth_bits up to 32.
/// Errors   std::invalid_argument: z outside that range, or NaN.
uint32_t depth_code(double z, int depth_bits);

/// A z for which depth_code() gives this code. A double, since a binary32 cannot tell all codes of
/// more than 24 bits apart.
double depth_of_code(uint32_t code, int depth_bits);

/// The depth code of a cleared sample; 0xFFFFFF for a design without depth.
uint32_t cleared_depth(const Design& design, const FrameState& frame);

}  // namespace pineda::spec
