// The functional model's samples before the exact judge.
#pragma once

#include "cli/output.h"
#include "model/core/frame.h"
#include "model/exact/exact.h"
#include "model/spec/bounds.h"
#include "studies/judge/mesh_judge.h"

namespace pineda::cli {

/// A triangle as the scene states it, for the judge.
exact::ScreenTriangle stated(const scene::ScreenTriangle& triangle);

/// What exact arithmetic says of a frame: every covered sample of every triangle, hidden ones too,
/// from the floats of the scene on. Colour is judged as the design interpolates it: with
/// perspective or affinely, or as the first vertex's where it is flat.
struct Judgement {
  uint64_t samples = 0;  // judged
  uint64_t missing = 0;  // exact covers, the model does not
  uint64_t extra = 0;    // the model covers, exact does not
  double max_depth_ulp = 0;
  double max_color_lsb = 0;
  spec::ErrorBounds bounds{};  // the design's; of depth with the most that a bias adds to it
  uint64_t beyond = 0;         // samples with a value beyond their triangle's bounds
  std::optional<studies::MeshJudgement> mesh;  // from clip space on

  bool holds() const {
    return missing == 0 && extra == 0 && beyond == 0 && (!mesh || mesh->holds());
  }
};

/// Draws all triangles of the scene on `renderer` and judges them, in bounded memory but for a
/// mesh's largest face: see studies::MeshJudge.
Judgement judge(const scene::Scene& scene, core::Renderer* renderer, Progress* progress);

/// "320 faces from clip space, 12,345 samples, 56 of them in an edge's band", and what is wrong
/// first.
std::string mesh_text(const studies::MeshJudgement& judgement);
Json mesh_json(const studies::MeshJudgement& judgement);

}  // namespace pineda::cli
