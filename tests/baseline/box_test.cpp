// "6.837 Lecture 6", slides 18 to 21: orientation by the area, the box from the edges' signs.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/baseline/printed.h"
#include "tests/baseline/support.h"

namespace pineda::test {
namespace {

using printed::Corners;
using printed::EdgeEqn;
using printed::Vertex2D;

TEST(BoxFromSignFlags, PrintedBoxHasNoRowsAndTheMendedOneIsTheLeastAndTheGreatest) {
  constexpr int kSize = 256;
  Random random(9);
  int drawn = 0;
  Verdict mended;
  for (int n = 0; n < 20000; ++n) {
    const spec::Triangle t = triangle_in(random, kSize);
    const Corners v = printed::corners(t);
    printed::Setup s;
    if (!printed::triangle_setup(v, kSize, kSize, &s)) continue;
    ASSERT_TRUE(s.in_table());
    const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
    ASSERT_EQ(s.x_min, std::max(static_cast<int>(left), 0));
    ASSERT_EQ(s.x_max, std::min(static_cast<int>(right + 1), kSize - 1));
    drawn += s.y_min <= s.y_max ? 1 : 0;
    if (n % 200 == 0) {
      judge_samples(square(kSize), t, samples_of("edge_flat", square(kSize), t), &mended);
    }
  }
  record("drawn", drawn);
  EXPECT_LE(drawn, 5);
  EXPECT_EQ(mended.faults(), 0);
  EXPECT_GT(mended.wanted, 100000);
}

// Narrower than a unit of 2^-12 px: B truncates to 0, and its sign flag then means "does not fall".
TEST(BoxFromSignFlags, SliverThatTruncatesToNoWidthIndexesOutsideTheTable) {
  Random random(10);
  int outside = 0;
  int below = 0;
  int set_up = 0;
  for (int n = 0; n < 20000; ++n) {
    Corners v;
    for (Vertex2D& p : v) {
      p.x = static_cast<float>(.5 + 3e-4 * random.unit());
      p.y = static_cast<float>(200 * random.unit());
    }
    printed::Setup s;
    if (!printed::triangle_setup(v, 256, 256, &s)) continue;
    ++set_up;
    outside += s.in_table() ? 0 : 1;
    below += s.x_flag < 0 || s.y_flag < 0 ? 1 : 0;
  }
  ASSERT_GT(set_up, 5000);
  record("outside", static_cast<double>(outside) / set_up);
  EXPECT_GT(static_cast<double>(outside) / set_up, .85);
  EXPECT_EQ(below, 0);  // index 6 only: three differences that add up to 0 are not all negative
}

TEST(BoxFromSignFlags, MendedBoxTakesATriangleOneSubpixelWide) {
  Verdict verdict;
  for (int x : {-1, 0, 1}) {
    const int centre = 8 * kPx + kHalfPx;
    const spec::Triangle t = triangle({centre + x, 0}, {centre + x + 1, 0}, {centre + x, 16 * kPx});
    judge_samples(square(16), t, samples_of("edge_flat", square(16), t), &verdict);
  }
  EXPECT_EQ(verdict.faults(), 0);
  EXPECT_GT(verdict.wanted, 0);
}

TEST(AreaByTheCs, IsTwiceTheAreaAndPositiveForClockwiseOnScreen) {
  const Corners clockwise{{{2, 2, 0}, {12, 2, 0}, {2, 12, 0}}};  // y down: right, then down
  printed::Setup s;
  ASSERT_TRUE(printed::triangle_setup(clockwise, 64, 64, &s));
  EXPECT_EQ(s.area, 2 * 50 * 4096);
  EXPECT_GT(EdgeEqn(clockwise[0], clockwise[1]).evaluate(3, 3), 0);  // no flip was needed
  // Cull is decided with that sign: clockwise is the back.
  const spec::Triangle t = triangle({2 * kPx, 2 * kPx}, {12 * kPx, 2 * kPx}, {2 * kPx, 12 * kPx});
  spec::FrameState frame = square(64);
  frame.cull = spec::Cull::kBack;
  EXPECT_TRUE(samples_of("edge_smooth", frame, t).empty());
  frame.cull = spec::Cull::kFront;
  EXPECT_EQ(samples_of("edge_smooth", frame, t).size(), 45u);
}

}  // namespace
}  // namespace pineda::test
