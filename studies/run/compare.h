// What changed between two sets of results.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "studies/run/results.h"

namespace pineda::studies {

/// One figure of one scene, design, memory and measure, in two sets.
struct Change {
  const Row* row;  // that it stands in
  std::string figure;
  double before = 0;
  double after = 0;

  /// Of a figure that was 0: infinite.
  double share() const { return after / before - 1; }
};

struct Comparison {
  std::vector<Change> changes;  // by more than the tolerance, the greatest first
  std::vector<const Row*> only_before, only_after;
  size_t rows = 0;     // in both
  size_t figures = 0;  // compared
};

/// Compares figures of rows with the same scene, design, memory and measure, whatever their keys; those
/// of this machine's speed are left out. The rows must outlive the result. `tolerance`: a share.
Comparison compare(const std::vector<Row>& before, const std::vector<Row>& after, double tolerance);

}  // namespace pineda::studies
