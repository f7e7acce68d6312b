// Local time of a unit: an integer count of cycles, and what each cycle was spent on.
#pragma once

#include "model/timing/units/frame.h"

namespace pineda::timing {

/// The only way in which a unit's time moves: every cycle passed is put down to a cause, so the
/// causes add up to the time.
class LocalTime {
 public:
  LocalTime() = default;
  LocalTime(Unit unit, Listener* listener) : unit_(unit), listener_(listener) {}

  /// The first cycle that is not spent yet.
  Cycle now() const { return now_; }
  const UnitCycles& cycles() const { return cycles_; }

  /// Spends the cycles before `until` on triangle `id`; none if that has passed.
  void spend(Cause cause, Cycle until, uint32_t id) {
    if (until <= now_) return;
    if (listener_ != nullptr && cause != Cause::kStarved) {
      listener_->spent(unit_, cause, now_, until, id);
    }
    cycles_[cause] += until - now_;
    now_ = until;
  }
  void starve(Cycle until) { spend(Cause::kStarved, until, 0); }
  void work(Cycle cycles, uint32_t id) { spend(Cause::kBusy, now_ + cycles, id); }
  /// Spends the cycles before `until`, `busy` of them on work, between which it is blocked. Not
  /// told to a listener.
  void work_at_times(Cycle busy, Cycle until) {
    cycles_[Cause::kBusy] += busy;
    cycles_[Cause::kBlocked] += until - now_ - busy;
    now_ = until;
  }

 private:
  Cycle now_ = 0;
  UnitCycles cycles_;
  Unit unit_ = Unit::kSetup;
  Listener* listener_ = nullptr;
};

}  // namespace pineda::timing
