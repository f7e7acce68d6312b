// What pineda study cycles prints of its rows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/output.h"
#include "studies/cycles/compare_cycles.h"

namespace pineda::cli {

/// A row of the table.
struct CycleRow {
  std::string scene, design, memory, stall;
  std::optional<int> latency_cycles;  // of an ideal memory
  scene::Size size;
  uint64_t triangles = 0;
  studies::CyclePoint point;

  bool holds() const {
    return point.holds(memory != spec::name_of(memory::Kind::kIdeal) ||
                       stall != spec::name_of(memory::StallMode::kNone));
  }

  double rtl_speed() const { return speed(point.fastest() ? point.fastest()->seconds : 0); }
  double time_speed() const { return speed(point.time_seconds); }
  double bits_speed() const { return speed(point.bits_seconds); }
  /// M cycles/s; 0: not measured.
  double speed(double seconds) const {
    return seconds > 0 ? 1e-6 * static_cast<double>(point.rtl_cycles) / seconds : 0;
  }
};

void print_columns(const Output& output);
void print_row(const Output& output, const CycleRow& row);
Json row_json(const CycleRow& row);

/// The worst of some rows.
struct CycleWorst {
  std::string design;  // "all": of several
  size_t rows = 0;
  size_t off = 0;  // of them: those in which anything differs
  size_t counters_off = 0;
  double error = 0;
  int64_t p99 = 0;
  int64_t max = 0;
  bool holds = true;
};
/// The worst rows by design, in their order; of several designs, a last entry covers all rows.
std::vector<CycleWorst> worst_of(const std::vector<CycleRow>& rows);
void print_worst(const Output& output, const std::vector<CycleWorst>& all);
Json worst_json(const std::vector<CycleWorst>& all);

/// Geometric means of the rows whose speed was measured, M cycles/s; 0: of none.
struct CycleMeans {
  double rtl = 0;
  double time = 0;
  double bits = 0;
};
CycleMeans means_of(const std::vector<CycleRow>& rows);
void print_means(const Output& output, const CycleMeans& means);
Json means_json(const CycleMeans& means);

}  // namespace pineda::cli
