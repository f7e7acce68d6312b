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
  require_bound(depth_io, "pineda/interp_ztest/unbound");
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
  write_free_ = last_write_ = -1;
}

void InterpZtestUnit::run() {
  for (;;) {
    Cycle visible;
    const spec::Stamp& stamp = stamp_i->front(&visible);
    draw(stamp, visible);
  }
}

void InterpZtestUnit::draw(const spec::Stamp& stamp, Cycle visible) {
  const bool test = frame_->state.depth != spec::DepthFunc::kOff;
  Cycle& address_free = address_free_[static_cast<size_t>(stamp.y) * static_cast<size_t>(columns_) +
                                      static_cast<size_t>(stamp.x)];
  Cycle& slot_free = slot_free_[slot_];
  slot_ = slot_ + 1 == slot_free_.size() ? 0 : slot_ + 1;

  time_.starve(visible);
  if (test) time_.wait_for_address(address_free);
  time_.block(slot_free);
  DepthMemory::Read read{time_.now(), 0, {}};
  if (test) read = depth_io->read({stamp.id, stamp.x, stamp.y, stamp.mask}, time_.now());
  time_.block(read.accepted);
  time_.work(1);

  spec::Fragment fragment;
  core::interpolate(contract_, stamp, &fragment);
  const uint32_t passed =
      core::depth_test(contract_, frame_->state.depth, stamp.mask, fragment.z, read.data.z);
  const Cycle data = test ? std::max(read.accepted + 2, read.response + 1) : read.accepted + 2;
  const Cycle load = std::max(data, write_free_);
  const Cycle retire = write(stamp, fragment, passed, load + 1);
  address_free = slot_free = retire + 1;
  stamp_i->pop(read.accepted);
}

Cycle InterpZtestUnit::write(const spec::Stamp& stamp, const spec::Fragment& fragment,
                             uint32_t passed, Cycle offered) {
  write_free_ = offered;
  if (passed == 0) return offered;
  frame_->counters.passed += static_cast<uint64_t>(__builtin_popcount(passed));
  Cycle retire = offered;
  if (frame_->state.depth != spec::DepthFunc::kOff) {
    const auto depth = core::depth_write(contract_, stamp, fragment, passed);
    retire = depth_io->write(depth, offered);
    frame_->listener->depth(retire, depth);
  }
  const auto color = core::color_write(contract_, stamp, fragment, passed);
  const Cycle colored = color_wr_o->write(color, offered);
  frame_->listener->color(colored, color);
  write_free_ = last_write_ = std::max(retire, colored);
  return retire;
}

UnitCycles InterpZtestUnit::cycles(Cycle drained) const {
  LocalTime time = time_;
  time.starve(drained);
  return time.cycles();
}

}  // namespace pineda::timing
