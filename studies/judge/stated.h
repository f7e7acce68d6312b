// A triangle as a scene states it, for the exact judge.
#pragma once

#include "model/exact/exact.h"
#include "model/scene/screen.h"

namespace pineda::studies {

inline exact::ScreenTriangle stated(const scene::ScreenTriangle& triangle) {
  exact::ScreenTriangle result;
  for (size_t i = 0; i < 3; ++i) {
    const scene::ScreenVertex& v = triangle.v[i];
    result[i] = {v.x, v.y, v.z, v.w, {v.rgba[0], v.rgba[1], v.rgba[2], v.rgba[3]}};
  }
  return result;
}

}  // namespace pineda::studies
