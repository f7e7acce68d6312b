#include "model/scene/polygons/triangulate.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "model/scene/polygons/ears.h"
#include "model/scene/polygons/planar.h"
#include "model/scene/polygons/winding.h"
#include "tests/scene/polygons/polygons.h"

namespace pineda::scene {
namespace {

// A plane with integer vectors in space, scaled by a power of two.
struct Plane {
  Vec3 origin{}, x{1, 0, 0}, y{0, 1, 0};
  int exponent = 0;

  std::vector<Vec3> place(const LatticePolygon& polygon) const {
    std::vector<Vec3> all;
    for (const LatticePoint& p : polygon) {
      Vec3 at = origin + static_cast<double>(p.x) * x + static_cast<double>(p.y) * y;
      for (double& c : at) c = std::ldexp(c, exponent);
      all.push_back(at);
    }
    return all;
  }
};

Plane random_plane(Random* random) {
  Plane plane;
  do {
    for (size_t k = 0; k < 3; ++k) {
      plane.origin[k] = static_cast<double>(random->between(-1000000, 1000000));
      plane.x[k] = static_cast<double>(random->between(-30, 30));
      plane.y[k] = static_cast<double>(random->between(-30, 30));
    }
  } while (cross(plane.x, plane.y) == Vec3{});
  plane.exponent =
      static_cast<int>(random->between(0, 2)) * static_cast<int>(random->between(-520, 480));
  return plane;
}

struct Cut {
  PolygonShape shape;
  Triangles triangles;
};

Cut cut(const LatticePolygon& polygon, const Plane& plane = {}) {
  Cut result;
  result.shape = triangulate(plane.place(polygon), &result.triangles);
  return result;
}

Triangles fan(size_t corners) {
  Triangles all;
  for (uint32_t i = 2; i < corners; ++i) all.push_back({0, i - 1, i});
  return all;
}

// Cuts it from every first corner, in both directions, in the plane of x and y and in another one.
void expect_simple(const LatticePolygon& polygon, const Plane& plane = {}) {
  for (size_t first = 0; first < polygon.size(); ++first) {
    LatticePolygon p = turned(polygon, first);
    for (int direction = 0; direction < 2; ++direction) {
      const Cut is = cut(p, plane);
      ASSERT_NE(is.shape, PolygonShape::kCrossing) << shown(p);
      ASSERT_EQ(fault_of(p, is.triangles), "") << shown(p);
      std::reverse(p.begin(), p.end());
    }
  }
}

const LatticePolygon kArrow = {{0, 0}, {4, -4}, {0, 6}, {-4, -4}};
const LatticePolygon kU = {{0, 9}, {0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}};

TEST(Triangulate, ConvexPolygonsAreFansFromTheFirstCorner) {
  const std::vector<LatticePolygon> all = {
      {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
      {{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}},          // a straight run
      {{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {0, 4}},  // repeated corners
      {{3, 0}, {6, 2}, {6, 5}, {3, 7}, {0, 5}, {0, 2}},
      {{0, 0}, {1000000, 1}, {2000000, 3}, {0, 1}},
  };
  for (const auto& polygon : all) {
    for (size_t first = 0; first < polygon.size(); ++first) {
      const LatticePolygon p = turned(polygon, first);
      const Cut is = cut(p);
      EXPECT_EQ(is.shape, PolygonShape::kConvex) << shown(p);
      EXPECT_EQ(is.triangles, fan(p.size())) << shown(p);
    }
  }
}

TEST(Triangulate, ConcavePolygonsAreCoveredOnceAndTheFanWouldNot) {
  for (const auto& polygon : {kArrow, kU}) {
    expect_simple(polygon);
    size_t wrong_fans = 0;
    for (size_t first = 0; first < polygon.size(); ++first) {
      wrong_fans += fault_of(turned(polygon, first), fan(polygon.size())).empty() ? 0 : 1;
    }
    EXPECT_GE(wrong_fans, polygon.size() / 2);
  }
}

TEST(Triangulate, PolygonsThatTouchThemselvesAreCoveredOnce) {
  const LatticePolygon two_lobes = {{0, 0}, {4, -4}, {4, 4}, {0, 0}, {-4, 4}, {-4, -4}};
  const LatticePolygon keyhole = {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0},
                                  {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}};
  const LatticePolygon holes_on_one_bridge = {{0, 0},  {20, 0}, {20, 9}, {0, 9}, {0, 4},  {3, 4},
                                              {4, 6},  {6, 5},  {3, 4},  {0, 4}, {10, 4}, {12, 6},
                                              {14, 4}, {12, 2}, {10, 4}, {0, 4}};
  const LatticePolygon spike_outside = {{0, 0}, {4, 0}, {9, 0}, {4, 0}, {4, 4}, {0, 4}};
  const LatticePolygon spike_inside = {{0, 0}, {9, 0}, {9, 9}, {4, 4}, {9, 9}, {0, 9}};
  const LatticePolygon ring_closed_on_itself = {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 4}, {3, 4},
                                                {3, 6}, {6, 6}, {6, 3}, {3, 3}, {3, 4}, {0, 4}};
  const LatticePolygon edge_upon_edge = {{0, 0}, {9, 0}, {9, 4}, {6, 4}, {6, 2}, {3, 2},
                                         {3, 4}, {6, 4}, {9, 4}, {9, 8}, {0, 8}};
  const LatticePolygon corner_on_edge = {{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}};
  const LatticePolygon two_bridged = {{0, 0},  {4, 0}, {4, 4}, {9, 4}, {9, 0}, {13, 0},
                                      {13, 8}, {9, 8}, {9, 4}, {4, 4}, {4, 8}, {0, 8}};
  for (const auto& polygon : {two_lobes, keyhole, holes_on_one_bridge, spike_outside, spike_inside,
                              ring_closed_on_itself, edge_upon_edge, corner_on_edge, two_bridged}) {
    expect_simple(polygon);
  }
}

TEST(Triangulate, PolygonsThatCrossThemselvesAreFansAndSaidToBe) {
  const std::vector<LatticePolygon> all = {
      {{0, 0}, {9, 9}, {9, 0}, {0, 5}},                                  // a bow tie
      {{0, 10}, {-6, -8}, {10, 3}, {-10, 3}, {6, -8}},                   // a pentagram
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}},  // twice around
      {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {6, 3}, {6, 6}, {3, 6}, {3, 3}},  // no hole
      {{0, 0}, {8, 0}, {8, 4}, {4, 2}, {0, 4}, {0, -2}, {8, -2}, {4, 2}, {0, 2}},  // at a corner
  };
  for (const auto& p : all) {
    const Cut is = cut(p);
    EXPECT_EQ(is.shape, PolygonShape::kCrossing) << shown(p);
    EXPECT_EQ(is.triangles, fan(p.size())) << shown(p);
  }
}

TEST(Triangulate, WhatHasNoPlaneIsAFan) {
  EXPECT_EQ(cut({{0, 0}, {4, 4}, {4, 0}, {0, 4}}).shape, PolygonShape::kFlat);  // areas cancel
  EXPECT_EQ(cut({{0, 0}, {1, 1}, {2, 2}, {3, 3}}).shape, PolygonShape::kFlat);
  EXPECT_EQ(cut({{5, 5}, {5, 5}, {5, 5}, {5, 5}}).shape, PolygonShape::kFlat);
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    Triangles triangles;
    EXPECT_EQ(triangulate({{0, 0, 0}, {1, bad, 0}, {1, 1, 0}, {0, 1, 0}}, &triangles),
              PolygonShape::kUnbounded);
    EXPECT_EQ(triangles, fan(4));
  }
}

TEST(Triangulate, AnyExponentIsCutAlike) {
  const Triangles expected = cut(kU).triangles;
  for (const int exponent : {-1074, -1000, -300, 0, 300, 1000, 1019}) {
    Plane plane;
    plane.exponent = exponent;
    const Cut is = cut(kU, plane);
    EXPECT_EQ(is.shape, PolygonShape::kSimple) << exponent;
    EXPECT_EQ(is.triangles, expected) << exponent;
  }
  // As wide as doubles reach and a denormal high.
  const double big = std::numeric_limits<double>::max();
  const double small = std::numeric_limits<double>::denorm_min();
  std::vector<Vec3> arrow;
  for (const auto& p : kArrow) {
    arrow.push_back({big * (static_cast<double>(p.x) / 4), small * static_cast<double>(p.y), 0});
  }
  Triangles triangles;
  EXPECT_EQ(triangulate(arrow, &triangles), PolygonShape::kSimple);
  EXPECT_EQ(fault_of(kArrow, triangles), "");
}

TEST(Triangulate, RandomSimplePolygonsInRandomPlanesAreCoveredOnce) {
  Random random(1);
  size_t concave = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const LatticePolygon p = simple(&random, static_cast<size_t>(random.between(4, 80)));
    const Cut is = cut(p, random_plane(&random));
    ASSERT_NE(is.shape, PolygonShape::kCrossing) << shown(p);
    ASSERT_EQ(fault_of(p, is.triangles), "") << shown(p);
    concave += is.shape == PolygonShape::kSimple ? 1 : 0;
    if (is.shape == PolygonShape::kConvex) {
      ASSERT_EQ(is.triangles, fan(p.size()));
    }
  }
  EXPECT_GT(concave, 400u);
}

bool has_crossing(const LatticePolygon& p) {
  const size_t n = p.size();
  for (size_t i = 0; i < n; ++i) {
    for (size_t k = 0; k < i; ++k) {
      const LatticePoint &a = p[i], &b = p[(i + 1) % n], &c = p[k], &d = p[(k + 1) % n];
      if (sign(twice_area(a, b, c)) * sign(twice_area(a, b, d)) < 0 &&
          sign(twice_area(c, d, a)) * sign(twice_area(c, d, b)) < 0) {
        return true;
      }
    }
  }
  return false;
}

// Makes the polygon touch itself: a triangle beside an edge is taken away, a diagonal is cut open,
// a hole is cut into a triangle, or a corner is repeated. Coordinates grow 8 times.
LatticePolygon touched(Random* random, const LatticePolygon& simple) {
  LatticePolygon p = simple;
  for (auto& at : p) at = {at.x * 8, at.y * 8};
  const auto triangles = cut(p).triangles;
  const auto t = triangles[static_cast<size_t>(
      random->between(0, static_cast<int64_t>(triangles.size()) - 1))];
  const auto k = static_cast<size_t>(random->between(0, 2));
  const uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
  const auto behind = [&](uint32_t i) { return p.begin() + static_cast<std::ptrdiff_t>(i) + 1; };
  // A cut into a triangle without area could lead outside.
  const bool has_area = twice_area(p[a], p[b], p[c]) != 0;
  switch (has_area ? random->between(0, 3) : 3) {
    case 0:
      if (b == (a + 1) % p.size() && p.size() > 4) p.insert(behind(a), p[c]);
      return p;
    case 1:
      p.insert(behind(a), {p[b], p[a]});
      return p;
    case 2: {
      const LatticePoint inner[3] = {
          {(6 * p[a].x + p[b].x + p[c].x) / 8, (6 * p[a].y + p[b].y + p[c].y) / 8},
          {(p[a].x + 6 * p[b].x + p[c].x) / 8, (p[a].y + 6 * p[b].y + p[c].y) / 8},
          {(p[a].x + p[b].x + 6 * p[c].x) / 8, (p[a].y + p[b].y + 6 * p[c].y) / 8}};
      p.insert(behind(a), {inner[0], inner[2], inner[1], inner[0], p[a]});
      return p;
    }
    default:
      p.insert(behind(a), p[a]);
      return p;
  }
}

TEST(Triangulate, RandomPolygonsThatTouchThemselvesAreCoveredOnce) {
  Random random(2);
  for (int trial = 0; trial < 600; ++trial) {
    LatticePolygon p = trial % 2 == 0
                           ? grown(&random, static_cast<size_t>(random.between(4, 16)), 8)
                           : untangled(&random, static_cast<size_t>(random.between(4, 14)), 40);
    for (int times = 0; times < 4; ++times) {
      const LatticePolygon next = touched(&random, p);
      // A diagonal may cross an earlier cut.
      if (twice_area(next) == 0 || has_crossing(next)) continue;
      p = next;
      const Cut is = cut(p, random_plane(&random));
      ASSERT_NE(is.shape, PolygonShape::kCrossing) << shown(p);
      ASSERT_EQ(fault_of(p, is.triangles), "") << shown(p);
    }
  }
}

// An independent test: edges cross at corners only, and beside every piece of an edge the winding
// number is 0 or that of the whole polygon.
bool surrounds_once(const LatticePolygon& p) {
  const size_t n = p.size();
  const int turn = sign(twice_area(p));
  constexpr int64_t kScale = 1 << 20;
  for (size_t i = 0; i < n; ++i) {
    const LatticePoint a = p[i], b = p[(i + 1) % n];
    if (a == b) continue;
    std::set<std::pair<int64_t, int64_t>> on{{a.x, a.y}, {b.x, b.y}};
    for (size_t k = 0; k < n; ++k) {
      const LatticePoint c = p[k], d = p[(k + 1) % n];
      if (sign(twice_area(a, b, c)) * sign(twice_area(a, b, d)) < 0 &&
          sign(twice_area(c, d, a)) * sign(twice_area(c, d, b)) < 0 &&
          std::none_of(p.begin(), p.end(), [&](const LatticePoint& at) {
            return twice_area(a, b, at) == 0 && twice_area(c, d, at) == 0;
          })) {
        return false;
      }
      if (touch(c, c, a, b)) on.insert({c.x, c.y});
    }
    for (auto at = on.begin(); std::next(at) != on.end(); ++at) {
      const auto to = std::next(at);
      const int64_t dx = to->first - at->first, dy = to->second - at->second;
      for (const int side : {-1, 1}) {
        const LatticePoint beside{(at->first + to->first) * kScale / 2 - side * dy,
                                  (at->second + to->second) * kScale / 2 + side * dx};
        const int around = winding(p, beside, kScale);
        if (around != 0 && around != turn) return false;
      }
    }
  }
  return true;
}

TEST(Triangulate, CrossingPolygonsAreToldFromTouchingOnes) {
  Random random(3);
  size_t once = 0, crossing = 0, hidden = 0;
  for (int trial = 0; trial < 60000; ++trial) {
    LatticePolygon p;
    const int64_t n = random.between(4, 9), size = random.between(2, 4);
    while (static_cast<int64_t>(p.size()) < n) {
      p.push_back({random.between(0, size), random.between(0, size)});
    }
    const Cut is = cut(p);
    if (twice_area(p) == 0) {
      ASSERT_EQ(is.shape, PolygonShape::kFlat) << shown(p);
      continue;
    }
    const bool is_once = surrounds_once(p);
    if (is.shape != PolygonShape::kCrossing) {
      ASSERT_TRUE(is_once) << shown(p);
      ASSERT_EQ(fault_of(p, is.triangles), "") << shown(p);
    }
    // Some polygons cross at a corner though no winding number shows it; with so few corners every
    // way to cut was tried.
    if (is_once && is.shape == PolygonShape::kCrossing) ++hidden;
    ++(is_once ? once : crossing);
  }
  EXPECT_GT(once, 2000u);
  EXPECT_LT(hidden, once / 20);
  EXPECT_GT(crossing, 2000u);
}

// A polygon that crosses itself at a corner, which shows only when every way to cut is tried.
LatticePolygon crossing_at_a_corner() {
  Random random(3);
  while (true) {
    LatticePolygon p;
    while (p.size() < 9) p.push_back({random.between(0, 3), random.between(0, 3)});
    const PlanarPolygon polygon(Plane{}.place(p));
    Triangles none;
    if (polygon.has_plane() && winds_once(polygon) &&
        cut_ears(polygon, &none) == EarCut::kImpossible) {
      return p;
    }
  }
}

TEST(Triangulate, WhatHasTooManyWaysToTryIsNotSaidToCross) {
  LatticePolygon p = crossing_at_a_corner();
  p.insert(p.end(), 256 - p.size(), p.back());
  EXPECT_EQ(cut(p).shape, PolygonShape::kCrossing);
  p.push_back(p.back());
  const Cut is = cut(p);
  EXPECT_EQ(is.shape, PolygonShape::kUnknown);
  EXPECT_EQ(is.triangles, fan(p.size()));
}

TEST(Triangulate, NoMoreIsTriedAfterSoManySteps) {
  Random random(7);
  const PlanarPolygon polygon(Plane{}.place(star(&random, 1000, 1000000)));
  Triangles triangles = {{7, 8, 9}};
  EXPECT_EQ(cut_ears(polygon, &triangles, 1000), EarCut::kUnknown);
  EXPECT_EQ(triangles.size(), 1u);
  EXPECT_EQ(cut_ears(polygon, &triangles), EarCut::kDone);
  EXPECT_EQ(triangles.size(), 1u + 998u);
}

TEST(PolygonCutter, CountsWhatHasTooManyWaysToTry) {
  Mesh mesh;
  mesh.position = Plane{}.place(crossing_at_a_corner());
  std::vector<uint32_t> vertex(mesh.position.size());
  std::iota(vertex.begin(), vertex.end(), 0U);
  vertex.resize(300, vertex.back());
  PolygonCutter cutter(&mesh);
  cutter.add(vertex.data(), vertex.size());
  std::vector<std::string> warnings;
  cutter.warn("a.obj", &warnings);
  EXPECT_EQ(warnings,
            (std::vector<std::string>{"a.obj: 1 polygons are too intricate, with more ways "
                                      "to cut them than are tried: cut as fans"}));
  EXPECT_TRUE(mesh.polygon.empty());
}

TEST(Triangulate, TheCheckSeesAWrongTriangle) {
  Random random(4);
  const LatticePolygon p = star(&random, 40, 1000);
  const Triangles right = cut(p).triangles;
  ASSERT_EQ(fault_of(p, right), "");
  EXPECT_NE(fault_of(p, fan(p.size())), "");
  for (size_t i = 0; i < right.size(); ++i) {
    Triangles wrong = right;
    std::swap(wrong[i][0], wrong[i][1]);
    EXPECT_NE(fault_of(p, wrong), "");
    wrong = right;
    wrong[i] = right[(i + 1) % right.size()];
    EXPECT_NE(fault_of(p, wrong), "");
  }
}

TEST(Triangulate, LargePolygonsOfEveryKind) {
  Random random(5);
  for (const auto& p : {star(&random, 10000, 1000000000), comb(2500, 30), spiral(10000)}) {
    const Cut is = cut(p, random_plane(&random));
    EXPECT_EQ(is.shape, PolygonShape::kSimple);
    EXPECT_EQ(fault_of(p, is.triangles), "");
  }
  std::vector<Vec3> circle;
  constexpr size_t kCorners = 1000000;
  for (size_t i = 0; i < kCorners; ++i) {
    const double angle = 2 * kPi * static_cast<double>(i) / kCorners;
    circle.push_back({std::cos(angle), std::sin(angle), std::cos(angle)});
  }
  Triangles triangles;
  EXPECT_EQ(triangulate(circle, &triangles), PolygonShape::kConvex);
  EXPECT_EQ(triangles.size(), kCorners - 2);
}

// Compares with the definition, in rationals.
TEST(PlanarPolygon, TurnsAreThoseOfTheNewellNormal) {
  using Rational = boost::multiprecision::cpp_rational;
  using Exact = std::array<Rational, 3>;
  const auto product = [](const Exact& a, const Exact& b) {
    return Exact{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto minus = [](const Exact& a, const Exact& b) {
    return Exact{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  Random random(6);
  std::array<int, 3> seen{};
  for (int trial = 0; trial < 60; ++trial) {
    const auto size = random.between(1, 3), spread = random.between(0, 1) * 1000;
    std::vector<Vec3> corner(5);
    for (Vec3& p : corner) {
      for (double& c : p) {
        c = std::ldexp(static_cast<double>(random.between(-size, size)),
                       static_cast<int>(random.between(-spread, spread)));
      }
    }
    std::vector<Exact> exact;
    for (const Vec3& p : corner) exact.push_back({Rational(p[0]), Rational(p[1]), Rational(p[2])});
    Exact n;
    for (size_t i = 0; i < 5; ++i) {
      const Exact term = product(exact[i], exact[(i + 1) % 5]);
      for (size_t k = 0; k < 3; ++k) n[k] += term[k];
    }
    const PlanarPolygon polygon(corner);
    ASSERT_EQ(polygon.has_plane(), n != Exact{});
    for (uint32_t i = 0; polygon.has_plane() && i < 125; ++i) {
      const uint32_t a = i % 5, b = i / 5 % 5, c = i / 25;
      const Exact normal = product(minus(exact[b], exact[a]), minus(exact[c], exact[a]));
      const Rational turn = n[0] * normal[0] + n[1] * normal[1] + n[2] * normal[2];
      ASSERT_EQ(polygon.turn(a, b, c), turn.sign()) << trial;
      ++seen[static_cast<size_t>(turn.sign() + 1)];
    }
  }
  for (const int count : seen) EXPECT_GT(count, 300);
}

}  // namespace
}  // namespace pineda::scene
