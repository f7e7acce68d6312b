#include "vectors/grammar/cases.h"

namespace pineda::vectors {

const std::vector<Counter>& counters() {
  static const std::vector<Counter> all = [] {
    std::vector<Counter> columns;
    for (const core::FrameCounter& row : core::kFrameCounters) {
      if (row.known == core::Known::kInTime) continue;
      columns.push_back({row.name, &row});
    }
    return columns;
  }();
  return all;
}

}  // namespace pineda::vectors
