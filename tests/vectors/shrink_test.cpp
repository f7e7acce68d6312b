// Cases get as small as they can while they fail.
#include "vectors/runner/shrink.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/vectors/samples.h"

namespace pineda::vectors {
namespace {

bool has_red(const FrameCase& value, int least) {
  return std::any_of(value.samples.begin(), value.samples.end(),
                     [&](const Sample& s) { return s.color[0] >= least; });
}

TEST(Shrink, LeavesWhatTheFailureNeeds) {
  FrameCase failing = sample_case<FrameCase>();
  failing.frame.scissor_x1 = 6;
  failing.frame.cull = spec::Cull::kNone;
  failing.frame.depth = spec::DepthFunc::kLequal;
  failing.ports = {memory::StallMode::kBoth, 7};
  failing.reset_cycle = 12;
  for (int i = 0; i < 3; ++i) failing.in.push_back(failing.in[0]);
  failing = run_model(kContract, failing);
  ASSERT_TRUE(has_red(failing, 100));
  int asked = 0;
  const FrameCase small = shrunk<FrameCase>(kContract, failing, [&](const FrameCase& value) {
    ++asked;
    EXPECT_EQ(difference(kContract, value, run_model(kContract, value)), std::nullopt);
    return has_red(value, 100);
  });
  EXPECT_TRUE(has_red(small, 100));
  EXPECT_EQ(small.in.size(), 1u);
  EXPECT_EQ(small.in[0].id, 2u);  // the only one with so much red
  EXPECT_EQ(small.ports.mode, memory::StallMode::kNone);
  EXPECT_FALSE(small.reset_cycle);
  EXPECT_EQ(small.frame.scissor_x1, spec::kNoScissorPx);
  EXPECT_EQ(small.frame.depth, spec::DepthFunc::kLess);
  EXPECT_LT(small.frame.width * small.frame.height, 42);
  EXPECT_EQ(small.in[0].v[0].z, 0);
  EXPECT_LT(asked, 200);
}

// Fewer triangles are further on in the cycle of a reset.
TEST(Shrink, MovesTheResetToWhereFewerInputsFail) {
  FrameCase failing = sample_case<FrameCase>();
  failing.in.resize(1);
  for (int i = 0; i < 3; ++i) failing.in.push_back(failing.in[0]);
  failing.reset_cycle = 12;
  failing = run_model(kContract, failing);
  const FrameCase small = shrunk<FrameCase>(kContract, failing, [](const FrameCase& value) {
    return !value.in.empty() && value.reset_cycle == 3 * value.in.size();
  });
  EXPECT_EQ(small.in.size(), 1u);
  EXPECT_EQ(small.reset_cycle, 3u);
}

TEST(Shrink, KeepsTwoStampsThatMeet) {
  InterpZtestCase failing = sample_case<InterpZtestCase>();
  const auto writes_twice = [](const InterpZtestCase& value) {
    for (size_t i = 0; i < value.depth.size(); ++i) {
      for (size_t k = 0; k < i; ++k) {
        if (value.depth[i].x == value.depth[k].x && value.depth[i].y == value.depth[k].y)
          return true;
      }
    }
    return false;
  };
  failing = run_model(kContract, failing);
  ASSERT_TRUE(writes_twice(failing));
  EXPECT_EQ(shrunk<InterpZtestCase>(kContract, failing, writes_twice).in.size(), 2u);
}

TEST(KindOf, ADifferenceLeavesOutPlacesAndNumbers) {
  EXPECT_EQ(kind_of("setup case sliver.3: setup_prim 2: e[1]: expected 0x7f (1), got 0x0 (0)"),
            kind_of("setup case fan.0: setup_prim 11: e[0]: expected 0x1 (1), got 0x0 (0)"));
  EXPECT_NE(kind_of("setup case a.0: setup_prim 2: e[1]: expected 0x7f (1), got 0x0 (0)"),
            kind_of("setup case a.0: setup_prim 2: a[1]: expected 0x7f (1), got 0x0 (0)"));
  EXPECT_EQ(kind_of("frame case a.0: sample (4, 5): depth: expected 1, got 2"),
            kind_of("frame case b.9: sample (14, 0): depth: expected 3, got 4"));
  EXPECT_NE(kind_of("interp_ztest case a.0: interp_ztest: nothing moves since cycle 9"), "");
}

}  // namespace
}  // namespace pineda::vectors
