#include <gtest/gtest.h>

#include <map>
#include <set>

#include "model/scene/builtin/builtin.h"

namespace pineda::scene {
namespace {

using Edge = std::pair<Vec3, Vec3>;

// -0 and 0 are one place.
Vec3 place(const Vec3& p) { return {p[0] + 0.0, p[1] + 0.0, p[2] + 0.0}; }

std::multiset<Edge> directed_edges(const Mesh& mesh) {
  std::multiset<Edge> edges;
  for (const auto& t : mesh.triangle) {
    for (size_t i = 0; i < 3; ++i) {
      edges.insert({place(mesh.position[t[i]]), place(mesh.position[t[(i + 1) % 3]])});
    }
  }
  return edges;
}

TEST(Teapot, TriangleCountFollowsTheTessellation) {
  for (const int n : {1, 2, 3, 10, 17}) {
    EXPECT_EQ(teapot(n).triangle.size(), static_cast<size_t>(64 * n * n - 8 * n)) << n;
  }
}

TEST(Teapot, NeighboursShareTheirEdgesBitForBitExceptAtTheOpenEnds) {
  for (const int n : {2, 4, 7, 10}) {
    const auto edges = directed_edges(teapot(n));
    size_t open = 0;
    for (const Edge& edge : edges) {
      EXPECT_EQ(edges.count(edge), 1u);
      open += edges.count({edge.second, edge.first}) == 0 ? 1 : 0;
    }
    // The rims of pot and lid (4n each), both ends of handle and spout (2n each).
    EXPECT_EQ(open, static_cast<size_t>(16 * n)) << n;
  }
}

TEST(Teapot, OutsideIsCounterClockwiseAndNormalsPointOut) {
  const Mesh mesh = teapot(10);
  double volume = 0;
  for (const auto& t : mesh.triangle) {
    const Vec3 &a = mesh.position[t[0]], &b = mesh.position[t[1]], &c = mesh.position[t[2]];
    const Vec3 face = cross(b - a, c - a);
    volume += dot(a, cross(b, c)) / 6;
    const Vec3 mean = mesh.normal[t[0]] + mesh.normal[t[1]] + mesh.normal[t[2]];
    EXPECT_GT(dot(face, mean), 0);
  }
  EXPECT_GT(volume, 10);  // pot and lid hold about 4 * 3 * 2
  for (const Vec3& n : mesh.normal) EXPECT_NEAR(length(n), 1, 1e-12);
}

TEST(Teapot, StandsUprightWithItsSpoutAtTheRight) {
  const Mesh mesh = teapot(10);
  Vec3 low{9, 9, 9}, high{-9, -9, -9};
  for (const Vec3& p : mesh.position) {
    for (size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  EXPECT_EQ(low[1], 0);
  EXPECT_EQ(high[1], 3.15);
  EXPECT_NEAR(low[0], -3, .01);      // the handle
  EXPECT_NEAR(high[0], 3.434, .01);  // the spout
  EXPECT_NEAR(high[2], 2, .01);
  EXPECT_EQ(low[2], -high[2]);
}

TEST(Grid, EveryInnerEdgeIsSharedAndTheFrameIsCovered) {
  const auto triangles = jittered_grid(100, 70);
  std::map<std::pair<std::pair<float, float>, std::pair<float, float>>, int> edges;
  int clockwise = 0;
  double area = 0;
  for (const auto& t : triangles) {
    const auto& v = t.v;
    const double area2 = static_cast<double>(v[1].x - v[0].x) * (v[2].y - v[0].y) -
                         static_cast<double>(v[2].x - v[0].x) * (v[1].y - v[0].y);
    area += std::abs(area2) / 2;
    clockwise += area2 > 0 ? 1 : 0;
    for (size_t i = 0; i < 3; ++i) {
      auto a = std::make_pair(v[i].x, v[i].y);
      auto b = std::make_pair(v[(i + 1) % 3].x, v[(i + 1) % 3].y);
      ++edges[{std::min(a, b), std::max(a, b)}];
    }
  }
  // 7 x 5 cells: of 24 px from -24 px on.
  ASSERT_EQ(triangles.size(), 2u * 7 * 5);
  EXPECT_EQ(triangles.back().id, 69u);
  int open = 0;
  for (const auto& edge : edges) {
    EXPECT_LE(edge.second, 2);
    open += edge.second == 1 ? 1 : 0;
  }
  EXPECT_EQ(open, 2 * (7 + 5));
  EXPECT_NEAR(area, 7 * 5 * 24 * 24, .05 * 7 * 5 * 24 * 24);
  EXPECT_GT(clockwise, 15);
  EXPECT_LT(clockwise, 55);
}

}  // namespace
}  // namespace pineda::scene
