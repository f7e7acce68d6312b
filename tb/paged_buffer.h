// The depth and colour memories of a frame of any size, of which few samples may be written.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "model/core/frame_buffer.h"

namespace pineda::tb {

/// Holds what core::FrameBuffer holds, in pages that come into being when a stamp of theirs is touched.
///
/// Errors   RtlError: a stamp with a lane outside the frame.
class PagedBuffer {
 public:
  PagedBuffer() = default;
  PagedBuffer(const spec::Contract& contract, const spec::FrameState& frame);
  /// With what a buffer holds.
  PagedBuffer(const spec::Contract& contract, const core::FrameBuffer& buffer);

  /// A page of kSide x kSide samples, row by row; its corner is (x, y) px.
  struct Page {
    int x, y;
    std::vector<uint32_t> depth;
    std::vector<uint16_t> color, hits;
  };

  /// Calls visit(lane, page, sample) for each lane of `mask` of the stamp in column x, row y; `sample`
  /// indexes the page's memories.
  template <class Visitor>
  void for_each_lane(const spec::Contract& contract, int x, int y, uint32_t mask, Visitor&& visit) {
    const spec::Design& d = contract.design;
    const int left = x << d.stamp_width_log2, top = y << d.stamp_height_log2;
    Page* const page = page_of(contract, left, top, mask);
    core::for_each_lane(d, mask, [&](size_t lane, int column, int row) {
      visit(lane, page, place_of(left + column, top + row));
    });
  }

  /// Every depth, also of what is not touched yet.
  void clear_depth(uint32_t code);

  /// The frame as a whole.
  core::FrameBuffer whole() const;
  /// Those that came into being, row by row.
  std::vector<const Page*> pages() const;

  int width() const { return width_; }
  int height() const { return height_; }

  static constexpr int kSide = 64;

 private:
  /// Of the sample at (x, y) px in its page.
  static size_t place_of(int x, int y) {
    return static_cast<size_t>(y % kSide) * kSide + static_cast<size_t>(x % kSide);
  }
  Page* page_of(const spec::Contract& contract, int left, int top, uint32_t mask);
  Page* made(int column, int row);

  int width_ = 0, height_ = 0, channels_ = 0, columns_ = 0;
  uint32_t clear_depth_ = 0, cleared_to_ = 0;
  std::vector<std::unique_ptr<Page>> pages_;
};

}  // namespace pineda::tb
