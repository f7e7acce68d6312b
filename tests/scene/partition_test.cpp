#include "model/scene/partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/spec/random.h"

namespace pineda::scene {
namespace {

int64_t turn(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return int64_t{b[0] - a[0]} * (c[1] - a[1]) - int64_t{b[1] - a[1]} * (c[0] - a[0]);
}

std::vector<Piece> cut(const std::vector<GridPoint>& polygon, bool clockwise = true) {
  std::vector<Piece> pieces;
  partition(polygon, clockwise, &pieces);
  return pieces;
}

std::vector<int64_t> areas(const std::vector<GridPoint>& p, const std::vector<Piece>& pieces) {
  std::vector<int64_t> all;
  for (const Piece& t : pieces) all.push_back(turn(p[t[0]], p[t[1]], p[t[2]]));
  return all;
}

TEST(Partition, ConvexPolygonStaysTheFanFromItsFirstPoint) {
  const std::vector<GridPoint> hexagon = {{0, 0}, {10, -5}, {20, 0}, {20, 10}, {10, 15}, {0, 10}};
  EXPECT_EQ(cut(hexagon), (std::vector<Piece>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}));
}

TEST(Partition, FanWithTrianglesWithoutAreaStaysAFan) {
  // With a repeated point, and a point in the middle of a side.
  const std::vector<GridPoint> quad = {{0, 0}, {5, 0}, {10, 0}, {10, 0}, {10, 10}};
  EXPECT_EQ(cut(quad), (std::vector<Piece>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

// The pentagon's second corner was snapped inwards: the fan's first triangle turns over.
TEST(Partition, PolygonBentInwardsIsCoveredOnceByTrianglesOfOneOrientation) {
  const std::vector<GridPoint> bent = {{0, 0}, {500, 1}, {1000, 0}, {1000, 800}, {0, 800}};
  ASSERT_LT(turn(bent[0], bent[1], bent[2]), 0);
  const auto all = areas(bent, cut(bent));
  EXPECT_EQ(all.size(), 3u);
  EXPECT_TRUE(std::all_of(all.begin(), all.end(), [](int64_t area) { return area > 0; }));
  int64_t sum = 0;
  for (const int64_t area : all) sum += area;
  EXPECT_EQ(sum, 2 * 1000 * 800 - 1000);
}

TEST(Partition, PolygonThatCrossesItselfBecomesItsHullTurnedAsBefore) {
  const std::vector<GridPoint> bow = {{0, 0}, {100, 1}, {100, 0}, {0, 1}};
  for (const bool clockwise : {true, false}) {
    const auto all = areas(bow, cut(bow, clockwise));
    ASSERT_EQ(all.size(), 2u);
    for (const int64_t area : all) EXPECT_EQ(area, clockwise ? 100 : -100);
  }
}

TEST(Partition, WithoutAreaOneTriangleWithoutAreaIsLeft) {
  const std::vector<GridPoint> line = {{0, 0}, {4, 4}, {8, 8}, {2, 2}, {1, 1}};
  const std::vector<GridPoint> point(7, {3, 3});
  for (const auto& polygon : {line, point}) {
    const auto all = areas(polygon, cut(polygon));
    ASSERT_GE(all.size(), 1u);
    EXPECT_TRUE(std::all_of(all.begin(), all.end(), [](int64_t area) { return area == 0; }));
  }
}

// A convex polygon a few grid steps wide, and its corners on the grid.
struct Snapped {
  std::vector<std::array<double, 2>> convex;
  std::vector<GridPoint> point;  // eight fine steps a grid step
};

double number(spec::Random* random, double low, double high) {
  return low + (high - low) * random->unit();
}

Snapped snapped(spec::Random* random) {
  std::vector<double> angle(static_cast<size_t>(random->between(4, 8)));
  for (double& a : angle) a = number(random, 0, 2 * M_PI);
  std::sort(angle.begin(), angle.end());
  const double wide = number(random, .3, 8), tall = number(random, .3, 3);
  const double tilt = number(random, 0, M_PI);
  const auto grid = [](double v) { return 8 * static_cast<int32_t>(std::nearbyint(v)); };
  Snapped polygon;
  for (const double a : angle) {
    const double x = wide * std::cos(a), y = tall * std::sin(a);
    polygon.convex.push_back({x * std::cos(tilt) - y * std::sin(tilt) + .3,
                              x * std::sin(tilt) + y * std::cos(tilt) + .1});
    polygon.point.push_back({grid(polygon.convex.back()[0]), grid(polygon.convex.back()[1])});
  }
  return polygon;
}

// Did snapping turn a triangle of the fan over?
bool is_bent(const std::vector<GridPoint>& p) {
  for (size_t i = 1; i + 1 < p.size(); ++i) {
    if (turn(p[0], p[i], p[i + 1]) < 0) return true;
  }
  return false;
}

// How many of the pieces contain a point? In fine steps.
int hits_of(const std::vector<GridPoint>& p, const std::vector<Piece>& pieces, double x, double y) {
  int hits = 0;
  for (const Piece& t : pieces) {
    int left = 0, right = 0;
    for (size_t i = 0; i < 3; ++i) {
      const GridPoint &a = p[t[i]], &b = p[t[(i + 1) % 3]];
      const double side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
      left += side > 0 ? 1 : 0;
      right += side < 0 ? 1 : 0;
    }
    hits += left == 3 || right == 3 ? 1 : 0;
  }
  return hits;
}

// The least distance of a point inside to the sides; negative outside. In grid steps.
double depth_in(const std::vector<std::array<double, 2>>& convex, double x, double y) {
  double nearest = 1e9;
  for (size_t i = 0; i < convex.size(); ++i) {
    const auto &a = convex[i], &b = convex[(i + 1) % convex.size()];
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    nearest = std::min(
        nearest, (dx * (y - a[1]) - dy * (x - a[0])) / (std::abs(dx) + std::abs(dy) + 1e-300));
  }
  return nearest;
}

// No point of a finer grid lies in two triangles, all triangles turn one way, and points further
// inside than snapping reaches are covered.
TEST(Partition, SnappedConvexPolygonsAreCoveredOnceWhateverSnappingDidToThem) {
  spec::Random random(1);
  int bent = 0, inside = 0;
  for (int n = 0; n < 20000; ++n) {
    const Snapped polygon = snapped(&random);
    const auto pieces = cut(polygon.point);
    const auto all = areas(polygon.point, pieces);
    const bool positive = std::all_of(all.begin(), all.end(), [](int64_t a) { return a >= 0; });
    const bool negative = std::all_of(all.begin(), all.end(), [](int64_t a) { return a <= 0; });
    ASSERT_TRUE(positive || negative) << n;
    bent += is_bent(polygon.point) ? 1 : 0;
    for (int k = 0; k < 40; ++k) {
      // On no line through grid points: odd multiples of 1/1024 fine steps.
      const double x = std::floor(number(&random, -9, 9) * 8 * 512) / 512 + 1. / 1024;
      const double y = std::floor(number(&random, -9, 9) * 8 * 512) / 512 + 1. / 2048;
      const int hits = hits_of(polygon.point, pieces, x, y);
      ASSERT_LE(hits, 1) << n << testing::PrintToString(polygon.point)
                         << testing::PrintToString(pieces) << x << " " << y;
      if (depth_in(polygon.convex, x / 8, y / 8) < .5) continue;
      ++inside;
      ASSERT_EQ(hits, 1) << n;
      ASSERT_TRUE(positive) << n;
    }
  }
  EXPECT_GT(bent, 500);
  EXPECT_GT(inside, 5000);
}

}  // namespace
}  // namespace pineda::scene
