// What the calls take: each value within its format. Throws Refused with the value's name.
#pragma once

#include "golden/call.h"
#include "model/exact/exact.h"
#include "model/scene/screen.h"
#include "model/spec/fields.h"

namespace pineda::golden {

/// A frame's raster state, for frames of up to 2^guard_bits px a side.
spec::FrameState frame_of(const pineda_frame* frame, int guard_bits, int depth_bits);
inline spec::FrameState frame_of(const pineda_frame* frame, const spec::Contract& contract) {
  return frame_of(frame, contract.design.guard_bits, contract.design.depth_bits);
}

spec::Triangle triangle_of(const spec::Contract& contract, const pineda_triangle& triangle);

/// Positions are within the guard band once they are snapped.
scene::ScreenTriangle screen_of(const exact::Format& format,
                                const pineda_screen_triangle& triangle);

/// Every field fits its bits, and the box is one of the frame.
spec::SetupPrim prim_of(const spec::Contract& contract, const pineda_setup_prim& prim);
/// Every field fits its bits, and a lane is covered.
spec::Stamp stamp_of(const spec::Contract& contract, const pineda_stamp& stamp);

/// Refuses a number outside [low, high].
void require(int64_t value, int64_t low, int64_t high, const char* name);
/// A lane's mask.
void require_lanes(const spec::Contract& contract, uint32_t mask);

}  // namespace pineda::golden
