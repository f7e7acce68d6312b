// The bare RTL takes the same cycles as the RTL under the bench and leaves the same frame, so that
// its speed is measured on the same work.
#include <cstdlib>

#include "model/memory/kinds.h"
#include "tb/bench_top.h"
#include "tests/rtl/support.h"

namespace pineda::tb {
namespace {

// Built before the tests run.
BenchTop& bare() {
  setenv("PINEDA_CACHE", PINEDA_BENCH_CACHE, 1);
  static BenchTop top(rtl().contract(), "g++");
  return top;
}

struct Drawn {
  Cycle cycles = 0;
  core::FrameBuffer buffer;
};

BenchOptions with_latency(int cycles) {
  BenchOptions options;
  options.depth_latency_cycles = cycles;
  return options;
}

Drawn draw_bare(const spec::FrameState& frame, const std::vector<spec::Triangle>& triangles,
                const BenchOptions& options) {
  bare().load(frame, triangles, options);
  const Cycle cycles = bare().run();
  return {cycles, bare().buffer()};
}

Drawn draw(const spec::FrameState& frame, const std::vector<spec::Triangle>& triangles,
           const BenchOptions& options) {
  FrameBench bench(rtl(), options);
  const Cycle cycles = bench.run(frame, from(triangles), nullptr).cycles;
  return {cycles, bench.buffer()};
}

testing::AssertionResult same(const Drawn& a, const Drawn& b) {
  if (a.cycles != b.cycles) return testing::AssertionFailure() << a.cycles << ", " << b.cycles;
  if (a.buffer.depth != b.buffer.depth) return testing::AssertionFailure() << "depth differs";
  if (a.buffer.color != b.buffer.color) return testing::AssertionFailure() << "colour differs";
  return testing::AssertionSuccess();
}

// Frames of odd sizes in any raster state, one after the other without a reset in between.
TEST(BenchTop, TakesTheCyclesOfTheBenchAndLeavesItsFrame) {
  spec::Random random(606);
  for (const int latency_cycles : {1, 3, 8, 64}) {
    for (int i = 0; i < 6; ++i) {
      const int width = random.between(1, 90);
      const int height = random.between(1, 90);
      const auto frame = random_raster_state(&random, width, height, rtl().contract());
      const int size_px = random.between(1, 60);
      const auto triangles = random_triangles(&random, frame, size_px, 200);
      const BenchOptions options = with_latency(latency_cycles);
      EXPECT_TRUE(same(draw_bare(frame, triangles, options), draw(frame, triangles, options)))
          << latency_cycles << ", frame " << i;
    }
  }
}

// Each with a memory of its own. Always ready again afterwards.
TEST(BenchTop, TakesTheCyclesOfTheBenchOnAnyMemoryUnderAnyStall) {
  spec::Random random(609);
  for (const memory::Kind kind : memory::kKinds) {
    for (const StallMode mode : kStallModes) {
      const auto frame = random_raster_state(&random, random.between(1, 90), random.between(1, 90),
                                             rtl().contract());
      const auto triangles = random_triangles(&random, frame, random.between(1, 60), 200);
      const auto options = [&] {
        BenchOptions made;
        made.memory = memory::make_timing(kind, rtl().contract(), 8);
        made.stall_mode = mode;
        made.seed = 3;
        return made;
      };
      const Drawn expected = draw(frame, triangles, options());
      EXPECT_TRUE(same(draw_bare(frame, triangles, options()), expected))
          << spec::name_of(kind) << ", " << stall_mode_name(mode);
      EXPECT_EQ(bare().run(), expected.cycles) << "another frame";
      EXPECT_TRUE(same(draw_bare(frame, triangles, with_latency(8)),
                       draw(frame, triangles, with_latency(8))));
    }
  }
}

TEST(BenchTop, RepeatsItselfAndDrawsEmptyFrames) {
  spec::Random random(607);
  const auto frame = random_state(&random, 40, 30);
  const auto triangles = random_triangles(&random, frame, 20, 100);
  const Drawn first = draw_bare(frame, triangles, with_latency(8));
  EXPECT_EQ(bare().run(), first.cycles);
  EXPECT_EQ(bare().buffer().depth, first.buffer.depth);
  EXPECT_TRUE(same(draw_bare(frame, {}, with_latency(8)), draw(frame, {}, with_latency(8))));
}

// The comparison sees a memory that answers a cycle late, and a triangle that is missing.
TEST(BenchTop, ComparisonFindsFaults) {
  spec::Random random(608);
  auto frame = random_state(&random, 60, 60);
  frame.depth = spec::DepthFunc::kLess;
  auto triangles = random_triangles(&random, frame, 30, 100);
  const Drawn expected = draw(frame, triangles, with_latency(8));
  EXPECT_NE(draw_bare(frame, triangles, with_latency(9)).cycles, expected.cycles);
  BenchOptions stalled = with_latency(8);
  for (const StallMode mode : {StallMode::kSource, StallMode::kSink}) {
    stalled.stall_mode = mode;
    const Cycle cycles = draw(frame, triangles, stalled).cycles;
    ++stalled.seed;
    EXPECT_NE(draw_bare(frame, triangles, stalled).cycles, cycles) << "another stall";
  }
  triangles.resize(50);
  EXPECT_NE(draw_bare(frame, triangles, with_latency(8)).buffer.color, expected.buffer.color);
}

TEST(BenchTop, ForeignLatencyIsRefused) {
  EXPECT_THROW(bare().load(spec::FrameState{8, 8}, {}, with_latency(0)), RtlError);
  EXPECT_THROW(bare().load(spec::FrameState{8, 8}, {}, with_latency(1025)), RtlError);
}

}  // namespace
}  // namespace pineda::tb
