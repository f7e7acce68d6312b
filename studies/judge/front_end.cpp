#include "studies/judge/front_end.h"

#include <algorithm>

#include "model/judge/truth.h"

namespace pineda::studies {

MeshJudgement judge_front_end(const scene::ClipMesh& mesh, const spec::FrameState& frame,
                              const std::vector<SceneTriangle>& pieces,
                              const spec::Design& design) {
  spec::Design exact = design;  // the judge always takes perspective-correct colours
  exact.perspective = true;
  MeshJudge mesh_judge(mesh, spec::contract(exact), frame);
  const auto channels = std::min<size_t>(static_cast<size_t>(spec::channels(design)), 4);
  const auto smooth = static_cast<size_t>(design.attributes);
  judge::ScreenTruth truth;
  for (const SceneTriangle& piece : pieces) {
    truth.judge({piece.screen, judge::format_of(design), judge::exact_frame(frame)});
    for (const exact::Sample& sample : truth.samples()) {
      MeshHit hit{
          sample.x, sample.y, piece.snapped.id, static_cast<uint32_t>(sample.z.nearest), {}};
      for (size_t k = 0; k < channels; ++k) {
        hit.color[k] = k < smooth ? static_cast<int32_t>(truth.attribute(sample, k, true).nearest)
                                  : truth.flat()[k];
      }
      mesh_judge.hit(hit);
    }
  }
  return mesh_judge.finish();
}

}  // namespace pineda::studies
