// What pineda check found, and the page that shows it.
#pragma once

#include <string>

#include "cli/judge.h"
#include "model/scene/scene.h"

namespace pineda::cli {

/// One side compared with core: the SystemC model or the RTL.
struct Side {
  std::string name;
  uint64_t compared = 0;           // tokens at the unit boundaries
  uint64_t mismatches = 0;         // of those, or missing
  uint64_t left_out = 0;           // stamps that hierarchical z kept from being sent
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
  double seconds = 0;

  uint64_t mismatches() const {
    const uint64_t hidden = model.left_out == rtl.left_out ? 0 : 1;
    return model.mismatches + model.differing_samples + rtl.mismatches + rtl.differing_samples +
           hidden;
  }
  bool holds() const { return mismatches() == 0 && judgement.holds(); }
};

/// The largest errors with their bounds, or why there is none.
std::string depth_error_text(const Judgement& judgement);
std::string color_error_text(const Judgement& judgement);

/// A page with the pictures beside it and every figure in tables; `settings` say how it was run.
std::string report_html(const CheckResult& result, const scene::Scene& scene,
                        const spec::Contract& contract, const std::string& settings);

}  // namespace pineda::cli
