// The triangles that the benchmarks draw: the same on every machine.
#pragma once

#include <string>
#include <vector>

#include "model/fast/triangle_list.h"
#include "model/scene/screen.h"
#include "model/spec/design.h"

namespace pineda::bench {

inline constexpr int kWidth = 1920;   // px
inline constexpr int kHeight = 1080;  // px

/// The built-in scenes: those that are drawn at random, and bunny, a mesh that is read from a file.
const std::vector<std::string>& scene_names();

/// The file of a scene that is a mesh; empty for the others.
std::string file_of(const std::string& scene);

/// The triangles of a built-in scene, or of a mesh's file, framed.
///
/// Out      x, y inside the frame, multiples of 2^-S px; z in [0, 1), multiples of 2^-24; w = 1, so
///          that nothing is left to round or to clip. Triangles wind both ways.
/// Errors   scene::InputError for a mesh that cannot be read.
std::vector<scene::ScreenTriangle> triangles_of(const spec::Contract& contract,
                                                const std::string& scene);

/// The state in which they are drawn: the frame, without culling, depth less.
spec::FrameState frame_state();

/// The triangles as the model takes them.
fast::TriangleList snapped(const spec::Contract& contract,
                           const std::vector<scene::ScreenTriangle>& triangles);

}  // namespace pineda::bench
