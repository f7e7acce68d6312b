// The samples of a stamp, a bit of a mask each.
#pragma once

#include <cstdint>

#include "model/spec/design.h"

namespace pineda::core {

/// Calls visit(lane, column, row) for each lane of `mask`: its number, row by row from the stamp's
/// corner, and its place there in px.
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
