// Formulas before the rasterizer: shares on the screen and in space, clipping against a plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/baseline/printed.h"
#include "tests/core/support.h"

namespace pineda::test {
namespace {

using printed::Vector;

// A point after the matrix, and what it becomes on the screen.
struct Clip {
  double x, z, w;
  double screen_x() const { return x / w; }
};

Clip between(const Clip& a, const Clip& b, double t) {
  return {a.x + t * (b.x - a.x), a.z + t * (b.z - a.z), a.w + t * (b.w - a.w)};
}

Clip random_clip(Random& random) {
  const double x = 20 * random.unit() - 10;
  const double z = 20 * random.unit() - 10;
  const double w = .1 + 10 * random.unit();
  return {x, z, w};
}

TEST(Perspective, SAndTAreRightForPositiveWAndEachOthersInverse) {
  Random random(41);
  for (int n = 0; n < 1000; ++n) {
    const Clip p1 = random_clip(random);
    const Clip p2 = random_clip(random);
    const double t = random.unit();
    const double s = printed::screen_share(t, p1.w, p2.w);
    // The slides leave out the primes: these shares are of *screen* coordinates.
    const double on_screen = p1.screen_x() + s * (p2.screen_x() - p1.screen_x());
    ASSERT_NEAR(between(p1, p2, t).screen_x(), on_screen, 1e-9 * (1 + std::abs(on_screen)));
    ASSERT_NEAR(printed::space_share(s, p1.w, p2.w), t, 1e-9);
  }
}

TEST(Perspective, ScreenShareServesZOverWAndNotZ) {
  Random random(42);
  double worst_z = 0;
  for (int n = 0; n < 1000; ++n) {
    const Clip p1 = random_clip(random);
    const Clip p2 = random_clip(random);
    const double t = random.unit();
    const double s = printed::screen_share(t, p1.w, p2.w);
    const Clip p = between(p1, p2, t);
    const double projected = p1.z / p1.w + s * (p2.z / p2.w - p1.z / p1.w);
    ASSERT_NEAR(p.z / p.w, projected, 1e-9 * (1 + std::abs(projected)));
    worst_z = std::max(worst_z, std::abs(p1.z + s * (p2.z - p1.z) - p.z));
  }
  EXPECT_GT(worst_z, 5);  // of a range of 20
}

// The share has a pole: with one point behind the eye it leaves [0, 1].
TEST(Perspective, ShareIsMeaninglessAcrossTheEye) {
  EXPECT_LT(printed::screen_share(.4, 1, -1), -1);  // .4 * -1 / .2 = -2
  EXPECT_GT(printed::screen_share(.6, 1, -1), 1);   // .6 * -1 / -.2 = 3
}

TEST(Clipping, CrossingShareLiesOnThePlane) {
  Random random(43);
  int crossings = 0;
  for (int n = 0; n < 2000; ++n) {
    const auto vector = [&] {
      Vector v;
      for (double& c : v) c = 2 * random.unit() - 1;
      return v;
    };
    const Vector normal = vector();
    const Vector q = vector();
    const Vector a = vector();
    const Vector b = vector();
    const double f_a = printed::plane_side(normal, q, a);
    const double f_b = printed::plane_side(normal, q, b);
    if (!printed::crosses(f_a, f_b)) continue;
    ++crossings;
    const double t = printed::crossing_share(normal, q, a, b);
    ASSERT_GT(t, 0);
    ASSERT_LT(t, 1);
    Vector p;
    for (size_t i = 0; i < 3; ++i) p[i] = a[i] + t * (b[i] - a[i]);
    ASSERT_NEAR(printed::plane_side(normal, q, p), 0, 1e-12);
  }
  EXPECT_GT(crossings, 500);
}

// f(a)f(b) is 0 for an edge that touches the plane, whichever side its other end is on: the product
// cannot say whether to keep the edge, two comparisons can.
TEST(Clipping, ProductOfTheSidesCannotTellTouchingEdgesApart) {
  const Vector n{0, 0, 1};
  const Vector q{0, 0, 0};
  const double on = printed::plane_side(n, q, {3, 1, 0});
  const double inside = printed::plane_side(n, q, {0, 0, 2});
  const double outside = printed::plane_side(n, q, {0, 0, -2});
  EXPECT_FALSE(printed::crosses(on, inside));
  EXPECT_FALSE(printed::crosses(on, outside));  // the same answer, though it must go
  EXPECT_TRUE(printed::crosses(inside, outside));
  const auto keeps = [](double f) { return f >= 0; };
  EXPECT_TRUE(keeps(on) && keeps(inside));
  EXPECT_FALSE(keeps(on) && keeps(outside));
}

// An edge from w = 1 to w = -1 through the near plane w = .1. Clipped after the divide, its end is
// mirrored and the cut lands on the wrong side of the screen.
TEST(Clipping, AfterTheDivideTheCutIsOnTheWrongSide) {
  const Clip in{.5, 0, 1};
  const Clip behind{4.5, 0, -1};
  const double t =
      printed::crossing_share({0, 0, 1}, {0, 0, .1}, {in.x, 0, in.w}, {behind.x, 0, behind.w});
  const Clip cut = between(in, behind, t);
  EXPECT_NEAR(cut.w, .1, 1e-12);
  EXPECT_NEAR(cut.screen_x(), 23, 1e-9);  // far to the right, where the line goes
  const double after = in.screen_x() + t * (behind.screen_x() - in.screen_x());
  EXPECT_NEAR(after, -1.75, 1e-9);
}

}  // namespace
}  // namespace pineda::test
