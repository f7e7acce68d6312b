// Figures that stress coverage: which samples belong to a triangle. A figure is only positions on
// the subpixel grid; the caller adds depth, colours and the order of the corners.
#pragma once

#include <vector>

#include "model/figures/pen.h"

namespace pineda::figures {

/// The axis-aligned rectangle with the opposite corners a and c.
constexpr Quad rectangle(Point a, Point c) { return {{a, {c.x, a.y}, c, {a.x, c.y}}}; }

/// A quad cut into two triangles, along the diagonal from its first corner or along the other one.
/// The diagonal is a shared edge: a sample on it belongs to exactly one half.
constexpr std::array<Corners, 2> halves(const Quad& quad, bool from_first) {
  const auto& [a, b, c, e] = quad;
  return {{{{a, b, from_first ? c : e}}, {{from_first ? a : b, c, e}}}};
}

/// The quads of a mesh of `columns` x `rows`, row by row: every sample inside belongs to exactly
/// one quad. Calls corner(i, j) once for each grid point, row by row.
template <class Corner>
std::vector<Quad> mesh(int columns, int rows, Corner corner) {
  std::vector<Point> above;
  std::vector<Quad> quads;
  for (int j = 0; j <= rows; ++j) {
    std::vector<Point> row;
    for (int i = 0; i <= columns; ++i) row.push_back(corner(i, j));
    for (size_t i = 1; j > 0 && i < row.size(); ++i) {
      quads.push_back({above[i - 1], above[i], row[i], row[i - 1]});
    }
    above = std::move(row);
  }
  return quads;
}

/// Points around a centre: one in each direction, at a random distance of `least` to `greatest`
/// times the direction's vector.
std::vector<Point> ring(Pen& pen, Point center, const std::vector<Point>& directions, int64_t least,
                        int64_t greatest);

/// A closed fan of triangles from a middle point to a ring: a sample at the middle is hit once.
std::vector<Corners> fan(Point middle, const std::vector<Point>& ring);

/// A T-junction on the edge from `a` to `b`: one triangle on one side, two on the other, which meet
/// at the snapped midpoint of the edge. Samples between edge and midpoint may be hit twice or not
/// at all; which ones is defined exactly.
struct TJunction {
  Point a;
  Point b;
  Point whole;
  Point split;

  /// The midpoint rounded down to the grid: at most half a subpixel off the edge in x and in y.
  constexpr Point middle() const { return {(a.x + b.x) >> 1, (a.y + b.y) >> 1}; }
  constexpr std::array<Corners, 3> triangles() const {
    return {{{{a, b, whole}}, {{a, middle(), split}}, {{middle(), b, split}}}};
  }
};

/// A random point whose x and y have no common factor and at most the magnitude `reach`.
Point coprime(Pen& pen, int64_t reach);

/// A vector w with cross(d, w) = 1, for d with coprime components. Source: Bezout's identity, by
/// Euclid's algorithm.
Point unit_partner(Point d);

/// A sliver of doubled area |e1 - 2*e2| subpixels^2, about twice as long as `along` (coprime
/// components), that passes over `sample` or close to it.
Corners sliver(Point sample, Point along, int64_t e1, int64_t e2);

/// Triangles without area: a point, two equal corners, a line through `p`.
constexpr Corners point(Point p) { return {{p, p, p}}; }
constexpr Corners doubled(Point p, Point q) { return {{p, p, q}}; }
constexpr Corners line(Point p, Point step) { return {{p, p + 2 * step, p - 3 * step}}; }

/// A triangle whose box contains no sample, though it may straddle the sample's row: it lies right
/// of the sample by at most one pixel.
Corners between_samples(Pen& pen, Point sample);

/// An equilateral triangle with a given circumscribed circle, snapped to the grid. The rotation is
/// given as the tangent of half the angle: sin and cos differ in their last bits among libraries.
Corners equilateral(const Lattice& lattice, double x_px, double y_px, double radius_px,
                    double half_angle_tangent);

/// A triangle with random corners in a box; in a square of half side `reach` around `p`.
Corners within(Pen& pen, Point low, Point high);
Corners around(Pen& pen, Point p, int64_t reach);

}  // namespace pineda::figures
