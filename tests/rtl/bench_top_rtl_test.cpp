// The bare RTL takes the same cycles as the RTL under the bench and leaves the same frame, so that
// its speed is measured on the same work.
#include <cstdlib>

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

Drawn draw_bare(const spec::FrameState& frame, const std::vector<spec::Triangle>& triangles,
                int latency_cycles) {
  bare().load(frame, triangles, latency_cycles);
  const Cycle cycles = bare().run();
  return {cycles, bare().buffer()};
}

Drawn draw(const spec::FrameState& frame, const std::vector<spec::Triangle>& triangles,
           int latency_cycles) {
  BenchOptions options;
  options.depth_latency_cycles = latency_cycles;
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
      EXPECT_TRUE(
          same(draw_bare(frame, triangles, latency_cycles), draw(frame, triangles, latency_cycles)))
          << latency_cycles << ", frame " << i;
    }
  }
}

TEST(BenchTop, RepeatsItselfAndDrawsEmptyFrames) {
  spec::Random random(607);
  const auto frame = random_state(&random, 40, 30);
  const auto triangles = random_triangles(&random, frame, 20, 100);
  const Drawn first = draw_bare(frame, triangles, 8);
  EXPECT_EQ(bare().run(), first.cycles);
  EXPECT_EQ(bare().buffer().depth, first.buffer.depth);
  EXPECT_TRUE(same(draw_bare(frame, {}, 8), draw(frame, {}, 8)));
}

// The comparison sees a memory that answers a cycle late, and a triangle that is missing.
TEST(BenchTop, ComparisonFindsFaults) {
  spec::Random random(608);
  auto frame = random_state(&random, 60, 60);
  frame.depth = spec::DepthFunc::kLess;
  auto triangles = random_triangles(&random, frame, 30, 100);
  const Drawn expected = draw(frame, triangles, 8);
  EXPECT_NE(draw_bare(frame, triangles, 9).cycles, expected.cycles);
  triangles.resize(50);
  EXPECT_NE(draw_bare(frame, triangles, 8).buffer.color, expected.buffer.color);
}

TEST(BenchTop, ForeignLatencyIsRefused) {
  EXPECT_THROW(bare().load(spec::FrameState{8, 8}, {}, 0), RtlError);
  EXPECT_THROW(bare().load(spec::FrameState{8, 8}, {}, 1025), RtlError);
}

}  // namespace
}  // namespace pineda::tb
