// Points on the subpixel grid, and a generator of random ones, for building figures.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "model/spec/design.h"
#include "model/spec/random.h"

namespace pineda::figures {

/// A point or vector in subpixels.
struct Point {
  int64_t x = 0;
  int64_t y = 0;
};
constexpr Point operator+(Point p, Point q) { return {p.x + q.x, p.y + q.y}; }
constexpr Point operator-(Point p, Point q) { return {p.x - q.x, p.y - q.y}; }
constexpr Point operator*(int64_t k, Point p) { return {k * p.x, k * p.y}; }
/// Rounds towards zero.
constexpr Point operator/(Point p, int64_t k) { return {p.x / k, p.y / k}; }
constexpr bool operator==(Point p, Point q) { return p.x == q.x && p.y == q.y; }

/// The corners of a triangle.
using Corners = std::array<Point, 3>;
/// The corners of a quad, in order around it.
using Quad = std::array<Point, 4>;

/// The subpixel grid of a design; all lengths in subpixels.
class Lattice {
 public:
  explicit constexpr Lattice(const spec::Design& design)
      : px_(int64_t{1} << design.subpixel_bits),
        tile_(px_ << design.tile_log2),
        greatest_((px_ << design.guard_bits) - 1) {}

  constexpr int64_t px() const { return px_; }
  constexpr int64_t half() const { return px_ / 2; }
  constexpr int64_t tile() const { return tile_; }
  /// The least and the greatest coordinate of the guard band.
  constexpr int64_t least() const { return -greatest_ - 1; }
  constexpr int64_t greatest() const { return greatest_; }
  /// The sample of pixel (i, j).
  constexpr Point center(int64_t i, int64_t j) const {
    return px_ * Point{i, j} + Point{half(), half()};
  }

 private:
  int64_t px_;
  int64_t tile_;
  int64_t greatest_;
};

/// Draws random points, x before y, clamped to the guard band.
class Pen : public Lattice {
 public:
  Pen(const spec::Design& design, uint64_t seed) : Lattice(design), random_(seed) {}

  spec::Random& random() { return random_; }

  /// A point in a box, borders included.
  Point in_box(Point low, Point high) {
    const int64_t x = random_.between(low.x, high.x);
    return kept({x, random_.between(low.y, high.y)});
  }
  /// A point in the square of half side `reach` around p.
  Point near(Point p, int64_t reach) {
    return in_box(p - Point{reach, reach}, p + Point{reach, reach});
  }
  /// The sample of a pixel in a box of pixels.
  Point center_in_box(Point low_px, Point high_px) {
    const int64_t i = random_.between(low_px.x, high_px.x);
    return center(i, random_.between(low_px.y, high_px.y));
  }

 private:
  Point kept(Point p) const {
    return {std::clamp(p.x, least(), greatest()), std::clamp(p.y, least(), greatest())};
  }

  spec::Random random_;
};

}  // namespace pineda::figures
