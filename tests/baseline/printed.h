// The algorithms as they are printed, faults included, to compare the mended ones of model/baseline
// with. As in Java, int wraps and (int) of a double truncates and saturates. Samples lie at whole
// pixels here, as on the slides.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/spec/structs.h"

namespace pineda::test::printed {

/// "6.837 Lecture 6", slide 11. Position in px.
struct Vertex2D {
  float x = 0;
  float y = 0;
  uint32_t argb = 0;
};
using Corners = std::array<Vertex2D, 3>;

/// A snapped triangle (S = 8), moved by half a pixel, so that samples are pixel centres.
Corners corners(const spec::Triangle& triangle);

/// A place in the raster as a program addresses it: pixel[row][column].
struct Pixel {
  int row;
  int column;
  bool operator==(const Pixel& p) const { return row == p.row && column == p.column; }
  bool operator<(const Pixel& p) const {
    return row < p.row || (row == p.row && column < p.column);
  }
};
using Pixels = std::vector<Pixel>;

/// Java's (int).
int32_t to_int(double value);

inline constexpr int kFractionBits = 12;

/// The edge equation object, after slide 12.
struct EdgeEqn {
  int32_t a = 0;
  int32_t b = 0;
  int32_t c = 0;
  int flag = 0;

  EdgeEqn() = default;
  EdgeEqn(const Vertex2D& v0, const Vertex2D& v1);
  void flip();
  int32_t evaluate(int x, int y) const;
};

/// C in binary32, slides 12 and 13.
float c_determinant(const Vertex2D& v0, const Vertex2D& v1);
float c_vertex(const Vertex2D& v0, const Vertex2D& v1);
float c_average(const Vertex2D& v0, const Vertex2D& v1);

/// triangleSetup, slide 18. The box is set when both indices are entries of the table, 0 to 5.
struct Setup {
  std::array<EdgeEqn, 3> edge;
  int32_t area = 0;
  int x_flag = 0;
  int y_flag = 0;
  int x_min = 0, x_max = 0, y_min = 0, y_max = 0;

  bool in_table() const { return x_flag >= 0 && x_flag < 6 && y_flag >= 0 && y_flag < 6; }
};
/// False for "degenerate triangle".
bool triangle_setup(const Corners& v, int width, int height, Setup* setup);

/// The same with the right box, to test what comes after the box; empty when degenerate.
Setup with_right_box(const Corners& v, int size_px);

/// Calls visit(x, y) for every `stride`-th pixel of the box.
template <class Visitor>
void for_each_pixel(const Setup& s, int stride, Visitor&& visit) {
  for (int y = s.y_min; y <= s.y_max; y += stride) {
    for (int x = s.x_min; x <= s.x_max; x += stride) visit(x, y);
  }
}

/// The draw loop of slide 16: every pixel that it writes, as it addresses it.
Pixels draw(const Setup& setup, int width);

/// The colour of the flat triangle's constructor, slide 14. It uses an undeclared `a`, taken as 0.
uint32_t flat_color(const Corners& v);

/// The plane equation of slide 24, A, B, C with 12 fraction bits: (int) as for the edges.
std::array<int32_t, 3> plane(const Corners& v, const std::array<int, 3>& value);

/// The inner loop of slide 29: four accumulators of 12 fraction bits to a pixel.
uint32_t smooth_color(int32_t a, int32_t r, int32_t g, int32_t b);
/// The index that it writes to: pixel[y*x], where y already includes the width.
int smooth_index(int x, int y, int width);

/// Edge walking, slide 8: rows and spans from the ceiling to the floor, both ends included.
Pixels edge_walk(const Corners& v);

/// "Triangles", the barycentric loop over [x_min, x_max] x [y_min, y_max], in doubles.
struct Range {
  int x_min, x_max, y_min, y_max;
};
/// The slides' conditions for drawing a sample: all three weights in [0, 1]; all three >= 0; all
/// three >= 0, and a sample on an edge belongs to the triangle on the side of the point r.
enum class Condition { kUnitInterval, kNotNegative, kOffScreenPoint };
Pixels barycentric(const Corners& v, const Range& range, Condition condition,
                   const Vertex2D& r = {-1, -1});

/// "Rasterization", 2006, appendix: s on the screen for t in space, and back.
double screen_share(double t, double w1, double w2);
double space_share(double s, double w1, double w2);

/// "Triangles", clipping against a plane: f(p) = N.(p - q), f(a)f(b) < 0 for a crossing, and the
/// share t of the way from a to b at which it lies.
using Vector = std::array<double, 3>;
double plane_side(const Vector& n, const Vector& q, const Vector& p);
bool crosses(double f_a, double f_b);
double crossing_share(const Vector& n, const Vector& q, const Vector& a, const Vector& b);

}  // namespace pineda::test::printed
