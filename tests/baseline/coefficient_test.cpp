// "6.837 Lecture 6", slides 12 and 13: A, B, C, and how many bits they need.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/baseline/printed.h"
#include "tests/baseline/support.h"

namespace pineda::test {
namespace {

using printed::Corners;
using printed::EdgeEqn;
using printed::Vertex2D;

// A coordinate that is not snapped, so that A and B are truncated, too.
Vertex2D anywhere(Random& random, int size_px) {
  const double x = random.unit() * size_px;
  const double y = random.unit() * size_px;
  return {static_cast<float>(x), static_cast<float>(y), 0};
}

// A and B are truncated, but C is computed from the untruncated vertices: an edge misses its own
// vertex by up to 2^-12 px for each px of distance from the origin.
TEST(EdgeEquation, CTruncatedApartFromAAndBMissesItsOwnVertex) {
  Random random(1);
  double apart = 0;
  double together = 0;
  for (int n = 0; n < 20000; ++n) {
    const Vertex2D u = anywhere(random, 724);
    const Vertex2D w = anywhere(random, 724);
    const EdgeEqn e(u, w);
    const double rest = e.a * double{u.x} + e.b * double{u.y};
    apart = std::max(apart, std::abs(rest + e.c));
    together = std::max(together, std::abs(rest + std::trunc(-rest)));
  }
  record("apart", apart);
  EXPECT_GT(apart, 500);  // units of 2^-12 px^2
  EXPECT_LT(together, 1);
}

// A triangle whose first edge passes the sample of `pixel` at `units` of 2^-16 px^2. The sample
// lies outside of that edge and inside of the other two.
spec::Triangle just_outside(Random& random, Point pixel, int units) {
  const auto [d, w] = unit_lattice(random, 20 * kPx);
  const Point p{pixel.x * kPx + kHalfPx, pixel.y * kPx + kHalfPx};
  const Point from{p.x + d.x, p.y + d.y};
  const Point to{p.x - d.x + units * w.x, p.y - d.y + units * w.y};  // cross(d, w) = 1
  const auto side = [&](Point q) {
    return int64_t{to.x - from.x} * (q.y - from.y) - int64_t{to.y - from.y} * (q.x - from.x);
  };
  Point far{p.x - 3 * d.y, p.y + 3 * d.x};
  if ((side(far) > 0) == (side(p) > 0)) far = {p.x + 3 * d.y, p.y - 3 * d.x};
  return triangle(from, to, far);
}

// On snapped vertices A and B are exact and only C is truncated, towards 0: where C is negative
// this moves the edge outwards.
TEST(EdgeEquation, TruncatedCDrawsASampleBeyondItsEdgeAndTheMendedOneDoesNot) {
  constexpr int kSize = 512;
  constexpr int kTriangles = 4000;
  Random random(2);
  int drawn = 0;
  Verdict mended;
  for (int n = 0; n < kTriangles; ++n) {
    const int x = random.between(100, 400);
    const int y = random.between(100, 400);
    const spec::Triangle t = just_outside(random, {x, y}, random.between(1, 15));
    ASSERT_FALSE(judge(square(kSize), t).covers(x, y));
    printed::Setup s;
    ASSERT_TRUE(printed::triangle_setup(printed::corners(t), kSize, kSize, &s));
    const auto& e = s.edge;
    drawn += (e[0].evaluate(x, y) | e[1].evaluate(x, y) | e[2].evaluate(x, y)) >= 0 ? 1 : 0;
    judge_samples(square(kSize), t, samples_of("edge_smooth", square(kSize), t), &mended);
  }
  record("drawn", static_cast<double>(drawn) / kTriangles);
  EXPECT_GT(drawn, kTriangles / 4);
  EXPECT_EQ(mended.faults(), 0);
  EXPECT_GT(mended.wanted, 100000);
}

// Share of random triangles in size x size px with a pixel that 32-bit and 64-bit edges decide
// differently.
double overflow_share(int size_px, int count, int stride) {
  Random random(3);
  int wrong = 0;
  for (int n = 0; n < count; ++n) {
    const Corners v = printed::corners(triangle_in(random, size_px));
    const printed::Setup s = printed::with_right_box(v, size_px);
    std::array<std::array<int64_t, 3>, 3> wide;
    double area = 0;
    for (size_t i = 0; i < 3; ++i) {
      const Vertex2D& u = v[i];
      const Vertex2D& w = v[(i + 1) % 3];
      const double c = double{u.x} * w.y - double{w.x} * u.y;
      area += c;
      wide[i] = {std::llround((double{u.y} - w.y) * 4096), std::llround((double{w.x} - u.x) * 4096),
                 static_cast<int64_t>(c * 4096)};
    }
    bool differs = false;
    printed::for_each_pixel(s, stride, [&](int x, int y) {
      bool inside = true;
      for (const auto& e : wide) {
        const int64_t value = e[0] * x + e[1] * y + e[2];
        inside = inside && (area > 0 ? value : -value) >= 0;
      }
      const int32_t signs =
          s.edge[0].evaluate(x, y) | s.edge[1].evaluate(x, y) | s.edge[2].evaluate(x, y);
      differs = differs || (signs >= 0) != inside;
    });
    wrong += differs ? 1 : 0;
  }
  return static_cast<double>(wrong) / count;
}

TEST(EdgeEquation, ThirtyTwoBitsOverflowAbove724Px) {
  const double at_724 = overflow_share(724, 400, 4);
  const double at_1024 = overflow_share(1024, 400, 4);
  const double at_4096 = overflow_share(4096, 400, 16);
  record("at_724", at_724);
  record("at_1024", at_1024);
  record("at_4096", at_4096);
  EXPECT_EQ(at_724, 0);
  EXPECT_NEAR(at_1024, .295, .08);
  EXPECT_GT(at_4096, .95);
}

TEST(EdgeEquation, SixtyFourBitsHoldA4096PxTriangle) {
  Random random(4);
  Verdict verdict;
  const spec::FrameState strip{4096, 64, spec::Cull::kNone, spec::DepthFunc::kLess};
  for (int n = 0; n < 12; ++n) {
    spec::Triangle t = triangle_in(random, 4096);
    for (auto& v : t.v) v.y -= 2000 * kPx;  // the strip cuts its middle
    judge_samples(strip, t, samples_of("edge_smooth", strip, t), &verdict);
  }
  EXPECT_EQ(verdict.faults(), 0);
  EXPECT_GT(verdict.wanted, 10000);
}

// Short edges far from the origin, as in any fine mesh.
TEST(CThreeWays, Binary32LosesTheDeterminantAndTheOneVertexFormIsNotAntisymmetric) {
  Random random(5);
  double determinant = 0;
  double vertex = 0;
  double average = 0;
  int lopsided = 0;
  constexpr int kEdges = 200000;
  for (int n = 0; n < kEdges; ++n) {
    const int x0 = random.between(0, 8192 * kPx);
    const int y0 = random.between(0, 8192 * kPx);
    const int x1 = x0 + random.between(-8 * kPx, 8 * kPx);
    const int y1 = y0 + random.between(-8 * kPx, 8 * kPx);
    const auto px = [](int v) { return static_cast<float>(v) / kPx; };
    const Vertex2D u{px(x0), px(y0), 0};
    const Vertex2D w{px(x1), px(y1), 0};
    const auto exact =
        static_cast<double>(int64_t{x0} * y1 - int64_t{x1} * y0) / (double{kPx} * kPx);
    const auto error = [&](float c) { return std::abs(c - exact) * 4096; };
    determinant = std::max(determinant, error(printed::c_determinant(u, w)));
    vertex = std::max(vertex, error(printed::c_vertex(u, w)));
    average = std::max(average, error(printed::c_average(u, w)));
    lopsided += printed::c_vertex(u, w) != -printed::c_vertex(w, u) ? 1 : 0;
    ASSERT_EQ(printed::c_average(u, w), -printed::c_average(w, u));
    ASSERT_EQ(printed::c_determinant(u, w), -printed::c_determinant(w, u));
  }
  record("determinant", determinant);
  record("vertex", vertex);
  record("average", average);
  record("lopsided", static_cast<double>(lopsided) / kEdges);
  EXPECT_NEAR(determinant, 1.6e4, .4e4);  // units of 2^-12 px^2
  EXPECT_NEAR(vertex, 31.7, 8);
  EXPECT_NEAR(average, 31.3, 8);
  EXPECT_NEAR(static_cast<double>(lopsided) / kEdges, .34, .12);
}

TEST(CThreeWays, InExactIntegersAllAgree) {
  Random random(6);
  for (int n = 0; n < 10000; ++n) {
    std::array<int64_t, 4> p;  // x0, y0, x1, y1
    for (int64_t& v : p) v = random.between(kGuardLow, kGuardHigh);
    const auto [x0, y0, x1, y1] = p;
    const int64_t a = y0 - y1;
    const int64_t b = x1 - x0;
    const int64_t determinant = x0 * y1 - x1 * y0;
    const int64_t twice = -(a * (x0 + x1) + b * (y0 + y1));
    ASSERT_EQ(-a * x0 - b * y0, determinant);
    ASSERT_EQ(twice % 2, 0);
    ASSERT_EQ(twice / 2, determinant);
  }
}

}  // namespace
}  // namespace pineda::test
