#include "model/timing/units/traversal_unit.h"

#include <algorithm>

namespace pineda::timing {

namespace {

// Takes the next token, as early as in the cycle of the last test or, with a bubble, after it. The
// first test of the new token is in the cycle after it was taken.
Cycle taken(Cycle visible, bool bubble, LocalTime* time) {
  const Cycle cycle = std::max(time->now() - (bubble ? 0 : 1), visible);
  time->starve(cycle + 1);
  return cycle;
}

}  // namespace

TraversalUnit::TraversalUnit(sc_core::sc_module_name name, const spec::Contract& contract)
    : sc_module(name),
      contract_(contract),
      walk_(contract),
      cover_(contract),
      coverage_(this),
      tiles_("tiles", Fifo::kTiles, contract.design.tile_fifo_depth) {
  prim_i.bind(*this);
  tiles_.out_o(coverage_);
}

void TraversalUnit::end_of_elaboration() { require_bound(stamp_o, "pineda/traversal/unbound"); }

void TraversalUnit::begin_frame(Frame* frame) {
  frame_ = frame;
  tiles_.begin_frame(frame->listener);
  time_ = LocalTime(Unit::kTiles, frame->listener);
  coverage_.begin_frame(frame->listener);
  floors_.reset();
  if (frame->hierarchical_z != nullptr && frame->hierarchical_z->is_active()) {
    floors_.emplace(contract_, frame->state, fast::TileShader::Values::kDepth);
  }
}

Cycle TraversalUnit::take(const spec::SetupPrim& prim, Cycle visible) {
  const Cycle cycle = taken(
      visible, contract_.design.prim_fifo_depth == 0 || contract_.design.hierarchical_z, &time_);
  if (frame_->walk != nullptr) {
    walk_small(prim, *frame_->walk);
    return cycle;
  }
  walk_.begin(prim);
  if (floors_) floors_->begin(prim);
  if (frame_->tokens) {
    walk_stamps(prim);
  } else {
    walk_tiles(prim);
  }
  return cycle;
}

void TraversalUnit::walk_small(const spec::SetupPrim& prim, const fast::SmallWalk& walk) {
  core::FrameCounters& counters = frame_->counters;
  const fast::TileCover* cover = walk.kept;
  for (int test = 0; test < walk.tests; ++test) {
    ++counters.tiles_tested;
    if ((walk.rejected >> test & 1) != 0) {
      ++counters.tiles_rejected;
    } else {
      prefetch(*cover);
      send({&prim, cover++, nullptr});
    }
    time_.work(1, prim.id);
  }
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
      prefetch(cover_);
      walk_.cover_stamps(&cover_, &frame_->stamps_by_samples);
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
      walk_.cover_stamps(&cover_, &frame_->stamps_by_samples);
      send({&prim, &cover_, &stamp_});
    }
  }
}

// Hands the tile over, whose stamps are covered.
void TraversalUnit::send(const TileToken& tile) {
  frame_->counters.tiles_accepted += tile.cover->accepted ? 1 : 0;
  frame_->stamps.add(tile.cover->covered);
  time_.spend(Cause::kBlocked, tiles_.push(tile, time_.now()), tile.prim->id);
}

// Fetches the tile's values into the processor's cache. They arrive while its coverage is found.
void TraversalUnit::prefetch(const fast::TileCover& cover) const {
  if (!frame_->has_values) return;
  frame_->buffer->prefetch(cover, frame_->planes == fast::Planes::kAll);
}

bool TraversalUnit::is_hidden() {
  if (!floors_) return false;
  const uint32_t floor = floors_->depth_floor(cover_.x, cover_.y);
  return floor != 0 && frame_->hierarchical_z->hides(time_.now(), cover_.x, cover_.y, floor);
}

void TraversalUnit::Coverage::begin_frame(Listener* listener) {
  time = LocalTime(Unit::kCoverage, listener);
  sender = LocalTime(Unit::kStamps, listener);
}

Cycle TraversalUnit::Coverage::take(const TileToken& tile, Cycle visible) {
  const Cycle cycle = taken(visible, unit_.contract_.design.tile_fifo_depth == 0, &time);
  if (tile.cover->covered.count == 0) {
    time.work(tile.cover->box.tests(), tile.prim->id);
  } else if (!take_run(tile)) {
    walk(tile);
  }
  return cycle;
}

bool TraversalUnit::Coverage::take_run(const TileToken& tile) {
  const fast::CoveredGroups& groups = tile.cover->groups;
  if (groups.count != groups.last - groups.first + 1) return false;
  // Of the first group that is not empty.
  const Cycle done = std::max(time.now() + groups.first, sent());
  if (!unit_.stamp_o->push_run(tile, done + 1)) return false;
  time.work_at_times(groups.last + 1, done + groups.before_last + 1);
  time.work(tile.cover->box.tests() - groups.last - 1, tile.prim->id);
  sender.starve(done + 1);
  sender.work(tile.cover->covered.count, tile.prim->id);
  return true;
}

void TraversalUnit::Coverage::walk(const TileToken& tile) {
  const fast::GroupBox& box = tile.cover->box;
  const uint32_t id = tile.prim->id;
  int tested = 0;
  tile.cover->covered.for_each_stamp([&](int place) {
    const int test = box.test_of(place);
    if (test >= tested) {
      time.work(test - tested, id);
      time.spend(Cause::kBlocked, sent(), id);
      time.work(1, id);
      sender.starve(time.now());
      tested = test + 1;
    }
    send(tile, place);
  });
  time.work(box.tests() - tested, id);
}

void TraversalUnit::Coverage::send(const TileToken& tile, int place) {
  const fast::TileCover& cover = *tile.cover;
  if (tile.stamp != nullptr) {
    const spec::Design& d = unit_.contract_.design;
    const int columns_log2 = cover.box.columns_log2;
    tile.stamp->first = place == cover.covered.first;
    tile.stamp->mask = fast::lanes_of(d, cover.covered, place);
    tile.stamp->x = (cover.x << columns_log2) + (place & ((1 << columns_log2) - 1));
    tile.stamp->y = (cover.y << (d.tile_log2 - d.stamp_height_log2)) + (place >> columns_log2);
  }
  const Cycle sent = unit_.stamp_o->push({&tile, place}, sender.now());
  sender.spend(Cause::kBlocked, sent, tile.prim->id);
  sender.work(1, tile.prim->id);
  Listener* const listener = unit_.frame_->listener;
  if (listener != nullptr) listener->stamp(sent, *tile.stamp);
}

Cycle TraversalUnit::idle_from() const {
  return std::max({time_.now(), coverage_.time.now(), coverage_.sender.now()});
}

namespace {

UnitCycles until(Cycle drained, LocalTime time) {
  time.starve(drained);
  return time.cycles();
}

}  // namespace

UnitCycles TraversalUnit::tile_cycles(Cycle drained) const { return until(drained, time_); }

UnitCycles TraversalUnit::coverage_cycles(Cycle drained) const {
  return until(drained, coverage_.time);
}

UnitCycles TraversalUnit::stamp_cycles(Cycle drained) const {
  return until(drained, coverage_.sender);
}

}  // namespace pineda::timing
