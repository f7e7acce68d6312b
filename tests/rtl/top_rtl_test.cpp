// Whole frames: the top against core at every boundary, the frame protocol, resets.
#include <algorithm>

#include "tests/rtl/support.h"

namespace pineda::tb {
namespace {

class TopRtl : public StallTest {};
INSTANTIATE_TEST_SUITE_P(, TopRtl, testing::ValuesIn(kStallModes), stall_test_name);

BenchOptions options(StallMode mode, int latency_cycles = 8) {
  BenchOptions o;
  o.stall_mode = mode;
  o.seed = 7;
  o.depth_latency_cycles = latency_cycles;
  return o;
}

TEST_P(TopRtl, ReproducesTheFrameVectorsBackToBack) {
  FrameBench bench(rtl(), options(GetParam()));
  for (const auto& c : committed_cases<vectors::FrameCase>()) {
    ASSERT_EQ(first_difference(&bench, c), "");
    // The scoreboard's memories are whole.
    constexpr int kMost = 65536;
    if (c.frame.width * c.frame.height > kMost) continue;
    ASSERT_EQ(check_frame(&bench, c.frame, c.in), "") << c.name;
  }
}

TEST_P(TopRtl, MatchesModel) {
  spec::Random random(404 + static_cast<uint64_t>(GetParam()));
  for (const int latency_cycles : {1, 3, 8, 64}) {
    FrameBench bench(rtl(), options(GetParam(), latency_cycles));
    for (int i = 0; i < 25; ++i) {
      const auto frame = random_state(&random, random.between(1, 90), random.between(1, 90));
      const auto triangles = random_triangles(&random, frame, random.between(1, 60), 250);
      ASSERT_EQ(check_frame(&bench, frame, triangles), "") << "frame " << i;
    }
  }
}

TEST_P(TopRtl, OddFrames) {
  spec::Random random(5);
  FrameBench bench(rtl(), options(GetParam()));
  for (const auto& [width, height] : {std::pair(641, 479), {1, 1}, {9, 1}, {1, 17}, {7, 9}}) {
    spec::FrameState frame;
    frame.width = width;
    frame.height = height;
    EXPECT_EQ(check_frame(&bench, frame, random_triangles(&random, frame, width, 40)), "")
        << width << "x" << height;
  }
}

// Each cycle's close-up counts one cycle for each unit; together they are the whole frame's
// counters.
TEST_P(TopRtl, CloseUpsSumUpToTheFrame) {
  spec::Random random(17);
  spec::FrameState frame;
  frame.width = frame.height = 12;
  const auto triangles = random_triangles(&random, frame, 5, 20);
  FrameBench whole(rtl(), options(GetParam()));
  const FrameResult result = whole.run(frame, from(triangles), nullptr);
  std::array<timing::UnitCycles, timing::kUnits> sum;
  for (Cycle cycle = 0; cycle < result.spent.drained; ++cycle) {
    FrameBench bench(rtl(), options(GetParam()));
    const auto causes =
        bench.run_close_up(frame, from(triangles), nullptr, {cycle, cycle, cycle + 1, ""});
    for (size_t u = 0; u < timing::kUnits; ++u) ++sum[u][causes[u]];
  }
  for (size_t u = 0; u < timing::kUnits; ++u) {
    EXPECT_EQ(sum[u].spent, result.spent.units[u].spent) << u;
  }
  EXPECT_GT(sum[0][timing::Cause::kBusy], 0);
}

// The memories are told for each frame what to clear depth to, and every depth function compares
// with that.
TEST_P(TopRtl, EveryDepthFunctionOnEveryClearedDepth) {
  spec::Random random(18);
  FrameBench bench(rtl(), options(GetParam()));
  for (const double depth : {0., .5, 1., 1 / 3., 1 - 0x1p-24}) {
    for (int func = 0; func < 9; ++func) {
      spec::FrameState frame;
      frame.width = frame.height = 24;
      frame.depth = static_cast<spec::DepthFunc>(func);
      frame.clear_depth = depth;
      EXPECT_EQ(check_frame(&bench, frame, {}), "") << depth;
      auto triangles = random_triangles(&random, frame, 30, 40);
      for (size_t i = 0; i < triangles.size(); i += 2) {  // at the cleared depth and beside it
        const int64_t code = spec::cleared_depth(rtl().contract().design, frame);
        const int64_t z = std::clamp<int64_t>(code + random.between(-1, 1), 0, (1 << 24) - 1);
        for (auto& v : triangles[i].v) v.z = z << spec::kDepthInputFractionBits;
      }
      EXPECT_EQ(check_frame(&bench, frame, triangles), "") << func << " on " << depth;
    }
  }
}

TEST_P(TopRtl, EmptyFrameEnds) {
  FrameBench bench(rtl(), options(GetParam()));
  spec::FrameState frame;
  frame.width = frame.height = 16;
  EXPECT_EQ(check_frame(&bench, frame, {}), "");
}

TEST_P(TopRtl, ResetInTheMiddleOfAFrameLeavesAWorkingPipeline) {
  spec::Random random(6);
  spec::FrameState frame;
  frame.width = frame.height = 48;
  const auto triangles = random_triangles(&random, frame, 40, 60);
  for (Cycle cycles = 1; cycles < 1200; cycles += 37) {
    FrameBench bench(rtl(), options(GetParam()));
    bench.run_into_reset(frame, from(triangles), cycles);
    ASSERT_EQ(check_frame(&bench, frame, triangles), "") << "reset after " << cycles << " cycles";
  }
}

TEST(TopRtlProtocol, CyclesOfAFrameDoNotDependOnTheOneBefore) {
  spec::Random random(8);
  spec::FrameState frame;
  frame.width = frame.height = 64;
  const auto triangles = random_triangles(&random, frame, 30, 100);
  FrameBench bench(rtl(), BenchOptions());
  const uint64_t first = bench.run(frame, from(triangles), nullptr).cycles;
  EXPECT_EQ(bench.run(frame, from(triangles), nullptr).cycles, first);
}

TEST(TopRtlMutant, IsCaughtAtTheFirstBoundary) {
  spec::Random random(9);
  spec::FrameState frame;
  frame.width = frame.height = 64;
  FrameBench bench(mutant(), BenchOptions());
  // The half-pixel lattice: samples lie on edges.
  auto triangles = random_triangles(&random, frame, 30, 200);
  for (auto& t : triangles) {
    for (auto& v : t.v) v.x &= ~127, v.y &= ~127;
  }
  const std::string text = check_frame(&bench, frame, triangles);
  EXPECT_EQ(text.substr(0, 10), "RTL setup:") << text;
  EXPECT_NE(text.find("setup_prim.e["), std::string::npos) << text;
}

// The mutant always asks for the greatest code.
TEST(TopRtlMutant, AnotherClearedDepthIsSeen) {
  spec::FrameState frame;
  frame.width = frame.height = 16;
  FrameBench bench(mutant(), BenchOptions());
  EXPECT_EQ(check_frame(&bench, frame, {}), "");
  frame.clear_depth = .5;
  EXPECT_EQ(check_frame(&bench, frame, {}), "depth memories differ");
}

TEST(TopRtlProtocol, RefusesALatencyItCannotKeep) {
  EXPECT_THROW(FrameBench(rtl(), options(StallMode::kNone, 0)), RtlError);
  EXPECT_THROW(FrameBench(rtl(), options(StallMode::kNone, 1025)), RtlError);
}

TEST(RtlLibrary, RefusesAMissingPlugin) {
  EXPECT_THROW(RtlLibrary(rtl().contract(), "/nonexistent/pineda_rtl.so"), RtlError);
}

TEST(RtlLibrary, RefusesAPluginOfAnotherPackage) {
  spec::Design design = spec::kHighTile;
  design.attributes = 3;
  try {
    const RtlLibrary library(spec::contract(design), PINEDA_RTL);
    FAIL() << "not refused";
  } catch (const RtlError& error) {
    EXPECT_NE(std::string(error.what()).find("another package"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace pineda::tb
