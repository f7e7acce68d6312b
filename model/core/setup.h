// Triangle setup: one snapped triangle in, three edge functions and the planes out.
#pragma once

#include "model/spec/structs.h"

namespace pineda::core {

/// Why a triangle ends in setup. The first cause in this order counts.
enum class Drop : uint8_t {
  kNone,
  kZeroArea,  // area2 = 0 after snapping
  kFacing,    // culled by the frame's cull state; front = counter-clockwise on screen
  kNoSample,  // its box holds no pixel centre
  kOutside,   // its box lies outside the frame
};
inline constexpr int kDropCauses = 5;

/// "zero area", "facing", "no sample", "outside"; "" for kNone.
const char* drop_name(Drop drop);

/// 1/area2 = mantissa * 2^(1 - k - length); mantissa UQ0.k in [1/2, 1).
struct Reciprocal {
  int64_t mantissa;
  int length;  // bit_length(area2)
};

/// Bits     the definition: ROM, then Newton steps x <- 2x(1 - mx) in k+2 bits, truncated, and one
///          rounding to k bits, saturated at 1 - 2^-k.
/// In       area2, 0 < area2 < 2^(AREA2_BITS - 1).
/// Errors   none. |relative error| < 2^-29.41 for LUT7 + 2 Newton, k = 30: found over every
///          mantissa of 32 bits (tests/core/reciprocal_test.cpp).
Reciprocal reciprocal(const spec::Contract& contract, int64_t area2);

/// Bits     the definition of every output bit of setup.
/// In       a triangle with vertices inside the guard band; the frame's state.
/// Out      *out when the result is kNone: canonical order (topmost, then leftmost vertex first,
///          positive area), edges and planes at the first sample of the box's first tile.
/// Drops    says why, and leaves *out as it was.
/// Errors   none: every intermediate fits by widths(), and what may wrap wraps by design.
/// Twin     rtl/setup_unit.sv. Source: Pineda, SIGGRAPH 1988; Direct3D 11.3 spec 3.4.2.1
/// (top-left).
Drop setup(const spec::Contract& contract, const spec::FrameState& frame,
           const spec::Triangle& triangle, spec::SetupPrim* out);

}  // namespace pineda::core
