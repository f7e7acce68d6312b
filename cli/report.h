// What pineda check found, and the page that shows it.
#pragma once

#include <string>

#include "cli/judge.h"
#include "model/scene/scene.h"
#include "model/spec/bounds.h"

namespace pineda::cli {

/// One side compared with core: the SystemC model or the RTL.
struct Side {
  std::string name;
  uint64_t compared = 0;           // tokens at the unit boundaries
  uint64_t mismatches = 0;         // of those, or missing
  uint64_t differing_samples = 0;  // of the memories at the end of the frame
  std::string first_divergence;
  uint64_t cycles = 0;
  double seconds = 0;
};

struct CheckResult {
  scene::Counters input;
  core::FrameCounters counters;
  Side model;
  Side rtl;
  Judgement judgement;
  spec::ErrorBounds bounds;
  double seconds = 0;

  uint64_t mismatches() const {
    return model.mismatches + model.differing_samples + rtl.mismatches + rtl.differing_samples;
  }
  bool errors_hold() const {
    return judgement.missing == 0 && judgement.extra == 0 &&
           judgement.max_depth_ulp <= bounds.depth_ulp &&
           judgement.max_color_lsb <= bounds.attribute_lsb;
  }
  bool holds() const { return mismatches() == 0 && errors_hold(); }
};

/// A page with the pictures beside it and every figure in tables; `settings` say how it was run.
std::string report_html(const CheckResult& result, const scene::Scene& scene,
                        const spec::Contract& contract, const std::string& settings);

}  // namespace pineda::cli
