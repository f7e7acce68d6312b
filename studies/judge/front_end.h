// Judges what the readers, clipping and projection made of a mesh, before any design draws it.
#pragma once

#include "model/scene/scene.h"
#include "studies/error/error.h"
#include "studies/judge/mesh_judge.h"

namespace pineda::studies {

/// Judges the exact samples of all pieces of a mesh, in the order of the pieces, which are snapped
/// as `design` snaps them; colours are perspective-correct.
MeshJudgement judge_front_end(const scene::ClipMesh& mesh, const spec::FrameState& frame,
                              const std::vector<SceneTriangle>& pieces, const spec::Design& design);

}  // namespace pineda::studies
