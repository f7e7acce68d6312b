// What each parameter of a design costs and buys: one at a time, on one scene.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/spec/bounds.h"
#include "studies/judge/scene_judge.h"
#include "studies/needs/design_cost.h"

namespace pineda::studies {

/// A design that differs from the base in one parameter; the reciprocal's four count as one.
struct ParameterPoint {
  std::string parameter;  // by its name in a design file, "reciprocal" for its four
  std::string value;
  bool is_base = false;
  spec::Design design;
  DesignCost cost;
  spec::ErrorBounds bounds;
  SceneJudgement judgement;  // every sample of the scene
  int64_t cycles = 0;        // of the frame, by the SystemC model
};

struct ParameterOptions {
  spec::Design base = spec::kHighTile;
  std::vector<std::string> parameters;  // all of them if empty
  std::function<void(const std::string& parameter, uint64_t triangles)> progress;
};

/// The points that the study tries, the base's own values among them, in the order of the
/// parameters. Values that cannot be built with the base's other parameters, or whose frames are
/// too small, are left out.
std::vector<ParameterPoint> parameter_points(const spec::Design& base,
                                             const spec::FrameState& frame);

/// Judges and times each point.
///
/// In       a scene that can be rewound, opened for the base; no depth bias.
/// Errors   std::invalid_argument for a parameter that the study does not try.
std::vector<ParameterPoint> study_parameters(const scene::Scene& scene,
                                             const ParameterOptions& options);

}  // namespace pineda::studies
