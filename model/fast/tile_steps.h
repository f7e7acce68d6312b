// Which tiles of a triangle's box are tested, in which order: core::TileWalk without what a tile carries.
#pragma once

#include <algorithm>

#include "model/core/traversal.h"
#include "model/fast/level.h"

namespace pineda::fast {

/// E' of the three edges at the first sample of a tile.
using EdgeValues = std::array<int64_t, 3>;

/// Bits     those of core::TileWalk.
/// In       begin(): a SetupPrim or its box and edges; the rows of tiles that are wanted.
/// Out      while !ended(): the tile at x(), y(), in tiles, and which edges reject it; then step().
class TileSteps {
 public:
  template <class Prim>
  PINEDA_INLINE void begin(const Prim& prim, int tile_log2, core::TileRows rows);

  bool ended() const { return y_ > last_y_; }
  int x() const { return x_; }
  int y() const { return y_; }
  /// The edges that reject the tile, bits of a mask.
  PINEDA_INLINE int rejects() const {
    const auto& [e0, e1, e2] = edges_;
    return (e0.at + e0.best < 0) | (e1.at + e1.best < 0) << 1 | (e2.at + e2.best < 0) << 2;
  }
  /// Does every edge accept every sample of the tile?
  PINEDA_INLINE bool accepted() const {
    const auto& [e0, e1, e2] = edges_;
    return ((e0.at + e0.worst) | (e1.at + e1.worst) | (e2.at + e2.worst)) >= 0;
  }
  /// E' at the tile's first sample. Where an edge accepts the tile, E' is lowered to 0 at its worst
  /// sample: the edge still accepts, and no E' in a tile that is not rejected is greater than
  /// (T - 1)(|a| + |b|).
  PINEDA_INLINE EdgeValues lowered() const {
    const auto& [e0, e1, e2] = edges_;
    return {std::min(e0.at, -e0.worst), std::min(e1.at, -e1.worst), std::min(e2.at, -e2.worst)};
  }
  PINEDA_INLINE void step(int rejects);

 private:
  struct Edge {
    int64_t at = 0, at_start = 0;  // E' at the first sample of the tile, of the row's start
    int64_t best = 0, worst = 0;   // what E' changes by to the best and the worst corner
    int64_t across = 0,
            down = 0;  // what it changes by to the next tile of the row, to the next row
  };
  PINEDA_INLINE void step_down();
  PINEDA_INLINE void set_direction(bool leftward);

  int x_ = 0, y_ = 0;
  int first_x_ = 0, last_x_ = 0, last_y_ = 0;
  std::array<Edge, 3> edges_{};
  // See core::TileWalk. Edges are bits of a mask.
  int start_x_ = 0;
  bool turns_ = false, to_the_end_ = false, past_ = false;
  int falls_rightward_ = 0, falls_downward_ = 0;
  int step_x_ = 1, end_x_ = 0;  // of this row
  int ends_ = 0;                // edges that end the row where they reject a tile
  int follows_ = 0;             // edges that let the start follow
};

// Each edge is written out: for three a loop does not pay.
template <class Prim>
PINEDA_INLINE void TileSteps::begin(const Prim& prim, int tile_log2, core::TileRows rows) {
  x_ = start_x_ = first_x_ = prim.x0 >> tile_log2;
  y_ = prim.y0 >> tile_log2;
  last_x_ = prim.x1 >> tile_log2;
  last_y_ = std::min(prim.y1 >> tile_log2, rows.last);
  const auto begin = [tile_log2](const spec::EdgeFunction& edge, Edge* e) PINEDA_INLINED {
    // What E changes by from the first sample of a tile to the last one.
    const int64_t a = edge.a * ((int64_t{1} << tile_log2) - 1);
    const int64_t b = edge.b * ((int64_t{1} << tile_log2) - 1);
    e->best = std::max<int64_t>(a, 0) + std::max<int64_t>(b, 0);
    e->worst = a + b - e->best;
    e->at = e->at_start = edge.e;
    e->across = edge.a * (int64_t{1} << tile_log2);
    e->down = edge.b * (int64_t{1} << tile_log2);
  };
  const auto& [e0, e1, e2] = prim.edge;
  begin(e0, &edges_[0]);
  begin(e1, &edges_[1]);
  begin(e2, &edges_[2]);
  falls_rightward_ = (e0.a < 0) | (e1.a < 0) << 1 | (e2.a < 0) << 2;
  falls_downward_ = (e0.b <= 0) | (e1.b <= 0) << 1 | (e2.b <= 0) << 2;
  turns_ = (falls_rightward_ | falls_downward_) != 7 && (falls_rightward_ & falls_downward_) != 0;
  past_ = false;
  set_direction(false);
  to_the_end_ = turns_;
  if (last_y_ < rows.first) y_ = rows.first;
  while (y_ < rows.first) {
    const int row = y_;
    while (y_ == row && x_ == start_x_) step(rejects());
    if (y_ == row) step_down();
  }
}

PINEDA_INLINE void TileSteps::set_direction(bool leftward) {
  const int falls_ahead = leftward ? ~falls_rightward_ : falls_rightward_;
  step_x_ = leftward ? -1 : 1;
  end_x_ = leftward ? first_x_ : last_x_;
  ends_ = falls_ahead;
  follows_ = ~falls_ahead & falls_downward_;
}

PINEDA_INLINE void TileSteps::step_down() {
  x_ = start_x_;
  ++y_;
  past_ = to_the_end_ = false;
  if (turns_ && step_x_ > 0) {
    set_direction(true);
    for (Edge& edge : edges_) edge.across = -edge.across;
  }
  for (Edge& edge : edges_) edge.at = edge.at_start += edge.down;
}

PINEDA_INLINE void TileSteps::step(int rejects) {
  if (past_ || x_ == end_x_) return step_down();
  auto& [e0, e1, e2] = edges_;
  e0.at += e0.across;
  e1.at += e1.across;
  e2.at += e2.across;
  x_ += step_x_;
  if (!to_the_end_) {
    if (rejects == 0) return;
    past_ = (rejects & ends_) != 0;
    if (x_ - step_x_ != start_x_ || (rejects & follows_) == 0) return;
  }
  start_x_ = x_;
  e0.at_start = e0.at;
  e1.at_start = e1.at;
  e2.at_start = e2.at;
}

}  // namespace pineda::fast
