#include "model/timing/counted/fifo_levels.h"

#include <algorithm>
#include <cstddef>

#include "model/fast/level.h"

namespace pineda::timing {

namespace {

// The sum over `count` tokens of the cycles from the later one of `before` and `inserted` to
// `after`.
PINEDA_KERNEL(Cycle, add_up,
              (const Cycle* inserted, const Cycle* before, const Cycle* after, size_t count),
              (inserted, before, after, count)) {
  Cycle sum = 0;
  for (size_t n = 0; n < count; ++n) {
    sum += std::max<Cycle>(after[n] - std::max(inserted[n], before[n]), 0);
  }
  return sum;
}

}  // namespace

void FifoLevels::count() {
  for (size_t k = 1; k <= depth_; ++k) {
    const Cycle* const before = &freed_[depth_ - k];
    const Cycle taken = add_up(inserted_.data(), before, before + 1, count_);
    if (taken == 0) break;
    taken_[k] += taken;
  }
  std::copy_n(freed_.begin() + static_cast<std::ptrdiff_t>(count_), depth_, freed_.begin());
  count_ = 0;
}

}  // namespace pineda::timing
