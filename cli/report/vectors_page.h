// The page of verification: test plan, bins, code and mutants beside each other.
#pragma once

#include <list>
#include <string>
#include <vector>

#include "cli/report/code_coverage.h"
#include "cli/report/testplan.h"
#include "studies/vectors/timed_coverage.h"

namespace pineda::cli {

/// The points of one unit, with the cases that hit them.
class UnitBins {
 public:
  UnitBins(vectors::Unit unit, const spec::Contract& contract)
      : unit_(unit), coverage_(unit, contract) {}

  template <class Case>
  void see(const Case& value) {
    coverage_.see(value);
    note(value.name);
  }

  /// How many names of cases a bin keeps.
  static constexpr size_t kNames = 3;
  struct Hitters {
    uint64_t cases = 0;
    std::vector<std::string> names;  // of the first
  };
  vectors::Unit unit() const { return unit_; }
  uint64_t cases() const { return cases_; }
  uint64_t not_timed() const { return coverage_.not_timed(); }
  const std::vector<vectors::PointHits>& points() const { return points_; }
  /// Who hit a bin.
  const Hitters& hitters(size_t point, size_t bin) const { return hitters_[point][bin]; }

 private:
  void note(const std::string& name);

  vectors::Unit unit_;
  vectors::WholeCoverage coverage_;
  uint64_t cases_ = 0;
  std::vector<vectors::PointHits> points_;
  std::vector<std::vector<Hitters>> hitters_;  // by point and bin
};

/// Mutants of a unit of the RTL, and what became of them.
struct UnitMutants {
  std::string unit;
  uint64_t mutants = 0, killed_level1 = 0, killed_level2 = 0, equivalent = 0, undecided = 0;

  uint64_t surviving() const;
};

/// A mutant of the functional model.
struct CoreMutant {
  std::string file, text, replacement;
};

struct VectorsPage {
  std::string design;
  std::string settings;  // "level 1, seed 1"
  std::vector<Testpoint> plan;
  std::list<UnitBins> bins;
  CodeCoverage code;
  std::vector<UnitMutants> mutants;  // none: not scored
  std::vector<CoreMutant> core;
};

std::string vectors_page_html(const VectorsPage& page);

}  // namespace pineda::cli
