#include "studies/judge/scene_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/core/frame.h"
#include "studies/judge/scene_truth.h"

namespace pineda::studies {
namespace {

/// Draws triangle by triangle and compares each with its truth.
class SceneDrawing {
 public:
  SceneDrawing(const spec::Contract& contract, const spec::FrameState& frame, TruthCache* truths,
               SceneJudgement* to)
      : contract_(contract),
        frame_(frame),
        truths_(*truths),
        to_(*to),
        buffer_(contract, frame),
        winners_(buffer_.depth.size(), 0),
        colors_(static_cast<size_t>(std::min(spec::channels(contract.design), 4))) {}

  void triangle(const spec::Triangle& triangle, const exact::ScreenJudge& judge);
  const Winners& winners() const { return winners_; }

  // What core::draw_triangle() hands over
  void prim(const spec::SetupPrim&) {}
  void stamp(const spec::Stamp&) {}
  void fragment(const spec::Stamp& stamp, const spec::Fragment& fragment);

 private:
  void sample(int x, int y, size_t lane, const spec::Stamp& stamp, const spec::Fragment& fragment);
  void write(const spec::Stamp& stamp, const spec::Fragment& fragment);

  const spec::Contract& contract_;
  spec::FrameState frame_;
  TruthCache& truths_;
  SceneJudgement& to_;
  core::FrameBuffer buffer_;
  Winners winners_;
  size_t colors_;
  uint32_t drawn_ = 0;
  const Truth* truth_ = nullptr;
  bool affine_ = true;
  std::vector<uint8_t> seen_;  // by index of the truth's sample
};

void SceneDrawing::triangle(const spec::Triangle& triangle, const exact::ScreenJudge& judge) {
  ++drawn_;
  affine_ = judge.affine();
  const int tile = contract_.design.tile_log2;
  for_each_band(judge, frame_.width, tile, [&](int first, int last, exact::Span rows) {
    truth_ = &truths_.truth(drawn_ - 1, judge, rows);
    seen_.assign(truth_->samples().size(), 0);
    core::FrameCounters counters;
    core::draw_triangle(contract_, frame_, {first, last}, triangle, &counters, *this);
    to_.missing += static_cast<uint64_t>(std::count(seen_.begin(), seen_.end(), 0));
  });
}

void SceneDrawing::fragment(const spec::Stamp& stamp, const spec::Fragment& fragment) {
  buffer_.for_each_lane(contract_, stamp.x, stamp.y, stamp.mask, [&](size_t lane, size_t pixel) {
    const auto width = static_cast<size_t>(frame_.width);
    sample(static_cast<int>(pixel % width), static_cast<int>(pixel / width), lane, stamp, fragment);
  });
  write(stamp, fragment);
}

void SceneDrawing::sample(int x, int y, size_t lane, const spec::Stamp& stamp,
                          const spec::Fragment& fragment) {
  const spec::Design& d = contract_.design;
  ++to_.samples;
  const int64_t index = truth_->find(x, y);
  if (index < 0 || seen_[static_cast<size_t>(index)] != 0) {
    ++to_.extra;
    return;
  }
  seen_[static_cast<size_t>(index)] = 1;
  const exact::Sample& truth = truth_->samples()[static_cast<size_t>(index)];
  if (d.depth_test) {
    to_.max_depth_ulp = std::max(to_.max_depth_ulp, std::abs(truth.z.error_of(fragment.z[lane])));
  }
  const auto& values = affine_ ? truth.affine : truth.perspective;
  const auto interpolated = static_cast<size_t>(d.attributes);
  for (size_t c = 0; c < colors_; ++c) {
    const int code =
        c < interpolated ? fragment.attr[lane][c] : stamp.planes.flat[c - interpolated];
    to_.max_color_lsb = std::max(to_.max_color_lsb, std::abs(values[c].error_of(code)));
  }
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
  SceneDrawing drawing(contract, scene.frame, &cache, &judgement);
  exact::Format format = format_of(design);
  format.guard_bits = guard_bits;
  format.attributes = std::min(spec::channels(design), 4);  // what the design makes flat may vary
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
