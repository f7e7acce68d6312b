#include "model/scene/builtin/builtin.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/spec/random.h"

namespace pineda::scene {
namespace {

using spec::Random;

constexpr int kSpacingPx = 24;  // of the grid
constexpr float kJitter = .2f;  // of the spacing

constexpr double kLeastShare = .125;  // least area of a random triangle, of the square around it

/// Appends a jittered grid with random depths in a range.
void add_grid(int width, int height, uint64_t seed, float nearest, float farthest,
              std::vector<ScreenTriangle>* triangles) {
  Random random(seed);
  // At least one cell beyond the frame on each side.
  const int columns = (width + kSpacingPx - 1) / kSpacingPx + 3;
  const int rows = (height + kSpacingPx - 1) / kSpacingPx + 3;
  std::vector<ScreenVertex> vertex;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      ScreenVertex v;
      v.x = kSpacingPx * (static_cast<float>(i - 1) + random.uniform(-kJitter, kJitter));
      v.y = kSpacingPx * (static_cast<float>(j - 1) + random.uniform(-kJitter, kJitter));
      v.z = random.uniform(nearest, farthest);
      for (size_t k = 0; k < 3; ++k) v.rgba[k] = static_cast<uint8_t>(random.bits());
      v.rgba[3] = 255;
      vertex.push_back(v);
    }
  }
  const auto add = [&](int a, int b, int c) {
    ScreenTriangle t;
    t.id = static_cast<uint32_t>(triangles->size());
    t.v = {vertex[static_cast<size_t>(a)], vertex[static_cast<size_t>(b)],
           vertex[static_cast<size_t>(c)]};
    const uint64_t order = random.bits();
    if ((order & 1) != 0) std::swap(t.v[1], t.v[2]);
    std::rotate(t.v.begin(), t.v.begin() + static_cast<int>((order >> 1) % 3), t.v.end());
    triangles->push_back(t);
  };
  for (int j = 0; j + 1 < rows; ++j) {
    for (int i = 0; i + 1 < columns; ++i) {
      const int corner = j * columns + i;
      add(corner, corner + 1, corner + columns);
      add(corner + 1, corner + columns + 1, corner + columns);
    }
  }
}

using Corners = std::array<std::array<double, 2>, 3>;

// A needle of length 1 in a random direction, around the middle of the unit square.
Corners needle_corners(Random* random, double width) {
  double x = 0, y = 0, square = 0;
  do {
    x = random->uniform(-1, 1);
    y = random->uniform(-1, 1);
    square = x * x + y * y;
  } while (square < .01 || square > 1);
  x *= .5 / std::sqrt(square);
  y *= .5 / std::sqrt(square);
  return {{{.5 - x, .5 - y},
           {.5 + x - width * y, .5 + y + width * x},
           {.5 + x + width * y, .5 + y - width * x}}};
}

// Three random points of the unit square whose triangle has an area of at least kLeastShare.
Corners random_corners(Random* random, double* area) {
  Corners corner{};
  do {
    for (auto& point : corner) {
      for (double& value : point) value = random->uniform(0, 1);
    }
    const auto& [p, q, r] = corner;
    *area = .5 * std::abs((q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]));
  } while (*area < kLeastShare);
  return corner;
}

}  // namespace

std::vector<ScreenTriangle> single_triangle(int width, int height) {
  const auto w = static_cast<float>(width);
  const auto h = static_cast<float>(height);
  ScreenTriangle t;
  t.v[0] = {.5f * w, .0625f * h, .25f, 1, {255, 0, 0, 255}};
  t.v[1] = {.0625f * w, .9375f * h, .5f, 1, {0, 255, 0, 255}};
  t.v[2] = {.9375f * w, .875f * h, .75f, 1, {0, 0, 255, 255}};
  return {t};
}

std::vector<ScreenTriangle> jittered_grid(int width, int height) {
  std::vector<ScreenTriangle> triangles;
  add_grid(width, height, 1, 0, 1, &triangles);
  return triangles;
}

std::vector<ScreenTriangle> layered_grids(int width, int height) {
  constexpr std::array<int, 8> kPlaces = {5, 2, 7, 4, 6, 1, 3, 0};  // slices; 0 is nearest
  std::vector<ScreenTriangle> triangles;
  for (const int place : kPlaces) {
    const float nearest = (static_cast<float>(place) + .1f) / 8;
    add_grid(width, height, static_cast<uint64_t>(place) + 1, nearest, nearest + .1f, &triangles);
  }
  return triangles;
}

std::vector<ScreenTriangle> random_triangles(const RandomScene& scene, int width, int height,
                                             uint64_t seed) {
  Random random(seed);
  std::vector<ScreenTriangle> triangles(static_cast<size_t>(scene.triangles));
  for (ScreenTriangle& t : triangles) {
    t.id = static_cast<uint32_t>(&t - triangles.data());
    double side = scene.length_px;  // of the square around it; 0: scale to the frame instead
    Corners corners;
    if (side > 0) {
      corners = needle_corners(&random, 2 * scene.area_px / (side * side));
    } else {
      double area = 0;
      corners = random_corners(&random, &area);
      side = std::sqrt(scene.area_px / area);
    }
    const double box_width = side > 0 ? side : width;
    const double box_height = side > 0 ? side : height;
    const double left = side > 0 ? double{random.uniform(0, 1)} * width - side / 2 : 0;
    const double top = side > 0 ? double{random.uniform(0, 1)} * height - side / 2 : 0;
    for (size_t i = 0; i < 3; ++i) {
      ScreenVertex& v = t.v[i];
      v.x = static_cast<float>(left + corners[i][0] * box_width);
      v.y = static_cast<float>(top + corners[i][1] * box_height);
      v.z = random.uniform(0, 1);
      for (size_t k = 0; k < 3; ++k) v.rgba[k] = static_cast<uint8_t>(random.bits());
      v.rgba[3] = 255;
    }
  }
  return triangles;
}

}  // namespace pineda::scene
