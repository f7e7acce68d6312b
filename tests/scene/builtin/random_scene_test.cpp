#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/scene/builtin/builtin.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

double area_px(const ScreenTriangle& t) {
  const auto& [p, q, r] = t.v;
  return .5 * std::abs((double{q.x} - p.x) * (double{r.y} - p.y) -
                       (double{r.x} - p.x) * (double{q.y} - p.y));
}

TEST(RandomScene, TrianglesHaveTheirAreaAndOnlyNeedlesAreLonger) {
  for (const RandomScene& scene : kRandomScenes) {
    const auto triangles = random_triangles(scene, 640, 480, 3);
    ASSERT_EQ(triangles.size(), static_cast<size_t>(scene.triangles));
    for (const ScreenTriangle& t : triangles) {
      const double area = area_px(t);
      if (scene.area_px > 0) {
        ASSERT_NEAR(area, scene.area_px, .001 * scene.area_px) << scene.name << t.id;
      } else {
        ASSERT_GE(area, 640 * 480 / 8.01) << scene.name << t.id;
      }
      for (size_t i = 0; i < 3; ++i) {
        const double reach = std::max<double>(std::sqrt(8 * area), 1.001 * scene.length_px) + 1e-3;
        ASSERT_LE(std::abs(t.v[i].x - t.v[(i + 1) % 3].x), scene.area_px > 0 ? reach : 640);
        ASSERT_LE(std::abs(t.v[i].y - t.v[(i + 1) % 3].y), scene.area_px > 0 ? reach : 480);
      }
    }
  }
}

TEST(RandomScene, NeedlesHaveTheirLengthInAnyDirection) {
  const RandomScene& scene = kRandomScenes[3];
  int steep = 0, falling = 0;
  for (const ScreenTriangle& t : random_triangles(scene, 640, 480, 3)) {
    const auto& [point, p, q] = t.v;
    const double x = .5 * (double{p.x} + q.x) - point.x, y = .5 * (double{p.y} + q.y) - point.y;
    ASSERT_NEAR(std::sqrt(x * x + y * y), 256, .01);
    steep += std::abs(y) > std::abs(x) ? 1 : 0;
    falling += x * y > 0 ? 1 : 0;
  }
  EXPECT_NEAR(steep, 1000, 100);
  EXPECT_NEAR(falling, 1000, 100);
}

TEST(RandomScene, SameSeedSameTrianglesAnotherSeedOthers) {
  const auto first = [](uint64_t seed) {
    Options options;
    options.seed = seed;
    spec::Triangle triangle;
    const spec::Contract contract = spec::contract(spec::kHighTile);
    EXPECT_TRUE(open_scene(contract, "random/px1000", options).source->next(&triangle));
    return triangle.v[0].x;
  };
  EXPECT_EQ(first(5), first(5));
  EXPECT_NE(first(5), first(6));
}

TEST(RandomScene, UnknownNameListsThoseThereAre) {
  EXPECT_TRUE(is_one_line_with(error_of("random/px2"), "one of px1, px1000, screen, needle"));
}

}  // namespace
}  // namespace pineda::scene
