// Hidden surfaces: cases that the painter's algorithm cannot draw and a depth buffer can.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "tests/baseline/support.h"

namespace pineda::test {
namespace {

constexpr int kSize = 128;
constexpr spec::FrameState kFrame{kSize, kSize, spec::Cull::kNone, spec::DepthFunc::kLess};
constexpr size_t kPixels = size_t{kSize} * kSize;
constexpr int kNobody = -1;

// Depth in codes at each corner.
spec::Triangle at_depths(spec::Triangle t, int64_t a, int64_t b, int64_t c) {
  const std::array<int64_t, 3> z{a, b, c};
  for (size_t i = 0; i < 3; ++i) t.v[i].z = z[i] << 8;
  return t;
}

Point px(int x, int y) { return {x * kPx, y * kPx}; }

using Scene = std::vector<spec::Triangle>;
using Owners = std::vector<int>;  // the triangle that each pixel shows

// In exact arithmetic: the nearest triangle.
Owners nearest(const Scene& scene) {
  Owners owner(kPixels, kNobody);
  std::vector<double> depth(kPixels, std::numeric_limits<double>::infinity());
  for (size_t i = 0; i < scene.size(); ++i) {
    const exact::Judge exact = judge(kFrame, scene[i]);
    for (size_t p = 0; p < kPixels; ++p) {
      const int x = static_cast<int>(p) % kSize;
      const int y = static_cast<int>(p) / kSize;
      if (!exact.covers(x, y)) continue;
      const double z = -exact.depth_error(x, y, 0);
      if (z < depth[p]) {
        depth[p] = z;
        owner[p] = static_cast<int>(i);
      }
    }
  }
  return owner;
}

enum class Depth { kBuffer, kNone };

// Drawn by a baseline, in the order given.
Owners drawn(const std::string& name, const Scene& scene, const std::vector<uint32_t>& order,
             Depth depth) {
  Owners owner(kPixels, kNobody);
  std::vector<int64_t> buffer(kPixels, std::numeric_limits<int64_t>::max());
  const auto rasterizer = find_baseline(name).make(kContract, kFrame);
  for (const uint32_t i : order) {
    Gathered gathered;
    rasterizer->draw(scene[i], &gathered);
    for (const baseline::Sample& s : gathered.samples) {
      const auto p = static_cast<size_t>(s.y) * kSize + static_cast<size_t>(s.x);
      if (depth == Depth::kBuffer && s.z >= buffer[p]) continue;
      buffer[p] = s.z;
      owner[p] = static_cast<int>(i);
    }
  }
  return owner;
}

int differences(const Owners& a, const Owners& b) {
  int count = 0;
  for (size_t p = 0; p < kPixels; ++p) count += a[p] != b[p] ? 1 : 0;
  return count;
}

Owners painted(const Scene& scene) {
  return drawn("painter", scene, baseline::paint_order(scene), Depth::kNone);
}

Owners buffered(const Scene& scene) {
  std::vector<uint32_t> order;
  for (uint32_t i = 0; i < scene.size(); ++i) order.push_back(i);
  return drawn("fp64", scene, order, Depth::kBuffer);
}

// Three plates behind each other.
Scene stack() {
  return {at_depths(triangle(px(10, 10), px(110, 20), px(40, 110)), 3000, 3000, 3000),
          at_depths(triangle(px(20, 5), px(100, 60), px(10, 90)), 9000, 9000, 9000),
          at_depths(triangle(px(60, 30), px(120, 100), px(30, 120)), 6000, 6000, 6000)};
}

// Two of the same mean depth that pass through each other along a line.
Scene crossing() {
  return {at_depths(triangle(px(5, 10), px(120, 64), px(5, 118)), 1000, 100000, 1000),
          at_depths(triangle(px(122, 10), px(8, 64), px(122, 118)), 1000, 100000, 1000)};
}

// Three bars, each of which lies over the next at one end and under the one before at the other.
Scene cycle() {
  constexpr int64_t kNear = 1000;
  constexpr int64_t kFar = 90000;
  return {at_depths(triangle(px(10, 30), px(118, 20), px(118, 44)), kNear, kFar, kFar),
          at_depths(triangle(px(108, 8), px(70, 120), px(48, 110)), kNear, kFar, kFar),
          at_depths(triangle(px(76, 118), px(14, 14), px(34, 8)), kNear, kFar, kFar)};
}

TEST(PaintersAlgorithm, IsRightWhereTrianglesLieBehindEachOther) {
  EXPECT_EQ(baseline::paint_order(stack()), (std::vector<uint32_t>{1, 2, 0}));
  EXPECT_EQ(differences(painted(stack()), nearest(stack())), 0);
}

TEST(PaintersAlgorithm, FailsWhereTwoPassThroughEachOther) {
  const int wrong = differences(painted(crossing()), nearest(crossing()));
  record("wrong", wrong);
  EXPECT_GT(wrong, 500);
  EXPECT_EQ(differences(buffered(crossing()), nearest(crossing())), 0);
}

// No order of the three is right, so no sorting key helps.
TEST(PaintersAlgorithm, FailsOnACycleInAnyOrder) {
  const Owners right = nearest(cycle());
  const int wrong = differences(painted(cycle()), right);
  record("wrong", wrong);
  EXPECT_GT(wrong, 50);
  std::vector<uint32_t> order{0, 1, 2};
  do {
    EXPECT_GT(differences(drawn("painter", cycle(), order, Depth::kNone), right), 50);
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(differences(buffered(cycle()), right), 0);
}

TEST(PaintersAlgorithm, EqualDepthsKeepTheOrderOfTheScene) {
  Scene scene(4, stack()[0]);
  scene[2] = at_depths(scene[2], 5000, 5000, 5000);
  scene[3] = at_depths(scene[3], 4000, 2000, 3000);  // the mean of the others
  EXPECT_EQ(baseline::paint_order(scene), (std::vector<uint32_t>{2, 0, 1, 3}));
  EXPECT_TRUE(baseline::paint_order({}).empty());
}

TEST(PaintersAlgorithm, IsTheOnlyOneThatOrdersTheScene) {
  for (const auto& b : baseline::baselines()) {
    EXPECT_EQ(b.orders_the_scene, std::string(b.name) == "painter") << b.name;
  }
}

}  // namespace
}  // namespace pineda::test
