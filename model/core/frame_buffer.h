// The memories of a frame.
#pragma once

#include <vector>

#include "model/spec/structs.h"

namespace pineda::core {

/// The code of a cleared sample: the greatest; without depth in the design 0xFFFFFF.
constexpr uint32_t cleared_depth(const spec::Design& d) {
  return static_cast<uint32_t>((uint64_t{1} << (d.depth_test ? d.depth_bits : 24)) - 1);
}

/// The frame's memories, row-major, top row first. Only samples inside the frame exist.
struct FrameBuffer {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<uint32_t> depth;  // codes
  std::vector<uint16_t> color;  // `channels` values a sample, flat ones last, cleared to 0
  std::vector<uint16_t> hits;   // triangles that cover the sample, saturating at 65535

  FrameBuffer() = default;
  FrameBuffer(const spec::Contract& contract, const spec::FrameState& frame);
  void clear(const spec::Contract& contract);

  /// Calls visit(lane, sample) for each lane of `mask` of the stamp in column x, row y; `sample`
  /// indexes the memories.
  template <class Visitor>
  void for_each_lane(const spec::Contract& contract, int x, int y, uint32_t mask,
                     Visitor&& visit) const {
    const int w_log2 = contract.design.stamp_width_log2;
    for (; mask != 0; mask &= mask - 1) {
      const int lane = __builtin_ctz(mask);
      const int px = (x << w_log2) + (lane & ((1 << w_log2) - 1));
      const int py = (y << contract.design.stamp_height_log2) + (lane >> w_log2);
      visit(static_cast<size_t>(lane),
            static_cast<size_t>(py) * static_cast<size_t>(width) + static_cast<size_t>(px));
    }
  }

  /// Asks the caches for the samples from (x, top) to (x, bottom) and those to their right, ahead
  /// of a draw.
  void prefetch(int x, int top, int bottom, bool with_color) const {
    size_t sample = static_cast<size_t>(top) * static_cast<size_t>(width) + static_cast<size_t>(x);
    for (int y = top; y <= bottom; ++y, sample += static_cast<size_t>(width)) {
      __builtin_prefetch(depth.data() + sample, 1);
      if (with_color) __builtin_prefetch(color.data() + sample * static_cast<size_t>(channels), 1);
    }
  }

  /// Depth codes of a stamp at the lanes of `mask`; 0 in the others.
  spec::DepthData read(const spec::Contract& contract, int x, int y, uint32_t mask) const;
  void write(const spec::Contract& contract, const spec::DepthWrite& write);
  void write(const spec::Contract& contract, const spec::ColorWrite& write);
  void count_hits(const spec::Contract& contract, const spec::Stamp& stamp);
};

}  // namespace pineda::core
