// Each shape in model/figures/limits.h has the geometry that it promises.
#include "model/figures/limits.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <utility>

#include "model/figures/coverage.h"
#include "tests/figures/support.h"

namespace pineda::figures {
namespace {

constexpr int64_t kLeast = -(int64_t{1} << 22);
constexpr int64_t kGreatest = (int64_t{1} << 22) - 1;

TEST(GuardBand, ItsCornersAreTheExtremesOfTheFormat) {
  const Lattice lattice(spec::kHighTile);
  const Quad quad = guard_band(lattice);
  EXPECT_EQ(quad[0], (Point{kLeast, kLeast}));
  EXPECT_EQ(quad[2], (Point{kGreatest, kGreatest}));
  for (size_t first = 0; first < 5; ++first) {
    const Corners t = three_of(quad, first);
    EXPECT_EQ(area2(t), (kGreatest - kLeast) * (kGreatest - kLeast));
    EXPECT_EQ(t[0], quad[first % 4]);
  }
}

TEST(GuardBand, RingRunsAlongItsWholeBorder) {
  Pen p = pen();
  const auto points = guard_band_ring(p, 16, 500 * 256);
  ASSERT_EQ(points.size(), 64u);
  int corners_in_order = 0;
  for (const Point q : points) {
    EXPECT_TRUE(q.x == kLeast || q.x == kGreatest || q.y == kLeast || q.y == kGreatest);
  }
  // All the way round: each triangle of the fan turns one way.
  for (const Corners& t : fan({}, points)) corners_in_order += area2(t) > 0 ? 1 : 0;
  EXPECT_EQ(corners_in_order, 64);
}

TEST(Through, ItsFirstEdgeHasThePointInTheMiddle) {
  const Corners t = through({100, 200}, {70, -9000}, {5, 5});
  EXPECT_EQ(t[0] + t[1], (Point{200, 400}));
  EXPECT_EQ(t[0] - t[1], (Point{140, -18000}));
}

TEST(ExtremeCorner, AllSixteenExtremesOfBothAxesAreDrawnInsideTheGuardBand) {
  Pen p = pen();
  std::set<int64_t> x, y;
  for (int n = 0; n < 2000; ++n) {
    const Point corner = extreme_corner(p, n % 4);
    x.insert(corner.x);
    y.insert(corner.y);
  }
  const std::set<int64_t> all{kLeast, kLeast + 1, -129,          -2,       -1, 0,
                              1,      128,        kGreatest - 1, kGreatest};
  EXPECT_EQ(x, all);
  EXPECT_EQ(y, all);
}

TEST(TileBorder, IsOnItOrHalfAPixelToEitherSide) {
  Pen p = pen();
  std::set<int64_t> drawn;
  for (int n = 0; n < 100; ++n) drawn.insert(tile_border(p, 3));
  EXPECT_EQ(drawn, (std::set<int64_t>{3 * 2048 - 128, 3 * 2048, 3 * 2048 + 128}));
}

TEST(Needle, HasItsWidthAcrossItsAxis) {
  for (const bool is_steep : {false, true}) {
    const Needle needle{1000, -300, 16, is_steep};
    const Corners t = needle.from({7, 9});
    EXPECT_EQ(t[0], (Point{7, 9}));
    EXPECT_EQ(t[1] - t[0], needle.along());
    EXPECT_EQ(std::abs(area2(t)), 1000 * 16);
  }
  EXPECT_EQ((Needle{1000, -300, 16, true}.along()), (Point{-300, 1000}));
}

TEST(WholePlane, IsEqualWhicheverWayItIsReached) {
  const WholePlane plane{16, 1, -2};
  const auto [a, b, c] = right_angle({3, 4}, 64);
  EXPECT_EQ(area2({a, b, c}), 64 * 64);
  EXPECT_EQ(plane.at(a), 16 + 3 - 8);
  EXPECT_EQ(plane.at(b) - plane.at(a), 64);
  EXPECT_EQ(plane.at(c) - plane.at(a), -128);
}

// The mutant: a step that is one unit off is not on the plane.
TEST(WholePlane, StepThatIsAUnitOffIsSeen) {
  const WholePlane plane{16, 1, -2}, off{16, 1, -3};
  EXPECT_NE(plane.at({3, 4}), off.at({3, 4}));
}

}  // namespace
}  // namespace pineda::figures
