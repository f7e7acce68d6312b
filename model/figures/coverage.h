// Figures that are hard to cover: which samples belong to a triangle. A figure is positions alone,
// on the lattice; who draws it adds depth, colours, and the order of the corners.
#pragma once

#include <vector>

#include "model/figures/pen.h"

namespace pineda::figures {

/// From corner to corner, the sides along the axes.
constexpr Quad rectangle(Point a, Point c) { return {{a, {c.x, a.y}, c, {a.x, c.y}}}; }

/// A quad cut along a diagonal: the one from its first corner, or the other. The diagonal is a
/// shared edge: its samples belong to one half.
constexpr std::array<Corners, 2> halves(const Quad& quad, bool from_first) {
  const auto& [a, b, c, e] = quad;
  return {{{{a, b, from_first ? c : e}}, {{from_first ? a : b, c, e}}}};
}

/// The quads of a mesh, row by row: every sample inside belongs to one. `corner(i, j)` is asked for
/// each corner of `columns` x `rows` quads once, row by row.
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

/// Points around a centre: one in each direction, `least` to `greatest` times as far.
std::vector<Point> ring(Pen& pen, Point center, const std::vector<Point>& directions, int64_t least,
                        int64_t greatest);

/// Triangles from a middle to a ring, all the way round: what is at the middle is hit once.
std::vector<Corners> fan(Point middle, const std::vector<Point>& ring);

/// An edge from `a` to `b` with a whole triangle on one side and two halves on the other, which
/// meet at the edge's middle, as it snaps: the crack is legal, and exact.
struct TJunction {
  Point a;
  Point b;
  Point whole;
  Point split;

  /// Down to the lattice, half a subpixel off the edge at the most in x and y.
  constexpr Point middle() const { return {(a.x + b.x) >> 1, (a.y + b.y) >> 1}; }
  constexpr std::array<Corners, 3> triangles() const {
    return {{{{a, b, whole}}, {{a, middle(), split}}, {{middle(), b, split}}}};
  }
};

/// x and y without a common factor, up to `reach`.
Point coprime(Pen& pen, int64_t reach);

/// w with cross(d, w) = 1; d coprime. Source: Bezout's identity, by Euclid's algorithm.
Point unit_partner(Point d);

/// A triangle of the doubled area |e1 - 2*e2| subpixels^2, about twice as long as the coprime
/// `along`, over a sample or close to it: the slivers that must draw what they cover.
Corners sliver(Point sample, Point along, int64_t e1, int64_t e2);

/// Nothing to draw: a point, two corners in one, a line through `p`.
constexpr Corners point(Point p) { return {{p, p, p}}; }
constexpr Corners doubled(Point p, Point q) { return {{p, p, q}}; }
constexpr Corners line(Point p, Point step) { return {{p, p + 2 * step, p - 3 * step}}; }

/// No sample in the box, though it may reach over the sample's row: all right of the sample, by a
/// pixel at the most.
Corners between_samples(Pen& pen, Point sample);

/// An equilateral triangle of a given circumscribed circle, on the lattice. Turned by a direction
/// that is stated without trigonometry, whose last bits differ among libraries: the tangent of half
/// the angle.
Corners equilateral(const Lattice& lattice, double x_px, double y_px, double radius_px,
                    double half_angle_tangent);

/// Three points of a box, of a square.
Corners within(Pen& pen, Point low, Point high);
Corners around(Pen& pen, Point p, int64_t reach);

}  // namespace pineda::figures
