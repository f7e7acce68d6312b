// Traversal: the tiles of a triangle's box, then the stamps of each tile that is not rejected.
#pragma once

#include "model/core/frame_counters.h"
#include "model/core/lanes.h"
#include "model/spec/structs.h"

namespace pineda::core {

using spec::Tile;

/// Clips a triangle to the rows of tiles first .. last: edges and planes are stepped to the first
/// tile of its first remaining row. Samples keep their bits. False if nothing is left.
bool clip_rows(const spec::Contract& contract, int first, int last, spec::SetupPrim* prim);

/// Walks the tiles of a triangle's box, row by row from the top, from left to right.
///
/// Bits     the definition. A tile is rejected when one edge is negative at that edge's best
///          corner sample, and an edge accepts a tile when it is >= 0 at its worst corner sample.
/// In       a SetupPrim.
/// Out      next(): one tile test a call; *tile is written when the tile is kept.
/// Twin     rtl/traversal/tile_walker.sv (one test a cycle).
class TileWalk {
 public:
  enum class Test { kRejected, kKept, kEnd };

  TileWalk(const spec::Contract& contract, const spec::SetupPrim& prim);
  Test next(Tile* tile);

 private:
  void fill(Tile* tile) const;
  void step();

  const spec::Contract& contract_;
  const spec::SetupPrim& prim_;
  int x_, y_;    // the tile that next() tests
  int first_x_;  // first and last column, last row
  int last_x_, last_y_;
  std::array<int64_t, 3> edge_{}, row_edge_{};  // E' at the first sample of this tile, this row
  spec::PlaneSet planes_;                       // ref is stepped; dx, dy stay
  std::array<int64_t, spec::kMaxAttributes + 1> row_ref_{};
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
void for_each_stamp(const spec::Contract& contract, const spec::SetupPrim& prim,
                    FrameCounters* counters, Visitor&& visit) {
  TileWalk tiles(contract, prim);
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
  for_each_stamp(contract, prim, &uncounted, visit);
}

}  // namespace pineda::core
