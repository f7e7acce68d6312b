// A frame buffer with a depth test, for the samples of any rasterizer.
#pragma once

#include <algorithm>
#include <vector>

#include "model/judge/sample.h"

namespace pineda::judge {

/// Does a new depth pass whose order to the stored one is -1 (less), 0 (equal) or 1 (greater)?
bool passes(spec::DepthFunc func, int order);

/// The depth and colour memories of a frame after the samples written so far.
class VisibleFrame {
 public:
  VisibleFrame(const spec::Design& design, const spec::FrameState& frame);

  void clear();
  /// Writes a sample if it passes the depth test of the frame's state.
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

}  // namespace pineda::judge
