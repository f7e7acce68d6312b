// How many slots of a FIFO are taken, cycle by cycle. Knows no SystemC.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "model/timing/counted/cycles.h"

namespace pineda::timing {

/// When the slots of one FIFO are free, and for how many cycles how many of them are taken.
///
/// In       for each token, in order, the cycles in which its slot was taken and freed: a slot
///          taken in t counts from t + 1 on, and up to and including the cycle in which it is
///          freed. Both kinds of cycles only grow.
/// Rate     token n and the k - 1 tokens before it are all in the FIFO in the cycles t with
///            inserted[n] < t <= freed[n - (k - 1)]
///          so in these k slots or more are taken. Those up to freed[n - k] were counted with token
///          n - 1. Tokens are counted some at a time: for k = 1, 2, ... until a k has no cycles.
/// Errors   none.
class FifoLevels {
 public:
  explicit FifoLevels(int depth)
      : depth_(static_cast<size_t>(depth)), freed_(depth_ + kTogether), taken_(depth_ + 1) {
    begin_frame();
  }

  void begin_frame() {
    std::fill(freed_.begin(), freed_.end(), kNever);
    std::fill(taken_.begin(), taken_.end(), 0);
    count_ = 0;
  }

  size_t depth() const { return depth_; }
  /// When the slot of the next token was freed; -1 if it has been free all the time.
  Cycle slot_freed() const { return freed_[count_]; }

  void slot(Cycle inserted, Cycle freed) {
    inserted_[count_] = inserted;
    freed_[depth_ + count_] = freed;
    if (++count_ == kTogether) count();
  }

  /// `count` tokens that flow through: when one comes, all before it have been freed or are being
  /// freed, and it is freed in the cycle after. The same holds when the next token comes. So no
  /// later token waits for their slots, and it need not be kept when they were freed.
  void flow(int count) { taken_[1] += count; }

  /// The cycles of the frame by level, 0 to depth, once every token has left.
  std::vector<Cycle> cycles(Cycle drained) const {
    FifoLevels all = *this;
    all.count();
    std::vector<Cycle> cycles = all.taken_;
    cycles[0] = drained;
    for (size_t k = 1; k < cycles.size(); ++k) cycles[k - 1] -= cycles[k];
    return cycles;
  }

 private:
  static constexpr Cycle kNever = -1;
  static constexpr size_t kTogether = 32;

  void count();

  size_t depth_;
  size_t count_ = 0;                         // tokens that are not counted yet
  std::array<Cycle, kTogether> inserted_{};  // of those tokens
  std::vector<Cycle> freed_;                 // of the `depth` tokens before them, then of those
  std::vector<Cycle> taken_;                 // by k: the cycles in which k slots or more are taken
};

}  // namespace pineda::timing
