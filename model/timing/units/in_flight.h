// Which stamps of a frame are in flight, where memories are always ready.
#pragma once

#include <vector>

#include "model/fast/tile_cover.h"
#include "model/timing/counted/cycles.h"

namespace pineda::timing {

/// When the address of each stamp is free again.
///
/// In       the stamps of a tile one by one, or as a run, a stamp a cycle. A run that comes when no
///          stamp of its tile is in flight is kept as a whole. When stamps of its tile come while it
///          is in flight, the cycles of its stamps are written down first.
/// Errors   none.
class InFlight {
 public:
  explicit InFlight(const spec::Design& design);

  void begin_frame(size_t tiles);

  /// From this cycle on no stamp of the tile is in flight.
  Cycle tile_free(size_t tile) const { return tiles_[tile].free; }
  /// From this cycle on that stamp is not in flight.
  Cycle stamp_free(size_t tile, int place);
  /// Can a run be accepted whose k-th stamp, from 0, comes in `first` + k?
  bool takes_run(size_t tile, const fast::TileSamples& covered, Cycle first) {
    return tiles_[tile].free <= first || takes_stamps(tile, covered, first);
  }

  /// A run that can be accepted. Its k-th stamp, from 0, comes in `first` + k and retires in
  /// `retire` + k.
  void run(size_t tile, const fast::TileSamples& covered, Cycle first, Cycle retire) {
    Tile& t = tiles_[tile];
    if (t.free > first) return write_run(tile, covered, retire);
    t.count = covered.count;
    t.free = retire + t.count;
    t.is_run = true;
    for (size_t i = 0; i < words_; ++i) stamps_[tile * words_ + i] = covered.stamps[i];
  }
  /// A stamp, after stamp_free() was asked for it.
  void stamp(size_t tile, int place, Cycle free) {
    free_[(tile << stamps_log2_) + static_cast<size_t>(place)] = tiles_[tile].free = free;
  }

 private:
  struct Tile {
    Cycle free = 0;
    int count = 0;       // stamps of the last run
    bool is_run = true;  // it is not written down stamp by stamp
  };
  bool takes_stamps(size_t tile, const fast::TileSamples& covered, Cycle first);
  void write_run(size_t tile, const fast::TileSamples& covered, Cycle retire);
  void write_down(size_t tile);

  int stamps_log2_;  // of a tile
  size_t words_;     // that hold a bit for each stamp of a tile
  std::vector<Tile> tiles_;
  std::vector<uint64_t> stamps_;  // by tile: the stamps of its last run, if it had one
  std::vector<Cycle> free_;       // by tile and place, of what is written down
};

}  // namespace pineda::timing
