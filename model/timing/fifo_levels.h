// How many slots of a FIFO are taken, cycle by cycle. Knows no SystemC.
#pragma once

#include <vector>

#include "model/timing/cycles.h"

namespace pineda::timing {

/// Counts the cycles that begin at each level of one FIFO.
///
/// In       for each token, in order, the cycles in which its slot was taken and freed: a slot
///          taken in t counts from t + 1 on, and up to and including the cycle in which it is
///          freed.
/// Rate     a few steps a token in memory of the FIFO's depth: both kinds of cycles only grow, so
///          the releases that an insertion has passed are taken off first.
/// Errors   none.
class FifoLevels {
 public:
  explicit FifoLevels(int depth)
      : freed_(static_cast<size_t>(depth)), cycles_(static_cast<size_t>(depth) + 1) {}

  void begin_frame() {
    cycles_.assign(cycles_.size(), 0);
    oldest_ = level_ = 0;
    now_ = 0;
  }

  void slot(Cycle inserted, Cycle freed) {
    while (level_ > 0 && freed_[oldest_] <= inserted) release();
    pass(inserted);
    size_t newest = oldest_ + level_++;
    if (newest >= freed_.size()) newest -= freed_.size();
    freed_[newest] = freed;
  }

  /// `count` tokens, each of which finds the FIFO empty or being emptied and is freed in the cycle
  /// after it came, the last one in `freed`.
  void flow(int count, Cycle freed) {
    while (level_ > 0) release();
    cycles_[1] += count;
    cycles_[0] += freed + 1 - now_ - count;
    now_ = freed + 1;
  }

  /// The cycles of the frame by level, 0 to depth, once every token has left.
  std::vector<Cycle> cycles(Cycle drained) const {
    FifoLevels rest = *this;
    while (rest.level_ > 0) rest.release();
    rest.pass(drained - 1);
    return rest.cycles_;
  }

 private:
  // Cycles up to and including this one began at the level that holds now.
  void pass(Cycle last) {
    cycles_[level_] += last + 1 - now_;
    now_ = last + 1;
  }
  void release() {
    pass(freed_[oldest_]);
    oldest_ = oldest_ + 1 == freed_.size() ? 0 : oldest_ + 1;
    --level_;
  }

  std::vector<Cycle> freed_;  // of the slots that are taken: a ring of `level_` from `oldest_` on
  size_t oldest_ = 0;
  size_t level_ = 0;
  Cycle now_ = 0;  // the first cycle that is not counted yet
  std::vector<Cycle> cycles_;
};

}  // namespace pineda::timing
