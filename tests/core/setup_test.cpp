// Setup: culling, boxes, the canonical order and the guard band.
#include "model/core/setup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

#include "model/core/frame.h"
#include "tests/core/support.h"

namespace pineda::test {
namespace {

using core::Drop;

constexpr spec::FrameState kFrame{64, 48, spec::Cull::kNone, spec::DepthFunc::kLess};

spec::FrameState culling(spec::Cull cull) {
  spec::FrameState frame = kFrame;
  frame.cull = cull;
  return frame;
}

Drop drop_of(const spec::FrameState& frame, const spec::Triangle& t) {
  spec::SetupPrim prim;
  return core::setup(kContract, frame, t, &prim);
}

const spec::Triangle kClockwise = triangle({100, 100}, {5000, 300}, {700, 6000});
const spec::Triangle kCounterClockwise = triangle({100, 100}, {700, 6000}, {5000, 300});

TEST(Culling, FrontIsCounterClockwiseOnScreen) {
  EXPECT_EQ(drop_of(culling(spec::Cull::kNone), kClockwise), Drop::kNone);
  EXPECT_EQ(drop_of(culling(spec::Cull::kNone), kCounterClockwise), Drop::kNone);
  EXPECT_EQ(drop_of(culling(spec::Cull::kBack), kClockwise), Drop::kFacing);
  EXPECT_EQ(drop_of(culling(spec::Cull::kBack), kCounterClockwise), Drop::kNone);
  EXPECT_EQ(drop_of(culling(spec::Cull::kFront), kClockwise), Drop::kNone);
  EXPECT_EQ(drop_of(culling(spec::Cull::kFront), kCounterClockwise), Drop::kFacing);
}

TEST(Culling, ZeroAreaDrawsNothingAndIsCounted) {
  const std::array<spec::Triangle, 5> flat{
      triangle({128, 128}, {1152, 1152}, {640, 640}),  // on a diagonal through centres
      triangle({128, 128}, {128, 128}, {128, 128}),    // one point, a centre
      triangle({128, 128}, {4000, 128}, {2000, 128}),  // a row of centres
      triangle({128, 4000}, {128, 128}, {128, 4000}),  // a column of centres, twice a corner
      triangle({kGuardLow, kGuardLow}, {0, 0}, {4194303, 4194303}),
  };
  for (const auto cull : {spec::Cull::kNone, spec::Cull::kBack, spec::Cull::kFront}) {
    core::Renderer renderer(kContract, culling(cull));
    for (const auto& t : flat) EXPECT_EQ(renderer.draw(t), Drop::kZeroArea);
    EXPECT_EQ(renderer.counters().triangles, 5u);
    EXPECT_EQ(renderer.counters().dropped[static_cast<size_t>(Drop::kZeroArea)], 5u);
    EXPECT_EQ(renderer.counters().fragments, 0u);
  }
}

// One unit of area is not zero: what counts is area, not how thin a triangle is.
TEST(Culling, OneUnitOfAreaIsNotZero) {
  EXPECT_EQ(drop_of(kFrame, triangle({128, 128}, {1152, 1152}, {1151, 1151})), Drop::kZeroArea);
  EXPECT_EQ(drop_of(kFrame, triangle({128, 128}, {1153, 1152}, {1152, 1151})), Drop::kNone);
}

TEST(Culling, FirstCauseCounts) {
  // A back-facing triangle outside the frame that holds no sample: facing comes first.
  const spec::Triangle t = triangle({-300, -300}, {-290, -300}, {-300, -290});
  EXPECT_EQ(drop_of(culling(spec::Cull::kBack), t), Drop::kFacing);
  EXPECT_EQ(drop_of(kFrame, t), Drop::kNoSample);
  EXPECT_EQ(drop_of(kFrame, triangle({-3000, -3000}, {-600, -3000}, {-3000, -600})),
            Drop::kOutside);
}

TEST(BoundingBox, GreatestVertexOnACentreIsExclusive) {
  // Corners on the centres of (2,3), (10,3) and (2,12).
  spec::SetupPrim prim;
  const spec::Triangle t = triangle({640, 896}, {2688, 896}, {640, 3200});
  ASSERT_EQ(core::setup(kContract, kFrame, t, &prim), Drop::kNone);
  EXPECT_EQ(prim.x0, 2);
  EXPECT_EQ(prim.y0, 3);
  EXPECT_EQ(prim.x1, 9);
  EXPECT_EQ(prim.y1, 11);
  // One subpixel further and the pixel is in the box; one less at the left and top changes nothing.
  const spec::Triangle grown = triangle({639, 895}, {2689, 895}, {639, 3201});
  ASSERT_EQ(core::setup(kContract, kFrame, grown, &prim), Drop::kNone);
  EXPECT_EQ(prim.x0, 2);
  EXPECT_EQ(prim.y0, 3);
  EXPECT_EQ(prim.x1, 10);
  EXPECT_EQ(prim.y1, 12);
}

TEST(BoundingBox, BetweenTwoCentresHoldsNoSample) {
  EXPECT_EQ(drop_of(kFrame, triangle({129, 0}, {384, 0}, {200, 9000})), Drop::kNoSample);
  EXPECT_EQ(drop_of(kFrame, triangle({128, 0}, {384, 0}, {200, 9000})), Drop::kNone);
  EXPECT_EQ(drop_of(kFrame, triangle({0, 129}, {9000, 384}, {0, 384})), Drop::kNoSample);
}

TEST(BoundingBox, FrameOfOnePixel) {
  constexpr spec::FrameState kOne{1, 1, spec::Cull::kNone, spec::DepthFunc::kLess};
  spec::SetupPrim prim;
  const spec::Triangle t =
      triangle({kGuardLow, kGuardLow}, {kGuardHigh, kGuardLow}, {0, kGuardHigh});
  ASSERT_EQ(core::setup(kContract, kOne, t, &prim), Drop::kNone);
  EXPECT_EQ(prim.x0, 0);
  EXPECT_EQ(prim.y0, 0);
  EXPECT_EQ(prim.x1, 0);
  EXPECT_EQ(prim.y1, 0);
  EXPECT_EQ(coverage_difference(kOne, t), "");
}

bool same_plane(const spec::Plane& a, const spec::Plane& b) {
  return a.dx == b.dx && a.dy == b.dy && a.ref == b.ref;
}

bool same(const spec::SetupPrim& a, const spec::SetupPrim& b) {
  bool equal = a.x0 == b.x0 && a.y0 == b.y0 && a.x1 == b.x1 && a.y1 == b.y1 &&
               same_plane(a.planes.z, b.planes.z);
  for (size_t i = 0; i < 3; ++i) {
    equal &= a.edge[i].a == b.edge[i].a && a.edge[i].b == b.edge[i].b && a.edge[i].e == b.edge[i].e;
  }
  for (size_t i = 0; i < 4; ++i) equal &= same_plane(a.planes.attr[i], b.planes.attr[i]);
  return equal;
}

TEST(CanonicalOrder, AllSixVertexOrdersGiveIdenticalBits) {
  Random random(51);
  int compared = 0;
  for (int n = 0; n < 3000; ++n) {
    const auto shape = static_cast<Shape>(n % 6);
    spec::Triangle t = random_triangle(random, shape);
    if (n % 5 == 0) t.v[1].y = t.v[0].y;  // two topmost vertices, often: the leftmost decides
    randomize_values(random, &t);
    spec::SetupPrim first;
    if (core::setup(kContract, frame_of(shape), t, &first) != Drop::kNone) continue;
    std::array<size_t, 3> order{0, 1, 2};
    while (std::next_permutation(order.begin(), order.end())) {
      spec::Triangle turned = t;
      for (size_t i = 0; i < 3; ++i) turned.v[i] = t.v[order[i]];
      spec::SetupPrim prim;
      ASSERT_EQ(core::setup(kContract, frame_of(shape), turned, &prim), Drop::kNone);
      ASSERT_TRUE(same(prim, first)) << n;
      ++compared;
    }
  }
  EXPECT_GT(compared, 5000);
}

// The comparison can fail: with depths swapped between vertices it is another triangle.
TEST(CanonicalOrder, MutantWithSwappedDepthsIsToldApart) {
  spec::Triangle t = kClockwise;
  t.v[0].z = 1000;
  spec::Triangle mutant = t;
  std::swap(mutant.v[0].z, mutant.v[1].z);
  spec::SetupPrim a;
  spec::SetupPrim b;
  ASSERT_EQ(core::setup(kContract, kFrame, t, &a), Drop::kNone);
  ASSERT_EQ(core::setup(kContract, kFrame, mutant, &b), Drop::kNone);
  EXPECT_FALSE(same(a, b));
}

TEST(GuardBand, ExtremeCornersCoverTheWholeFrameWithoutWrapping) {
  // Two triangles make the guard band's square: every sample of a frame is hit once.
  const std::array<spec::Triangle, 2> halves{
      triangle({kGuardLow, kGuardLow}, {kGuardHigh, kGuardLow}, {kGuardHigh, kGuardHigh}),
      triangle({kGuardLow, kGuardLow}, {kGuardHigh, kGuardHigh}, {kGuardLow, kGuardHigh})};
  constexpr spec::FrameState kOdd{641, 479, spec::Cull::kNone, spec::DepthFunc::kLess};
  HitMap hits(kOdd);
  for (const auto& t : halves) {
    EXPECT_EQ(coverage_difference(kOdd, t), "");
    hits.draw(t);
  }
  EXPECT_EQ(hits.count(1), 641 * 479);
}

// The mutant: edges of 32 bits wrap, and the test above sees it.
TEST(GuardBand, MutantWithEdgesOf32BitsIsCaught) {
  const spec::Triangle t =
      triangle({kGuardLow, kGuardLow}, {kGuardHigh, kGuardLow}, {kGuardHigh, kGuardHigh});
  spec::SetupPrim prim;
  ASSERT_EQ(core::setup(kContract, kFrame, t, &prim), Drop::kNone);
  for (auto& edge : prim.edge) edge.e = spec::wrap(edge.e, 32);
  EXPECT_NE(coverage_difference(prim, truth(kFrame, t)), "");
}

}  // namespace
}  // namespace pineda::test
