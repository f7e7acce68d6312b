// Which pixels an algorithm looks at: spans, quarters of the frame, points.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/baseline/printed.h"
#include "tests/baseline/support.h"

namespace pineda::test {
namespace {

TEST(EdgeWalking, SpansWithBothEndsIncludedHitSharedEdgesTwice) {
  constexpr int kSize = 200;
  Random random(51);
  const auto mesh = lattice_mesh(random, kSize);
  Hits printed(kSize);
  for (const spec::Triangle& t : mesh) {
    for (const auto& p : printed::edge_walk(printed::corners(t))) printed.add(p.column, p.row);
  }
  record("doubles", printed.doubles());
  EXPECT_GT(printed.doubles(), 500);
  const Hits mended = hits_of("edge_walk", mesh, kSize);
  EXPECT_EQ(mended.doubles(), 0);
  EXPECT_EQ(mended.holes(), 0);
}

// Flat top, flat bottom, the middle vertex left and right; one row; an edge on a row of samples.
TEST(EdgeWalking, EveryCaseOfTheBreakpointMatchesTheJudge) {
  Verdict verdict;
  for (const int y : {-kHalfPx, 0, 1, kPx / 3, kHalfPx - 1, kHalfPx}) {
    const int top = 8 * kPx + y;
    for (const spec::Triangle& t :
         {triangle({4 * kPx, top}, {40 * kPx, top}, {20 * kPx, 50 * kPx}),
          triangle({4 * kPx, 50 * kPx}, {40 * kPx, 50 * kPx}, {20 * kPx, top}),
          triangle({20 * kPx, top}, {4 * kPx, 30 * kPx}, {30 * kPx, 60 * kPx}),
          triangle({20 * kPx, top}, {44 * kPx, 30 * kPx}, {10 * kPx, 60 * kPx}),
          triangle({4 * kPx, top}, {40 * kPx, top + kPx}, {20 * kPx, top + kHalfPx}),
          triangle({-40 * kPx, -300 * kPx}, {90 * kPx, top}, {-5 * kPx, 300 * kPx})}) {
      judge_samples(square(64), t, samples_of("edge_walk", square(64), t), &verdict);
    }
  }
  EXPECT_EQ(verdict.faults(), 0);
  EXPECT_GE(verdict.triangles, 30);  // one shape can miss every sample
}

// 300 px long, a pixel wide, at 45 degrees.
TEST(Visited, NeedleCostsByAlgorithm) {
  const spec::Triangle t = triangle({4 * kPx, 4 * kPx + 37}, {4 * kPx + 54307, 4 * kPx + 54307},
                                    {4 * kPx + 300, 4 * kPx - 40});
  const auto cost = [&](const char* name) {
    const auto rasterizer = find_baseline(name).make(kContract, square(256));
    Gathered gathered;
    rasterizer->draw(t, &gathered);
    const double ratio =
        static_cast<double>(rasterizer->visited()) / static_cast<double>(gathered.samples.size());
    record(name, ratio);
    return ratio;
  };
  EXPECT_EQ(cost("edge_walk"), 1);
  EXPECT_GT(cost("barycentric"), 150);
  EXPECT_EQ(cost("barycentric"), cost("fp64"));
  EXPECT_GT(cost("edge_smooth"), 75);
  EXPECT_LT(cost("edge_smooth"), cost("barycentric"));
  EXPECT_LT(cost("subdivision"), 10);
}

// Half of the frame: squares are accepted whole, so few of them are tested.
TEST(Subdivision, AcceptsAndRejectsWholeSquares) {
  constexpr int kSize = 256;
  const auto rasterizer = find_baseline("subdivision").make(kContract, square(kSize));
  Gathered gathered;
  rasterizer->draw(triangle({0, 0}, {kSize * kPx, 0}, {0, kSize * kPx}), &gathered);
  const auto covered = static_cast<uint64_t>(gathered.samples.size());
  EXPECT_EQ(covered, 255u * 256u / 2);
  const uint64_t squares = rasterizer->visited() - covered;
  record("squares", static_cast<double>(squares));
  EXPECT_LT(squares, covered / 20);
  EXPECT_GT(squares, 256u);
  // A triangle beside the frame: the frame is rejected as one square.
  const auto idle = find_baseline("subdivision").make(kContract, square(kSize));
  idle->draw(triangle({-9 * kPx, 0}, {-kPx, 0}, {-9 * kPx, 80 * kPx}), &gathered);
  EXPECT_EQ(idle->visited(), 1u);
}

// As far as the tests of squares can tell, the three edges of a sliver are one line across the
// frame.
TEST(Subdivision, BeyondTheTipsOfASliverNothingIsSplit) {
  const auto rasterizer = find_baseline("subdivision").make(kContract, kHugeFrame);
  Gathered gathered;
  const Point p{8000 * kPx + kHalfPx, 8000 * kPx + kHalfPx};
  rasterizer->draw(
      triangle({p.x - 20 * kPx, p.y - 20 * kPx - 1}, {p.x + 20 * kPx, p.y + 20 * kPx}, {p.x, p.y}),
      &gathered);
  EXPECT_LT(rasterizer->visited(), 1000u);
  EXPECT_GT(rasterizer->visited(), 100u);
}

TEST(Points, TakeTheirVerticesAndNothingElse) {
  spec::Triangle t = triangle({0, 0}, {10 * kPx - 1, 3 * kPx}, {-1, 5 * kPx});
  t.v[0].attr = {1, 2, 3, 4};
  t.v[0].z = 1000 * 256 + 128;
  t.v[1].z = kMaxDepthInput;
  const auto samples = samples_of("points", square(10), t);
  ASSERT_EQ(samples.size(), 2u);  // the third lies left of the frame
  EXPECT_EQ(samples[0].x, 0);
  EXPECT_EQ(samples[0].y, 0);
  EXPECT_EQ(samples[0].z, 1001);
  EXPECT_EQ(samples[0].rgba, (std::array<int, 4>{1, 2, 3, 4}));
  EXPECT_TRUE(samples_of("points", square(10), triangle({5, -1}, {5, -kPx}, {-1, 5})).empty());
  EXPECT_EQ(samples[1].x, 9);
  EXPECT_EQ(samples[1].z, (1 << 24) - 1);
}

// A scene of 100 million primitives, a tenth of them visible, on 2 million pixels: five a pixel.
// Most triangles that small cover no sample, but their vertices land in nearly every pixel.
TEST(Points, FillMicroTrianglesAndNotLargeOnes) {
  constexpr int kSize = 32;
  Random random(52);
  std::vector<spec::Triangle> micro;
  const double side = std::sqrt(.4) * kPx;  // of a right triangle of .2 px^2
  for (int n = 0; n < 5 * kSize * kSize; ++n) {
    const double turn = 7 * random.unit();
    const int dx = static_cast<int>(side * std::cos(turn));
    const int dy = static_cast<int>(side * std::sin(turn));
    const int x = random.between(0, kSize * kPx - 1);
    const int y = random.between(0, kSize * kPx - 1);
    micro.push_back(triangle({x, y}, {x + dx, y + dy}, {x - dy, y + dx}));
  }
  const Hits by_points = hits_of("points", micro, kSize);
  int empty = 0;
  for (const auto& t : micro) empty += judge(square(kSize), t).samples() == 0 ? 1 : 0;
  record("empty", empty);
  EXPECT_GT(empty, static_cast<int>(micro.size()) * 3 / 4);  // 80 %
  EXPECT_LT(by_points.holes(), 3);
  const Hits by_area = hits_of("edge_smooth", micro, kSize);
  EXPECT_GT(by_area.holes(), 100);

  const std::vector<spec::Triangle> large{triangle({0, 0}, {64 * kPx, 0}, {0, 64 * kPx})};
  EXPECT_GT(hits_of("points", large, kSize).holes(), 890);
  EXPECT_EQ(hits_of("edge_smooth", large, kSize).holes(), 0);
}

}  // namespace
}  // namespace pineda::test
