// Judges one design on one scene by exact arithmetic: the coverage and values of every sample, and
// which triangle is visible in the end.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "model/judge/comparison.h"
#include "studies/judge/scene_truth.h"
#include "studies/needs/scene_use.h"

namespace pineda::studies {

/// What a design must hold at every covered sample of a scene, hidden ones included.
struct SceneLimits {
  double depth_ulp = 1;  // in codes of the design's own depth
  double color_lsb = 1;  // against perspective-correct colours where the w of a triangle differ
  uint64_t other_winner = 0;  // samples that may show another triangle than with exact depths
};

struct SceneJudgement : judge::Verdict {
  uint64_t other_winner = 0;  // samples of the frame that show another triangle
  bool finished = true;       // false: stopped at the first triangle out of the limits

  bool holds(const SceneLimits& limits) const;
  /// Empty if it holds, else what does not, in a few words.
  std::string broken(const SceneLimits& limits) const;
};

struct SceneJudgeOptions {
  SceneLimits limits;
  bool stop_early = false;  // at the first limit that is broken
  std::function<void(uint64_t triangles)> progress;
};

/// Draws the scene with `design` in bounded memory. `guard_bits`: those of the design that the
/// scene was opened for; that design's positions are taken as true. `truths`: keeps exact samples
/// of this scene for further designs with as many channels; or nullptr.
SceneJudgement judge_scene(const scene::Scene& scene, const spec::Design& design, int guard_bits,
                           const Winners& winners, const SceneJudgeOptions& options,
                           TruthCache* truths = nullptr);

}  // namespace pineda::studies
