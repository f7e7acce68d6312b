#include "model/scene/partition.h"

#include <algorithm>
#include <numeric>

#include "model/scene/polygons/triangulate.h"

namespace pineda::scene {
namespace {

using Indices = std::vector<uint8_t>;

// Twice the signed area of a triangle.
int64_t turn(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return int64_t{b[0] - a[0]} * (c[1] - a[1]) - int64_t{b[1] - a[1]} * (c[0] - a[0]);
}

int64_t doubled_area(const std::vector<GridPoint>& p) {
  int64_t area = 0;
  for (size_t i = 1; i + 1 < p.size(); ++i) area += turn(p[0], p[i], p[i + 1]);
  return area;
}

// Do the triangles of the fan from the first point have one orientation, and go less than once
// around it?
bool is_fan(const std::vector<GridPoint>& p) {
  const int64_t way = doubled_area(p) < 0 ? -1 : 1;
  size_t first = 1;
  while (first < p.size() && p[first] == p[0]) ++first;
  if (first == p.size()) return true;
  bool past_half = false;
  for (size_t i = first; i < p.size(); ++i) {
    if (i > first && way * turn(p[0], p[i - 1], p[i]) < 0) return false;
    const int64_t from_first = way * turn(p[0], p[first], p[i]);
    if (from_first < 0) past_half = true;
    if (from_first > 0 && past_half) return false;
    if (from_first == 0 && i > first && p[i] != p[0]) {
      // On the line through p[0] and p[first]: in the same direction, or opposite.
      const int64_t along = int64_t{p[i][0] - p[0][0]} * (p[first][0] - p[0][0]) +
                            int64_t{p[i][1] - p[0][1]} * (p[first][1] - p[0][1]);
      if (along < 0 || past_half) return false;
    }
  }
  return true;
}

void fan(const Indices& corner, std::vector<Piece>* pieces) {
  for (size_t i = 1; i + 1 < corner.size(); ++i) {
    pieces->push_back({corner[0], corner[i], corner[i + 1]});
  }
}

// The convex hull, clockwise where y points down, without points on its sides; by Andrew's monotone
// chains.
Indices hull(const std::vector<GridPoint>& p) {
  Indices order(p.size());
  std::iota(order.begin(), order.end(), uint8_t{0});
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return p[a] < p[b]; });
  Indices chain;
  const auto add = [&](uint8_t i, size_t least) {
    while (chain.size() > least && turn(p[chain[chain.size() - 2]], p[chain.back()], p[i]) <= 0) {
      chain.pop_back();
    }
    chain.push_back(i);
  };
  for (const uint8_t i : order) add(i, 1);
  const size_t lower = chain.size();
  for (size_t k = order.size() - 1; k-- > 0;) add(order[k], lower);
  chain.pop_back();  // the first point again
  return chain;
}

}  // namespace

void partition(const std::vector<GridPoint>& polygon, bool clockwise, std::vector<Piece>* pieces) {
  pieces->clear();
  if (is_fan(polygon)) {
    Indices all(polygon.size());
    std::iota(all.begin(), all.end(), uint8_t{0});
    return fan(all, pieces);
  }
  std::vector<Vec3> corners;
  for (const GridPoint& p : polygon) {
    corners.push_back({static_cast<double>(p[0]), static_cast<double>(p[1]), 0});
  }
  std::vector<std::array<uint32_t, 3>> triangles;
  const PolygonShape shape = triangulate(corners, &triangles);
  if (shape == PolygonShape::kConvex || shape == PolygonShape::kSimple) {
    for (const auto& t : triangles) {
      pieces->push_back(
          {static_cast<uint8_t>(t[0]), static_cast<uint8_t>(t[1]), static_cast<uint8_t>(t[2])});
    }
    return;
  }
  Indices outline = hull(polygon);
  if (outline.size() < 3) return pieces->push_back({0, 0, 0});
  if (!clockwise) std::reverse(outline.begin(), outline.end());
  fan(outline, pieces);
}

}  // namespace pineda::scene
