// The right answers of the cases of values and of order.
#include <algorithm>
#include <cmath>

#include "model/spec/bounds.h"
#include "tests/core/support.h"
#include "tests/hard/support.h"

namespace pineda::hard {
namespace {

using test::kContract;

constexpr uint32_t kFarCode = (1u << 24) - 1;

spec::Attributes color_at(const core::FrameBuffer& buffer, size_t sample) {
  spec::Attributes color{};
  for (size_t i = 0; i < 4; ++i) color[i] = buffer.color[4 * sample + i];
  return color;
}

TEST(Needles, AreLongAndThin) {
  for (const auto& t : snapped("needles").triangles) {
    double longest = 0;
    for (size_t i = 0; i < 3; ++i) {
      const auto &a = t.v[i], &b = t.v[(i + 1) % 3];
      longest = std::max(longest, std::hypot(a.x - b.x, a.y - b.y) / 256);
    }
    const auto area2 = judge(kContract, {1, 1, {}, {}}, t).doubled_area();
    const double width = std::abs(static_cast<double>(area2)) / 65536 / longest;
    EXPECT_GE(longest, 99);
    EXPECT_GT(width, .05);
    EXPECT_LE(width, 2);
  }
}

// The first triangle contains all others, on one plane. Their codes differ from it within the
// bound.
TEST(Coplanar, CodesDifferByNoMoreThanTheBound) {
  for (const auto& design : spec::designs()) {
    SCOPED_TRACE(design.name);
    const auto contract = spec::contract(design);
    const Snapped scene = snapped(hard_case("coplanar"), contract);
    const auto codes = [&](const spec::Triangle& t) {
      core::Renderer renderer(contract, scene.frame);
      renderer.draw(t);
      return renderer.buffer();
    };
    const core::FrameBuffer outer = codes(scene.triangles[0]);
    const auto limit = static_cast<int64_t>(2 * spec::error_bounds(design).depth_ulp);
    int compared = 0;
    for (size_t i = 1; i < scene.triangles.size(); ++i) {
      const core::FrameBuffer inner = codes(scene.triangles[i]);
      for (size_t k = 0; k < inner.hits.size(); ++k) {
        if (inner.hits[k] == 0) continue;
        ++compared;
        EXPECT_LE(std::abs(int64_t{inner.depth[k]} - outer.depth[k]), limit) << i << " " << k;
      }
    }
    EXPECT_GT(compared, 2000);
  }
}

// Three copies in a row, each in its colour.
void expect_copy_that_stays(const std::string& name, size_t copy) {
  const Snapped scene = snapped(name);
  const core::Renderer all = drawn(scene);
  size_t samples = 0;
  for (size_t i = 0; i < scene.triangles.size(); i += 3) {
    const core::Renderer one = drawn(scene, i, 1);
    const core::Renderer three = drawn(scene, i, 3);
    EXPECT_EQ(one.buffer().depth, drawn(scene, i + 1, 1).buffer().depth);
    EXPECT_EQ(one.buffer().depth, drawn(scene, i + 2, 1).buffer().depth);
    EXPECT_EQ(one.buffer().depth, three.buffer().depth);
    const spec::Attributes wanted = scene.triangles[i + copy].v[0].attr;
    for (size_t k = 0; k < one.buffer().hits.size(); ++k) {
      if (one.buffer().hits[k] == 0) continue;
      ++samples;
      ASSERT_EQ(all.buffer().hits[k], 3);
      ASSERT_EQ(all.buffer().depth[k], one.buffer().depth[k]);
      ASSERT_EQ(color_at(all.buffer(), k), wanted) << name << " " << k;
    }
  }
  EXPECT_GT(samples, 200u);
}
TEST(EqualDepth, LessKeepsTheFirst) { expect_copy_that_stays("equal_depth_less", 0); }
TEST(EqualDepth, LequalKeepsTheLast) { expect_copy_that_stays("equal_depth_lequal", 2); }

// Depths and colours are constant in each triangle, so coverage alone tells the winner.
TEST(BackToBack, LeavesTheNearestAndTheFirstAmongEquals) {
  const Snapped scene = snapped("back_to_back");
  std::vector<size_t> winner(32 * 32, SIZE_MAX);
  int replaced = 0, equal = 0;
  for (size_t i = 0; i < scene.triangles.size(); ++i) {
    const auto exact = judge(kContract, scene.frame, scene.triangles[i]);
    for (size_t k = 0; k < winner.size(); ++k) {
      if (!exact.covers(static_cast<int>(k % 32), static_cast<int>(k / 32))) continue;
      const auto z = [&](size_t triangle) { return scene.triangles[triangle].v[0].z; };
      const bool first = winner[k] == SIZE_MAX;
      equal += !first && z(i) == z(winner[k]) ? 1 : 0;
      replaced += !first && z(i) < z(winner[k]) ? 1 : 0;
      if (first || z(i) < z(winner[k])) winner[k] = i;
    }
  }
  EXPECT_GT(replaced, 50);
  EXPECT_GT(equal, 20);
  const core::Renderer all = drawn(scene);
  for (size_t k = 0; k < winner.size(); ++k) {
    const bool hit = winner[k] != SIZE_MAX;
    const spec::Attributes nothing{};
    const auto& wanted = hit ? scene.triangles[winner[k]].v[0].attr : nothing;
    ASSERT_EQ(color_at(all.buffer(), k), wanted) << k;
    const int64_t z = hit ? scene.triangles[winner[k]].v[0].z : int64_t{kFarCode} << 8;
    ASSERT_EQ(all.buffer().depth[k], (z + 128) >> 8) << k;
  }
}

TEST(DepthNearOne, CodesAreRoundedFromTheExactProduct) {
  const auto floats = hard_case("depth_near_one").make();
  const core::Renderer all = drawn(snapped("depth_near_one"));
  int wrong_in_floats = 0;
  ASSERT_EQ(floats.size(), all.buffer().depth.size());
  for (size_t i = 0; i < floats.size(); ++i) {
    const float z = floats[i].v[0].z;
    ASSERT_TRUE(z >= .5f && z <= 1);
    const double exact = double{z} * kFarCode;  // 48 bits
    EXPECT_LE(std::abs(all.buffer().depth[i] - exact), .5 + 1 / 512.) << i;
    const auto in_floats = static_cast<int64_t>(z * 16777215 + .5f);
    wrong_in_floats += std::abs(static_cast<double>(in_floats) - exact) > .5 + 1 / 512. ? 1 : 0;
  }
  EXPECT_EQ(all.buffer().depth[0], 1u << 23);
  EXPECT_EQ(all.buffer().depth[1], kFarCode);
  // The mutant: the formula in binary32 fails for about half of them.
  EXPECT_GT(wrong_in_floats, 180);
}

TEST(Perspective, ReachesRatiosOfAMillion) {
  float greatest = 0;
  for (const auto& t : hard_case("perspective").make()) {
    const auto [low, high] = std::minmax({t.v[0].w, t.v[1].w, t.v[2].w});
    greatest = std::max(greatest, high / low);
  }
  EXPECT_EQ(greatest, 1e6f);
  EXPECT_EQ(snapped("perspective").counters.perspective, 32u);
}

}  // namespace
}  // namespace pineda::hard
