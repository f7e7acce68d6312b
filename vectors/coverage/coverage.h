// The collector: which bins of the table cases hit.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "vectors/coverage/point.h"
#include "vectors/grammar/cases.h"

namespace pineda::vectors {

/// What was seen of one point.
struct PointHits {
  std::string name;
  std::string what;
  Bins bins;
  std::vector<uint64_t> count;  // by bin
};

size_t reachable_bins(const std::vector<PointHits>& points);
/// Those of them that were hit.
size_t hit_bins(const std::vector<PointHits>& points);
/// "mask: 5 lanes, called unreachable: ...", where such a bin was hit.
std::vector<std::string> contradictions(const std::vector<PointHits>& points);

/// Collects the bins that the cases of one unit hit.
///
/// In       cases of the unit in the formats of the design. A frame is seen at every unit.
/// Out      points(): the rows of the table that the unit and the design have.
/// Errors   none; what is hit although the table calls it unreachable is listed: an illegal input, or a wrong
///          reason.
class Coverage {
 public:
  Coverage(Unit unit, const spec::Contract& contract);
  ~Coverage();

  void see(const SetupCase& value);
  void see(const TraversalCase& value);
  void see(const InterpZtestCase& value);
  void see(const FrameCase& value);

  std::vector<PointHits> points() const;
  /// hit_bins(points()), quickly.
  size_t hit() const;

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

}  // namespace pineda::vectors
