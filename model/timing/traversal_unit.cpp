#include "model/timing/traversal_unit.h"

#include <algorithm>

namespace pineda::timing {

namespace {

// Takes the next token in the cycle of the last test, if it is there; the first test comes after.
template <class T>
T take(StreamIn<T>* stream, LocalTime* time) {
  Cycle visible;
  T token = stream->front(&visible);
  const Cycle taken = std::max(time->now() - 1, visible);
  stream->pop(taken);
  time->starve(taken + 1);
  return token;
}

}  // namespace

TraversalUnit::TraversalUnit(sc_core::sc_module_name name, const spec::Contract& contract)
    : sc_module(name), contract_(contract), tiles_("tiles", contract.design.tile_fifo_depth) {
  SC_HAS_PROCESS(TraversalUnit);
  SC_THREAD(run_tiles);
  SC_THREAD(run_stamps);
}

void TraversalUnit::end_of_elaboration() {
  require_bound(prim_i, "pineda/traversal/unbound");
  require_bound(stamp_o, "pineda/traversal/unbound");
}

void TraversalUnit::begin_frame(Frame* frame) {
  frame_ = frame;
  tiles_.begin_frame();
  tile_time_ = {};
  stamp_time_ = {};
  stamp_sent_ = -1;
}

void TraversalUnit::run_tiles() {
  for (;;) walk(take(prim_i[0], &tile_time_));
}

void TraversalUnit::walk(const spec::SetupPrim& prim) {
  using Test = core::TileWalk::Test;
  core::TileWalk tiles(contract_, prim);
  spec::Tile tile;
  for (Test test; (test = tiles.next(&tile)) != Test::kEnd;) {
    ++frame_->counters.tiles_tested;
    if (test == Test::kRejected) {
      ++frame_->counters.tiles_rejected;
    } else if (is_hidden(tile)) {
      ++frame_->counters.tiles_hidden;
    } else {
      frame_->counters.tiles_accepted += tile.accepted == 7 ? 1 : 0;
      ++frame_->under_way;
      tile_time_.block(tiles_.push(tile, tile_time_.now()));
    }
    tile_time_.work(1);
  }
}

bool TraversalUnit::is_hidden(const spec::Tile& tile) {
  if (frame_->hierarchical_z == nullptr || !frame_->hierarchical_z->is_active()) return false;
  const uint32_t floor = core::depth_floor(contract_, tile.planes);
  if (floor == 0) return false;
  while (frame_->under_way != 0) sc_core::wait(sc_core::SC_ZERO_TIME);
  return frame_->hierarchical_z->hides(tile_time_.now(), tile.x, tile.y, floor);
}

void TraversalUnit::run_stamps() {
  for (;;) walk(take<spec::Tile>(&tiles_, &stamp_time_));
}

void TraversalUnit::walk(const spec::Tile& tile) {
  core::StampWalk stamps(contract_, tile);
  spec::Stamp stamp;
  stamps.begin(&stamp);
  while (stamps.next(&stamp.mask, &stamp.x, &stamp.y)) {
    if (stamp.mask != 0) stamp_time_.block(stamp_sent_);  // the output register
    stamp_time_.work(1);
    if (stamp.mask != 0) send(stamp);
  }
  --frame_->under_way;
}

void TraversalUnit::send(const spec::Stamp& stamp) {
  ++frame_->under_way;
  stamp_sent_ = stamp_o->push(stamp, stamp_time_.now());
  frame_->listener->stamp(stamp_sent_, stamp);
  ++frame_->counters.stamps;
  frame_->counters.fragments += static_cast<uint64_t>(__builtin_popcount(stamp.mask));
}

Cycle TraversalUnit::idle_from() const {
  return std::max({tile_time_.now(), stamp_time_.now(), stamp_sent_ + 1});
}

UnitCycles TraversalUnit::tile_cycles(Cycle drained) const {
  LocalTime time = tile_time_;
  time.starve(drained);
  return time.cycles();
}

UnitCycles TraversalUnit::stamp_cycles(Cycle drained) const {
  LocalTime time = stamp_time_;
  time.starve(drained);
  return time.cycles();
}

}  // namespace pineda::timing
