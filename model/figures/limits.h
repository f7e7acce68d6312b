// Figures at limits: at the borders of the guard band and of tiles, thin triangles, and planes with
// integer coefficients. A figure is only positions on the subpixel grid.
#pragma once

#include <vector>

#include "model/figures/pen.h"

namespace pineda::figures {

/// The corners of the guard band.
constexpr Quad guard_band(const Lattice& lattice) {
  const int64_t low = lattice.least();
  const int64_t high = lattice.greatest();
  return {{{low, low}, {high, low}, {high, high}, {low, high}}};
}

/// Three consecutive corners of a quad.
constexpr Corners three_of(const Quad& quad, size_t first) {
  return {{quad[first % 4], quad[(first + 1) % 4], quad[(first + 2) % 4]}};
}

/// Points around the border of the guard band, `on_a_side` on each side, each moved along the
/// border by up to `jitter`.
std::vector<Point> guard_band_ring(Pen& pen, int on_a_side, int64_t jitter);

/// A triangle whose first edge runs from q + along to q - along.
constexpr Corners through(Point q, Point along, Point far) { return {{q + along, q - along, far}}; }

/// A point whose coordinates are extremes of the format or lie next to zero. Where bit 0 of
/// `quadrant` is clear x is mirrored, x -> -1 - x, which stays inside the guard band; bit 1
/// likewise for y.
Point extreme_corner(Pen& pen, int quadrant);

/// A coordinate on the border before tile `n`, or half a pixel before or after it.
int64_t tile_border(Pen& pen, int64_t n);

/// A long thin triangle, roughly along an axis: its small area must not increase any error.
struct Needle {
  int64_t length;  // along the axis
  int64_t across;  // offset of the far end across the axis
  int64_t width;   // across the axis, at the start
  bool is_steep;   // the axis is y

  constexpr Point along() const { return is_steep ? Point{across, length} : Point{length, across}; }
  constexpr Corners from(Point start) const {
    return {{start, start + along(), start + (is_steep ? Point{width, 0} : Point{0, width})}};
  }
};

/// A triangle with a right angle at `corner` and legs of equal length, to the right and down.
constexpr Corners right_angle(Point corner, int64_t leg) {
  return {{corner, corner + Point{leg, 0}, corner + Point{0, leg}}};
}

/// value = at_0 + x*dx + y*dy, exact in integers: all triangles on this plane must give the same
/// values, bit for bit.
struct WholePlane {
  int64_t at_0;
  int64_t dx;
  int64_t dy;

  constexpr int64_t at(Point p) const { return at_0 + dx * p.x + dy * p.y; }
};

}  // namespace pineda::figures
