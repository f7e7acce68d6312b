// Writes scenes as .tri: the text that TriReader reads back to the same bits.
#pragma once

#include <string>
#include <vector>

#include "model/scene/screen.h"

namespace pineda::scene {

/// The state lines, those first that every scene has.
std::string tri_state(const spec::FrameState& frame);
/// Three lines "v X Y Z W R G B A", in the shortest decimals that read back to the same binary32.
std::string tri_vertices(const ScreenTriangle& triangle);
/// A whole file.
std::string tri_text(const spec::FrameState& frame, const std::vector<ScreenTriangle>& triangles);

}  // namespace pineda::scene
