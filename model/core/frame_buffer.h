// The memories of a frame.
#pragma once

#include <vector>

#include "model/spec/clear_depth.h"

namespace pineda::core {

/// The order of samples in memories, row by row, top row first.
struct RowMajor {
  template <class T>
  using Samples = std::vector<T>;

  int width = 0;
  int height = 0;

  RowMajor() = default;
  RowMajor(const spec::Design&, const spec::FrameState& frame)
      : width(frame.width), height(frame.height) {}
  size_t samples() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  }
  /// From a sample to the one below it in the same stamp.
  size_t row_step() const { return static_cast<size_t>(width); }
};

/// The frame's memories in some order of samples.
template <class Order>
struct SampleMemories : Order {
  template <class T>
  using Samples = typename Order::template Samples<T>;

  int channels = 0;
  uint32_t clear_depth = 0;  // code
  Samples<uint32_t> depth;   // codes
  Samples<uint16_t> color;   // `channels` values a sample, flat ones last, cleared to 0
  Samples<uint16_t> hits;    // triangles that cover the sample, saturating at 65535

  SampleMemories() = default;
  SampleMemories(const spec::Contract& contract, const spec::FrameState& frame);
  void clear();

  /// Calls visit(lane, sample) for each lane of `mask` of the stamp in column x, row y; `sample`
  /// indexes the memories.
  template <class Visitor>
  void for_each_lane(const spec::Contract& contract, int x, int y, uint32_t mask,
                     Visitor&& visit) const {
    const spec::Design& d = contract.design;
    const size_t first = this->index(x << d.stamp_width_log2, y << d.stamp_height_log2);
    const size_t columns = size_t{1} << d.stamp_width_log2;
    for (; mask != 0; mask &= mask - 1) {
      const auto lane = static_cast<size_t>(__builtin_ctz(mask));
      visit(lane, first + (lane >> d.stamp_width_log2) * this->row_step() + (lane & (columns - 1)));
    }
  }

  /// Depth codes of a stamp at the lanes of `mask`; 0 in the others.
  spec::DepthData read(const spec::Contract& contract, int x, int y, uint32_t mask) const;
  void write(const spec::Contract& contract, const spec::DepthWrite& write);
  void write(const spec::Contract& contract, const spec::ColorWrite& write);
  void count_hits(const spec::Contract& contract, const spec::Stamp& stamp);
};

/// Only samples inside the frame exist.
using FrameBuffer = SampleMemories<RowMajor>;

}  // namespace pineda::core
