// The triangles of a frame in memory, as the renderer takes them quickest.
#pragma once

#include <vector>

#include "model/fast/blocks.h"
#include "model/fast/setup_lanes.h"

namespace pineda::fast {

/// In groups of TriangleGroup, 48 bytes a triangle, where the frame is drawn in blocks and set up in
/// lanes; whole elsewhere.
class TriangleList {
 public:
  TriangleList(const spec::Contract& contract, const spec::FrameState& frame)
      : is_grouped_(has_setup_lanes(contract) && has_blocks(contract, frame)),
        channels_(spec::channels(contract.design)) {}

  void push_back(const spec::Triangle& triangle) {
    if (is_grouped_) {
      if (size_ % kGroup == 0) groups_.emplace_back();
      groups_.back().set(size_ % kGroup, triangle, channels_);
    } else {
      whole_.push_back(triangle);
    }
    ++size_;
  }

  void clear() {
    size_ = 0;
    groups_.clear();
    whole_.clear();
  }
  size_t size() const { return size_; }
  bool is_grouped() const { return is_grouped_; }
  const std::vector<TriangleGroup>& groups() const { return groups_; }
  const std::vector<spec::Triangle>& whole() const { return whole_; }

 private:
  bool is_grouped_;
  int channels_;
  size_t size_ = 0;
  std::vector<TriangleGroup> groups_;
  std::vector<spec::Triangle> whole_;
};

}  // namespace pineda::fast
