#include "model/figures/limits.h"

#include <algorithm>

namespace pineda::figures {

std::vector<Point> guard_band_ring(Pen& pen, int on_a_side, int64_t jitter) {
  const int64_t low = pen.least();
  const int64_t high = pen.greatest();
  const int64_t spacing = (high - low + 1) / on_a_side;
  std::vector<Point> ring;
  for (int i = 0; i < 4 * on_a_side; ++i) {
    const int64_t from = low + i % on_a_side * spacing;
    const int64_t along = std::min(from + pen.random().between(0, jitter), high);
    const Quad sides{{{along, low}, {high, along}, {-1 - along, high}, {low, -1 - along}}};
    ring.push_back(sides[static_cast<size_t>(i / on_a_side)]);
  }
  return ring;
}

Point extreme_corner(Pen& pen, int quadrant) {
  const std::array<int64_t, 8> extremes{
      pen.least(), pen.greatest(), pen.least() + 1, pen.greatest() - 1, -1, 0, 1, pen.half()};
  const auto pick = [&] { return extremes[static_cast<size_t>(pen.random().between(0, 7))]; };
  const int64_t x = pick();
  const int64_t y = pick();
  return {(quadrant & 1) != 0 ? x : -1 - x, (quadrant & 2) != 0 ? y : -1 - y};
}

int64_t tile_border(Pen& pen, int64_t n) {
  return n * pen.tile() + pen.random().between(-1, 1) * pen.half();
}

}  // namespace pineda::figures
