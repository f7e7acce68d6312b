// What the contract says, in the terms of the exact judge, which knows nothing of the project.
#pragma once

#include "model/exact/exact.h"
#include "model/spec/structs.h"

namespace pineda::judge {

exact::Format format_of(const spec::Design& design);
exact::Frame exact_frame(const spec::FrameState& frame);

/// The judge of a snapped triangle, with its interpolated attributes; where shading is flat, those
/// of the first vertex. Depths without a bias.
exact::Judge exact_judge(const spec::Design& design, const spec::FrameState& frame,
                         const spec::Triangle& triangle);

}  // namespace pineda::judge
