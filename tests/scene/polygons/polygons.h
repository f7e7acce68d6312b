// Polygons on a lattice, generated in several ways, and a check of how they were cut.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "model/scene/vec.h"
#include "model/spec/random.h"

namespace pineda::scene {

struct LatticePoint {
  int64_t x = 0, y = 0;
  bool operator==(const LatticePoint& o) const { return x == o.x && y == o.y; }
};

using LatticePolygon = std::vector<LatticePoint>;
using Triangles = std::vector<std::array<uint32_t, 3>>;
using spec::Random;

inline constexpr double kPi = 3.14159265358979323846;

inline std::string shown(const LatticePolygon& polygon) {
  std::string text;
  for (const auto& p : polygon) text += "(" + std::to_string(p.x) + "," + std::to_string(p.y) + ")";
  return text;
}

inline LatticePolygon turned(LatticePolygon polygon, size_t by) {
  std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(by), polygon.end());
  return polygon;
}

inline int64_t twice_area(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

inline int sign(int64_t value) { return (value > 0) - (value < 0); }

inline int64_t twice_area(const LatticePolygon& p) {
  int64_t area = 0;
  for (size_t i = 0; i < p.size(); ++i) area += twice_area(p[0], p[i], p[(i + 1) % p.size()]);
  return area;
}

/// How often the polygon winds around a point that is not on its edges; `at` is scaled by `scale`.
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

/// What is wrong with the triangles of a polygon; "" if they cover its inside once and nothing
/// else: there are n - 2, their common border and area are the polygon's, each turns as the polygon
/// does or has no area, and the middle of each lies inside.
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

// Simple polygons, made in several ways.

inline LatticePolygon star(Random* random, size_t n, int64_t size) {
  LatticePolygon p;
  for (size_t i = 0; i < n; ++i) {
    const double angle = 2 * kPi * static_cast<double>(i) / static_cast<double>(n);
    const auto radius = static_cast<double>(random->between(size / 8, size));
    p.push_back({std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
  }
  return p;
}

inline LatticePolygon comb(size_t teeth, int64_t depth) {
  LatticePolygon p{{0, 0}};
  const auto n = static_cast<int64_t>(teeth);
  p.push_back({4 * n, 0});
  for (int64_t i = n; i-- > 0;) {
    p.push_back({4 * i + 4, depth});
    p.push_back({4 * i + 2, depth});
    p.push_back({4 * i + 2, 2});
    p.push_back({4 * i, 2});
  }
  return p;
}

inline LatticePolygon spiral(size_t n) {
  LatticePolygon p;
  const auto at = [&](size_t i, double out) {
    const double angle = .37 * static_cast<double>(i);
    const double radius = 50 * (static_cast<double>(i) + 20 + out);
    p.push_back({std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
  };
  for (size_t i = 0; i < n / 2; ++i) at(i, 0);
  for (size_t i = n / 2; i-- > 0;) at(i, 6);
  return p;
}

inline bool touch(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                  const LatticePoint& d) {
  const auto in_box = [](const LatticePoint& p, const LatticePoint& q, const LatticePoint& r) {
    return std::min(p.x, q.x) <= r.x && r.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= r.y &&
           r.y <= std::max(p.y, q.y);
  };
  const int s1 = sign(twice_area(a, b, c)), s2 = sign(twice_area(a, b, d));
  const int s3 = sign(twice_area(c, d, a)), s4 = sign(twice_area(c, d, b));
  if (s1 * s2 < 0 && s3 * s4 < 0) return true;
  return (s1 == 0 && in_box(a, b, c)) || (s2 == 0 && in_box(a, b, d)) ||
         (s3 == 0 && in_box(c, d, a)) || (s4 == 0 && in_box(c, d, b));
}

// A triangle grown by points of a small lattice, so that many lie on straight runs.
inline LatticePolygon grown(Random* random, size_t n, int64_t size) {
  LatticePolygon p{{0, 0}, {size, 0}, {0, size}};
  for (size_t tries = 0; p.size() < n && tries < 40 * n; ++tries) {
    const LatticePoint at{random->between(0, size), random->between(0, size)};
    const auto i = static_cast<size_t>(random->between(0, static_cast<int64_t>(p.size()) - 1));
    const LatticePoint a = p[i], b = p[(i + 1) % p.size()];
    bool is_free = !(twice_area(a, b, at) == 0 && touch(a, a, at, b));
    for (size_t k = 0; is_free && k < p.size(); ++k) {
      const LatticePoint c = p[k], d = p[(k + 1) % p.size()];
      if (k == i) continue;
      if (!(d == a) && touch(a, at, c, d)) is_free = false;
      if (!(c == b) && touch(b, at, c, d)) is_free = false;
      if (d == a && (twice_area(c, a, at) == 0 || touch(b, at, c, d))) is_free = false;
      if (c == b && (twice_area(d, b, at) == 0 || touch(a, at, c, d))) is_free = false;
    }
    if (is_free) p.insert(p.begin() + static_cast<std::ptrdiff_t>(i) + 1, at);
  }
  return p;
}

// Random points, whose crossings are removed one after the other.
inline LatticePolygon untangled(Random* random, size_t n, int64_t size) {
  LatticePolygon p;
  while (p.size() < n) {
    const LatticePoint at{random->between(0, size), random->between(0, size)};
    bool is_general = true;
    for (size_t i = 0; i < p.size(); ++i) {
      for (size_t k = 0; k < i; ++k) is_general = is_general && twice_area(p[i], p[k], at) != 0;
      is_general = is_general && !(p[i] == at);
    }
    if (is_general) p.push_back(at);
  }
  for (bool has_crossing = true; has_crossing;) {
    has_crossing = false;
    for (size_t i = 0; i < n; ++i) {
      for (size_t k = i + 2; k < n; ++k) {
        if ((k + 1) % n == i || !touch(p[i], p[i + 1], p[k], p[(k + 1) % n])) continue;
        std::reverse(p.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     p.begin() + static_cast<std::ptrdiff_t>(k) + 1);
        has_crossing = true;
      }
    }
  }
  return p;
}

inline LatticePolygon simple(Random* random, size_t n) {
  switch (random->between(0, 4)) {
    case 0:
      return star(random, n, 100000);
    case 1:
      return comb(n / 4, random->between(3, 50));
    case 2:
      return spiral(n);
    case 3:
      return grown(random, n, random->between(4, 40));
    default:
      return untangled(random, std::min<size_t>(n, 24), 1000);
  }
}

}  // namespace pineda::scene
