#include "vectors/grammar/cases.h"

namespace pineda::vectors {
namespace {

constexpr const char* kUnitNames[] = {"setup", "traversal", "interp_ztest", "frame"};

}  // namespace

const char* unit_name(Unit unit) { return kUnitNames[static_cast<int>(unit)]; }

std::optional<Unit> find_unit(const std::string& name) {
  for (int i = 0; i < 4; ++i) {
    if (name == kUnitNames[i]) return static_cast<Unit>(i);
  }
  return std::nullopt;
}

const std::vector<Counter>& counters() {
  static const std::vector<Counter> all = [] {
    std::vector<Counter> columns;
    for (const core::FrameCounter& row : core::kFrameCounters) {
      if (row.known == core::Known::kInTime) continue;
      std::string name = row.is_drop() ? core::drop_key(row.drop) : row.name;
      if (row.is_drop() && row.drop == core::Drop::kNone) name = "kept";
      columns.push_back({std::move(name), &row});
    }
    return columns;
  }();
  return all;
}

}  // namespace pineda::vectors
