// Scenes of a few triangles in memory.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "model/scene/scene.h"

namespace pineda::studies {

inline constexpr std::array<uint8_t, 4> kRed = {255, 0, 0, 255};
inline constexpr std::array<uint8_t, 4> kBlue = {0, 0, 255, 255};

inline scene::Scene scene_of(std::vector<scene::ScreenTriangle> triangles,
                             const spec::FrameState& frame) {
  scene::Scene scene;
  scene.name = "small";
  scene.frame = frame;
  scene.source = std::make_unique<scene::SnappedSource>(
      spec::contract(spec::kHighTile), std::make_unique<scene::ListReader>(std::move(triangles)));
  return scene;
}

inline spec::FrameState frame_of(int width, int height) {
  spec::FrameState frame;
  frame.width = width;
  frame.height = height;
  return frame;
}

/// The left upper half of the square of `side` px at (x, y), of one depth and colour.
inline scene::ScreenTriangle half_square(float x, float y, float side, float z,
                                         const std::array<uint8_t, 4>& rgba) {
  scene::ScreenTriangle t;
  t.v[0] = {x, y, z, 1, rgba};
  t.v[1] = {x + side, y, z, 1, rgba};
  t.v[2] = {x, y + side, z, 1, rgba};
  return t;
}

/// Two of them, a constant colour each, that do not touch.
inline scene::Scene two_flat_triangles() {
  return scene_of({half_square(2, 2, 24, .25f, kRed), half_square(32, 4, 24, .5f, kBlue)},
                  frame_of(64, 40));
}

inline scene::Scene teapot(int width, int height, int tessellate = 10) {
  scene::Options options;
  options.tessellate = tessellate;
  options.size = scene::Size{width, height};
  return scene::open_scene(spec::contract(spec::kHighTile), "teapot", options);
}

}  // namespace pineda::studies
