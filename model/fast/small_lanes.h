// What SmallWalks hands to its vector kernels and gets from them.
#pragma once

#include "model/fast/prim_group.h"

namespace pineda::fast {

inline constexpr int kSmallTileLog2 = 3;  // a tile is a block
inline constexpr int kSmallTiles = 4;     // of a small triangle, two across and two down

/// Triangles, and what of the frame decides about them; coordinates in units of 2^-S px.
struct alignas(64) SmallCorners {
  std::array<Each<int32_t>, 3> x{}, y{};
  int subpixel_bits = 0;
  int clip_x0 = 0, clip_y0 = 0, clip_x1 = 0, clip_y1 = 0;
  bool culls_positive = false, culls_negative = false;  // doubled areas
};

/// What setup and the tests of tiles find.
struct alignas(64) SmallFound {
  Each<int32_t> drop;                     // core::Drop
  Each<int32_t> x0, y0, x1, y1;           // clipped box
  Each<int32_t> tested;                   // tiles: a bit each, by 2 * row + column
  Each<int32_t> rejected, accepted;       // of these
  std::array<Each<uint32_t>, 2> covered;  // samples of the box: the upper and the lower four rows
  uint32_t small = 0;                     // a bit a triangle; of the others nothing is found
  uint32_t turns = 0;                     // the second row is walked to the left
};

}  // namespace pineda::fast
