// Triangles of a few samples, side by side: set up, and their tiles covered, before one is drawn.
#pragma once

#include <vector>

#include "model/core/setup.h"
#include "model/fast/highway_targets.h"
#include "model/fast/prim_group.h"
#include "model/fast/tile_cover.h"

namespace pineda::fast {

/// What setup and the walk over the tiles find of one triangle.
struct SmallWalk {
  core::Drop drop = core::Drop::kNone;
  int tests = 0;                    // of tiles; 0 if it is dropped
  unsigned rejected = 0;            // a bit a test, in order
  const TileCover* kept = nullptr;  // the tiles of the others, in order, with all their stamps
};

/// Looks at triangles of one frame, up to kGroup at a time.
///
/// Bits     those of core::setup(), core::TileWalk and core::StampWalk.
/// In       begin_frame(), then find(): triangles whose numbers are in their ranges.
/// Out      walk(): of the i-th triangle of the last find(); null where its box of samples, the
///          frame's borders aside, is larger than 8 x 8 px.
class SmallWalks {
 public:
  /// Does a design's arithmetic fit 32-bit lanes, and a tile a block?
  static bool fit(const spec::Design& design);

  explicit SmallWalks(const spec::Contract& contract);

  void begin_frame(const spec::FrameState& frame);
  /// Adds the stamps of all tiles that are kept to *by_samples.
  void find(const spec::Triangle* triangles, size_t count, StampsBySamples* by_samples);
  const SmallWalk* walk(size_t i) const { return (small_ >> i & 1) != 0 ? &walks_[i] : nullptr; }

 private:
  spec::Design design_;
  spec::FrameState frame_;
  uint32_t small_ = 0;  // a bit a triangle
  Each<SmallWalk> walks_{};
  std::vector<TileCover> covers_;  // of all tiles that are kept
};

}  // namespace pineda::fast
