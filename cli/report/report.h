// What pineda check found, and the page that shows it.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <string>

#include "cli/report/differ.h"
#include "cli/report/judge.h"
#include "model/scene/scene.h"
#include "model/timing/counted/counters.h"

namespace pineda::cli {

/// One side compared with core: the SystemC model or the RTL.
struct Side {
  std::string name;
  uint64_t compared = 0;           // tokens at the unit boundaries
  uint64_t mismatches = 0;         // of those, or missing
  uint64_t left_out = 0;           // stamps that hierarchical z kept from being sent
  uint64_t differing_samples = 0;  // of the memories at the end of the frame
  std::string first_divergence;
  timing::FrameResult frame;
  std::vector<int64_t> retired;  // studies::RetireCycles
  double seconds = 0;
};

struct CheckResult {
  scene::Counters input;
  core::FrameCounters counters;
  Side model;
  Side rtl;
  size_t counters_compared = 0;
  std::vector<timing::CounterDifference> counters_differ;  // of model and RTL
  studies::RetireErrors retire;
  std::optional<FirstRetireDifference> first_retire;
  Judgement judgement;
  double seconds = 0;

  uint64_t mismatches() const {
    const uint64_t hidden = model.left_out == rtl.left_out ? 0 : 1;
    return model.mismatches + model.differing_samples + rtl.mismatches + rtl.differing_samples +
           hidden;
  }
  double cycle_error() const {
    const timing::Cycle apart = std::abs(model.frame.cycles - rtl.frame.cycles);
    return static_cast<double>(apart) /
           static_cast<double>(std::max<timing::Cycle>(1, rtl.frame.cycles));
  }
  bool holds() const {
    return mismatches() == 0 && judgement.holds() && cycle_error() <= studies::kCycleErrorBound &&
           counters_differ.empty();
  }
};

/// The cycles of both, and how far apart where that is more than the bound.
std::string cycles_text(const CheckResult& result);
/// "72 compared, all equal".
std::string counters_text(const CheckResult& result);
/// The largest errors with their bounds, or why there is none.
std::string depth_error_text(const Judgement& judgement);
std::string color_error_text(const Judgement& judgement);

/// A page with the pictures beside it and every figure in tables; `settings` say how it was run.
std::string report_html(const CheckResult& result, const scene::Scene& scene,
                        const spec::Contract& contract, const std::string& settings);

}  // namespace pineda::cli
