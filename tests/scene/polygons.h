// Polygons on a lattice, made in several ways, and a check of how they were cut.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "model/scene/vec.h"

namespace pineda::scene {

struct LatticePoint {
  int64_t x = 0, y = 0;
  bool operator==(const LatticePoint& o) const { return x == o.x && y == o.y; }
};

using LatticePolygon = std::vector<LatticePoint>;
using Triangles = std::vector<std::array<uint32_t, 3>>;
using Random = std::mt19937_64;

inline int64_t twice_area(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

inline int sign(int64_t value) { return (value > 0) - (value < 0); }

inline int64_t twice_area(const LatticePolygon& p) {
  int64_t area = 0;
  for (size_t i = 0; i < p.size(); ++i) area += twice_area(p[0], p[i], p[(i + 1) % p.size()]);
  return area;
}

/// How often the polygon winds around a point beside its edges, both `scale` times as large.
inline int winding(const LatticePolygon& p, const LatticePoint& at, int64_t scale) {
  int around = 0;
  for (size_t i = 0; i < p.size(); ++i) {
    const LatticePoint a{p[i].x * scale, p[i].y * scale};
    const LatticePoint b{p[(i + 1) % p.size()].x * scale, p[(i + 1) % p.size()].y * scale};
    if ((a.y <= at.y) == (b.y <= at.y)) continue;
    const int side = sign(twice_area(a, b, at));
    if (a.y <= at.y && side > 0) ++around;
    if (a.y > at.y && side < 0) --around;
  }
  return around;
}

/// What is wrong with the triangles of a polygon; "" if they cover its inside once, and nothing
/// else: there are n - 2, together they have the polygon for their border and its area, each turns
/// as it does or not at all, and the middle of each lies inside.
inline std::string fault_of(const LatticePolygon& p, const Triangles& triangles) {
  const size_t n = p.size();
  if (triangles.size() != n - 2) return "another number of triangles";
  const int turn = sign(twice_area(p));
  std::map<std::pair<uint32_t, uint32_t>, int> border;  // an edge from the lesser corner on
  const auto add = [&](uint32_t a, uint32_t b, int times) {
    border[std::minmax(a, b)] += a < b ? times : -times;
  };
  for (uint32_t i = 0; i < n; ++i) add(i, (i + 1) % static_cast<uint32_t>(n), -1);
  int64_t area = 0;
  for (const auto& t : triangles) {
    if (t[0] >= n || t[1] >= n || t[2] >= n) return "a corner that there is not";
    const int64_t own = twice_area(p[t[0]], p[t[1]], p[t[2]]) * turn;
    if (own < 0) return "a triangle is turned over";
    area += own;
    for (size_t k = 0; k < 3; ++k) add(t[k], t[(k + 1) % 3], 1);
    const LatticePoint middle{p[t[0]].x + p[t[1]].x + p[t[2]].x, p[t[0]].y + p[t[1]].y + p[t[2]].y};
    if (own > 0 && n < 300 && winding(p, middle, 3) != turn) return "a triangle lies outside";
  }
  for (const auto& [edge, times] : border) {
    if (times != 0) return "another border";
  }
  return area == twice_area(p) * turn ? "" : "another area";
}

}  // namespace pineda::scene
