#include "model/scene/builtin.h"

#include <algorithm>

#include "model/scene/random.h"

namespace pineda::scene {
namespace {

constexpr int kSpacingPx = 24;  // of the grid
constexpr float kJitter = .2f;  // of the spacing

/// A jittered grid with random depths of a range, behind the triangles that are there.
void add_grid(int width, int height, uint64_t seed, float nearest, float farthest,
              std::vector<ScreenTriangle>* triangles) {
  Random random(seed);
  // One cell more than the frame on each side.
  const int columns = (width + kSpacingPx - 1) / kSpacingPx + 3;
  const int rows = (height + kSpacingPx - 1) / kSpacingPx + 3;
  std::vector<ScreenVertex> vertex;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      ScreenVertex v;
      v.x = kSpacingPx * (static_cast<float>(i - 1) + random.between(-kJitter, kJitter));
      v.y = kSpacingPx * (static_cast<float>(j - 1) + random.between(-kJitter, kJitter));
      v.z = random.between(nearest, farthest);
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
  constexpr std::array<int, 8> kPlaces = {5, 2, 7, 4, 6, 1, 3, 0};  // from the front
  std::vector<ScreenTriangle> triangles;
  for (const int place : kPlaces) {
    const float nearest = (static_cast<float>(place) + .1f) / 8;
    add_grid(width, height, static_cast<uint64_t>(place) + 1, nearest, nearest + .1f, &triangles);
  }
  return triangles;
}

}  // namespace pineda::scene
