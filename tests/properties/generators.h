// Triangles and meshes for properties: rapidcheck makes them, and makes them smaller when one
// fails.
#pragma once

#include <rapidcheck.h>

#include <ostream>
#include <vector>

#include "tests/core/support.h"

namespace pineda::properties {

using test::Point;

/// A triangle of one class, and the frame to draw it in.
struct Figure {
  test::Shape shape;
  spec::FrameState frame;
  spec::Triangle t;
};
std::ostream& operator<<(std::ostream& to, const Figure& figure);

/// Any of the six classes; those of small triangles lie anywhere in the greatest frame.
rc::Gen<Figure> figure();
/// The same, all in a small window.
rc::Gen<Figure> figure_in_window();

/// n from -reach to reach; becomes 0 when it shrinks.
rc::Gen<int> offset(int reach);

/// Triangles that fill a rectangle around the window without gaps, in any winding.
struct Mesh {
  std::vector<spec::Triangle> triangles;
};
std::ostream& operator<<(std::ostream& to, const Mesh& mesh);
rc::Gen<Mesh> mesh();

/// Is p inside the triangle (+1), on its border (0), or outside (-1)?
int side(const spec::Triangle& t, Point p);

/// A covered sample and its values.
struct Sample {
  int x = 0;
  int y = 0;
  uint32_t z = 0;
  spec::Attributes attr{};
};
inline bool same_place(const Sample& a, const Sample& b) { return a.x == b.x && a.y == b.y; }
inline bool same(const Sample& a, const Sample& b) {
  return same_place(a, b) && a.z == b.z && a.attr == b.attr;
}
/// The samples of a triangle as core draws it, in the unit's order.
std::vector<Sample> samples(const spec::FrameState& frame, const spec::Triangle& t);
/// Sorts by place, row by row.
void sort(std::vector<Sample>* samples);

/// The samples of a triangle before and after a move, of those that the frame shows both times;
/// given at their places after the move, sorted.
struct Moved {
  std::vector<Sample> before, after;
};
/// Moves by (dx, dy) px. A move out of the guard band is discarded as a case.
Moved move(const Figure& figure, int dx, int dy);

}  // namespace pineda::properties
