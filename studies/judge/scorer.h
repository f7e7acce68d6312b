// Scores one subject against the truth, triangle by triangle, or its finished frame.
#pragma once

#include "model/baseline/baseline.h"
#include "model/judge/comparison.h"
#include "model/judge/visible_frame.h"
#include "studies/error/error.h"

namespace pineda::studies {

/// For each triangle: begin(), then the samples that the subject draws, then end().
class Scorer final : public baseline::Sink {
 public:
  /// `design` says which values there are, and how they are interpolated.
  Scorer(Subject* subject, const spec::FrameState& frame, const spec::Design& design,
         bool with_map);

  void begin(const judge::Truth& truth);
  /// The subject covers this sample with these values.
  void sample(const judge::Drawn& drawn);
  void sample(const baseline::Sample& sample) override;
  void end();

  /// Instead of triangles: scores every pixel of the subject's finished frame against the frame
  /// that correctly rounded codes leave.
  void frame(const judge::VisibleFrame& truth, const judge::VisibleFrame& got);

 private:
  void values(size_t pixel, const judge::Errors& errors);
  void wrong(size_t pixel, uint8_t kind);
  size_t pixel(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
  }

  Subject* subject_;
  int width_;
  judge::Values values_;  // of the attributes the colour alone
  const judge::Truth* truth_ = nullptr;
  judge::Seen seen_;
};

/// A design point's fragments, hidden ones included, to a scorer.
class DesignScorer {
 public:
  DesignScorer(const spec::Design& design, const spec::FrameState& frame, bool with_map);
  DesignScorer(const DesignScorer&) = delete;
  DesignScorer& operator=(const DesignScorer&) = delete;

  void score(const spec::Triangle& triangle, const judge::ScreenTruth& truth);
  const Subject& subject() const { return subject_; }
  Subject& subject() { return subject_; }

 private:
  spec::Contract contract_;
  spec::FrameState frame_;
  Subject subject_;
  Scorer scorer_;
};

}  // namespace pineda::studies
