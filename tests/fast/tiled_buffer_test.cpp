// The memories in blocks hold what those by rows hold.
#include "model/fast/tiled_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace pineda::test {
namespace {

using core::FrameBuffer;
using fast::TiledBuffer;

spec::Contract contract_of(int tile_log2, int flat_attributes) {
  spec::Design d = spec::kHighTile;
  d.tile_log2 = tile_log2;
  d.flat_attributes = flat_attributes;
  return spec::contract(d);
}

spec::FrameState frame_of(int width, int height) {
  spec::FrameState frame;
  frame.width = width;
  frame.height = height;
  return frame;
}

// Writes every sample that the frame has, stamp by stamp, each with values of its own.
template <class Buffer>
void write_all(const spec::Contract& c, Buffer* buffer) {
  uint32_t next = 0;
  for (int y = 0; y < (buffer->height + 1) / 2; ++y) {
    for (int x = 0; x < (buffer->width + 1) / 2; ++x) {
      uint32_t mask = 2 * x + 1 < buffer->width ? 15 : 5;
      if (2 * y + 1 == buffer->height) mask &= 3;
      spec::Stamp stamp;
      spec::DepthWrite depth;
      spec::ColorWrite color;
      stamp.x = depth.x = color.x = x;
      stamp.y = depth.y = color.y = y;
      stamp.mask = depth.mask = color.mask = mask;
      for (size_t lane = 0; lane < 4; ++lane) {
        depth.z[lane] = next++;
        for (int32_t& a : color.attr[lane]) a = static_cast<int32_t>(next++ & 255);
      }
      color.flat[0] = static_cast<int32_t>(next++ & 255);
      buffer->write(c, depth);
      buffer->write(c, color);
      if (x % 3 == y % 5) buffer->count_hits(c, stamp);
      ASSERT_EQ(buffer->read(c, x, y, mask & 9).z[0], depth.z[0]);
      ASSERT_EQ(buffer->read(c, x, y, mask & 9).z[1], 0u);
    }
  }
}

bool same(const FrameBuffer& a, const FrameBuffer& b) {
  return a.depth == b.depth && a.color == b.color && a.hits == b.hits;
}

constexpr int kSizes[][2] = {{1, 1}, {7, 3}, {8, 8}, {9, 17}, {33, 20}, {70, 65}};

TEST(TiledBuffer, HoldsWhatRowsHold) {
  for (int tile_log2 = 2; tile_log2 <= 6; ++tile_log2) {
    const auto c = contract_of(tile_log2, tile_log2 % 2);
    for (const auto& size : kSizes) {
      const auto frame = frame_of(size[0], size[1]);
      FrameBuffer rows(c, frame);
      TiledBuffer tiles(c, frame);
      EXPECT_TRUE(same(tiles.by_rows(c), rows));  // cleared
      write_all(c, &rows);
      write_all(c, &tiles);
      EXPECT_TRUE(same(tiles.by_rows(c), rows)) << tile_log2 << ' ' << size[0];
      tiles.clear();
      EXPECT_TRUE(same(tiles.by_rows(c), FrameBuffer(c, frame)));
    }
  }
}

TEST(TiledBuffer, RowsOfABlockAreSideBySideOnACacheLine) {
  for (int tile_log2 = 2; tile_log2 <= 6; ++tile_log2) {
    const TiledBuffer buffer(contract_of(tile_log2, 0), frame_of(70, 65));
    const int side = std::min(1 << tile_log2, fast::kBlockPx);
    std::set<size_t> seen;
    for (int y = 0; y < 65; ++y) {
      for (int x = 0; x < 70; ++x) {
        const size_t sample = buffer.index(x, y);
        ASSERT_LT(sample, buffer.depth.size());
        EXPECT_TRUE(seen.insert(sample).second);
        if (x % side != 0) {
          EXPECT_EQ(sample, buffer.index(x - 1, y) + 1);
        }
        if (y % side != 0) {
          EXPECT_EQ(sample, buffer.index(x, y - 1) + fast::kBlockPx);
        }
        if (x % side != 0 || y % side != 0) continue;
        EXPECT_EQ(sample % fast::kBlockSamples, 0u);
      }
    }
    EXPECT_EQ(reinterpret_cast<uintptr_t>(buffer.depth.data()) % 64, 0u);
    EXPECT_EQ(reinterpret_cast<uintptr_t>(buffer.color.data()) % 64, 0u);
  }
}

TEST(TiledBuffer, CopiesSomeRowsOfTiles) {
  const auto c = contract_of(3, 1);
  const auto frame = frame_of(20, 30);
  TiledBuffer tiles(c, frame);
  write_all(c, &tiles);
  const FrameBuffer all = tiles.by_rows(c);
  FrameBuffer some(c, frame);
  tiles.copy_rows(1, 2, &some);
  for (size_t i = 0; i < all.depth.size(); ++i) {
    const bool in = i / 20 >= 8 && i / 20 < 24;
    ASSERT_EQ(some.depth[i], in ? all.depth[i] : all.clear_depth) << i;
    ASSERT_EQ(some.color[5 * i], in ? all.color[5 * i] : 0) << i;
    ASSERT_EQ(some.hits[i], in ? all.hits[i] : 0) << i;
  }
  tiles.copy_rows(0, 0, &some);
  tiles.copy_rows(3, 3, &some);
  EXPECT_TRUE(same(some, all));
}

TEST(TiledBuffer, MutantThatSwapsTwoSamplesIsSeen) {
  const auto c = contract_of(3, 0);
  const auto frame = frame_of(20, 30);
  FrameBuffer rows(c, frame);
  TiledBuffer tiles(c, frame);
  write_all(c, &rows);
  write_all(c, &tiles);
  std::swap(tiles.depth[tiles.index(9, 9)], tiles.depth[tiles.index(10, 9)]);
  EXPECT_FALSE(same(tiles.by_rows(c), rows));
}

}  // namespace
}  // namespace pineda::test
