// What exact arithmetic says of one triangle, sample by sample, and of the frame that is left.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "model/exact/exact.h"
#include "model/spec/structs.h"

namespace pineda::studies {

exact::Format format_of(const spec::Design& design);
exact::Frame exact_frame(const spec::FrameState& frame);

/// The covered samples of one triangle with their exact values.
class Truth {
 public:
  void judge(const exact::ScreenJudge& judge) { this->judge(judge, judge.rows()); }
  /// Those in some rows of the triangle's.
  void judge(const exact::ScreenJudge& judge, exact::Span rows);

  const std::vector<exact::Sample>& samples() const { return samples_; }
  /// The snapped attributes of the first vertex: what flat attributes are everywhere.
  const std::array<int, 4>& flat() const { return flat_; }
  /// The exact value of an attribute, interpolated as a design does.
  const exact::Value& attribute(const exact::Sample& sample, size_t i, bool perspective) const {
    return perspective && !affine_ ? sample.perspective[i] : sample.affine[i];
  }
  /// max(|dz/dx|, |dz/dy|) in codes a px.
  double depth_slope() const { return depth_slope_; }
  /// Index of the sample of pixel (x, y), -1 where the triangle does not cover it.
  int64_t find(int x, int y) const;

 private:
  struct Row {
    exact::Span span;
    size_t first;  // index of its first sample
  };
  bool affine_ = true;
  double depth_slope_ = 0;
  std::array<int, 4> flat_{};
  exact::Span rows_;
  std::vector<Row> row_;
  std::vector<exact::Sample> samples_;
};

/// A frame's memories as a rasterizer leaves them that draws these samples.
class VisibleFrame {
 public:
  VisibleFrame(const spec::Design& design, const spec::FrameState& frame);

  void clear();
  /// With the depth test of the frame's state.
  void write(int x, int y, int64_t z, const std::array<int, 4>& rgba) {
    const int64_t stored = z_[at(x, y)];
    if (passes(z, stored)) overwrite(x, y, frame_.depth_write ? z : stored, rgba);
  }
  void overwrite(int x, int y, int64_t z, const std::array<int, 4>& rgba) {
    const size_t i = at(x, y);
    z_[i] = static_cast<uint32_t>(z);
    std::copy(rgba.begin(), rgba.end(), rgba_[i].begin());
    drawn_[i] = 1;
  }

  size_t size() const { return z_.size(); }
  bool drawn(size_t i) const { return drawn_[i] != 0; }
  int64_t z(size_t i) const { return z_[i]; }
  const std::array<uint16_t, 4>& rgba(size_t i) const { return rgba_[i]; }

 private:
  size_t at(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(frame_.width) + static_cast<size_t>(x);
  }
  bool passes(int64_t z, int64_t stored) const {
    return z < stored ? less_passes_ : z == stored ? equal_passes_ : greater_passes_;
  }

  spec::FrameState frame_;
  uint32_t clear_code_;
  bool less_passes_, equal_passes_, greater_passes_;
  std::vector<uint32_t> z_;
  std::vector<std::array<uint16_t, 4>> rgba_;
  std::vector<uint8_t> drawn_;
};

}  // namespace pineda::studies
