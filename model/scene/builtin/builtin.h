// The built-in scenes. They give the same triangles on every machine and in every run.
#pragma once

#include <cstdint>
#include <vector>

#include "model/scene/mesh.h"
#include "model/scene/screen.h"

namespace pineda::scene {

/// The Utah teapot: 32 bicubic patches of n x n quads. It has 64*n*n - 8*n triangles, since each of
/// the 8 patches that end in the middle of the lid or of the bottom has n triangles without area.
/// Out      outside counter-clockwise, y up, spout at +x; adjacent patches share bit-identical
///          vertex positions.
Mesh teapot(int n);

/// One triangle, red, green and blue, over most of the frame.
std::vector<ScreenTriangle> single_triangle(int width, int height);

/// A jittered grid of triangles, larger than the frame, with random winding and vertex order: each
/// sample is covered exactly once.
std::vector<ScreenTriangle> jittered_grid(int width, int height);

/// Eight such grids, each in its own slice of the depth range, drawn in mixed depth order: each
/// sample is covered eight times.
std::vector<ScreenTriangle> layered_grids(int width, int height);

/// A scene of random triangles, all of one area or of the frame's size, with random positions,
/// depths and colours.
struct RandomScene {
  const char* name;  // after random/
  const char* summary;
  int triangles;
  float area_px;  // px^2; 0: the corners lie anywhere in the frame, the area is 1/8 of it or more
  float length_px = 0;  // of a needle, from its point to the middle of its short side
};
inline constexpr RandomScene kRandomScenes[] = {
    {"px1", "50,000 random triangles of 1 px", 50'000, 1},
    {"px1000", "5,000 random triangles of 1,000 px", 5'000, 1000},
    {"screen", "200 random triangles of an eighth of the frame and more", 200, 0},
    {"needle", "2,000 random needles of 256 px by 2 px, in any direction", 2'000, 256, 256}};

/// But for needles there are no slivers: a triangle's area is at least an eighth of its bounding box.
std::vector<ScreenTriangle> random_triangles(const RandomScene& scene, int width, int height,
                                             uint64_t seed);

}  // namespace pineda::scene
