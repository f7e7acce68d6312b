#include "studies/judge/scene_judge.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/judge/drawing.h"

namespace pineda::studies {
namespace {

/// All colours, taken as perspective-correct, also those that the design makes flat.
judge::Values colors_of(const spec::Design& design) {
  const int colors = std::min(spec::channels(design), 4);
  return {design.depth_test, colors, colors, true};
}

/// Draws triangle by triangle and compares each with its truth.
class SceneDrawing {
 public:
  SceneDrawing(const spec::Contract& contract, const spec::FrameState& frame,
               const SceneLimits& limits, TruthCache* truths, judge::Verdict* to)
      : contract_(contract),
        frame_(frame),
        limits_{limits.depth_ulp, limits.color_lsb},
        truths_(*truths),
        comparison_(colors_of(contract.design), to),
        buffer_(contract, frame),
        winners_(buffer_.depth.size(), 0) {}

  void triangle(const spec::Triangle& triangle, const exact::ScreenJudge& judge);
  const Winners& winners() const { return winners_; }

 private:
  void write(const spec::Stamp& stamp, const spec::Fragment& fragment);

  const spec::Contract& contract_;
  spec::FrameState frame_;
  spec::ErrorBounds limits_;
  TruthCache& truths_;
  judge::Comparison comparison_;
  core::FrameBuffer buffer_;
  Winners winners_;
  uint32_t drawn_ = 0;
};

void SceneDrawing::triangle(const spec::Triangle& triangle, const exact::ScreenJudge& judge) {
  ++drawn_;
  const spec::Design& d = contract_.design;
  for_each_band(judge, frame_.width, d.tile_log2, [&](int first, int last, exact::Span rows) {
    comparison_.begin(truths_.truth(drawn_ - 1, judge, rows), limits_, triangle.id);
    judge::for_each_fragment(contract_, frame_, {first, last}, triangle,
                             [&](const spec::Stamp& stamp, const spec::Fragment& fragment) {
                               judge::for_each_sample(
                                   d, stamp, fragment,
                                   [&](const judge::Drawn& drawn) { comparison_.sample(drawn); });
                               write(stamp, fragment);
                             });
    comparison_.end();
  });
}

void SceneDrawing::write(const spec::Stamp& stamp, const spec::Fragment& fragment) {
  uint32_t passed = stamp.mask;
  if (core::tests_depth(contract_, frame_)) {
    const auto stored = buffer_.read(contract_, stamp.x, stamp.y, stamp.mask);
    passed = core::depth_test(contract_, frame_.depth, stamp.mask, fragment.z, stored.z);
    if (frame_.depth_write) {
      buffer_.write(contract_, core::depth_write(contract_, stamp, fragment, passed));
    }
  }
  buffer_.for_each_lane(contract_, stamp.x, stamp.y, passed,
                        [&](size_t, size_t pixel) { winners_[pixel] = drawn_; });
}

}  // namespace

bool SceneJudgement::holds(const SceneLimits& limits) const { return broken(limits).empty(); }

std::string SceneJudgement::broken(const SceneLimits& limits) const {
  const char* least = finished ? "" : " or more";
  if (missing + extra > 0) return fmt::format("{} samples missing, {} too many", missing, extra);
  if (max_depth_ulp > limits.depth_ulp) {
    return fmt::format("depth error {:.2f} ulp{}", max_depth_ulp, least);
  }
  if (max_color_lsb > limits.color_lsb) {
    return fmt::format("colour error {:.2f} LSB{}", max_color_lsb, least);
  }
  if (other_winner > limits.other_winner) {
    return fmt::format("{} samples show another triangle", other_winner);
  }
  return {};
}

SceneJudgement judge_scene(const scene::Scene& scene, const spec::Design& design, int guard_bits,
                           const Winners& winners, const SceneJudgeOptions& options,
                           TruthCache* truths) {
  SceneJudgement judgement;
  const spec::Contract contract = spec::contract(design);
  TruthCache none(0);
  TruthCache& cache = truths != nullptr ? *truths : none;
  SceneDrawing drawing(contract, scene.frame, options.limits, &cache, &judgement);
  exact::Format format = judge::format_of(design);
  format.guard_bits = guard_bits;
  format.attributes = std::min(spec::channels(design), 4);  // also those that the design makes flat
  cache.start(format);
  for_each_judged(scene, contract, format,
                  [&](const spec::Triangle& triangle, const exact::ScreenJudge& judge) {
                    drawing.triangle(triangle, judge);
                    if (options.progress) options.progress(triangle.id);
                    if (options.stop_early) judgement.finished = judgement.holds(options.limits);
                    return judgement.finished;
                  });
  if (!judgement.finished) return judgement;
  for (size_t i = 0; i < winners.size(); ++i) {
    judgement.other_winner += winners[i] != drawing.winners()[i] ? 1 : 0;
  }
  return judgement;
}

}  // namespace pineda::studies
