// The judge against cases worked by hand.
#include "model/exact/exact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

namespace exact {
namespace {

constexpr int kSubpixelBits = 1;  // half pixels: pixel centres lie on the odd coordinates

Vertex at(int64_t x, int64_t y) { return {x, y, 0, {0}}; }

Judge judge(const Triangle& t, Cull cull = Cull::kNone, int size = 8) {
  return {t, kSubpixelBits, size, size, cull};
}

std::set<std::pair<int, int>> covered(const Judge& j, int size = 8) {
  std::set<std::pair<int, int>> samples;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      if (j.covers(x, y)) samples.insert({x, y});
    }
  }
  return samples;
}

using Samples = std::set<std::pair<int, int>>;

TEST(JudgeCoverage, RightTriangleThroughCentresKeepsTopAndLeftOnly) {
  // Corners on the centres of pixels (0,0), (3,0), (0,3). Row 0 lies on the top edge: x from 0 to
  // below 3. Rows 1 and 2 run from the left edge to below the diagonal at 2 and 1. Row 3: bottom.
  const Judge j = judge({at(1, 1), at(7, 1), at(1, 7)});
  EXPECT_EQ(covered(j), (Samples{{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {0, 2}}));
  EXPECT_EQ(j.samples(), 6);
  EXPECT_EQ(j.doubled_area(), 36);  // clockwise: right, then down
  EXPECT_EQ(j.rows().first, 0);
  EXPECT_EQ(j.rows().last, 2);
}

TEST(JudgeCoverage, OtherHalfOfTheSquareTakesTheDiagonal) {
  // (3,0), (3,3), (0,3): the diagonal is its left edge, so it takes (2,1) and (1,2); its right edge
  // and its bottom edge give nothing, and (3,0) lies on the right edge.
  const Judge j = judge({at(7, 1), at(7, 7), at(1, 7)});
  EXPECT_EQ(covered(j), (Samples{{2, 1}, {1, 2}, {2, 2}}));
}

TEST(JudgeCoverage, MiddleVertexOnCentreBelongsToTheLeftCornerOnly) {
  // Corner pointing left at the centre of (1,2): both its edges are left edges.
  EXPECT_TRUE(judge({at(3, 5), at(7, 2), at(7, 8)}).covers(1, 2));
  // Corner pointing right at the centre of (3,2): both are right edges.
  EXPECT_FALSE(judge({at(7, 5), at(2, 2), at(2, 8)}).covers(3, 2));
}

TEST(JudgeCoverage, ApexOnCentreBelongsToNobodyWithoutATopEdge) {
  // The apex touches a left and a right edge.
  EXPECT_FALSE(judge({at(5, 3), at(8, 8), at(2, 8)}).covers(2, 1));
  // A lower apex touches them too.
  EXPECT_FALSE(judge({at(2, 2), at(8, 2), at(5, 7)}).covers(2, 3));
}

TEST(JudgeCoverage, FrameCutsSpansAndRows) {
  const Judge j = judge({at(-100, -100), at(300, -100), at(-100, 300)}, Cull::kNone, 4);
  EXPECT_EQ(j.samples(), 16);
  EXPECT_EQ(j.span(0).first, 0);
  EXPECT_EQ(j.span(0).last, 3);
  EXPECT_GT(j.span(4).first, j.span(4).last);
  EXPECT_GT(j.span(-1).first, j.span(-1).last);
}

TEST(JudgeCoverage, AnyVertexOrderCoversTheSameSamples) {
  Triangle t{at(1, 1), at(9, 4), at(3, 11)};
  std::array<int, 3> order{0, 1, 2};
  const Samples wanted = covered(judge(t));
  ASSERT_GT(wanted.size(), 5u);
  do {
    const auto v = [&](size_t i) { return t[static_cast<size_t>(order[i])]; };
    EXPECT_EQ(covered(judge({v(0), v(1), v(2)})), wanted);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(JudgeCulling, FrontIsCounterClockwiseOnScreen) {
  const Triangle clockwise{at(1, 1), at(7, 1), at(1, 7)};
  const Triangle counter{at(1, 1), at(1, 7), at(7, 1)};
  EXPECT_TRUE(judge(clockwise, Cull::kBack).culled());
  EXPECT_FALSE(judge(clockwise, Cull::kFront).culled());
  EXPECT_FALSE(judge(counter, Cull::kBack).culled());
  EXPECT_TRUE(judge(counter, Cull::kFront).culled());
  EXPECT_EQ(judge(counter, Cull::kFront).samples(), 0);
  EXPECT_EQ(judge(counter, Cull::kBack).samples(), 6);
  EXPECT_EQ(judge(counter).doubled_area(), -36);
}

TEST(JudgeCulling, ZeroAreaIsCulledWhateverTheState) {
  for (const Cull cull : {Cull::kNone, Cull::kBack, Cull::kFront}) {
    const Judge j = judge({at(1, 1), at(3, 3), at(7, 7)}, cull);
    EXPECT_TRUE(j.culled());
    EXPECT_EQ(j.samples(), 0);
  }
}

TEST(JudgeErrors, PlaneThroughThreeCornersByHand) {
  // z = 10 codes at (0,0), 14 at the centre of (4,0), 30 at the centre of (0,4), and an attribute
  // of the same values: at pixel (1,2) z = 10 + 1*1 + 2*5 = 21.
  const Triangle t{Vertex{1, 1, 2560, {10}}, Vertex{9, 1, 3584, {14}}, Vertex{1, 9, 7680, {30}}};
  const Judge j = judge(t);
  EXPECT_DOUBLE_EQ(j.depth_error(1, 2, 21), 0.0);
  EXPECT_DOUBLE_EQ(j.depth_error(1, 2, 24), 3.0);
  EXPECT_DOUBLE_EQ(j.attribute_error(1, 2, 0, 20), -1.0);
  EXPECT_DOUBLE_EQ(j.attribute_error(0, 0, 0, 10), 0.0);
}

TEST(JudgeErrors, ThirdOfACodeIsTheNearestDouble) {
  // 0, 0 and 1 at corners 3 px apart: 1/3 one pixel along the way.
  const Judge j = judge({Vertex{1, 1, 0, {0}}, Vertex{7, 1, 256, {1}}, Vertex{1, 7, 0, {0}}});
  EXPECT_DOUBLE_EQ(j.depth_error(1, 0, 0), -1.0 / 3.0);
  EXPECT_DOUBLE_EQ(j.attribute_error(1, 0, 0, 1), 2.0 / 3.0);
}

TEST(JudgeErrors, WhatCannotBeJudgedIsRefused) {
  EXPECT_THROW(judge({at(int64_t{1} << 27, 1), at(7, 1), at(1, 7)}), std::out_of_range);
  EXPECT_THROW(judge({Vertex{1, 1, -1, {0}}, at(7, 1), at(1, 7)}), std::out_of_range);
  EXPECT_THROW(Judge({at(1, 1), at(7, 1), at(1, 7)}, 0, 8, 8, Cull::kNone), std::out_of_range);
  const Judge j = judge({at(1, 1), at(7, 1), at(1, 7)});
  EXPECT_THROW(j.depth_error(5, 5, 0), std::domain_error);
  EXPECT_THROW(j.attribute_error(0, 0, 1, 0), std::out_of_range);
}

}  // namespace
}  // namespace exact
