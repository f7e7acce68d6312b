#include "model/timing/units/interp_ztest_unit.h"

#include <algorithm>
#include <limits>

#include "model/timing/ports/frame_memory.h"

namespace pineda::timing {

namespace {

constexpr Cycle kForever = std::numeric_limits<Cycle>::max();

}  // namespace

InterpZtestUnit::InterpZtestUnit(sc_core::sc_module_name name, const spec::Contract& contract)
    : sc_module(name), contract_(contract), in_flight_(contract.design) {
  stamp_i.bind(*this);
}

void InterpZtestUnit::end_of_elaboration() {
  if (contract_.design.depth_test) require_bound(depth_io, "pineda/interp_ztest/unbound");
  require_bound(color_wr_o, "pineda/interp_ztest/unbound");
}

void InterpZtestUnit::begin_frame(Frame* frame) {
  frame_ = frame;
  time_ = LocalTime(Unit::kInterpZtest, frame->listener);
  const spec::Design& d = contract_.design;
  tests_ = core::tests_depth(contract_, frame->state);
  writes_depth_ = tests_ && frame->state.depth_write;
  tile_columns_ = ((frame->state.width - 1) >> d.tile_log2) + 1;
  const int tile_rows = ((frame->state.height - 1) >> d.tile_log2) + 1;
  const auto tiles = static_cast<size_t>(tile_columns_) * static_cast<size_t>(tile_rows);
  columns_log2_ = d.tile_log2 - d.stamp_width_log2;
  tile_stamps_log2_ = fast::stamps_log2(d);
  write_free_ = retired_ = exit_ = -1;
  // Nothing has been loaded in cycle -1 or before: all slots are free.
  tile_loads_.assign(static_cast<size_t>(d.plane_slots) - 1, -1);
  tiles_accepted_ = tiles_loaded_ = slot_ = 0;

  shader_.reset();
  if (!frame->tokens) {
    const bool all = frame->planes == fast::Planes::kAll;
    shader_.emplace(contract_, frame->state,
                    all ? fast::TileShader::Values::kAll : fast::TileShader::Values::kDepth);
  }
  if (!asks()) {
    in_flight_.begin_frame(tiles);
    pass_cycles_ = !d.depth_test ? 1
                   : !tests_     ? 5
                                 : std::max<Cycle>(4, frame->depth_latency + 1) + 1;
    return;
  }
  register_ = {};
  last_stamp_.assign(tiles << tile_stamps_log2_, 0);
  last_of_tile_.assign(tiles, 0);
  accepted_count_ = retired_count_ = entered_count_ = exit_count_ = 0;
  slot_free_.assign(static_cast<size_t>(contract_.width.inflight_stamps), 0);
  exits_.assign(static_cast<size_t>(contract_.width.attribute_cycles) + 1, -1);
  // There is room for the stamps in flight, and for one that has retired while its colours wait in
  // the register.
  stored_.reset(slot_free_.size() + 1);
  colored_.reset(exits_.size());
  writes_.reset(slot_free_.size() + 1);
  colors_.reset(exits_.size());
}

Cycle InterpZtestUnit::take(const StampToken& stamp, Cycle visible) {
  return asks() ? take_asking(stamp, visible) : take_direct(stamp, visible);
}

size_t InterpZtestUnit::tile_of(const fast::TileCover& cover) const {
  return static_cast<size_t>(cover.y) * static_cast<size_t>(tile_columns_) +
         static_cast<size_t>(cover.x);
}

size_t InterpZtestUnit::address_of(const fast::TileCover& cover, int place) const {
  return (tile_of(cover) << tile_stamps_log2_) + static_cast<size_t>(place);
}

InterpZtestUnit::Place InterpZtestUnit::place_of(const fast::TileCover& cover, int place) const {
  const spec::Design& d = contract_.design;
  return {(cover.x << columns_log2_) + (place & ((1 << columns_log2_) - 1)),
          (cover.y << (d.tile_log2 - d.stamp_height_log2)) + (place >> columns_log2_)};
}

// ---- Memories that are always ready

Cycle InterpZtestUnit::take_direct(const StampToken& stamp, Cycle visible) {
  const fast::TileCover& cover = *stamp.tile->cover;
  const bool first = stamp.place == cover.covered.first;
  if (first) draw(*stamp.tile);
  const size_t tile = tile_of(cover);
  time_.starve(visible);
  if (tests_) time_.spend(Cause::kHazard, in_flight_.stamp_free(tile, stamp.place), stamp.id());
  const Cycle accepted = time_.now();
  if (first) keep_planes(accepted + pass_cycles_ - 1);
  time_.work(1, stamp.id());
  write_free_ = accepted + pass_cycles_;
  if (tests_) in_flight_.stamp(tile, stamp.place, write_free_ + 1);
  if (frame_->last_write != nullptr) {
    if (first) frame_->last_write->run(cover.x, cover.y);
    frame_->last_write->retires(write_free_);
  } else if (!frame_->has_values || shader_->passed().has(stamp.place)) {
    pass(write_free_);
    if (writes_depth_ && frame_->hierarchical_z != nullptr) {
      update(cover, stamp.place, write_free_);
    }
  }
  return accepted;
}

bool InterpZtestUnit::take_run(const TileToken& tile, Cycle first_visible) {
  if (asks()) return false;
  const fast::TileCover& cover = *tile.cover;
  const fast::TileSamples& covered = cover.covered;
  const size_t number = tile_of(cover);
  if (time_.now() > first_visible) return false;
  if (tests_ && !in_flight_.takes_run(number, covered, first_visible)) return false;
  // The stamps enter the FIFO a cycle before they are visible. All but the first one find room for
  // the tile after this one.
  if (planes_free(slot_) >= first_visible) return false;
  if (covered.count > 1 && (tile_loads_.size() == 1 || planes_free(next_slot()) > first_visible)) {
    return false;
  }
  keep_planes(first_visible + pass_cycles_ - 1);
  draw(tile);
  time_.starve(first_visible);
  time_.work(covered.count, tile.prim->id);
  const Cycle retire = first_visible + pass_cycles_;  // of the first stamp
  write_free_ = retire + covered.count - 1;
  if (tests_) in_flight_.run(number, covered, first_visible, retire);
  if (frame_->last_write != nullptr) {
    frame_->last_write->run(cover.x, cover.y, retire);
  } else {
    pass_run(cover, retire);
  }
  return true;
}

Cycle InterpZtestUnit::has_room() {
  if (asks()) wait_for_planes();
  return planes_free(slot_);
}

void InterpZtestUnit::accept_tile() {
  ++tiles_accepted_;
  slot_ = next_slot();
}

// Notes a tile whose first stamp is accepted, and where memories are always ready is loaded then.
void InterpZtestUnit::keep_planes(Cycle loaded) {
  tile_loads_[slot_] = loaded;
  accept_tile();
}

void InterpZtestUnit::draw(const TileToken& tile) {
  if (!frame_->has_values) return;
  shader_->begin(*tile.prim);
  shader_->draw(*tile.cover, frame_->buffer);
}

// Notes the writes of a tile's stamps that passed. The k-th covered one, from 0, writes in
// `retire` + k.
void InterpZtestUnit::pass_run(const fast::TileCover& cover, Cycle retire) {
  const fast::TileSamples& passed = frame_->has_values ? shader_->passed() : cover.covered;
  if (passed.count == 0) return;
  const bool all = passed.count == cover.covered.count;
  pass(retire + (all ? passed.count - 1 : cover.covered.before(passed.last)));
  if (!writes_depth_ || frame_->hierarchical_z == nullptr) return;
  passed.for_each_stamp(
      [&](int place) { update(cover, place, retire + cover.covered.before(place)); });
}

// Notes the writes of a stamp that retires in `retire`.
void InterpZtestUnit::pass(Cycle retire) {
  exit_ = retire + contract_.width.attribute_cycles;
  if (writes_depth_) retired_ = retire;
}

// Tells hierarchical z of a stamp's depth write.
void InterpZtestUnit::update(const fast::TileCover& cover, int place, Cycle retire) {
  const Place at = place_of(cover, place);
  frame_->hierarchical_z->update(retire, {at.x, at.y, greatest_depth(at)});
}

uint32_t InterpZtestUnit::greatest_depth(Place place) const {
  const auto [x, y] = place;
  const auto z = frame_->buffer->read(contract_, x, y, inside(x, y)).z;
  return *std::max_element(z.begin(), z.end()) >>
         (contract_.design.depth_bits - contract_.design.hierarchical_z_bits);
}

// ---- Other memories

Cycle InterpZtestUnit::take_asking(const StampToken& token, Cycle visible) {
  const fast::TileCover& cover = *token.tile->cover;
  const size_t address = address_of(cover, token.place);
  const Place place = place_of(cover, token.place);
  if (token.is_first()) {
    accept_tile();
    __builtin_prefetch(&last_stamp_[address], 1);  // is there once the tile is drawn
    if (!frame_->tokens) draw(*token.tile);
  }
  time_.starve(visible);
  Cycle response = 0;
  const Cycle accepted = accept(token, place, address, &response);
  time_.work(1, token.id());

  Stored& stored = stored_.push();
  stored.place = place;
  stored.first = token.is_first();
  stored.data = !contract_.design.depth_test ? accepted
                : tests_                     ? std::max(accepted + 4, response + 1)
                                             : accepted + 4;
  frame_->tokens ? test(*token.tile->stamp, &stored) : see(token, &stored);
  last_stamp_[address] = last_of_tile_[tile_of(cover)] = ++accepted_count_;
  return accepted;
}

Cycle InterpZtestUnit::accept(const StampToken& token, Place place, size_t address,
                              Cycle* response) {
  if (!contract_.design.depth_test) {
    while (!stored_.empty()) step(kForever);
    time_.spend(Cause::kBlocked, write_free_, token.id());
    return time_.now();
  }
  if (tests_) {
    wait_for_address(tile_of(*token.tile->cover), address, token.id());
  }
  if (accepted_count_ >= slot_free_.size()) wait_for(accepted_count_ - slot_free_.size() + 1);
  time_.spend(Cause::kBlocked, slot_free_[accepted_count_ % slot_free_.size()], token.id());
  if (!tests_) return time_.now();
  const Cycle accepted = read(token, place, response);
  count_stall(MemoryPort::kDepthRead, accepted - time_.now());
  time_.spend(Cause::kMemory, accepted, token.id());
  return accepted;
}

// The table has the cycles of the last stamps. Those before them are not in flight any more: the stamp
// before this one had to wait for them. Most tiles have none of the last ones, and their stamps, which
// would have to be fetched from far away, are not looked at.
void InterpZtestUnit::wait_for_address(size_t tile, size_t address, uint32_t id) {
  const uint64_t slots = slot_free_.size();
  const auto may_be_in_flight = [&](uint64_t number) {
    return number > 0 && number + slots > accepted_count_;
  };
  if (!may_be_in_flight(last_of_tile_[tile])) return;
  const uint64_t last = last_stamp_[address];
  if (!may_be_in_flight(last)) return;
  wait_for(last);
  time_.spend(Cause::kHazard, slot_free_[(last - 1) % slots], id);
}

Cycle InterpZtestUnit::read(const StampToken& token, Place place, Cycle* response) {
  for (Cycle offered = time_.now();;) {
    advance(offered);
    const Reply reply = read(token, place, offered);
    if (reply.taken) {
      *response = reply.response;
      return reply.cycle;
    }
    offered = reply.cycle;
  }
}

Reply InterpZtestUnit::read(const StampToken& token, Place place, Cycle offered) {
  if (!frame_->tokens) {
    return frame_->memory->ask(MemoryPort::kDepthRead, offered, place.x, place.y);
  }
  const spec::Stamp& stamp = *token.tile->stamp;
  data_ = {};
  return depth_io->read({stamp.id, stamp.x, stamp.y, asked(stamp)}, offered, &data_);
}

Reply InterpZtestUnit::write_depth(Cycle offered) {
  if (frame_->tokens) return depth_io->write(writes_.front().depth, offered);
  const auto [x, y] = stored_.front().place;
  return frame_->memory->ask(MemoryPort::kDepthWrite, offered, x, y);
}

Reply InterpZtestUnit::write_color(Cycle offered) {
  if (frame_->tokens) return color_wr_o->write(colors_.front(), offered);
  const auto [x, y] = colored_.front().place;
  return frame_->memory->ask(MemoryPort::kColorWrite, offered, x, y);
}

// Without tokens: what the shader found of a stamp.
void InterpZtestUnit::see(const StampToken& token, Stored* stored) {
  stored->passed = shader_->passed().has(token.place);
  stored->writes = stored->passed && writes_depth_;
  if (stored->writes && frame_->hierarchical_z != nullptr) {
    stored->greatest = greatest_depth(stored->place);
  }
}

void InterpZtestUnit::test(const spec::Stamp& stamp, Stored* stored) {
  Writes& writes = writes_.push();
  core::interpolate_depth(contract_, stamp, &fragment_);
  const uint32_t passed =
      core::depth_test(contract_, frame_->state.depth, stamp.mask, fragment_.z, data_.z);
  stored->passed = passed != 0;
  stored->writes = stored->passed && writes_depth_;
  if (!stored->passed) return;
  ++frame_->counters.interpolated;
  frame_->counters.passed += static_cast<uint64_t>(core::count_lanes(passed));
  core::interpolate_attributes(contract_, stamp, passed, &fragment_);
  core::color_write(contract_, stamp, fragment_, passed, &writes.color);
  if (!stored->writes) return;
  writes.depth = core::depth_write(contract_, stamp, fragment_, passed);
  if (frame_->hierarchical_z != nullptr) {
    stored->greatest = core::depth_ceiling(contract_, fragment_, passed, data_.z);
  }
}

uint32_t InterpZtestUnit::asked(const spec::Stamp& stamp) const {
  return contract_.design.hierarchical_z ? inside(stamp.x, stamp.y) : stamp.mask;
}

uint32_t InterpZtestUnit::inside(int stamp_x, int stamp_y) const {
  const spec::Design& d = contract_.design;
  uint32_t mask = 0;
  for (int lane = 0; lane < contract_.width.lanes; ++lane) {
    const int x = (stamp_x << d.stamp_width_log2) + (lane & ((1 << d.stamp_width_log2) - 1));
    const int y = (stamp_y << d.stamp_height_log2) + (lane >> d.stamp_width_log2);
    const bool in_frame = x < frame_->state.width && y < frame_->state.height;
    mask |= static_cast<uint32_t>(in_frame) << lane;
  }
  return mask;
}

void InterpZtestUnit::advance(Cycle until) {
  if (!asks()) return;
  while (step(until)) {
  }
}

void InterpZtestUnit::drain() {
  advance(kForever);
  if (!frame_->tokens) {
    const fast::StampCounts& passed = frame_->has_values ? shader_->counts() : frame_->stamps;
    frame_->counters.interpolated = passed.stamps;
    frame_->counters.passed = passed.samples;
  }
  if (frame_->last_write == nullptr) return;
  const Cycle retired = frame_->last_write->find();
  if (retired >= 0) exit_ = retired + contract_.width.attribute_cycles;
}

// Goes on until so many stamps have retired, and no further: the read that waits for them may come
// before later writes.
void InterpZtestUnit::wait_for(uint64_t retired) {
  while (retired_count_ < retired) {
    if (!turn()) offer(kForever);
  }
}

// The same until the first stamp is loaded whose tile's slot the next tile waits for.
void InterpZtestUnit::wait_for_planes() {
  while (tiles_loaded_ + tile_loads_.size() <= tiles_accepted_) {
    if (!turn()) offer(kForever);
  }
}

bool InterpZtestUnit::step(Cycle until) {
  while (turn()) {
  }
  return offer(until);
}

// Offers the earliest write, if that is before `until`.
bool InterpZtestUnit::offer(Cycle until) {
  const Cycle write = register_.loaded && !register_.written ? register_.write_offered : kForever;
  const Cycle color = colored_.empty() ? kForever : colored_.front().offered;
  if (std::min(write, color) >= until) return false;
  if (write <= color) {
    const Reply reply = write_depth(write);
    count_stall(MemoryPort::kDepthWrite, reply.cycle - write);
    reply.taken ? retire(reply.cycle) : void(register_.write_offered = reply.cycle);
  } else {
    const Reply reply = write_color(color);
    count_stall(MemoryPort::kColorWrite, reply.cycle - color);
    reply.taken ? exit(reply.cycle) : void(colored_.front().offered = reply.cycle);
  }
  return true;
}

// Takes one step of the write register that needs no port; false if there is none.
bool InterpZtestUnit::turn() {
  if (stored_.empty()) return false;
  Stored& stored = stored_.front();
  Register& r = register_;
  if (!r.loaded) {
    r = {};
    r.loaded = true;
    r.offered = r.write_offered = r.enter = std::max(stored.data, write_free_) + 1;
    if (stored.first) {
      tile_loads_[tiles_loaded_++ % tile_loads_.size()] = r.offered - 1;
    }
    r.entered = !stored.passed;
    if (!stored.writes) retire(r.offered);
    return true;
  }
  const Cycle latency = contract_.width.attribute_cycles;
  if (!r.entered && entered_count_ - exit_count_ < exits_.size()) {
    r.enter = std::max(r.offered, exits_[entered_count_++ % exits_.size()] + 1);
    Colored& colored = colored_.push();
    colored.offered = std::max(r.enter + latency, exit_ + 1);
    colored.place = stored.place;
    if (frame_->tokens) colors_.push() = writes_.front().color;
    r.entered = true;
    return true;
  }
  // Without a pipe the colours stay in the register until they are written.
  const bool left = r.entered && (latency > 0 || colored_.empty());
  if (!r.written || !left) return false;
  write_free_ = std::max(r.retire, latency > 0 || !stored.passed ? r.enter : exit_);
  r.loaded = false;
  stored_.pop();
  if (frame_->tokens) writes_.pop();
  return true;
}

void InterpZtestUnit::retire(Cycle cycle) {
  const Stored& stored = stored_.front();
  register_.written = true;
  register_.retire = cycle;
  slot_free_[retired_count_++ % slot_free_.size()] = cycle + 1;
  if (!stored.writes) return;
  retired_ = cycle;
  if (frame_->listener != nullptr) frame_->listener->depth(cycle, writes_.front().depth);
  if (frame_->hierarchical_z != nullptr) {
    frame_->hierarchical_z->update(cycle, {stored.place.x, stored.place.y, stored.greatest});
  }
}

void InterpZtestUnit::exit(Cycle cycle) {
  exit_ = exits_[exit_count_++ % exits_.size()] = cycle;
  if (frame_->listener != nullptr) frame_->listener->color(cycle, colors_.front());
  if (frame_->tokens) colors_.pop();
  colored_.pop();
  if (!colored_.empty()) colored_.front().offered = std::max(colored_.front().offered, cycle + 1);
}

void InterpZtestUnit::count_stall(MemoryPort port, Cycle cycles) {
  frame_->port_stalls[static_cast<size_t>(port)] += cycles;
}

UnitCycles InterpZtestUnit::cycles(Cycle drained) const {
  LocalTime time = time_;
  time.starve(drained);
  return time.cycles();
}

}  // namespace pineda::timing
