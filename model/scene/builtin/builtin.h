// The scenes that need no file. The same triangles on every machine and every run.
#pragma once

#include <cstdint>
#include <vector>

#include "model/scene/mesh.h"
#include "model/scene/screen.h"

namespace pineda::scene {

/// The Utah teapot: 32 bicubic patches, each of n x n quads; 64*n*n - 8*n triangles, because the
/// patches that meet in the middle of the lid and of the bottom lose a row of n.
/// Out      outside counter-clockwise, y up, spout at +x; vertices of neighbours bit-identical.
Mesh teapot(int n);

/// One triangle, red, green and blue, over most of the frame.
std::vector<ScreenTriangle> single_triangle(int width, int height);

/// A jittered grid of triangles in any winding and vertex order that reaches over the frame: each
/// sample is covered exactly once.
std::vector<ScreenTriangle> jittered_grid(int width, int height);

/// Eight such grids, each in a slice of the depth range of its own, neither from the front nor from
/// the back: each sample is covered eight times.
std::vector<ScreenTriangle> layered_grids(int width, int height);

/// What a random scene draws: so many triangles, of one area or of the frame's size, each anywhere
/// in the frame, at random depths in random colours.
struct RandomScene {
  const char* name;  // after random/
  const char* summary;
  int triangles;
  float area_px;  // 0: the corners lie anywhere in the frame, an eighth of it covered at least
};
inline constexpr RandomScene kRandomScenes[] = {
    {"px1", "50,000 random triangles of 1 px", 50'000, 1},
    {"px1000", "5,000 random triangles of 1,000 px", 5'000, 1000},
    {"screen", "200 random triangles of an eighth of the frame and more", 200, 0}};

/// None of them is a sliver: its box is at most eight times its area.
std::vector<ScreenTriangle> random_triangles(const RandomScene& scene, int width, int height,
                                             uint64_t seed);

}  // namespace pineda::scene
