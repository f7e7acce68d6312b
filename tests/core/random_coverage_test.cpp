// 100,000 random triangles: traversal's masks against the judge's spans, sample by sample.
#include <gtest/gtest.h>

#include <string>

#include "tests/core/support.h"

namespace pineda::test {
namespace {

struct ShapeCase {
  const char* name;
  Shape shape;
  int count;
  int least_drawn;  // least number of triangles that cover a sample
};

class RandomCoverage : public testing::TestWithParam<ShapeCase> {};
INSTANTIATE_TEST_SUITE_P(Shapes, RandomCoverage,
                         testing::Values(ShapeCase{"Size16Px", Shape::k16Px, 35000, 25000},
                                         ShapeCase{"Size256Px", Shape::k256Px, 15000, 8000},
                                         ShapeCase{"Size8192Px", Shape::k8192Px, 15000, 10000},
                                         ShapeCase{"GuardBand", Shape::kGuardBand, 15000, 5000},
                                         ShapeCase{"Needle", Shape::kNeedle, 15000, 10000},
                                         ShapeCase{"Sliver", Shape::kSliver, 5000, 500}),
                         [](const auto& c) { return std::string(c.param.name); });

TEST_P(RandomCoverage, EqualsTheJudgeExactly) {
  const ShapeCase c = GetParam();
  Random random(31);
  int drawn = 0;
  for (int n = 0; n < c.count; ++n) {
    const spec::Triangle t = random_triangle(random, c.shape);
    ASSERT_EQ(coverage_difference(frame_of(c.shape), t), "") << "triangle " << n;
    drawn += judge(frame_of(c.shape), t).samples() > 0 ? 1 : 0;
  }
  EXPECT_GE(drawn, c.least_drawn);
}

// The check can fail: one unit added to or taken from one edge is a difference somewhere.
TEST(RandomCoverageMutant, EdgeOffByOneUnitIsCaught) {
  Random random(32);
  int caught = 0;
  for (int n = 0; n < 2000; ++n) {
    const spec::Triangle t = random_triangle(random, Shape::k16Px);
    spec::SetupPrim prim;
    if (core::setup(kContract, kHugeFrame, t, &prim) != core::Drop::kNone) continue;
    prim.edge[static_cast<size_t>(n % 3)].e += n % 2 == 0 ? 1 : -1;
    caught += coverage_difference(prim, truth(kHugeFrame, t)).empty() ? 0 : 1;
  }
  EXPECT_GT(caught, 5);
}

}  // namespace
}  // namespace pineda::test
