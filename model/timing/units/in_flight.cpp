#include "model/timing/units/in_flight.h"

#include <algorithm>

namespace pineda::timing {

InFlight::InFlight(const spec::Design& d)
    : columns_log2_(d.tile_log2 - d.stamp_width_log2),
      stamps_log2_(fast::stamps_log2(d)),
      words_(fast::TileSamples(d).stamps.size()) {}

void InFlight::begin_frame(size_t tiles) {
  tiles_.assign(tiles, {});
  stamps_.assign(tiles * words_, 0);
  free_.resize(tiles << stamps_log2_);
}

Cycle InFlight::stamp_free(size_t tile, int place) {
  if (tiles_[tile].is_run) write_down(tile);
  return free_[(tile << stamps_log2_) + static_cast<size_t>(place)];
}

void InFlight::write_down(size_t tile) {
  Tile& t = tiles_[tile];
  t.is_run = false;
  fast::StampBox box;
  box.column0 = t.column0;
  box.columns = t.columns;
  box.row0 = t.row0;
  box.columns_log2 = columns_log2_;
  Cycle* const free = &free_[tile << stamps_log2_];
  std::fill_n(free, size_t{1} << stamps_log2_, 0);
  const Cycle after_first = t.free - t.last;
  fast::for_each_bit(&stamps_[tile * words_], words_,
                     [&](int place) { free[place] = after_first + box.test_of(place); });
}

}  // namespace pineda::timing
