#include "model/timing/units/setup_unit.h"

#include <algorithm>

namespace pineda::timing {

SetupUnit::SetupUnit(sc_core::sc_module_name name, const spec::Contract& contract)
    : sc_module(name), contract_(contract) {
  tri_i.bind(*this);
}

void SetupUnit::end_of_elaboration() { require_bound(prim_o, "pineda/setup/unbound"); }

void SetupUnit::begin_frame(Frame* frame) {
  frame_ = frame;
  prim_ = {};
  next_step_ = empty_step_ = last_step_ = inside_until_ = busy_ = frozen_ = total_frozen_ = 0;
  freezes_.clear();
  last_output_ = -1;
}

Cycle SetupUnit::take(const spec::Triangle& triangle, Cycle offered) {
  const core::Drop drop = set_up(triangle);
  ++frame_->counters.triangles;
  ++frame_->counters.dropped[static_cast<size_t>(drop)];

  const Cycle accepted = accept(offered);
  const Cycle step = next_step_;
  const bool sent = drop == core::Drop::kNone;
  const spec::Widths& width = contract_.width;
  const Cycle interval = sent ? width.setup_interval_cycles : width.setup_drop_cycles;
  if (frame_->listener != nullptr) report_work(interval, triangle.id);
  busy_ += interval;
  next_step_ = step + interval;
  last_step_ = step;
  const Cycle inside = sent ? width.setup_latency_cycles + 1 : width.setup_drop_latency_cycles;
  inside_until_ = std::max(inside_until_, step + inside);
  empty_step_ = sent ? next_step_ : step + width.setup_drop_latency_cycles;
  if (!sent) return accepted;
  if (frame_->last_write != nullptr) frame_->last_write->triangle(triangle);
  send(step);
  return accepted;
}

core::Drop SetupUnit::set_up(const spec::Triangle& triangle) {
  const fast::SmallWalk* const walk = frame_->walk;
  const bool needs_prim = walk == nullptr || frame_->planes != fast::Planes::kNone;
  if (needs_prim) {
    return fast::setup(contract_, frame_->state, triangle, &prim_, frame_->planes);
  }
  prim_.id = triangle.id;
  return walk->drop;
}

// The step in which a triangle that could be accepted in `step` has its turn.
Cycle SetupUnit::in_turn(Cycle step) const {
  const bool in_turns = contract_.design.setup_style == spec::SetupStyle::kStepped;
  if (!in_turns || step >= inside_until_) return step;
  const Cycle interval = contract_.width.setup_interval_cycles;
  const Cycle turn = last_step_ + (step - last_step_ + interval - 1) / interval * interval;
  return std::min(turn, inside_until_);
}

Cycle SetupUnit::accept(Cycle offered) {
  const Cycle worked_until = next_step_;
  const auto step = [&] { return in_turn(std::max(next_step_, offered - frozen_)); };
  for (; !freezes_.empty() && freezes_.front().step <= step(); freezes_.pop_front()) {
    // A triangle that comes while the unit is frozen is accepted in the step that ends the freeze.
    next_step_ = std::max(next_step_, freezes_.front().step);
    if (freezes_.front().step >= worked_until) report(freezes_.front());
    frozen_ += freezes_.front().cycles;
  }
  next_step_ = step();
  return next_step_ + frozen_;
}

void SetupUnit::send(Cycle accepted_step) {
  const Cycle step = accepted_step + contract_.width.setup_latency_cycles;
  const Cycle offered = step + total_frozen_;
  last_output_ = prim_o->push(prim_, offered);
  if (frame_->listener != nullptr) frame_->listener->prim(last_output_, prim_);
  if (last_output_ == offered) return;
  freezes_.push_back({step, last_output_ - offered, prim_.id});
  total_frozen_ += last_output_ - offered;
}

// Reports the cycles of the triangle that is accepted in next_step_: busy in its steps, blocked in
// the freezes between them. These freezes belong to earlier outputs, so all of them are listed.
void SetupUnit::report_work(Cycle interval, uint32_t id) const {
  Cycle cycle = next_step_ + frozen_;
  Cycle step = next_step_;
  for (const Freeze& freeze : freezes_) {
    if (freeze.step >= next_step_ + interval) break;
    const Cycle until = cycle + freeze.step - step;
    if (until > cycle) frame_->listener->spent(Unit::kSetup, Cause::kBusy, cycle, until, id);
    cycle = until + freeze.cycles;
    frame_->listener->spent(Unit::kSetup, Cause::kBlocked, until, cycle, freeze.id);
    step = freeze.step;
  }
  frame_->listener->spent(Unit::kSetup, Cause::kBusy, cycle, cycle + next_step_ + interval - step,
                          id);
}

// Reports a freeze that falls into the time of no triangle: the unit has done its work and waits
// for an output to be taken. report_work() reports all other freezes.
void SetupUnit::report(const Freeze& freeze) const {
  if (frame_->listener == nullptr) return;
  const Cycle from = freeze.step + frozen_;
  frame_->listener->spent(Unit::kSetup, Cause::kBlocked, from, from + freeze.cycles, freeze.id);
}

void SetupUnit::drain() {
  for (; !freezes_.empty(); freezes_.pop_front()) {
    if (freezes_.front().step >= next_step_) report(freezes_.front());
    frozen_ += freezes_.front().cycles;
  }
}

Cycle SetupUnit::idle_from() const {
  // total_frozen_ also counts freezes after empty_step_, which would make the first value too
  // large. But such a freeze ends with its output taken, and then the second value is the larger
  // one.
  return std::max(empty_step_ + total_frozen_, last_output_ + 1);
}

UnitCycles SetupUnit::cycles(Cycle drained) const {
  UnitCycles cycles;
  cycles[Cause::kBusy] = busy_;
  cycles[Cause::kBlocked] = total_frozen_;
  cycles[Cause::kStarved] = drained - busy_ - total_frozen_;
  return cycles;
}

}  // namespace pineda::timing
