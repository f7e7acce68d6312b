// What is counted of a frame in time, by the model and by the RTL alike: the table of all counters.
// Knows no SystemC.
#pragma once

#include <string>
#include <vector>

#include "model/core/frame_counters.h"
#include "model/timing/counted/cycles.h"

namespace pineda::timing {

/// A frame that was drawn in time, by the model or by the RTL.
struct FrameResult {
  Cycle cycles = 0;  // up to and including the last write accepted, the clear if none
  core::FrameCounters counters;
  CycleCounters spent;
  bool knows_passed = true;  // else counters of core::Known::kIfTested count every sample

  const UnitCycles& of(Unit unit) const { return spent.units[static_cast<size_t>(unit)]; }
};

/// Nothing has happened yet; there is a count for every level of the design's FIFOs.
FrameResult empty_result(const spec::Contract& contract);

/// A row of the table: a counter, as every list, JSON and comparison names it.
struct Counter {
  std::string name;  // "setup.blocked", "prims.level_2", "stamps_of_3_samples", "tiles_rejected"
  std::string json;  // where it stands in a command's JSON: "/units/setup/blocked"; "": left out
  const char* unit;
  std::string meaning;
  std::string rtl;  // the array of the RTL's events, as tb/plugin.cpp names it; "": not counted
  core::RtlKinds kinds;
  core::Known known = core::Known::kAlways;
};

// The rows of CycleCounters.
Counter drained_row();
Counter unit_row(Unit unit, Cause cause);
Counter level_row(Fifo fifo, size_t level);
/// A design without depth has no RTL behind the ports of the depth memory.
Counter stall_row(MemoryPort port, bool has_depth);
Counter stamps_row(size_t samples);
Counter passed_row();
Counter failed_row();
// And those of core::FrameCounters.
Counter frame_row(const core::FrameCounter& row);

/// Calls visit(row, count) for each counter in CycleCounters, of model or RTL; the count can be
/// written where they are not const.
template <class Spent, class Visit>
void for_each_cycle_counter(const spec::Contract& contract, Spent& spent, Visit visit) {
  visit(drained_row(), spent.drained);
  for (size_t u = 0; u < kUnits; ++u) {
    for (size_t c = 0; c < kCauses; ++c) {
      visit(unit_row(static_cast<Unit>(u), static_cast<Cause>(c)), spent.units[u].spent[c]);
    }
  }
  for (size_t f = 0; f < kFifos; ++f) {
    for (size_t level = 0; level < spent.levels[f].size(); ++level) {
      visit(level_row(static_cast<Fifo>(f), level), spent.levels[f][level]);
    }
  }
  for (size_t p = 0; p < kMemoryPorts; ++p) {
    visit(stall_row(static_cast<MemoryPort>(p), contract.design.depth_test), spent.port_stalls[p]);
  }
  for (size_t samples = 0; samples <= static_cast<size_t>(contract.width.lanes); ++samples) {
    visit(stamps_row(samples), spent.stamps_by_samples[samples]);
  }
  visit(passed_row(), spent.samples_passed);
  visit(failed_row(), spent.samples_failed);
}

/// The same for all counters of a frame: those, then core::FrameCounters.
template <class Result, class Visit>
void for_each_counter(const spec::Contract& contract, Result& result, Visit visit) {
  for_each_cycle_counter(contract, result.spent, visit);
  for (const core::FrameCounter& row : core::kFrameCounters) {
    visit(frame_row(row), row.of(result.counters));
  }
}

/// A counter and what it counted.
struct NamedCount {
  std::string name;
  int64_t count = 0;
  core::Known known = core::Known::kAlways;
};

/// In the order of the table; two frames of one design have the same counters.
std::vector<NamedCount> counter_list(const spec::Contract& contract, const FrameResult& result);

/// A counter on which two sides do not agree.
struct CounterDifference {
  std::string name;
  int64_t model = 0;
  int64_t rtl = 0;
  core::Known known = core::Known::kAlways;
};

/// The counters that differ, in their order. Errors: other names: std::invalid_argument.
std::vector<CounterDifference> counter_differences(const std::vector<NamedCount>& model,
                                                   const std::vector<NamedCount>& rtl);

}  // namespace pineda::timing
