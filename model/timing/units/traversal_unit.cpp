#include "model/timing/units/traversal_unit.h"

#include <algorithm>

namespace pineda::timing {

namespace {

// Takes the next token, as early as in the cycle of the last test. The first test of the new token
// is in the cycle after that.
Cycle taken(Cycle visible, LocalTime* time) {
  const Cycle cycle = std::max(time->now() - 1, visible);
  time->starve(cycle + 1);
  return cycle;
}

}  // namespace

TraversalUnit::TraversalUnit(sc_core::sc_module_name name, const spec::Contract& contract)
    : sc_module(name),
      contract_(contract),
      walk_(contract),
      cover_(contract),
      stamp_walker_(this),
      tiles_("tiles", Fifo::kTiles, contract.design.tile_fifo_depth) {
  prim_i.bind(*this);
  tiles_.out_o(stamp_walker_);
}

void TraversalUnit::end_of_elaboration() { require_bound(stamp_o, "pineda/traversal/unbound"); }

void TraversalUnit::begin_frame(Frame* frame) {
  frame_ = frame;
  tiles_.begin_frame(frame->listener);
  time_ = LocalTime(Unit::kTiles, frame->listener);
  stamp_walker_.begin_frame(frame->listener);
  floors_.reset();
  if (frame->hierarchical_z != nullptr && frame->hierarchical_z->is_active()) {
    floors_.emplace(contract_, frame->state, fast::TileShader::Values::kDepth);
  }
}

Cycle TraversalUnit::take(const spec::SetupPrim& prim, Cycle visible) {
  const Cycle cycle = taken(visible, &time_);
  walk_.begin(prim);
  if (floors_) floors_->begin(prim);
  if (frame_->tokens) {
    walk_stamps(prim);
  } else {
    walk_tiles(prim);
  }
  return cycle;
}

void TraversalUnit::walk_tiles(const spec::SetupPrim& prim) {
  core::FrameCounters& counters = frame_->counters;
  for (;;) {
    int rejected = 0;
    const bool kept = walk_.next_kept(&cover_, &rejected);
    counters.tiles_tested += static_cast<uint64_t>(rejected);
    counters.tiles_rejected += static_cast<uint64_t>(rejected);
    time_.work(rejected, prim.id);
    if (!kept) return;
    ++counters.tiles_tested;
    if (is_hidden()) {
      ++counters.tiles_hidden;
    } else {
      prefetch();
      send({&prim, &cover_, nullptr});
    }
    time_.work(1, prim.id);
  }
}

// As walk_tiles(), but also steps the planes from tile to tile, since stamps are made with them.
void TraversalUnit::walk_stamps(const spec::SetupPrim& prim) {
  using Test = core::TileWalk::Test;
  core::FrameCounters& counters = frame_->counters;
  planes_.emplace(contract_, prim);
  for (Test test; (test = walk_.next(&cover_)) != Test::kEnd; time_.work(1, prim.id)) {
    planes_->next(&tile_);
    ++counters.tiles_tested;
    if (test == Test::kRejected) {
      ++counters.tiles_rejected;
    } else if (is_hidden()) {
      ++counters.tiles_hidden;
    } else {
      core::StampWalk(contract_, tile_).begin(&stamp_);
      send({&prim, &cover_, &stamp_});
    }
  }
}

// Finds the coverage of the tile's stamps and hands the tile over.
void TraversalUnit::send(const TileToken& tile) {
  walk_.cover_stamps(&cover_, &frame_->stamps_by_samples);
  frame_->counters.tiles_accepted += cover_.accepted ? 1 : 0;
  frame_->stamps.add(cover_.covered);
  time_.spend(Cause::kBlocked, tiles_.push(tile, time_.now()), tile.prim->id);
}

// Fetches the tile's values into the processor's cache. They arrive while its coverage is found.
void TraversalUnit::prefetch() const {
  if (!frame_->has_values) return;
  frame_->buffer->prefetch(cover_, frame_->planes == fast::Planes::kAll);
}

bool TraversalUnit::is_hidden() {
  if (!floors_) return false;
  const uint32_t floor = floors_->depth_floor(cover_.x, cover_.y);
  return floor != 0 && frame_->hierarchical_z->hides(time_.now(), cover_.x, cover_.y, floor);
}

void TraversalUnit::StampWalker::begin_frame(Listener* listener) {
  time = LocalTime(Unit::kStamps, listener);
  sent = -1;
}

Cycle TraversalUnit::StampWalker::take(const TileToken& tile, Cycle visible) {
  const Cycle cycle = taken(visible, &time);
  const fast::TileSamples& covered = tile.cover->covered;
  const int tests = tile.cover->box.tests();
  if (covered.count == 0) {
    time.work(tests, tile.prim->id);
  } else if (sent <= time.now() && unit_.stamp_o->push_run(tile, time.now() + 1)) {
    sent = time.now() + tile.cover->box.test_of(covered.last) + 1;
    time.work(tests, tile.prim->id);
  } else {
    walk(tile);
  }
  return cycle;
}

void TraversalUnit::StampWalker::walk(const TileToken& tile) {
  const fast::TileCover& cover = *tile.cover;
  const spec::Design& d = unit_.contract_.design;
  const uint32_t id = tile.prim->id;
  int tested = 0;
  cover.covered.for_each_stamp([&](int place) {
    const int test = cover.box.test_of(place);
    time.work(test - tested, id);
    time.spend(Cause::kBlocked, sent, id);  // the output register
    time.work(1, id);
    tested = test + 1;
    if (tile.stamp != nullptr) {
      const int columns_log2 = cover.box.columns_log2;
      tile.stamp->first = place == cover.covered.first;
      tile.stamp->mask = fast::lanes_of(d, cover.covered, place);
      tile.stamp->x = (cover.x << columns_log2) + (place & ((1 << columns_log2) - 1));
      tile.stamp->y = (cover.y << (d.tile_log2 - d.stamp_height_log2)) + (place >> columns_log2);
    }
    sent = unit_.stamp_o->push({&tile, place}, time.now());
    Listener* const listener = unit_.frame_->listener;
    if (listener != nullptr) listener->stamp(sent, *tile.stamp);
  });
  time.work(cover.box.tests() - tested, id);
}

Cycle TraversalUnit::idle_from() const {
  return std::max({time_.now(), stamp_walker_.time.now(), stamp_walker_.sent + 1});
}

UnitCycles TraversalUnit::tile_cycles(Cycle drained) const {
  LocalTime time = time_;
  time.starve(drained);
  return time.cycles();
}

UnitCycles TraversalUnit::stamp_cycles(Cycle drained) const {
  LocalTime time = stamp_walker_.time;
  time.starve(drained);
  return time.cycles();
}

}  // namespace pineda::timing
