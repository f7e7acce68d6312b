// Scores one subject against the truth, triangle by triangle, or its finished frame.
#pragma once

#include "model/baseline/baseline.h"
#include "studies/error/error.h"
#include "studies/judge/truth.h"

namespace pineda::studies {

/// What a subject makes of each triangle goes in between begin() and end().
class Scorer final : public baseline::Sink {
 public:
  /// `design` says which values there are, and how they are interpolated.
  Scorer(Subject* subject, const spec::FrameState& frame, const spec::Design& design,
         bool with_map);

  void begin(const Truth& truth);
  /// The subject covers this sample with these values.
  void sample(const baseline::Sample& sample) override;
  void end();

  /// Instead of triangles: every pixel of the frame that the subject left, against the frame that
  /// the nearest codes leave.
  void frame(const VisibleFrame& truth, const VisibleFrame& got);

 private:
  void values(size_t pixel, double depth_error, bool depth_misrounded,
              const std::array<double, 4>& color_error, const std::array<bool, 4>& misrounded);
  void wrong(size_t pixel, uint8_t kind);
  size_t pixel(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
  }

  Subject* subject_;
  int width_;
  bool depth_;
  bool perspective_;
  size_t attributes_;  // interpolated, of those that a sample has
  size_t channels_;
  const Truth* truth_ = nullptr;
  std::vector<uint8_t> seen_;  // by index of the truth's sample
};

/// A design point's fragments, hidden ones included, to a scorer.
class DesignScorer {
 public:
  DesignScorer(const spec::Design& design, const spec::FrameState& frame, bool with_map);
  DesignScorer(const DesignScorer&) = delete;
  DesignScorer& operator=(const DesignScorer&) = delete;

  void score(const spec::Triangle& triangle, const Truth& truth);
  const Subject& subject() const { return subject_; }
  Subject& subject() { return subject_; }

 private:
  spec::Contract contract_;
  spec::FrameState frame_;
  Subject subject_;
  Scorer scorer_;
};

}  // namespace pineda::studies
