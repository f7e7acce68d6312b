// Traversal: the tiles of a triangle's box, then the stamps of each tile that is not rejected.
#pragma once

#include "model/core/frame_counters.h"
#include "model/core/lanes.h"
#include "model/spec/structs.h"

namespace pineda::core {

using spec::Tile;

/// Rows of tiles, first to last.
struct TileRows {
  int first = 0;
  int last = 1 << 16;  // more than any frame has
};

/// Walks the tiles of a triangle's box, row by row from the top, along its edges: tiles that an edge
/// is known to reject are passed over.
///
/// Bits     the definition. A tile is rejected when one edge is negative at that edge's best
///          corner sample, and an edge accepts a tile when it is >= 0 at its worst corner sample.
///          A row is walked to the right. It ends one tile after an edge with a < 0 rejects: all
///          further ones are outside too. The next row starts where this one did, further right by
///          the tiles there that an edge with a >= 0 and b <= 0 rejects: that edge rejects them
///          in all rows below. Where the triangle's left side runs down to the left (a >= 0, b > 0)
///          and its right side does so too (a < 0, b <= 0), the first row is walked to its end, and
///          those below start there and are walked to the left, by the mirrored rule.
/// In       a SetupPrim; the rows of tiles that are wanted. Those above are walked in silence.
/// Out      next(): one tile test a call; *tile is written when the tile is kept.
/// Twin     rtl/traversal/tile_walker.sv (one test a cycle).
class TileWalk {
 public:
  enum class Test { kRejected, kKept, kEnd };

  TileWalk(const spec::Contract& contract, const spec::SetupPrim& prim, TileRows rows = {});
  Test next(Tile* tile);

 private:
  bool any_edge(bool falls_rightward, bool falls_downward) const;
  void test();
  void fill(Tile* tile) const;
  void step();
  void step_across();
  void step_down();

  const spec::Contract& contract_;
  const spec::SetupPrim& prim_;
  int x_, y_;    // the tile that next() tests
  int first_x_;  // first and last column, last row
  int last_x_, last_y_;
  int start_x_;                           // where the row started, further on by tiles outside
  std::array<bool, 3> rejects_{};         // the edges' tests of this tile
  uint32_t accepts_ = 0;                  // a bit an edge
  bool turns_;                            // rows below the first are walked to the left
  bool leftward_ = false, past_ = false;  // this row: to the left; ends with this tile
  std::array<int64_t, 3> edge_{}, start_edge_{};  // E' at the first sample of this tile, the start
  spec::PlaneSet planes_;                         // ref is stepped; dx, dy stay
  std::array<int64_t, spec::kMaxAttributes + 1> start_ref_{};
};

/// Walks the stamps of a tile inside the box, row by row from the top, from left to right.
///
/// Bits     the definition. A sample is covered when it is in the box and no edge is negative
///          there; an edge that accepts the tile is not tested.
/// Out      next(): one stamp test a call; false when the tile is done. An empty stamp (*mask = 0)
///          is tested but not sent.
/// Twin     rtl/traversal/coverage_finder.sv (some tests a cycle), stamp_sender.sv.
class StampWalk {
 public:
  StampWalk(const spec::Contract& contract, const Tile& tile);

  /// Sets the members of a stamp that all stamps of the tile share.
  void begin(spec::Stamp* stamp) const;
  bool next(uint32_t* mask, int* x, int* y);  // x, y: column and row of the stamp in the frame

 private:
  const spec::Contract& contract_;
  const Tile& tile_;
  int first_x_, last_x_, last_y_;  // stamps, from the tile's corner
  int x_, y_;
};

/// Calls visit(stamp) for each stamp of a triangle that has a covered sample, in order, and counts
/// tiles, stamps and samples.
///
/// Bits     those of TileWalk and StampWalk.
template <class Visitor>
void for_each_stamp(const spec::Contract& contract, const spec::SetupPrim& prim, TileRows rows,
                    FrameCounters* counters, Visitor&& visit) {
  TileWalk tiles(contract, prim, rows);
  Tile tile;
  spec::Stamp stamp;
  for (TileWalk::Test test; (test = tiles.next(&tile)) != TileWalk::Test::kEnd;) {
    ++counters->tiles_tested;
    if (test == TileWalk::Test::kRejected) {
      ++counters->tiles_rejected;
      continue;
    }
    counters->tiles_accepted += tile.accepted == 7 ? 1 : 0;
    StampWalk stamps(contract, tile);
    stamps.begin(&stamp);
    while (stamps.next(&stamp.mask, &stamp.x, &stamp.y)) {
      if (stamp.mask == 0) continue;
      ++counters->stamps;
      counters->fragments += static_cast<uint64_t>(count_lanes(stamp.mask));
      visit(static_cast<const spec::Stamp&>(stamp));
      stamp.first = false;
    }
  }
}
template <class Visitor>
void for_each_stamp(const spec::Contract& contract, const spec::SetupPrim& prim, Visitor&& visit) {
  FrameCounters uncounted;
  for_each_stamp(contract, prim, {}, &uncounted, visit);
}

}  // namespace pineda::core
