// Finds the smallest design that draws a scene right.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "studies/judge/scene_judge.h"
#include "studies/needs/design_cost.h"

namespace pineda::studies {

struct NeedsOptions {
  spec::Design base = spec::kHighTile;  // no parameter exceeds it; perspective may be added
  double depth_ulp = 1;                 // in codes of the design's own depth
  double color_lsb = 1;
  std::function<void(uint64_t designs, uint64_t triangles)> progress;
};

/// One parameter that may shrink.
struct Need {
  std::string parameter;  // named as in a design file; the reciprocal's four count as one
  std::string base;       // value; "-" where the design does not use it
  std::string value;
  int64_t saved_bits = 0;  // what design_cost() would grow by with the base's value instead
  std::string next;        // the next smaller value, empty if there is none
  std::string forbids;     // what the next value would break
};

struct Needs {
  SceneUse use;
  SceneLimits limits;  // its other_winner is the base's
  // The base, or the base with perspective if the scene's colours exceed the limit without it. If
  // this design does not hold there is no answer.
  spec::Design start;
  SceneJudgement of_start;
  bool found = false;
  spec::Design design;  // its name and summary live as long as the program
  SceneJudgement judgement;
  std::vector<Need> parameters;
  DesignCost base_cost;
  DesignCost cost;
  uint64_t judged_designs = 0;
};

/// Shrinks the base's guard_bits, depth_test, attributes (those that the first vertex may give
/// become flat), perspective, depth_bits, the reciprocal, gradient_fraction_bits,
/// tile_fraction_bits and inverse_w_bits while every sample of the scene stays within the limits,
/// coverage is exact and no more samples show another triangle than with the base. Each parameter
/// is bisected; then no parameter can be made smaller alone. What throughput or the snapped
/// positions depend on stays: tiles, stamps, FIFOs, subpixel_bits; setup gets no slower.
///
/// In       a scene that can be rewound, opened for the base. With a depth bias, which is in codes
///          of the base, depth_bits stays.
Needs find_needs(const scene::Scene& scene, const NeedsOptions& options);

}  // namespace pineda::studies
