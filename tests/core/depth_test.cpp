// Depth test and the frame's memories.
#include <gtest/gtest.h>

#include "model/core/frame.h"
#include "tests/core/support.h"

namespace pineda::test {
namespace {

using spec::DepthFunc;

constexpr spec::FrameState frame(DepthFunc func) { return {31, 23, spec::Cull::kNone, func}; }

// A slanted triangle with varying depth and one varying colour; `color` marks the triangle by
// another.
spec::Triangle slanted(int color) {
  spec::Triangle t = triangle({100, 50}, {7500, 900}, {1500, 5700});
  const std::array<int64_t, 3> z{1000000, 4000000000, 123456789};
  for (size_t i = 0; i < 3; ++i) {
    t.v[i].z = z[i];
    t.v[i].attr = {color, static_cast<int32_t>(80 * i), 0, 255};
  }
  return t;
}

TEST(DepthTest, LaneByLaneTruth) {
  // Lanes: nearer, equal, farther, nearer but not in the mask.
  std::array<uint32_t, spec::kMaxLanes> z{5, 7, 9, 0};
  std::array<uint32_t, spec::kMaxLanes> stored{7, 7, 7, 7};
  EXPECT_EQ(core::depth_test(kContract, DepthFunc::kLess, 0b0111, z, stored), 0b0001u);
  EXPECT_EQ(core::depth_test(kContract, DepthFunc::kLequal, 0b0111, z, stored), 0b0011u);
  EXPECT_EQ(core::depth_test(kContract, DepthFunc::kOff, 0b0111, z, stored), 0b0111u);
}

TEST(EqualZ, LessKeepsTheFirstAndLequalTheLast) {
  for (const auto func : {DepthFunc::kLess, DepthFunc::kLequal}) {
    core::Renderer once(kContract, frame(func));
    once.draw(slanted(10));
    core::Renderer twice(kContract, frame(func));
    twice.draw(slanted(10));
    const uint64_t passed_once = twice.counters().passed;
    twice.draw(slanted(200));
    EXPECT_EQ(once.buffer().depth, twice.buffer().depth);  // z is bit-identical
    EXPECT_GT(passed_once, 100u);
    EXPECT_EQ(twice.counters().passed, func == DepthFunc::kLess ? passed_once : 2 * passed_once);
    for (size_t i = 0; i < twice.buffer().hits.size(); ++i) {
      const int wanted = twice.buffer().hits[i] == 0 ? 0 : func == DepthFunc::kLess ? 10 : 200;
      ASSERT_EQ(twice.buffer().color[4 * i], wanted) << i;
    }
  }
}

// The test above can fail: a depth of one code less passes LESS.
TEST(EqualZ, MutantOneCodeNearerIsSeen) {
  core::Renderer renderer(kContract, frame(DepthFunc::kLess));
  renderer.draw(slanted(10));
  const uint64_t passed = renderer.counters().passed;
  spec::Triangle nearer = slanted(200);
  for (auto& v : nearer.v) v.z -= 2 << spec::kDepthInputFractionBits;
  renderer.draw(nearer);
  EXPECT_EQ(renderer.counters().passed, 2 * passed);
}

TEST(DepthOff, WritesColorAndLeavesDepthAlone) {
  core::Renderer renderer(kContract, frame(DepthFunc::kOff));
  renderer.draw(slanted(10));
  renderer.draw(slanted(20));
  EXPECT_EQ(renderer.counters().passed, renderer.counters().fragments);
  int colored = 0;
  for (size_t i = 0; i < renderer.buffer().depth.size(); ++i) {
    ASSERT_EQ(renderer.buffer().depth[i], 0xffffffu);
    colored += renderer.buffer().color[4 * i] == 20 ? 1 : 0;
  }
  EXPECT_EQ(static_cast<uint64_t>(colored) * 2, renderer.counters().fragments);
}

TEST(DepthTest, NearestWinsInEitherOrder) {
  spec::Triangle far = slanted(10);
  spec::Triangle near = slanted(200);
  for (auto& v : far.v) v.z = kMaxDepthInput - 256;
  for (auto& v : near.v) v.z = 256;
  core::Renderer forward(kContract, frame(DepthFunc::kLess));
  core::Renderer backward(kContract, frame(DepthFunc::kLess));
  forward.draw(far);
  forward.draw(near);
  backward.draw(near);
  backward.draw(far);
  EXPECT_EQ(forward.buffer().depth, backward.buffer().depth);
  EXPECT_EQ(forward.buffer().color, backward.buffer().color);
  EXPECT_EQ(forward.counters().passed, 2 * backward.counters().passed);
  // The greatest code is what the buffer is cleared to: it never passes LESS.
  for (auto& v : far.v) v.z = kMaxDepthInput;
  core::Renderer cleared(kContract, frame(DepthFunc::kLess));
  cleared.draw(far);
  EXPECT_GT(cleared.counters().fragments, 0u);
  EXPECT_EQ(cleared.counters().passed, 0u);
}

TEST(FrameBuffer, ClearForgetsEverything) {
  core::Renderer renderer(kContract, frame(DepthFunc::kLess));
  const core::FrameBuffer fresh = renderer.buffer();
  renderer.draw(slanted(10));
  EXPECT_NE(renderer.buffer().depth, fresh.depth);
  renderer.clear();
  EXPECT_EQ(renderer.buffer().depth, fresh.depth);
  EXPECT_EQ(renderer.buffer().color, fresh.color);
  EXPECT_EQ(renderer.buffer().hits, fresh.hits);
  EXPECT_EQ(renderer.counters().triangles, 0u);
}

TEST(FrameBuffer, HitsSaturate) {
  constexpr spec::FrameState kOne{1, 1, spec::Cull::kNone, DepthFunc::kOff};
  core::Renderer renderer(kContract, kOne);
  const spec::Triangle t = triangle({0, 0}, {512, 0}, {0, 512});
  for (int i = 0; i < 65540; ++i) renderer.draw(t);
  EXPECT_EQ(renderer.buffer().hits[0], 65535);
  EXPECT_EQ(renderer.counters().fragments, 65540u);
}

}  // namespace
}  // namespace pineda::test
