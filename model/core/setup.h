// Triangle setup: one snapped triangle in, three edge functions and the planes out.
#pragma once

#include <iterator>

#include "model/spec/structs.h"

namespace pineda::core {

/// Why setup drops a triangle. If several causes apply, the first in this order is reported.
enum class Drop : uint8_t {
  kNone,
  kZeroArea,  // area2 = 0 after snapping
  kFacing,    // culled by the frame's cull state; front = counter-clockwise on screen
  kNoSample,  // its box holds no pixel centre
  kOutside,   // its box lies outside the frame or the scissor
};

struct DropName {
  Drop value;
  const char* word;
  const char* spoken;
};
inline constexpr DropName kDropNames[] = {
    {Drop::kNone, "kept", ""},
    {Drop::kZeroArea, "zero_area", "zero area"},
    {Drop::kFacing, "facing", "facing"},
    {Drop::kNoSample, "no_sample", "no sample"},
    {Drop::kOutside, "outside", "outside"},
};
constexpr const auto& names(Drop) { return kDropNames; }
inline constexpr int kDropCauses = std::size(kDropNames);

/// "zero area", "facing", "no sample", "outside"; "" for kNone.
constexpr const char* drop_name(Drop drop) { return spec::row_of(drop).spoken; }

/// Sets a triangle up.
///
/// Bits     the definition of every output bit of setup.
/// In       a triangle with vertices inside the guard band; the frame's state.
/// Out      *out when the result is kNone: canonical order (clockwise from the topmost, then
///          leftmost vertex), edges and planes at the first sample of the box's first tile. Flat
///          shading gives the attributes of the scene's vertex 0 to all three. A design without a
///          reciprocal has no planes here: see exact_planes.h.
/// Drops    for the reason that it returns; *out is then unchanged.
/// Errors   none: every intermediate fits by widths(), and what may wrap wraps by design.
/// Twin     rtl/setup/setup_unit.sv.
/// Source   Pineda, SIGGRAPH 1988; Direct3D 11.3 functional spec 3.4.2.1 (top-left).
Drop setup(const spec::Contract& contract, const spec::FrameState& frame,
           const spec::Triangle& triangle, spec::SetupPrim* out);

}  // namespace pineda::core
