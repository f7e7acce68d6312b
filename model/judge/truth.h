// The exact samples of one triangle, and the errors of drawn samples against them.
#pragma once

#include <vector>

#include "model/judge/exact_terms.h"
#include "model/judge/sample.h"

namespace pineda::judge {

/// The exact coverage of one triangle and the errors of drawn samples.
class Truth {
 public:
  virtual ~Truth() = default;

  /// Rows that may have covered samples; empty when first > last.
  virtual exact::Span rows() const = 0;
  /// The covered samples of a row.
  virtual exact::Span span(int y) const = 0;
  /// The errors of a drawn sample, which must be covered.
  virtual Errors errors(const Values& values, const Drawn& drawn) const = 0;

 protected:
  Truth() = default;
  Truth(const Truth&) = default;
  Truth& operator=(const Truth&) = default;
};

/// The truth of a triangle as the scene states it, in floats. Computes all exact values once, so
/// that several rasterizers can be compared with them.
class ScreenTruth final : public Truth {
 public:
  /// Without perspective only affine values are computed, which is faster.
  explicit ScreenTruth(bool with_perspective = true) : with_perspective_(with_perspective) {}

  void judge(const exact::ScreenJudge& judge) { this->judge(judge, judge.rows()); }
  /// Judges some rows of the triangle; the others are treated as empty.
  void judge(const exact::ScreenJudge& judge, exact::Span rows);

  exact::Span rows() const override { return rows_; }
  exact::Span span(int y) const override { return row(y).span; }
  Errors errors(const Values& values, const Drawn& drawn) const override;

  const std::vector<exact::Sample>& samples() const { return samples_; }
  /// nullptr where the triangle does not cover pixel (x, y).
  const exact::Sample* find(int x, int y) const;
  /// The snapped attributes of the first vertex: the values of flat attributes.
  const spec::Attributes& flat() const { return flat_; }
  /// The exact value of attribute i, interpolated with or without perspective.
  exact::Value attribute(const exact::Sample& sample, size_t i, bool perspective) const;
  /// max(|dz/dx|, |dz/dy|) in codes a px.
  double depth_slope() const { return depth_slope_; }

 private:
  struct Row {
    exact::Span span;
    size_t first;  // index of its first sample
  };
  const Row& row(int y) const { return row_[static_cast<size_t>(y - rows_.first)]; }

  bool with_perspective_;
  bool affine_ = true;
  double depth_slope_ = 0;
  spec::Attributes flat_{};
  exact::Span rows_;
  std::vector<Row> row_;
  std::vector<exact::Sample> samples_;
};

/// The truth of a snapped triangle, as a design takes it. Computes a value when asked for it.
///
/// Bits     with perspective the weights are exact integers times the vertices' rounded 1/w, summed
///          in long doubles. The depth bias itself is not judged: it is given, in codes, and depths
///          that it carries beyond an end of the range are accepted when they are clamped there.
class SnappedTruth final : public Truth {
 public:
  SnappedTruth(const spec::Design& design, const spec::FrameState& frame,
               const spec::Triangle& triangle, double bias_codes = 0)
      : triangle_(triangle),
        judge_(exact_judge(design, frame, triangle)),
        top_code_((int64_t{1} << design.depth_bits) - 1),
        bias_codes_(bias_codes) {}

  const exact::Judge& judge() const { return judge_; }
  exact::Span rows() const override { return judge_.rows(); }
  exact::Span span(int y) const override { return judge_.span(y); }
  Errors errors(const Values& values, const Drawn& drawn) const override;

 private:
  double depth_error(const Drawn& drawn) const;
  double perspective_error(const Drawn& drawn, size_t attribute) const;

  spec::Triangle triangle_;
  exact::Judge judge_;
  int64_t top_code_;
  double bias_codes_;
};

}  // namespace pineda::judge
