#include "model/timing/setup_unit.h"

#include <algorithm>

namespace pineda::timing {

SetupUnit::SetupUnit(sc_core::sc_module_name name, const spec::Contract& contract)
    : sc_module(name), contract_(contract) {
  SC_HAS_PROCESS(SetupUnit);
  SC_THREAD(run);
}

void SetupUnit::end_of_elaboration() {
  require_bound(tri_i, "pineda/setup/unbound");
  require_bound(prim_o, "pineda/setup/unbound");
}

void SetupUnit::begin_frame(Frame* frame) {
  frame_ = frame;
  next_step_ = empty_step_ = busy_ = frozen_ = total_frozen_ = 0;
  freezes_.clear();
  last_output_ = -1;
}

void SetupUnit::run() {
  for (;;) {
    Cycle offered;
    const spec::Triangle& triangle = tri_i->front(&offered);
    spec::SetupPrim prim;
    const core::Drop drop = core::setup(contract_, frame_->state, triangle, &prim);
    ++frame_->counters.triangles;
    ++frame_->counters.dropped[static_cast<size_t>(drop)];

    tri_i->pop(accept(offered));
    const Cycle step = next_step_;
    const bool sent = drop == core::Drop::kNone;
    const spec::Widths& width = contract_.width;
    const Cycle interval = sent ? width.setup_interval_cycles : width.setup_drop_cycles;
    busy_ += interval;
    next_step_ = step + interval;
    empty_step_ = sent ? next_step_ : step + width.setup_drop_latency_cycles;
    if (sent) send(prim, step);
  }
}

Cycle SetupUnit::accept(Cycle offered) {
  const auto step = [&] { return std::max(next_step_, offered - frozen_); };
  for (; !freezes_.empty() && freezes_.front().step <= step(); freezes_.pop_front()) {
    // A triangle that comes while the unit is frozen is accepted in the step that ends the freeze.
    next_step_ = std::max(next_step_, freezes_.front().step);
    frozen_ += freezes_.front().cycles;
  }
  next_step_ = step();
  return next_step_ + frozen_;
}

void SetupUnit::send(const spec::SetupPrim& prim, Cycle accepted_step) {
  const Cycle step = accepted_step + contract_.width.setup_latency_cycles;
  const Cycle offered = step + total_frozen_;
  last_output_ = prim_o->push(prim, offered);
  frame_->listener->prim(last_output_, prim);
  if (last_output_ == offered) return;
  freezes_.push_back({step, last_output_ - offered});
  total_frozen_ += last_output_ - offered;
}

Cycle SetupUnit::idle_from() const {
  // A freeze still ahead of empty_step_ belongs to an output, which then is the later of the two.
  return std::max(empty_step_ + total_frozen_, last_output_ + 1);
}

UnitCycles SetupUnit::cycles(Cycle drained) const {
  UnitCycles cycles;
  cycles.busy = busy_;
  cycles.blocked = total_frozen_;
  cycles.starved = drained - busy_ - total_frozen_;
  return cycles;
}

}  // namespace pineda::timing
