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
  void judge(const exact::ScreenJudge& judge);

  const std::vector<exact::Sample>& samples() const { return samples_; }
  /// Index of the sample of pixel (x, y), -1 where the triangle does not cover it.
  int64_t find(int x, int y) const;

 private:
  struct Row {
    exact::Span span;
    size_t first;  // index of its first sample
  };
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
    if (passes(z, z_[at(x, y)])) overwrite(x, y, z, rgba);
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
    if (frame_.depth == spec::DepthFunc::kOff) return true;
    return z < stored || (frame_.depth == spec::DepthFunc::kLequal && z == stored);
  }

  spec::FrameState frame_;
  uint32_t clear_code_;
  std::vector<uint32_t> z_;
  std::vector<std::array<uint16_t, 4>> rgba_;
  std::vector<uint8_t> drawn_;
};

}  // namespace pineda::studies
