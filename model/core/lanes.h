// Loops over the lanes (samples) of a stamp's mask.
#pragma once

#include <cstdint>

#include "model/spec/design.h"

namespace pineda::core {

/// Calls visit(lane, column, row) for each lane of `mask`. Lanes are numbered row by row; column
/// and row are px from the stamp's top left corner.
template <class Visitor>
void for_each_lane(const spec::Design& design, uint32_t mask, Visitor&& visit) {
  const int columns = 1 << design.stamp_width_log2;
  for (int lane = 0; mask >> lane != 0; ++lane) {
    if ((mask >> lane & 1) == 0) continue;
    visit(static_cast<size_t>(lane), lane % columns, lane / columns);
  }
}

/// How many lanes `mask` has.
inline int count_lanes(uint32_t mask) {
  int count = 0;
  for (; mask != 0; mask &= mask - 1) ++count;
  return count;
}

}  // namespace pineda::core
