// The walk of tiles along a triangle's edges: which tiles it tests, and in which order.
#include <gtest/gtest.h>

#include <cmath>

#include "model/spec/difference.h"
#include "tests/core/support.h"

namespace pineda::test {
namespace {

using Test = core::TileWalk::Test;

struct Walk {
  int tested = 0;
  std::vector<std::pair<int, int>> kept;  // column and row
};

Walk walk_of(const spec::SetupPrim& prim, core::TileRows rows = {}) {
  Walk walk;
  core::TileWalk tiles(kContract, prim, rows);
  core::Tile tile;
  for (Test test; (test = tiles.next(&tile)) != Test::kEnd; ++walk.tested) {
    if (test == Test::kKept) walk.kept.emplace_back(tile.x, tile.y);
  }
  return walk;
}

spec::SetupPrim prim_of(const spec::FrameState& frame, const spec::Triangle& t) {
  spec::SetupPrim prim;
  EXPECT_EQ(core::setup(kContract, frame, t, &prim), core::Drop::kNone);
  return prim;
}

// Corners in tiles, in a frame of 64 x 64 of them.
Walk walk_of(std::array<std::array<double, 2>, 3> corners) {
  const auto at = [&](size_t i) {
    return Point{static_cast<int>(corners[i][0] * 8 * kPx),
                 static_cast<int>(corners[i][1] * 8 * kPx)};
  };
  return walk_of(prim_of({512, 512, spec::Cull::kNone, spec::DepthFunc::kLess},
                         triangle(at(0), at(1), at(2))));
}

using Tiles = std::vector<std::pair<int, int>>;

TEST(TileWalk, ARowEndsOneTilePastTheTriangle) {
  // The right side runs down to the left from column 8: rows keep 9, 5 and 1 tiles.
  const Walk walk = walk_of({{{0, 0}, {8.5, 0}, {0, 2.125}}});
  EXPECT_EQ(walk.kept.size(), 9u + 5 + 1);
  // Its top is flat, so the sides count as those of a triangle that runs down to the left: rows below
  // the first are walked to the left, from where the triangle ends above.
  EXPECT_EQ(walk.kept[9], std::pair(4, 1));
  EXPECT_EQ(walk.kept.back(), std::pair(0, 2));
  EXPECT_EQ(walk.tested, 9 + (4 + 5) + (4 + 1));
}

TEST(TileWalk, RowsStartFurtherRightWhereTheLeftSideRunsToTheRight) {
  // From the top left to the bottom right: the tiles of a diagonal.
  const Walk walk = walk_of({{{0.25, 0}, {0.5, 0}, {9.75, 9.5}}});
  EXPECT_EQ(walk.kept.front(), std::pair(0, 0));
  EXPECT_EQ(walk.kept.back(), std::pair(9, 9));
  EXPECT_LT(walk.tested, 60) << "of 100 in the box";
  for (size_t i = 1; i < walk.kept.size(); ++i) {
    EXPECT_LT(std::pair(walk.kept[i - 1].second, walk.kept[i - 1].first),
              std::pair(walk.kept[i].second, walk.kept[i].first));
  }
}

TEST(TileWalk, RowsAreWalkedToTheLeftWhereBothSidesRunToTheLeft) {
  const Walk walk = walk_of({{{9.5, 0}, {9.75, 0}, {0.25, 9.5}}});
  EXPECT_EQ(walk.kept.front().second, 0);
  EXPECT_EQ(walk.kept.back(), std::pair(0, 9));
  EXPECT_LT(walk.tested, 60) << "of 100 in the box";
  for (size_t i = 1; i < walk.kept.size(); ++i) {
    if (walk.kept[i].second == 0) continue;  // the first row
    EXPECT_LT(std::pair(walk.kept[i - 1].second, -walk.kept[i - 1].first),
              std::pair(walk.kept[i].second, -walk.kept[i].first));
  }
}

// Needles of any direction: a few tests a row beyond the tiles that are kept, and the first row.
TEST(TileWalk, NeedlesCostAFewTestsARow) {
  for (int degrees = 0; degrees < 180; ++degrees) {
    const double angle = (degrees + .37) * std::acos(-1.0) / 180;
    const double x = 31 * std::cos(angle), y = 31 * std::sin(angle);
    // A cap of half a tile, square to the long sides
    const double cap_x = -.25 * std::sin(angle), cap_y = .25 * std::cos(angle);
    const Walk walk = walk_of(
        {{{32 - x, 32 - y}, {32 + x + cap_x, 32 + y + cap_y}, {32 + x - cap_x, 32 + y - cap_y}}});
    const auto kept = static_cast<int>(walk.kept.size());
    const auto rows = static_cast<int>(2 * std::abs(y)) + 2;
    const auto columns = static_cast<int>(2 * std::abs(x)) + 2;
    EXPECT_LE(walk.tested, kept + 4 * rows + 2 * columns) << degrees << " degrees";
  }
}

// Tiles are tested once and in the box, and none that holds a part of the triangle is passed over:
// FlagsAgreeWithEverySampleOfTheTile. Here: never more than the box has.
TEST(TileWalk, NeverTestsMoreThanTheBox) {
  Random random(62);
  int fewer = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto shape = static_cast<Shape>(random.between(1, 4));
    spec::SetupPrim prim;
    if (core::setup(kContract, kWindow, random_triangle(random, shape), &prim) != core::Drop::kNone)
      continue;
    const int box = ((prim.x1 >> 3) - (prim.x0 >> 3) + 1) * ((prim.y1 >> 3) - (prim.y0 >> 3) + 1);
    const int tested = walk_of(prim).tested;
    ASSERT_LE(tested, box);
    fewer += tested < box ? 1 : 0;
  }
  EXPECT_GT(fewer, 300);
}

std::vector<spec::Stamp> stamps_of(const spec::SetupPrim& prim, core::TileRows rows = {}) {
  std::vector<spec::Stamp> stamps;
  core::FrameCounters uncounted;
  core::for_each_stamp(kContract, prim, rows, &uncounted,
                       [&](const spec::Stamp& stamp) { stamps.push_back(stamp); });
  return stamps;
}

TEST(TileWalk, BandsOfRowsTogetherAreTheWhole) {
  Random random(61);
  const int last_row = (kWindow.height - 1) >> kContract.design.tile_log2;
  int compared = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto shape = static_cast<Shape>(random.between(1, 4));
    const spec::Triangle t = random_triangle(random, shape);
    spec::SetupPrim prim;
    if (core::setup(kContract, kWindow, t, &prim) != core::Drop::kNone) continue;
    const auto whole = stamps_of(prim);
    for (const int rows : {1, 2, 4}) {
      std::vector<spec::Stamp> all;
      int tested = 0;
      for (int first = 0; first <= last_row; first += rows) {
        const core::TileRows band{first, first + rows - 1};
        const auto stamps = stamps_of(prim, band);
        all.insert(all.end(), stamps.begin(), stamps.end());
        tested += walk_of(prim, band).tested;
      }
      const auto text = spec::difference(kContract, whole, all);
      ASSERT_FALSE(text) << "triangle " << i << ", bands of " << rows << ": " << *text;
      ASSERT_EQ(tested, walk_of(prim).tested) << "triangle " << i << ", bands of " << rows;
    }
    compared += whole.empty() ? 0 : 1;
  }
  EXPECT_GT(compared, 500);
}

TEST(TileWalk, NothingIsTestedOutsideTheBox) {
  const auto prim = prim_of(kWindow, triangle({0, 20 * kPx}, {30 * kPx, 20 * kPx}, {0, 30 * kPx}));
  EXPECT_EQ(walk_of(prim, {0, 1}).tested, 0);
  EXPECT_EQ(walk_of(prim, {4, 5}).tested, 0);
  EXPECT_GT(walk_of(prim, {0, 1 << 16}).tested, 0);
}

}  // namespace
}  // namespace pineda::test
