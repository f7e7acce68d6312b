// Judges the functional model's samples by exact arithmetic.
#pragma once

#include "cli/output.h"
#include "model/core/frame.h"
#include "model/judge/comparison.h"
#include "studies/judge/mesh_judge.h"

namespace pineda::cli {

/// What exact arithmetic says of a frame: every covered sample of every triangle, hidden ones too,
/// from the floats of the scene on. Colour is judged as the design interpolates it: with
/// perspective or affinely, or as the first vertex's where it is flat.
struct Judgement : judge::Verdict {
  spec::ErrorBounds bounds{};  // the design's; depth's with the most that a bias adds to it
  std::optional<studies::MeshJudgement> mesh;  // from clip space on

  bool holds() const { return Verdict::holds() && (!mesh || mesh->holds()); }
};

/// Draws all triangles of the scene on `renderer` and judges them, in bounded memory but for a
/// mesh's largest face: see studies::MeshJudge.
Judgement judge(const scene::Scene& scene, core::Renderer* renderer, Progress* progress);

/// "320 faces from clip space, 12,345 samples, 56 of them in an edge's band", and what is wrong
/// first.
std::string mesh_text(const studies::MeshJudgement& judgement);
Json mesh_json(const studies::MeshJudgement& judgement);

}  // namespace pineda::cli
