// How many slots of a FIFO are taken, cycle by cycle. Knows no SystemC.
#pragma once

#include <algorithm>
#include <vector>

#include "model/timing/cycles.h"

namespace pineda::timing {

/// When the slots of one FIFO are free, and for how many cycles how many of them are taken.
///
/// In       for each token, in order, the cycles in which its slot was taken and freed: a slot
///          taken in t counts from t + 1 on, and up to and including the cycle in which it is
///          freed. Both kinds of cycles only grow.
/// Rate     a step a slot taken, in memory of the FIFO's depth. k slots or more are taken while
///          some token n is in that has the token k - 1 before it in as well:
///            inserted[n] < t <= freed[n - (k - 1)]
///          and of those cycles the ones up to freed[n - k] were counted with token n - 1.
/// Errors   none.
class FifoLevels {
 public:
  explicit FifoLevels(int depth)
      : freed_(static_cast<size_t>(depth), kNever), taken_(static_cast<size_t>(depth) + 1) {}

  void begin_frame() {
    std::fill(freed_.begin(), freed_.end(), kNever);
    std::fill(taken_.begin(), taken_.end(), 0);
    next_ = 0;
  }

  size_t depth() const { return freed_.size(); }
  /// When the slot of the next token was freed; -1 if it has been free all the time.
  Cycle slot_freed() const { return freed_[next_]; }

  void slot(Cycle inserted, Cycle freed) {
    Cycle until = freed;
    size_t slot = next_;
    for (size_t k = 1; until > inserted; ++k) {
      slot = (slot == 0 ? freed_.size() : slot) - 1;
      taken_[k] += until - std::max(inserted, freed_[slot]);
      until = freed_[slot];
    }
    freed_[next_] = freed;
    next_ = next_ + 1 == freed_.size() ? 0 : next_ + 1;
  }

  /// `count` tokens, each of which comes when those before it are freed or are being freed, and is
  /// freed in the cycle after; so is the last one when the next token comes. Then nothing that
  /// comes can meet their releases, which are left out.
  void flow(int count) { taken_[1] += count; }

  /// The cycles of the frame by level, 0 to depth, once every token has left.
  std::vector<Cycle> cycles(Cycle drained) const {
    std::vector<Cycle> cycles = taken_;
    cycles[0] = drained;
    for (size_t k = 1; k < cycles.size(); ++k) cycles[k - 1] -= cycles[k];
    return cycles;
  }

 private:
  static constexpr Cycle kNever = -1;

  std::vector<Cycle> freed_;  // by slot: of its last token
  size_t next_ = 0;           // the slot of the next token
  std::vector<Cycle> taken_;  // by k: the cycles in which k slots or more are taken
};

}  // namespace pineda::timing
