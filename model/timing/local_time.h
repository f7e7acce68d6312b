// Local time of a unit: an integer count of cycles, and what each cycle was spent on.
#pragma once

#include <cstdint>

namespace pineda::timing {

/// A cycle of the frame. Cycle 0 is the first clock edge after reset: the frame is taken. From
/// cycle 1 on the memories are asked to clear; once they have, triangles are taken.
using Cycle = int64_t;
inline constexpr Cycle kClearOffered = 1;

/// What the cycles of a unit, from cycle 0 until the frame has drained, were spent on.
struct UnitCycles {
  Cycle busy = 0;
  Cycle starved = 0;  // nothing to work on
  Cycle blocked = 0;  // the next stage, a port or a full table does not take it
  Cycle hazard = 0;   // the stamp's address is in flight (interpolation only)

  Cycle total() const { return busy + starved + blocked + hazard; }
};

/// The only way in which a unit's time moves: every cycle passed is put down to a cause, so the
/// causes add up to the time.
class LocalTime {
 public:
  /// The first cycle that is not spent yet.
  Cycle now() const { return now_; }
  const UnitCycles& cycles() const { return cycles_; }

  /// Spends the cycles before `until`; none if that has passed.
  void starve(Cycle until) { spend(until, &cycles_.starved); }
  void block(Cycle until) { spend(until, &cycles_.blocked); }
  void wait_for_address(Cycle until) { spend(until, &cycles_.hazard); }
  void work(Cycle cycles) { spend(now_ + cycles, &cycles_.busy); }

 private:
  void spend(Cycle until, Cycle* cause) {
    if (until <= now_) return;
    *cause += until - now_;
    now_ = until;
  }

  Cycle now_ = 0;
  UnitCycles cycles_;
};

}  // namespace pineda::timing
