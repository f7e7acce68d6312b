// What clipping, projection and the readers made of a mesh, before any design has drawn it.
#pragma once

#include "model/scene/scene.h"
#include "studies/error/error.h"
#include "studies/judge/mesh_judge.h"

namespace pineda::studies {

/// Judges the exact samples of a mesh's pieces, all of them in their order, snapped as `design`
/// snaps; colours with perspective.
MeshJudgement judge_front_end(const scene::ClipMesh& mesh, const spec::FrameState& frame,
                              const std::vector<SceneTriangle>& pieces, const spec::Design& design);

}  // namespace pineda::studies
