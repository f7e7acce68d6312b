// Triangles of a few samples, side by side: covered, and their values worked out, before one is drawn.
#pragma once

#include "model/fast/blocks.h"

namespace pineda::fast {

inline constexpr int kSmallPx = 8;  // the greatest box, from the corner of its first stamp

/// The covered samples of the small triangles of a group.
struct SmallPrims {
  struct Sample {
    uint32_t place;  // of its depth: words of 32 bits from the first line of a BlockBuffer
    uint32_t depth;  // a code
    uint32_t color;  // as in SampleLine
    uint32_t bit;    // of its triangle's samples: x + 8y from the box
  };
  uint32_t small = 0;      // a bit each: these are here, the others are drawn in blocks
  Each<uint64_t> covered;  // samples, by `bit`
  Each<uint32_t> end;      // of a triangle's samples: the next one's begin there
  std::array<Sample, kGroup * kSmallPx * kSmallPx> samples;
};

/// Finds the small triangles of a group, counts their tiles, and asks for the lines of their samples.
void cover_small(const BlockState& state, const PrimGroup& group, const BlockBuffer& buffer,
                 SmallPrims* small, BlockCounts* counts);

}  // namespace pineda::fast
