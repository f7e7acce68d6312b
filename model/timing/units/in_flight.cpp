#include "model/timing/units/in_flight.h"

#include <algorithm>

namespace pineda::timing {

InFlight::InFlight(const spec::Design& d)
    : stamps_log2_(fast::stamps_log2(d)), words_(fast::TileSamples(d).stamps.size()) {}

void InFlight::begin_frame(size_t tiles) {
  tiles_.assign(tiles, {});
  stamps_.resize(tiles * words_);
  free_.resize(tiles << stamps_log2_);
}

Cycle InFlight::stamp_free(size_t tile, int place) {
  if (tiles_[tile].is_run) write_down(tile);
  return free_[(tile << stamps_log2_) + static_cast<size_t>(place)];
}

bool InFlight::takes_stamps(size_t tile, const fast::TileSamples& covered, Cycle first) {
  if (tiles_[tile].is_run) write_down(tile);
  const Cycle* const free = &free_[tile << stamps_log2_];
  bool takes = true;
  covered.for_each_stamp([&](int place) { takes &= free[place] <= first++; });
  return takes;
}

// The runs before it are written down: takes_stamps() was asked.
void InFlight::write_run(size_t tile, const fast::TileSamples& covered, Cycle retire) {
  Cycle* const free = &free_[tile << stamps_log2_];
  covered.for_each_stamp([&](int place) { free[place] = ++retire; });
  tiles_[tile].free = retire;
}

void InFlight::write_down(size_t tile) {
  Tile& t = tiles_[tile];
  t.is_run = false;
  Cycle* const free = &free_[tile << stamps_log2_];
  std::fill_n(free, size_t{1} << stamps_log2_, 0);
  if (t.count == 0) return;  // no run yet
  Cycle stamp_free = t.free - t.count + 1;
  fast::for_each_bit(&stamps_[tile * words_], words_,
                     [&](int place) { free[place] = stamp_free++; });
}

}  // namespace pineda::timing
