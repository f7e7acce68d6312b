// The rates that the units promise, and the rules of their handshakes.
#include <algorithm>

#include "tests/rtl/support.h"

namespace pineda::tb {
namespace {

using spec::Triangle;

Triangle triangle(int32_t x0, int32_t y0, int32_t x1, int32_t y1, int32_t x2, int32_t y2) {
  Triangle t;
  const int32_t px = 1 << rtl().contract().design.subpixel_bits;
  t.v[0].x = x0 * px, t.v[0].y = y0 * px;
  t.v[1].x = x1 * px, t.v[1].y = y1 * px;
  t.v[2].x = x2 * px, t.v[2].y = y2 * px;
  return t;
}

spec::FrameState frame(int width, int height) {
  spec::FrameState state;
  state.width = width;
  state.height = height;
  return state;
}

std::vector<spec::SetupPrim> prims(const spec::FrameState& state,
                                   const std::vector<Triangle>& triangles) {
  vectors::SetupCase c{"", state, triangles, {}, {}};
  return vectors::run_model(rtl().contract(), c).out;
}

std::vector<spec::Stamp> stamps(const spec::FrameState& state,
                                const std::vector<Triangle>& triangles) {
  vectors::TraversalCase c{"", state, prims(state, triangles), {}};
  return vectors::run_model(rtl().contract(), c).out;
}

// Gaps between neighbouring cycles.
std::vector<Cycle> gaps(const std::vector<Cycle>& cycles) {
  std::vector<Cycle> differences;
  for (size_t i = 1; i < cycles.size(); ++i) differences.push_back(cycles[i] - cycles[i - 1]);
  return differences;
}

TEST(SetupRtlRate, TakesATriangleAtEveryInterval) {
  const int interval = rtl().contract().width.setup_interval_cycles;
  EXPECT_LE(interval, 16);
  SetupBench bench(rtl(), BenchOptions());
  bench.set_frame(frame(64, 64));
  std::vector<Cycle> accepted;
  bench.run(std::vector<Triangle>(20, triangle(0, 0, 40, 5, 10, 50)), &accepted);
  EXPECT_EQ(gaps(accepted), std::vector<Cycle>(19, interval));
}

TEST(SetupRtlRate, DroppedTriangleTakesSixCycles) {
  SetupBench bench(rtl(), BenchOptions());
  bench.set_frame(frame(64, 64));
  std::vector<Cycle> accepted;
  const auto out = bench.run(std::vector<Triangle>(20, triangle(5, 5, 10, 10, 20, 20)), &accepted);
  EXPECT_TRUE(out.tokens.empty());
  EXPECT_EQ(gaps(accepted), std::vector<Cycle>(19, 6));
}

TEST(TraversalRtlRate, NoBubbleInsideAcceptedTiles) {
  const auto state = frame(256, 256);
  TraversalBench bench(rtl(), BenchOptions());
  // Covers the frame: every tile is accepted, so 128 x 128 stamps leave one a cycle.
  const auto trace = bench.run(prims(state, {triangle(-300, -10, 300, -10, 128, 1000)}));
  ASSERT_EQ(trace.tokens.size(), 128u * 128u);
  EXPECT_EQ(trace.cycles.back() - trace.cycles.front(), 128 * 128 - 1);
}

TEST(TraversalRtlRate, TestsOneTileACycle) {
  const auto state = frame(1024, 1024);
  // A needle along the diagonal of a 128 x 128 box of tiles: in each row a tile before it, the ones that it
  // cuts, and two past it.
  const Triangle needle = triangle(0, 0, 1024, 1023, 1024, 1024);
  TraversalBench bench(rtl(), BenchOptions());
  std::vector<Cycle> accepted;
  const auto both = prims(state, {needle, needle});
  bench.run(both, &accepted);
  ASSERT_EQ(accepted.size(), 2u);
  core::FrameCounters counters;
  core::for_each_stamp(rtl().contract(), both[0], {}, &counters, [](const spec::Stamp&) {});
  const auto tiles = static_cast<Cycle>(counters.tiles_tested);
  EXPECT_NEAR(static_cast<double>(tiles), 4 * 128, 4);
  EXPECT_GE(accepted[1] - accepted[0], tiles);
  // Kept tiles' stamps are sent while other tiles are rejected, but for a few cycles at the FIFO.
  EXPECT_LE(accepted[1] - accepted[0], tiles + tiles / 50);
}

class InterpZtestRtlRate : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Latency, InterpZtestRtlRate, testing::Values(1, 2, 8, 15, 16),
                         testing::PrintToStringParamName());

TEST_P(InterpZtestRtlRate, TakesAStampACycleWithoutHazards) {
  const auto state = frame(64, 64);
  BenchOptions options;
  options.depth_latency_cycles = GetParam();
  InterpZtestBench bench(rtl(), options);
  std::vector<Cycle> accepted;
  bench.run(state, stamps(state, {triangle(-100, -10, 200, -10, 32, 400)}), &accepted);
  ASSERT_EQ(accepted.size(), 32u * 32u);
  EXPECT_EQ(accepted.back() - accepted.front(), 32 * 32 - 1);
}

// A stamp's read is accepted in t and its data come in t + latency; they are tested in the next
// cycle and written in the one after. The next read follows the write. A latency of 3 is hidden
// behind the interpolation of the depths. Once the FIFO in front is full, stamps come at that rate.
TEST_P(InterpZtestRtlRate, SameAddressWaitsForTheWriteAndNoLonger) {
  const auto state = frame(64, 64);
  BenchOptions options;
  options.depth_latency_cycles = GetParam();
  const auto one = stamps(state, {triangle(-100, -10, 200, -10, 32, 400)})[0];
  InterpZtestBench bench(rtl(), options);
  std::vector<Cycle> accepted;
  const auto fifo = static_cast<size_t>(rtl().contract().design.stamp_fifo_depth);
  bench.run(state, std::vector<spec::Stamp>(fifo + 8, one), &accepted);
  accepted.erase(accepted.begin(), accepted.begin() + static_cast<std::ptrdiff_t>(fifo) + 1);
  EXPECT_EQ(gaps(accepted), std::vector<Cycle>(6, std::max(GetParam(), 3) + 3));
}

TEST_P(InterpZtestRtlRate, TimeDoesNotDependOnDepth) {
  const auto state = frame(64, 64);
  BenchOptions options;
  options.depth_latency_cycles = GetParam();
  auto near = triangle(0, 0, 20, 0, 0, 20);
  auto far = near;
  for (auto& v : far.v) v.z = 1 << 20;
  std::vector<Cycle> passing, failing;
  InterpZtestBench(rtl(), options).run(state, stamps(state, {far, near, far}), &passing);
  InterpZtestBench(rtl(), options).run(state, stamps(state, {near, far, far}), &failing);
  EXPECT_EQ(passing, failing);
}

// Two triangles on the same pixels in consecutive cycles: the second sees the first one's depth.
TEST(InterpZtestRtlHazard, OverlapInConsecutiveCyclesReadsAfterTheWrite) {
  const auto state = frame(2, 2);
  auto near = triangle(-10, -10, 30, -10, -10, 30);
  near.v[0].attr[0] = near.v[1].attr[0] = near.v[2].attr[0] = 200;
  auto far = near;
  for (auto& v : far.v) v.z = 1 << 20, v.attr[0] = 100;
  InterpZtestBench bench(rtl(), BenchOptions());
  const auto in = stamps(state, {near, far});
  ASSERT_EQ(in.size(), 2u);
  const auto writes = bench.run(state, in);
  EXPECT_EQ(writes.depth.tokens.size(), 1u);
  EXPECT_EQ(bench.buffer().depth, std::vector<uint32_t>(4, 0));
  EXPECT_EQ(bench.buffer().color[0], 200);
}

// Valid never waits for ready: while every consumer is not ready, each output is still offered.
TEST(HandshakeRtl, ValidRisesWhileReadyIsLow) {
  RtlUnit setup(rtl(), "setup");
  SourceEnd<Triangle> in(setup, "tri");
  SinkEnd<spec::SetupPrim> out(setup, "prim");
  PayloadPort<spec::FrameState> state(setup, "frame_i");
  setup.reset();
  state.set(frame(64, 64));
  in.offer(triangle(0, 0, 40, 5, 10, 50));
  for (int cycle = 0; cycle < 40; ++cycle) {
    setup.settle();
    ASSERT_FALSE(out.taken());
    const bool took = in.taken();
    setup.clock();
    if (took) in.withdraw();
  }
  setup.settle();
  EXPECT_TRUE(out.offered());

  RtlUnit interp(rtl(), "interp_ztest");
  SourceEnd<spec::Stamp> stamp(interp, "stamp");
  SinkEnd<spec::DepthRead> read(interp, "depth_rd");
  interp.reset();
  stamp.offer(stamps(frame(8, 8), {triangle(0, 0, 8, 0, 0, 8)})[0]);
  interp.settle();
  ASSERT_TRUE(stamp.taken());
  interp.clock();
  stamp.withdraw();
  interp.settle();
  EXPECT_TRUE(read.offered());
}

}  // namespace
}  // namespace pineda::tb
