// Small triangles side by side: what core's setup and walks find of them.
#include "model/fast/small_walks.h"

#include <gtest/gtest.h>

#include "tests/core/hard_triangles.h"
#include "tests/fast/levels.h"

namespace pineda::test {
namespace {

using Test = core::TileWalk::Test;

// A frame whose borders, and those of its scissor, run through tiles.
spec::FrameState random_frame(Random& random) {
  spec::FrameState frame{61, 43};
  frame.cull = static_cast<spec::Cull>(random.between(0, 2));
  if (random.between(0, 1) == 0) return frame;
  frame.scissor_x0 = static_cast<int>(random.between(0, 30));
  frame.scissor_y0 = static_cast<int>(random.between(0, 20));
  frame.scissor_x1 = static_cast<int>(random.between(30, 70));
  frame.scissor_y1 = static_cast<int>(random.between(20, 50));
  return frame;
}

// With a tip near the upper right corner of a tile: an edge may reject that tile, though the box
// reaches into it.
spec::Triangle tip_at_a_tile(Random& random, const spec::Design& d) {
  const int px = 1 << d.subpixel_bits;
  const int x = static_cast<int>(8 * px * random.between(1, 6) - random.between(px / 2, px));
  const int y = static_cast<int>(8 * px * random.between(0, 4) + random.between(0, 2 * px));
  spec::Triangle t;
  for (spec::Vertex& v : t.v) {
    v.x = static_cast<int>(x + random.between(0, 7 * px));
    v.y = static_cast<int>(y + random.between(0, 7 * px));
  }
  t.v[0].x = x;
  t.v[0].y = y;
  return t;
}

// Within `reach` px, some on or between centres of pixels; or anywhere.
spec::Triangle random_triangle(Random& random, const spec::Design& d, int reach_px) {
  if (random.between(0, 9) == 0) return hard_triangle(random, d);
  if (random.between(0, 3) == 0) return tip_at_a_tile(random, d);
  const int px = 1 << d.subpixel_bits;
  const int64_t x = random.between(-4 * px, 66 * px), y = random.between(-4 * px, 48 * px);
  const int grid = random.between(0, 1) == 0 ? px / 2 : 1;
  spec::Triangle t;
  for (spec::Vertex& v : t.v) {
    v.x = static_cast<int>(x + random.between(0, reach_px * px)) / grid * grid;
    v.y = static_cast<int>(y + random.between(0, reach_px * px)) / grid * grid;
  }
  return t;
}

void expect_same_tile(const spec::Contract& c, const core::Tile& tile, const fast::TileCover& cover,
                      fast::StampsBySamples* by_samples) {
  EXPECT_EQ(cover.x, tile.x);
  EXPECT_EQ(cover.y, tile.y);
  EXPECT_EQ((std::array{cover.x0, cover.y0, cover.x1, cover.y1}),
            (std::array{tile.x0, tile.y0, tile.x1, tile.y1}));
  EXPECT_EQ(cover.accepted, tile.accepted == 7);
  core::StampWalk walk(c, tile);
  uint32_t mask = 0;
  int x = 0, y = 0, count = 0, samples = 0;
  const int columns_log2 = cover.box.columns_log2;
  while (walk.next(&mask, &x, &y)) {
    const int row = y - (tile.y << (c.design.tile_log2 - c.design.stamp_height_log2));
    const int place = (row << columns_log2) + x - (tile.x << columns_log2);
    EXPECT_EQ(cover.covered.has(place), mask != 0);
    EXPECT_EQ(fast::lanes_of(c.design, cover.covered, place), mask);
    if (mask == 0) continue;
    EXPECT_EQ(cover.covered.before(place), count);
    if (count++ == 0) {
      EXPECT_EQ(cover.covered.first, place);
      EXPECT_EQ(cover.groups.first, cover.box.test_of(place));
    }
    samples += core::count_lanes(mask);
    ++(*by_samples)[static_cast<size_t>(core::count_lanes(mask))];
  }
  EXPECT_EQ(cover.covered.count, count);
  EXPECT_EQ(cover.covered.sample_count, samples);
  EXPECT_EQ(cover.full, samples == 64);
  if (count > 0) {
    EXPECT_EQ(cover.groups.last, cover.box.test_of(cover.covered.last));
  }
}

// Returns the tests of tiles.
int expect_same(const spec::Contract& c, const spec::FrameState& frame, const spec::Triangle& t,
                const fast::SmallWalk& walk, fast::StampsBySamples* by_samples) {
  spec::SetupPrim prim;
  const core::Drop drop = core::setup(c, frame, t, &prim);
  EXPECT_EQ(walk.drop, drop);
  if (drop != core::Drop::kNone) return 0;
  core::TileWalk tiles(c, prim);
  core::Tile tile;
  int test = 0, kept = 0;
  for (Test outcome; (outcome = tiles.next(&tile)) != Test::kEnd; ++test) {
    EXPECT_EQ(walk.rejected >> test & 1, outcome == Test::kRejected ? 1U : 0U);
    if (outcome == Test::kKept) expect_same_tile(c, tile, walk.kept[kept++], by_samples);
  }
  EXPECT_EQ(walk.tests, test);
  return test;
}

TEST(SmallWalks, EqualSetupAndWalksOfCore) {
  Random random(47);
  int known = 0, four = 0;
  std::array<int, core::kDropCauses> drops{};
  for (int shape = 0; shape < 36; ++shape) {
    spec::Design d = spec::kHighTile;
    d.subpixel_bits = shape < 18 ? 8 : 4;
    d.stamp_width_log2 = shape % 3;
    d.stamp_height_log2 = shape / 3 % 3;
    d.tested_stamps_log2 = shape % 4;
    const spec::Contract c = spec::contract(d);
    ASSERT_TRUE(fast::SmallWalks::fit(d));
    fast::SmallWalks walks(c);
    for (int n = 0; n < 60; ++n) {
      const spec::FrameState frame = random_frame(random);
      std::vector<spec::Triangle> group(static_cast<size_t>(random.between(1, 16)));
      const int reach = static_cast<int>(random.between(1, 11));
      for (spec::Triangle& t : group) t = random_triangle(random, d, reach);
      for_each_level([&] {
        fast::StampsBySamples got{}, expected{};
        walks.begin_frame(frame);
        walks.find(group.data(), group.size(), &got);
        for (size_t i = 0; i < group.size(); ++i) {
          const fast::SmallWalk* walk = walks.walk(i);
          if (walk == nullptr) continue;
          ++known;
          ++drops[static_cast<size_t>(walk->drop)];
          four += expect_same(c, frame, group[i], *walk, &expected) == 4 ? 1 : 0;
        }
        EXPECT_EQ(got, expected);
        ASSERT_FALSE(testing::Test::HasFailure()) << "shape " << shape << " " << n;
      });
    }
  }
  EXPECT_GT(known, 10000);
  EXPECT_GT(four, 500);
  EXPECT_GT(*std::min_element(drops.begin(), drops.end()), 50);
}

TEST(SmallWalks, TilesOfAnotherSizeAndFinerSubpixelsDoNotFit) {
  spec::Design d = spec::kHighTile;
  EXPECT_TRUE(fast::SmallWalks::fit(d));
  d.tile_log2 = 4;
  EXPECT_FALSE(fast::SmallWalks::fit(d));
  d = spec::kHighTile;
  d.subpixel_bits = 9;
  EXPECT_FALSE(fast::SmallWalks::fit(d));
}

}  // namespace
}  // namespace pineda::test
