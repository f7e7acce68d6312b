// Six classes of random triangles: what errors and coverage are measured on.
#pragma once

#include <array>
#include <cstdint>
#include <random>

#include "model/spec/random.h"
#include "model/spec/structs.h"

namespace pineda::studies {

/// The figures in docs/ were drawn with this engine.
using Random = spec::RandomFrom<std::mt19937_64>;

/// A position in subpixels of 2^-8 px.
struct Point {
  int x;
  int y;
};

/// Classes of random triangles; 8 subpixel bits, a guard band of 2^14 px.
enum class Shape {
  k16Px,       // anywhere in the greatest frame and over its borders
  k256Px,      // around the window
  k8192Px,     // an edge crosses the window
  kGuardBand,  // the same, corners anywhere in the guard band
  kNeedle,     // the same, 100-8000 px long, 1/16-2 px wide
  kSliver,     // doubled area of 1 to 4 units, a vertex on a pixel centre
};
inline constexpr std::array<Shape, 6> kShapes = {Shape::k16Px,      Shape::k256Px,  Shape::k8192Px,
                                                 Shape::kGuardBand, Shape::kNeedle, Shape::kSliver};
/// "16 px", "256 px", "8192 px", "guard band", "needles", "slivers".
const char* shape_name(Shape shape);

/// The frame that a class is drawn in: the greatest one, which is too large to allocate, or a small
/// window whose borders cut tiles and stamps.
spec::FrameState frame_of(Shape shape);
spec::Triangle random_triangle(Random& random, Shape shape);

/// A triangle whose values are all 0.
spec::Triangle triangle(Point a, Point b, Point c);

/// Gives each vertex a depth of 24.8 bits and colours of 8: each an extreme or any value.
void randomize_values(Random& random, spec::Triangle* t);

/// d and w with cross(d, w) = 1, d of at most `reach` subpixels a side.
struct Lattice {
  Point d;
  Point w;
};
Lattice unit_lattice(Random& random, int reach);

}  // namespace pineda::studies
