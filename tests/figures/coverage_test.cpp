// Each shape in model/figures/coverage.h has the geometry that it promises.
#include "model/figures/coverage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <utility>

#include "tests/figures/support.h"

namespace pineda::figures {
namespace {

// How often each edge is walked, less how often the other way round: nonzero edges are the border.
using Edges = std::map<std::array<int64_t, 4>, int>;
void walk(const Corners& t, Edges* edges) {
  for (size_t i = 0; i < 3; ++i) {
    const Point p = t[i], q = t[(i + 1) % 3];
    const bool forward = std::pair(p.x, p.y) < std::pair(q.x, q.y);
    const Point a = forward ? p : q, b = forward ? q : p;
    const std::array<int64_t, 4> key{a.x, a.y, b.x, b.y};
    if (((*edges)[key] += forward ? 1 : -1) == 0) edges->erase(key);
  }
}

TEST(Halves, ShareTheDiagonalOfTheirChoiceAndFillTheQuad) {
  const Quad quad = rectangle({3, 4}, {13, 24});
  for (const bool from_first : {false, true}) {
    Edges edges;
    int64_t area = 0;
    for (const Corners& half : halves(quad, from_first)) {
      area += area2(half);
      walk(half, &edges);
      EXPECT_EQ(holds(half, quad[0]) && holds(half, quad[2]), from_first);
    }
    EXPECT_EQ(area, 2 * 10 * 20);
    EXPECT_EQ(edges.size(), 4u);
  }
}

// The border of the triangles of a mesh that is 5 quads wide and 3 high.
Edges border_of_mesh(bool is_torn) {
  int asked = 0;
  const auto corner = [&](int i, int j) {
    EXPECT_EQ(asked, 6 * j + i);  // row by row, each once
    ++asked;
    return Point{100 * i + j % 2, 100 * j + i % 3};
  };
  Edges edges;
  auto quads = mesh(5, 3, corner);
  EXPECT_EQ(asked, 6 * 4);
  EXPECT_EQ(quads.size(), 15u);
  if (is_torn) ++quads[7][2].x;
  for (size_t i = 0; i < quads.size(); ++i) {
    for (const Corners& half : halves(quads[i], i % 3 == 0)) {
      EXPECT_GT(area2(half), 0);
      walk(half, &edges);
    }
  }
  return edges;
}

TEST(Mesh, HasNoBorderInside) { EXPECT_EQ(border_of_mesh(false).size(), 2u * (5 + 3)); }

// The mutant: one corner of one quad a subpixel off.
TEST(Mesh, CornerOfOneQuadThatIsASubpixelOffIsSeen) {
  EXPECT_GT(border_of_mesh(true).size(), 2u * (5 + 3));
}

TEST(Fan, GoesAllTheWayRoundItsMiddle) {
  Pen p = pen();
  for (int n = 0; n < 100; ++n) {
    const Point middle = p.near({0, 0}, 5000);
    const auto points = ring(p, middle, {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, 2, 90);
    ASSERT_EQ(points.size(), 4u);
    EXPECT_EQ(points[1].x, middle.x);
    EXPECT_GE(points[1].y, middle.y + 2);
    EXPECT_LE(points[1].y, middle.y + 90);
    Edges edges;
    for (const Corners& t : fan(middle, points)) {
      EXPECT_GT(area2(t), 0);
      walk(t, &edges);
    }
    EXPECT_EQ(edges.size(), 4u);  // the ring alone
  }
}

TEST(TJunction, HalvesMeetHalfASubpixelOffTheEdgeAtTheMost) {
  Pen p = pen();
  int off = 0;
  for (int n = 0; n < 200; ++n) {
    const TJunction t{p.near({0, 0}, 999), p.near({0, 0}, 999), p.near({0, 0}, 999),
                      p.near({0, 0}, 999)};
    const Point twice = t.a + t.b - 2 * t.middle();
    EXPECT_TRUE((twice.x == 0 || twice.x == 1) && (twice.y == 0 || twice.y == 1));
    off += twice == Point{} ? 0 : 1;
    const auto [whole, first, second] = t.triangles();
    EXPECT_EQ(whole[0], first[0]);
    EXPECT_EQ(whole[1], second[1]);
    EXPECT_EQ(first[1], second[0]);
    EXPECT_EQ(first[2], second[2]);
    // The crack is what the two halves lack of the triangle on their side.
    EXPECT_EQ(area2(first) + area2(second) - area2({t.a, t.b, t.split}),
              area2({t.a, t.middle(), t.b}));
  }
  EXPECT_GT(off, 100);
}

TEST(Sliver, HasTheStatedAreaHoweverLong) {
  Pen p = pen();
  for (const int64_t reach : {5, 1280, 1280000}) {
    for (int64_t e1 = -3; e1 <= 3; ++e1) {
      for (int64_t e2 = -2; e2 <= 2; ++e2) {
        const Point along = coprime(p, reach);
        const Point sample = p.center_in_box({0, 0}, {99, 99});
        EXPECT_EQ(std::gcd(along.x, along.y), 1);
        EXPECT_EQ(cross(along, unit_partner(along)), 1);
        const Corners t = sliver(sample, along, e1, e2);
        EXPECT_EQ(std::abs(area2(t)), std::abs(e1 - 2 * e2));
        EXPECT_TRUE(e2 != 0 || t[2] == sample);
      }
    }
  }
}

// The mutant: a partner of another direction gives other areas.
TEST(Sliver, PartnerOfAnotherDirectionIsSeen) {
  const Point along{7, -12};
  const Point wrong = unit_partner({12, -7});
  EXPECT_NE(std::abs(area2({Point{} + along, Point{} - along + wrong, Point{}})), 1);
}

TEST(WithoutArea, PointsDoubledPointsAndLinesHaveNone) {
  EXPECT_EQ(area2(point({3, 4})), 0);
  EXPECT_EQ(area2(doubled({3, 4}, {70, 80})), 0);
  EXPECT_EQ(area2(line({3, 4}, {7, -11})), 0);
  EXPECT_FALSE(line({3, 4}, {7, -11})[1] == line({3, 4}, {7, -11})[2]);
}

TEST(BetweenSamples, NoColumnOfSamplesIsInTheBox) {
  Pen p = pen();
  const Point sample = p.center(3, 4);
  for (int n = 0; n < 1000; ++n) {
    for (const Point corner : between_samples(p, sample)) {
      EXPECT_GT(corner.x, sample.x);
      EXPECT_LE(corner.x, sample.x + p.px());
      EXPECT_LE(std::abs(corner.y - sample.y), 3);
    }
  }
}

TEST(Equilateral, SidesAreEqualToWithinTheLattice) {
  const Lattice lattice(spec::kHighTile);
  for (const double tangent : {-1., -.3, 0., .5, 1.}) {
    const Corners t = equilateral(lattice, 20, 30, 5, tangent);
    for (size_t i = 0; i < 3; ++i) {
      const Point side = t[(i + 1) % 3] - t[i];
      EXPECT_NEAR(std::hypot(side.x, side.y), 5 * std::sqrt(3.) * 256, 1.5) << tangent;
    }
    EXPECT_GT(area2(t), 0);
  }
}

TEST(Pen, DrawsAllOfABoxXFirstAndNothingOutsideTheGuardBand) {
  Pen p = pen();
  spec::Random same(1);
  for (int n = 0; n < 100; ++n) {
    const int64_t x = same.between(-3, 4);
    EXPECT_EQ(p.in_box({-3, 5}, {4, 6}), (Point{x, same.between(5, 6)}));
  }
  for (const Point corner :
       within(p, {p.greatest(), 2 * p.least()}, {2 * p.greatest(), p.least()})) {
    EXPECT_EQ(corner, (Point{p.greatest(), p.least()}));
  }
  for (const Point corner : around(p, p.center(2, 2), 128)) {
    EXPECT_TRUE(corner.x >= 512 && corner.x <= 768 && corner.y >= 512 && corner.y <= 768);
  }
  EXPECT_EQ(p.center(2, -1), (Point{640, -128}));
  EXPECT_EQ(p.tile(), 2048);
}

}  // namespace
}  // namespace pineda::figures
