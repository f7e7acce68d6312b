// The depth and colour memories of a frame.
#pragma once

#include <vector>

#include "model/core/lanes.h"
#include "model/spec/clear_depth.h"

namespace pineda::core {

/// Samples are stored row by row, the top row first; there are none outside the frame.
struct FrameBuffer {
  int width = 0;
  int height = 0;
  int channels = 0;
  uint32_t clear_depth = 0;     // code
  std::vector<uint32_t> depth;  // codes
  std::vector<uint16_t> color;  // `channels` values a sample, flat ones last, cleared to 0
  std::vector<uint16_t> hits;   // triangles that cover the sample, saturating at 65535

  FrameBuffer() = default;
  FrameBuffer(const spec::Contract& contract, const spec::FrameState& frame);
  void clear();

  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  }
  /// Calls visit(lane, sample) for each lane of `mask` of the stamp in column x, row y; `sample`
  /// indexes the memories.
  template <class Visitor>
  void for_each_lane(const spec::Contract& contract, int x, int y, uint32_t mask,
                     Visitor&& visit) const {
    const spec::Design& d = contract.design;
    const size_t first = index(x << d.stamp_width_log2, y << d.stamp_height_log2);
    core::for_each_lane(d, mask, [&](size_t lane, int column, int row) {
      visit(lane, first + index(column, row));
    });
  }

  /// Depth codes of a stamp at the lanes of `mask`; 0 in the others.
  spec::DepthData read(const spec::Contract& contract, int x, int y, uint32_t mask) const;
  void write(const spec::Contract& contract, const spec::DepthWrite& write);
  void write(const spec::Contract& contract, const spec::ColorWrite& write);
  void count_hits(const spec::Contract& contract, const spec::Stamp& stamp);
};

}  // namespace pineda::core
