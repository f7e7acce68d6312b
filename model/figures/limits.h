// Figures at limits: of the guard band, of tiles, of what setup divides by, and planes that are
// whole numbers. A figure is positions alone, on the lattice.
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

/// Three corners of a quad one after the other.
constexpr Corners three_of(const Quad& quad, size_t first) {
  return {{quad[first % 4], quad[(first + 1) % 4], quad[(first + 2) % 4]}};
}

/// Points on the border of the guard band all the way round, `on_a_side` on each side, moved on by
/// up to `jitter` each.
std::vector<Point> guard_band_ring(Pen& pen, int on_a_side, int64_t jitter);

/// A triangle whose first edge runs through `q`, `along` to either side.
constexpr Corners through(Point q, Point along, Point far) { return {{q + along, q - along, far}}; }

/// Coordinates that are the format's extremes or lie next to zero. Bit 0 of `quadrant` unset turns
/// the sign of x, bit 1 that of y, inside the guard band: -1 - least is the greatest.
Point extreme_corner(Pen& pen, int quadrant);

/// A coordinate on the border before tile `n`, or half a pixel to either side.
int64_t tile_border(Pen& pen, int64_t n);

/// Long and thin, roughly along an axis: no term may grow as the area shrinks.
struct Needle {
  int64_t length;  // along the axis
  int64_t across;  // what the other end lies beside it
  int64_t width;   // across the axis, at the start
  bool is_steep;   // the axis is y

  constexpr Point along() const { return is_steep ? Point{across, length} : Point{length, across}; }
  constexpr Corners from(Point start) const {
    return {{start, start + along(), start + (is_steep ? Point{width, 0} : Point{0, width})}};
  }
};

/// A right angle at `corner`, both legs of one length, to the right and down.
constexpr Corners right_angle(Point corner, int64_t leg) {
  return {{corner, corner + Point{leg, 0}, corner + Point{0, leg}}};
}

/// value = at_0 + x*dx + y*dy exactly: triangles on one plane are equal to the last bit.
struct WholePlane {
  int64_t at_0;
  int64_t dx;
  int64_t dy;

  constexpr int64_t at(Point p) const { return at_0 + dx * p.x + dy * p.y; }
};

}  // namespace pineda::figures
