// Coverage by whole tiles: the tiles, stamps and counts of core's walks.
#include "model/fast/tile_cover.h"

#include <gtest/gtest.h>

#include <set>

#include "model/core/setup.h"
#include "tests/core/hard_triangles.h"
#include "tests/fast/levels.h"

namespace pineda::test {
namespace {

using Test = core::TileWalk::Test;

/// What a walk finds, in flat lists that can be compared.
struct Walk {
  std::vector<std::array<int64_t, 3>> stamps;  // x, y, mask
  std::vector<int> kept;                       // number of each tile that is kept
  std::vector<int> accepted;                   // of these, those that all edges accept
  std::vector<int> tests;                      // of groups of stamps, in each
  fast::StampsBySamples by_samples{};
};

Walk core_walk(const spec::Contract& c, const spec::SetupPrim& prim) {
  Walk walk;
  core::TileWalk tiles(c, prim);
  core::Tile tile;
  int number = 0;
  for (Test test; (test = tiles.next(&tile)) != Test::kEnd; ++number) {
    if (test == Test::kRejected) continue;
    walk.kept.push_back(number);
    if (tile.accepted == 7) walk.accepted.push_back(number);
    core::StampWalk stamps(c, tile);
    std::set<std::pair<int, int>> groups;
    uint32_t mask = 0;
    int x = 0, y = 0;
    while (stamps.next(&mask, &x, &y)) {
      groups.emplace(x >> c.width.tested_stamps_log2, y);
      if (mask == 0) continue;
      walk.stamps.push_back({x, y, mask});
      ++walk.by_samples[static_cast<size_t>(core::count_lanes(mask))];
    }
    walk.tests.push_back(static_cast<int>(groups.size()));
  }
  return walk;
}

void add_stamps(const spec::Contract& c, const fast::TileCover& cover, Walk* walk) {
  const spec::Design& d = c.design;
  int count = 0, samples = 0, first = -1, last = -1;
  std::set<int> groups;
  cover.covered.for_each_stamp([&](int place) {
    EXPECT_EQ(cover.covered.before(place), count);
    groups.insert(cover.box.test_of(place));
    const uint32_t mask = fast::lanes_of(d, cover.covered, place);
    const int columns_log2 = cover.box.columns_log2;
    walk->stamps.push_back(
        {(cover.x << columns_log2) + (place & ((1 << columns_log2) - 1)),
         (cover.y << (d.tile_log2 - d.stamp_height_log2)) + (place >> columns_log2), mask});
    ++count;
    samples += core::count_lanes(mask);
    if (first < 0) first = place;
    last = place;
  });
  EXPECT_EQ(cover.covered.count, count);
  EXPECT_EQ(cover.covered.sample_count, samples);
  if (count == 0) return;
  EXPECT_EQ(cover.covered.first, first);
  EXPECT_EQ(cover.covered.last, last);
  EXPECT_EQ(cover.groups.count, static_cast<int>(groups.size()));
  EXPECT_EQ(cover.groups.first, *groups.begin());
  EXPECT_EQ(cover.groups.last, *groups.rbegin());
  const int last_group = last >> c.width.tested_stamps_log2 << c.width.tested_stamps_log2;
  EXPECT_EQ(cover.groups.before_last, cover.covered.before(last_group));
}

Walk fast_walk(const spec::Contract& c, const spec::SetupPrim& prim, bool skips) {
  Walk walk;
  fast::TileCoverWalk tiles(c);
  fast::TileCover cover(c);
  tiles.begin(prim);
  for (int number = 0;; ++number) {
    if (skips) {
      int rejected = 0;
      const bool kept = tiles.next_kept(&cover, &rejected);
      number += rejected;
      if (!kept) return walk;
    } else {
      const Test test = tiles.next(&cover);
      if (test == Test::kEnd) return walk;
      if (test == Test::kRejected) continue;
    }
    walk.kept.push_back(number);
    if (cover.accepted) walk.accepted.push_back(number);
    walk.tests.push_back(cover.box.tests());
    tiles.cover_stamps(&cover, &walk.by_samples);
    add_stamps(c, cover, &walk);
  }
}

bool same(const Walk& a, const Walk& b) {
  return a.stamps == b.stamps && a.kept == b.kept && a.accepted == b.accepted &&
         a.tests == b.tests && a.by_samples == b.by_samples;
}

class TileCover : public testing::TestWithParam<int> {};  // the tile's side, as a power of two

TEST_P(TileCover, EqualsStampByStampForStampsOfEveryShape) {
  Random random(31);
  int stamps = 0, full = 0;
  for (int shape = 0; shape < 9; ++shape) {
    for (const int guard_bits : {10, 14}) {
      spec::Design d = spec::kHighTile;
      d.tile_log2 = GetParam();
      d.guard_bits = guard_bits;
      d.stamp_width_log2 = shape % 3;
      d.stamp_height_log2 = shape / 3;
      d.tested_stamps_log2 = shape % 4;
      const spec::Contract c = spec::contract(d);
      for (int n = 0; n < 60; ++n) {
        spec::FrameState frame = hard_frame(random, d);
        frame.width = frame.height = 131;
        frame.scissor_x0 %= 64;
        spec::Triangle t = hard_triangle(random, d);
        for (auto& v : t.v) {
          if (random.between(0, 2) == 0) continue;
          v.x = static_cast<int>(random.between(-1000, 140 * kPx));
          v.y = static_cast<int>(random.between(-1000, 140 * kPx));
          // Half of them have corners on or between centres: edges then meet corners of tiles.
          if (n % 2 == 0) continue;
          v.x = v.x / kHalfPx * kHalfPx;
          v.y = v.y / kHalfPx * kHalfPx;
        }
        spec::SetupPrim prim;
        if (core::setup(c, frame, t, &prim) != core::Drop::kNone) continue;
        const Walk expected = core_walk(c, prim);
        stamps += static_cast<int>(expected.stamps.size());
        full += static_cast<int>(expected.accepted.size());
        for_each_level([&] {
          ASSERT_TRUE(same(fast_walk(c, prim, false), expected)) << "shape " << shape << " " << n;
          ASSERT_TRUE(same(fast_walk(c, prim, true), expected)) << "shape " << shape << " " << n;
        });
      }
    }
  }
  EXPECT_GT(stamps, 20000);
  EXPECT_GT(full, 50);
}

// A left edge through the first column of samples of its tiles: E is 0 there, and accepts the tile.
TEST_P(TileCover, AnEdgeThroughCornerSamplesAcceptsTheTile) {
  spec::Design d = spec::kHighTile;
  d.tile_log2 = GetParam();
  const spec::Contract c = spec::contract(d);
  const int left = (kPx << d.tile_log2) + kHalfPx;
  const int reach = 8 * (kPx << d.tile_log2);
  const spec::FrameState frame{1024, 1024};
  spec::SetupPrim prim;
  ASSERT_EQ(core::setup(c, frame, triangle({left, 0}, {left + reach, 0}, {left, reach}), &prim),
            core::Drop::kNone);
  const Walk expected = core_walk(c, prim);
  EXPECT_GE(expected.accepted.size(), 7u);  // those of that column alone
  for_each_level([&] { EXPECT_TRUE(same(fast_walk(c, prim, false), expected)); });
}
INSTANTIATE_TEST_SUITE_P(Sides, TileCover, testing::Values(2, 3, 4, 5, 6));

}  // namespace
}  // namespace pineda::test
