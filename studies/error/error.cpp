#include "studies/error/error.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "model/fast/renderer.h"
#include "studies/judge/scorer.h"

namespace pineda::studies {
namespace {

template <class Call>
double seconds_of(Call&& call) {
  const auto start = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A subject during the study: how it is drawn, scored and timed.
class Contestant {
 public:
  virtual ~Contestant() = default;
  virtual void score(const spec::Triangle& triangle, const judge::ScreenTruth& truth) = 0;
  /// Called after all triangles; for subjects that are judged by their frame.
  virtual void score_frame(const std::vector<SceneTriangle>&, const judge::VisibleFrame&) {}
  /// Seconds to draw a frame, its clear included. Memories are allocated only for the call.
  virtual double frame_seconds(const std::vector<SceneTriangle>& triangles) = 0;

  virtual Subject& subject() = 0;
};

class DesignContestant final : public Contestant {
 public:
  DesignContestant(const spec::Design& design, const spec::FrameState& frame, bool map)
      : contract_(spec::contract(design)), frame_(frame), scorer_(design, frame, map) {}

  Subject& subject() override { return scorer_.subject(); }
  void score(const spec::Triangle& triangle, const judge::ScreenTruth& truth) override {
    scorer_.score(triangle, truth);
  }
  double frame_seconds(const std::vector<SceneTriangle>& triangles) override {
    fast::Renderer renderer(contract_, frame_);
    return seconds_of([&] {
      renderer.clear();
      for (const SceneTriangle& t : triangles) renderer.draw(t.snapped);
    });
  }

 private:
  spec::Contract contract_;
  spec::FrameState frame_;
  DesignScorer scorer_;
};

/// Writes a baseline's samples into memories: with the depth test or, for the painter, without it.
struct FrameSink final : baseline::Sink {
  FrameSink(judge::VisibleFrame* memory, bool tests) : to(memory), test(tests) {}
  void sample(const baseline::Sample& s) override {
    if (test) {
      to->write(s.x, s.y, s.z, s.rgba);
    } else {
      to->overwrite(s.x, s.y, s.z, s.rgba);
    }
  }
  judge::VisibleFrame* to;
  bool test;
};

/// The design with all that a baseline interpolates: depth and every channel, all affine.
spec::Design all_affine(spec::Design design) {
  design.attributes = spec::channels(design);
  design.flat_attributes = 0;
  design.perspective = false;
  design.depth_test = true;
  return design;
}

class BaselineContestant final : public Contestant {
 public:
  BaselineContestant(const baseline::Baseline& row, const spec::Design& design,
                     const spec::FrameState& frame, bool map)
      : rasterizer_(row.make(spec::contract(design), frame)),
        scorer_(&subject_, frame, all_affine(design), map),
        design_(design),
        frame_(frame) {
    subject_.name = row.name;
    subject_.summary = row.summary;
    subject_.judged_by_frame = row.orders_the_scene;
  }

  Subject& subject() override { return subject_; }
  void score(const spec::Triangle& triangle, const judge::ScreenTruth& truth) override {
    if (subject_.judged_by_frame) return;
    scorer_.begin(truth);
    rasterizer_->draw(triangle, &scorer_);
    scorer_.end();
    subject_.visited = static_cast<double>(rasterizer_->visited());
  }

  void score_frame(const std::vector<SceneTriangle>& triangles,
                   const judge::VisibleFrame& truth) override {
    if (!subject_.judged_by_frame) return;
    judge::VisibleFrame memory(design_, frame_);
    draw_frame(triangles, &memory);
    subject_.visited = static_cast<double>(rasterizer_->visited());
    scorer_.frame(truth, memory);
  }

  double frame_seconds(const std::vector<SceneTriangle>& triangles) override {
    judge::VisibleFrame memory(design_, frame_);
    return seconds_of([&] { draw_frame(triangles, &memory); });
  }

 private:
  void draw_frame(const std::vector<SceneTriangle>& triangles, judge::VisibleFrame* memory) {
    memory->clear();
    const bool paints = subject_.judged_by_frame && frame_.depth != spec::DepthFunc::kOff;
    FrameSink sink(memory, !paints);
    if (!paints) {
      for (const SceneTriangle& t : triangles) rasterizer_->draw(t.snapped, &sink);
      return;
    }
    std::vector<spec::Triangle> snapped;
    for (const SceneTriangle& t : triangles) snapped.push_back(t.snapped);
    for (const uint32_t i : baseline::paint_order(snapped)) rasterizer_->draw(snapped[i], &sink);
  }

  Subject subject_;
  std::unique_ptr<baseline::Rasterizer> rasterizer_;
  Scorer scorer_;
  spec::Design design_;
  spec::FrameState frame_;
};

double largest_affine_error(const std::vector<exact::Sample>& samples) {
  double largest = 0;
  for (const exact::Sample& s : samples) {
    for (size_t i = 0; i < s.affine.size(); ++i) {
      const exact::Value& a = s.affine[i];
      const exact::Value& p = s.perspective[i];
      largest = std::max(
          largest, std::abs(static_cast<double>(a.whole - p.whole) + (a.fraction - p.fraction)));
    }
  }
  return largest;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const size_t n = values.size();
  return n % 2 != 0 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

using Contestants = std::vector<std::unique_ptr<Contestant>>;

Contestants contestants(const spec::FrameState& frame, const ErrorOptions& options) {
  const spec::Design& first = options.designs.at(0);
  Contestants all;
  for (const spec::Design& d : options.designs) {
    if (!same_formats(d, first)) {
      throw std::invalid_argument("study_errors: designs of different formats");
    }
    all.push_back(std::make_unique<DesignContestant>(d, frame, options.maps));
  }
  if (!options.baselines) return all;
  for (const auto& row : baseline::baselines()) {
    all.push_back(std::make_unique<BaselineContestant>(row, first, frame, options.maps));
  }
  return all;
}

// Three rounds over all subjects, so that other load on the machine affects all of them alike; one
// round where a round takes long.
constexpr int kRuns = 3;
constexpr double kLongRoundSeconds = 10;

int time_frames(const std::vector<SceneTriangle>& triangles, const ErrorOptions& options,
                Contestants* all) {
  std::vector<std::vector<double>> seconds(all->size());
  int runs = 0;
  double round_seconds = 0;
  while (runs < kRuns && (runs == 0 || round_seconds < kLongRoundSeconds)) {
    round_seconds = 0;
    for (size_t i = 0; i < all->size(); ++i) {
      if (options.progress) options.progress("timing", static_cast<uint64_t>(runs));
      seconds[i].push_back((*all)[i]->frame_seconds(triangles));
      round_seconds += seconds[i].back();
    }
    ++runs;
  }
  for (size_t i = 0; i < all->size(); ++i) (*all)[i]->subject().seconds = median(seconds[i]);
  return runs;
}

}  // namespace

bool Subject::holds() const {
  return missing == 0 && extra == 0 &&
         (!bounds || (depth.max() <= bounds->depth_ulp && color.max() <= bounds->attribute_lsb));
}

bool ErrorStudy::holds() const {
  return std::all_of(subjects.begin(), subjects.end(),
                     [](const Subject& s) { return !s.is_design || s.holds(); });
}

bool same_formats(const spec::Design& a, const spec::Design& b) {
  return a.subpixel_bits == b.subpixel_bits && a.guard_bits == b.guard_bits &&
         a.depth_bits == b.depth_bits && spec::channels(a) == spec::channels(b) &&
         a.attribute_bits == b.attribute_bits && a.inverse_w_bits == b.inverse_w_bits;
}

int64_t count_samples(const std::vector<SceneTriangle>& triangles, const spec::FrameState& frame,
                      const spec::Design& design, int64_t limit) {
  int64_t count = 0;
  for (const SceneTriangle& t : triangles) {
    count += exact::ScreenJudge(t.screen, judge::format_of(design), judge::exact_frame(frame))
                 .snapped()
                 .samples();
    if (count > limit) break;
  }
  return count;
}

ErrorStudy study_errors(const std::vector<SceneTriangle>& triangles, const spec::FrameState& frame,
                        const ErrorOptions& options) {
  const spec::Design first = all_affine(options.designs.at(0));
  Contestants all = contestants(frame, options);
  ErrorStudy study;
  study.width = frame.width;
  study.height = frame.height;
  study.triangles = triangles.size();

  judge::VisibleFrame visible(first, frame);
  judge::ScreenTruth truth;
  for (const SceneTriangle& t : triangles) {
    const exact::ScreenJudge judge(t.screen, judge::format_of(first), judge::exact_frame(frame));
    truth.judge(judge);
    study.samples += truth.samples().size();
    if (!judge.affine()) {
      study.affine_lsb = std::max(study.affine_lsb, largest_affine_error(truth.samples()));
    }
    for (const auto& contestant : all) contestant->score(t.snapped, truth);
    for (const exact::Sample& s : truth.samples()) {
      std::array<int, 4> rgba;
      for (size_t i = 0; i < 4; ++i) rgba[i] = static_cast<int>(s.affine[i].nearest);
      visible.write(s.x, s.y, s.z.nearest, rgba);
    }
    if (options.progress) options.progress("judging", t.snapped.id);
  }
  for (const auto& contestant : all) contestant->score_frame(triangles, visible);
  study.runs = time_frames(triangles, options, &all);
  for (auto& contestant : all) study.subjects.push_back(std::move(contestant->subject()));
  return study;
}

}  // namespace pineda::studies
