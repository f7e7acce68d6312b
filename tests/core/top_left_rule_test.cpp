// Samples that lie on edges and corners. Each mutant of the rule must be caught.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/core/support.h"

namespace pineda::test {
namespace {

constexpr spec::FrameState kFrame{16, 16, spec::Cull::kNone, spec::DepthFunc::kLess};

Point centre(int x, int y) { return {x * kPx + kHalfPx, y * kPx + kHalfPx}; }

// A 12 px square whose corners and whose diagonal pass through pixel centres.
HitMap split_square(Rule rule) {
  HitMap hits(kFrame);
  hits.draw(triangle(centre(0, 0), centre(12, 0), centre(12, 12)), rule);
  hits.draw(triangle(centre(0, 0), centre(12, 12), centre(0, 12)), rule);
  return hits;
}

TEST(TopLeftRule, SharedDiagonalIsHitExactlyOnce) {
  const HitMap hits = split_square(Rule::kTopLeft);
  EXPECT_EQ(hits.count(1), 144);
  EXPECT_EQ(hits.count(-1), 0);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) EXPECT_EQ(hits.at(x, y), x < 12 && y < 12 ? 1 : 0);
  }
}

TEST(TopLeftRule, MutantInclusiveHitsTheDiagonalTwice) {
  const HitMap hits = split_square(Rule::kInclusive);
  EXPECT_EQ(hits.count(-1), 13);
  EXPECT_EQ(hits.count(1) + hits.count(-1), 169);
}

TEST(TopLeftRule, MutantStrictLeavesTheDiagonalEmpty) {
  const HitMap hits = split_square(Rule::kStrict);
  EXPECT_EQ(hits.count(1), 11 * 10);  // two open triangles of 55 samples
  EXPECT_EQ(hits.at(5, 5), 0);
}

TEST(TopLeftRule, HorizontalAndVerticalEdgesThroughCentres) {
  // Corners on the centres of (2,2), (8,2), (2,8): six columns and rows, the diagonal not included.
  const spec::Triangle t = triangle(centre(2, 2), centre(8, 2), centre(2, 8));
  EXPECT_EQ(coverage_difference(kFrame, t), "");
  HitMap hits(kFrame);
  hits.draw(t);
  EXPECT_EQ(hits.count(1), 6 + 5 + 4 + 3 + 2 + 1);
  EXPECT_EQ(hits.at(2, 2), 1);  // top left corner
  EXPECT_EQ(hits.at(8, 2), 0);  // right end of the top edge
  EXPECT_EQ(hits.at(2, 8), 0);  // lower end of the left edge
  EXPECT_EQ(hits.at(5, 5), 0);  // on the diagonal, a right edge here
}

TEST(TopLeftRule, BottomAndRightEdgesThroughCentresGiveNothing) {
  const spec::Triangle t = triangle(centre(8, 8), centre(2, 8), centre(8, 2));
  EXPECT_EQ(coverage_difference(kFrame, t), "");
  HitMap hits(kFrame);
  hits.draw(t);
  EXPECT_EQ(hits.count(1), 1 + 2 + 3 + 4 + 5);  // with the test above 36: the whole square
  EXPECT_EQ(hits.at(5, 5), 1);                  // on the diagonal, now a left edge
  EXPECT_EQ(hits.at(7, 7), 1);
  EXPECT_EQ(hits.at(8, 7), 0);
  EXPECT_EQ(hits.at(7, 8), 0);
}

// Every triangle of a lattice of half pixels in a small frame: all that touch centres and corners.
TEST(TopLeftRule, AllTrianglesOfTheHalfPixelLatticeMatchTheJudge) {
  constexpr int kSteps = 7;
  constexpr spec::FrameState kSmall{4, 4, spec::Cull::kNone, spec::DepthFunc::kLess};
  const auto corner = [](int i) { return Point{i % kSteps * kHalfPx, i / kSteps * kHalfPx}; };
  int drawn = 0;
  for (int i = 0; i < kSteps * kSteps; ++i) {
    for (int j = i + 1; j < kSteps * kSteps; ++j) {
      for (int k = 0; k < kSteps * kSteps; ++k) {
        const spec::Triangle t = triangle(corner(i), corner(j), corner(k));
        ASSERT_EQ(coverage_difference(kSmall, t), "") << i << ' ' << j << ' ' << k;
        ++drawn;
      }
    }
  }
  EXPECT_EQ(drawn, 49 * 48 / 2 * 49);
}

TEST(TopLeftRule, FanAroundASampleHitsItExactlyOnce) {
  Random random(11);
  for (int n = 0; n < 300; ++n) {
    // One corner in each of three to eight directions around the centre of (8, 8); often a
    // neighbour lies straight across or on a row or column of centres.
    constexpr std::array<Point, 8> kDirections{
        {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    std::vector<Point> ring;
    const int phase = random.between(0, 7);
    const int step = random.between(1, 2);
    for (int i = 0; i < 8; i += step) {
      const Point d = kDirections[static_cast<size_t>((i + phase) % 8)];
      const int r = random.between(1, 5 * kPx);
      ring.push_back({8 * kPx + kHalfPx + d.x * r, 8 * kPx + kHalfPx + d.y * r});
    }
    HitMap hits(kFrame);
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point& next = ring[(i + 1) % ring.size()];
      const bool turn = random.between(0, 1) != 0;
      hits.draw(turn ? triangle(ring[i], next, centre(8, 8))
                     : triangle(next, ring[i], centre(8, 8)));
    }
    ASSERT_EQ(hits.at(8, 8), 1) << n;
    ASSERT_EQ(hits.count(-1), 0) << n;
  }
}

TEST(TopLeftRule, FanMutantInclusiveHitsItsHubByEveryTriangle) {
  HitMap hits(kFrame);
  const std::array<Point, 4> ring{centre(8, 3), centre(13, 8), centre(8, 13), centre(3, 8)};
  for (size_t i = 0; i < 4; ++i) {
    hits.draw(triangle(ring[i], ring[(i + 1) % 4], centre(8, 8)), Rule::kInclusive);
  }
  EXPECT_EQ(hits.at(8, 8), 4);
}

// Doubled areas of one to four units: such a triangle may cover just the pixel centre at its
// corner.
TEST(TopLeftRule, SliverOfOneUnitDrawsTheSampleItOwns) {
  Random random(12);
  int drawn = 0;
  int one_unit = 0;
  for (int n = 0; n < 2000; ++n) {
    const spec::Triangle t = random_triangle(random, Shape::kSliver);
    const exact::Judge exact = judge(kHugeFrame, t);
    ASSERT_LE(std::abs(exact.doubled_area()), 4);
    ASSERT_GE(std::abs(exact.doubled_area()), 1);
    ASSERT_EQ(coverage_difference(kHugeFrame, t), "") << n;
    drawn += exact.samples() > 0 ? 1 : 0;
    one_unit += exact.samples() > 0 && std::abs(exact.doubled_area()) == 1 ? 1 : 0;
  }
  EXPECT_GT(drawn, 200);
  EXPECT_GT(one_unit, 50);
}

TEST(TopLeftRule, MutantShiftFirstLosesSamplesBesideAnEdge) {
  // The centre of (8,8) lies one subpixel inside a right edge: E is small and its shifted value 0.
  const spec::Triangle t =
      triangle({8 * kPx + kHalfPx + 1, 4 * kPx}, {8 * kPx + kHalfPx + 1, 4 * kPx + kPx / 2 + 5},
               {4 * kPx, 4 * kPx});
  spec::SetupPrim prim;
  ASSERT_EQ(core::setup(kContract, kFrame, t, &prim), core::Drop::kNone);
  const judge::SnappedTruth exact = truth(kFrame, t);
  ASSERT_EQ(coverage_difference(with_rule(prim, t, Rule::kTopLeft), exact), "");
  EXPECT_NE(coverage_difference(with_rule(prim, t, Rule::kShiftFirst), exact), "");
}

}  // namespace
}  // namespace pineda::test
