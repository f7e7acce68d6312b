#include "model/timing/interp_ztest_unit.h"

#include <algorithm>

namespace pineda::timing {

InterpZtestUnit::InterpZtestUnit(sc_core::sc_module_name name, const spec::Contract& contract)
    : sc_module(name), contract_(contract) {
  SC_HAS_PROCESS(InterpZtestUnit);
  SC_THREAD(run);
}

void InterpZtestUnit::end_of_elaboration() {
  require_bound(stamp_i, "pineda/interp_ztest/unbound");
  if (contract_.design.depth_test) require_bound(depth_io, "pineda/interp_ztest/unbound");
  require_bound(color_wr_o, "pineda/interp_ztest/unbound");
}

void InterpZtestUnit::begin_frame(Frame* frame) {
  frame_ = frame;
  time_ = {};
  const spec::Design& d = contract_.design;
  columns_ = ((frame->state.width - 1) >> d.stamp_width_log2) + 1;
  const int rows = ((frame->state.height - 1) >> d.stamp_height_log2) + 1;
  address_free_.assign(static_cast<size_t>(columns_) * static_cast<size_t>(rows), 0);
  slot_free_.assign(static_cast<size_t>(contract_.width.inflight_stamps), 0);
  slot_ = 0;
  write_free_ = retired_ = exit_ = -1;
  exits_.assign(static_cast<size_t>(contract_.width.attribute_cycles) + 1, -1);
  next_exit_ = 0;
}

void InterpZtestUnit::run() {
  for (;;) {
    Cycle visible;
    const spec::Stamp& stamp = stamp_i->front(&visible);
    contract_.design.depth_test ? draw(stamp, visible) : color(stamp, visible);
    --frame_->under_way;
  }
}

void InterpZtestUnit::draw(const spec::Stamp& stamp, Cycle visible) {
  const bool test = core::tests_depth(contract_, frame_->state);
  Cycle& address_free = address_free_[static_cast<size_t>(stamp.y) * static_cast<size_t>(columns_) +
                                      static_cast<size_t>(stamp.x)];
  Cycle& slot_free = slot_free_[slot_];
  slot_ = slot_ + 1 == slot_free_.size() ? 0 : slot_ + 1;

  time_.starve(visible);
  if (test) time_.wait_for_address(address_free);
  time_.block(slot_free);
  DepthMemory::Read read{time_.now(), 0, {}};
  if (test) read = depth_io->read({stamp.id, stamp.x, stamp.y, asked(stamp)}, time_.now());
  time_.block(read.accepted);
  time_.work(1);

  core::interpolate_depth(contract_, stamp, &fragment_);
  const uint32_t passed =
      core::depth_test(contract_, frame_->state.depth, stamp.mask, fragment_.z, read.data.z);
  const Cycle data = test ? std::max(read.accepted + 2, read.response + 1) : read.accepted + 2;
  const Cycle offered = std::max(data, write_free_) + 1;
  const Cycle retire = write(stamp, passed, read.data, offered);
  write_free_ = std::max(retire, enter(stamp, passed, offered));
  address_free = slot_free = retire + 1;
  stamp_i->pop(read.accepted);
}

void InterpZtestUnit::color(const spec::Stamp& stamp, Cycle visible) {
  time_.starve(visible);
  time_.block(write_free_);
  const Cycle accepted = time_.now();
  time_.work(1);
  write_free_ = enter(stamp, stamp.mask, accepted + 1);
  stamp_i->pop(accepted);
}

uint32_t InterpZtestUnit::asked(const spec::Stamp& stamp) const {
  const spec::Design& d = contract_.design;
  if (!d.hierarchical_z) return stamp.mask;
  uint32_t mask = 0;
  for (int lane = 0; lane < contract_.width.lanes; ++lane) {
    const int x = (stamp.x << d.stamp_width_log2) + (lane & ((1 << d.stamp_width_log2) - 1));
    const int y = (stamp.y << d.stamp_height_log2) + (lane >> d.stamp_width_log2);
    const bool inside = x < frame_->state.width && y < frame_->state.height;
    mask |= static_cast<uint32_t>(inside) << lane;
  }
  return mask;
}

Cycle InterpZtestUnit::write(const spec::Stamp& stamp, uint32_t passed,
                             const spec::DepthData& stored, Cycle offered) {
  const bool writes = core::tests_depth(contract_, frame_->state) && frame_->state.depth_write;
  if (passed == 0 || !writes) return offered;
  const auto depth = core::depth_write(contract_, stamp, fragment_, passed);
  retired_ = depth_io->write(depth, offered);
  frame_->listener->depth(retired_, depth);
  if (frame_->hierarchical_z != nullptr) {
    const uint32_t greatest = core::depth_ceiling(contract_, fragment_, passed, stored.z);
    frame_->hierarchical_z->update(retired_, {stamp.x, stamp.y, greatest});
  }
  return retired_;
}

Cycle InterpZtestUnit::enter(const spec::Stamp& stamp, uint32_t passed, Cycle offered) {
  if (passed == 0) return offered;
  ++frame_->counters.interpolated;
  frame_->counters.passed += static_cast<uint64_t>(__builtin_popcount(passed));
  core::interpolate_attributes(contract_, stamp, passed, &fragment_);
  const auto color = core::color_write(contract_, stamp, fragment_, passed);
  const int latency = contract_.width.attribute_cycles;
  Cycle& freed = exits_[next_exit_];
  next_exit_ = next_exit_ + 1 == exits_.size() ? 0 : next_exit_ + 1;
  const Cycle entered = std::max(offered, freed + 1);
  exit_ = freed = color_wr_o->write(color, std::max(entered + latency, exit_ + 1));
  frame_->listener->color(exit_, color);
  return latency == 0 ? exit_ : entered;
}

UnitCycles InterpZtestUnit::cycles(Cycle drained) const {
  LocalTime time = time_;
  time.starve(drained);
  return time.cycles();
}

}  // namespace pineda::timing
