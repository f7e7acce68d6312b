// Converts the project's types to those of model/exact, which includes nothing of the project.
#pragma once

#include "model/exact/exact.h"
#include "model/spec/structs.h"

namespace pineda::judge {

exact::Format format_of(const spec::Design& design);
exact::Frame exact_frame(const spec::FrameState& frame);

/// The judge of a snapped triangle and its interpolated attributes; with flat shading all vertices
/// get those of the first. Depths are judged without a bias.
exact::Judge exact_judge(const spec::Design& design, const spec::FrameState& frame,
                         const spec::Triangle& triangle);

}  // namespace pineda::judge
