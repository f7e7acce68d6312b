// A scene as OpenGL is given it.
#pragma once

#include <cstdint>
#include <vector>

#include "model/scene/scene.h"

namespace pineda::llvmpipe {

struct Vertex {
  float position[4];  // in clip space
  uint8_t rgba[4];
};

/// A snapped triangle in clip space: row 0 at the top, depths from 0 to 1. llvmpipe snaps to 1/256 px
/// as well.
std::array<Vertex, 3> clip_vertices(const scene::Scene& scene, const spec::Triangle& triangle);

}  // namespace pineda::llvmpipe
