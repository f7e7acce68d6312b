// The scenes that need no file. The same triangles on every machine and every run.
#pragma once

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

}  // namespace pineda::scene
