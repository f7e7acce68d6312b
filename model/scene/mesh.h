// A triangle mesh in world space: right-handed, y up, outside counter-clockwise.
#pragma once

#include <cstdint>
#include <vector>

#include "model/scene/vec.h"

namespace pineda::scene {

using Rgba = std::array<uint8_t, 4>;

struct Mesh {
  std::vector<Vec3> position;
  std::vector<Vec3> normal;  // unit length, one a position
  std::vector<Rgba> color;   // one a position; empty: shaded from the normals
  bool is_lit = false;       // the colours are materials', shaded from the normals too
  std::vector<std::array<uint32_t, 3>> triangle;

  /// A triangle with a coordinate that is NaN or infinite cannot be projected.
  bool is_finite(const std::array<uint32_t, 3>& t) const {
    return scene::is_finite(position[t[0]]) && scene::is_finite(position[t[1]]) &&
           scene::is_finite(position[t[2]]);
  }
};

}  // namespace pineda::scene
