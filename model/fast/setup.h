// Triangle setup, quickly.
#pragma once

#include "model/core/setup.h"

namespace pineda::fast {

/// Which planes are set up, beside the box and the edges: none, depth's or all.
enum class Planes : uint8_t { kNone, kDepth, kAll };

/// Bits     those of core::setup(), of what is set up.
/// Out      *out when the result is kNone; planes that were not asked for have no meaning.
/// Drops    the result says why; *out then has no meaning.
core::Drop setup(const spec::Contract& contract, const spec::FrameState& frame,
                 const spec::Triangle& triangle, spec::SetupPrim* out,
                 Planes planes = Planes::kAll);

}  // namespace pineda::fast
