// Triangle setup, quickly.
#pragma once

#include "model/core/setup.h"

namespace pineda::fast {

/// What of a triangle is set up: always its box and edges, and of its planes none, depth's or all.
enum class Planes : uint8_t { kNone, kDepth, kAll };

/// Bits     those of core::setup(), of what is set up.
/// Out      *out when the result is kNone; the rest of it is of no use.
/// Drops    says why; *out is then of no use.
core::Drop setup(const spec::Contract& contract, const spec::FrameState& frame,
                 const spec::Triangle& triangle, spec::SetupPrim* out,
                 Planes planes = Planes::kAll);

}  // namespace pineda::fast
