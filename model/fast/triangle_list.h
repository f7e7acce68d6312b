// The triangles of a frame in memory, as the renderer takes them quickest.
#pragma once

#include <algorithm>
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
      begin_group();
      groups_.back().set(size_ % kGroup, triangle, channels_);
    } else {
      whole_.push_back(triangle);
    }
    ++size_;
  }
  /// Triangle i of a group of another list. One that is not counted is drawn, but in no count of triangles.
  void push_back(const TriangleGroup& group, size_t i, bool counted) {
    begin_group();
    groups_.back().copy(size_ % kGroup, group, i);
    if (!counted) counted_.back() &= ~(1U << size_ % kGroup);
    ++size_;
  }

  void clear() {
    size_ = 0;
    groups_.clear();
    counted_.clear();
    whole_.clear();
  }
  size_t size() const { return size_; }
  bool is_grouped() const { return is_grouped_; }
  const std::vector<TriangleGroup>& groups() const { return groups_; }
  /// By group, a bit for each of its triangles.
  const std::vector<uint32_t>& counted() const { return counted_; }
  size_t in_group(size_t i) const { return std::min(kGroup, size_ - i * kGroup); }
  const std::vector<spec::Triangle>& whole() const { return whole_; }

 private:
  void begin_group() {
    if (size_ % kGroup != 0) return;
    groups_.emplace_back();
    counted_.push_back(~0U);
  }

  bool is_grouped_;
  int channels_;
  size_t size_ = 0;
  std::vector<TriangleGroup> groups_;
  std::vector<uint32_t> counted_;
  std::vector<spec::Triangle> whole_;
};

}  // namespace pineda::fast
