// Every counter of a frame by its name, to compare two sides of the same frame. Knows no SystemC.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/timing/cycles.h"

namespace pineda::timing {

/// "setup.blocked", "prims.level_2", "depth_read.stalls", "stamps_of_3_samples", "dropped.facing".
struct NamedCount {
  std::string name;
  int64_t count = 0;
};

/// In an order of its own; two frames of one design have the same names.
std::vector<NamedCount> counter_list(const spec::Contract& contract, const CycleCounters& spent,
                                     const core::FrameCounters& counters);

/// A counter on which two sides do not agree.
struct CounterDifference {
  std::string name;
  int64_t model = 0;
  int64_t rtl = 0;
};

/// The counters that differ, in their order. Errors: other names: std::invalid_argument.
std::vector<CounterDifference> counter_differences(const std::vector<NamedCount>& model,
                                                   const std::vector<NamedCount>& rtl);

}  // namespace pineda::timing
