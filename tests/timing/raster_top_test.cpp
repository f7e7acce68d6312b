// The whole rasterizer: small frames worked by hand, bits against core, counters, errors.
#include <gtest/gtest.h>
#include <unistd.h>

#include <numeric>
#include <stdexcept>

#include "tests/timing/support.h"

namespace pineda::test {
namespace {

using timing::ExternalPort;
using Cycles = std::vector<Cycle>;

template <class T>
Cycles cycles_of(const std::vector<Event<T>>& events) {
  Cycles cycles;
  for (const auto& event : events) cycles.push_back(static_cast<Cycle>(event.cycle));
  return cycles;
}

// Covers a frame of up to 64 x 64 px.
spec::Triangle cover(int64_t z = 1000) { return flat_triangle(0, 0, 128, 0, 0, 128, z); }

class RasterTopTiming : public testing::Test {
 protected:
  timing::FrameResult run(const Scene& scene) {
    record_ = {};
    Recorder recorder(&record_);
    return top_.run(scene.frame, pull_from(scene), &recorder);
  }

  timing::RasterTop top_{"top", kContract};
  Record record_;
};

// Accepted in 2, set up in 29, its tile tested in 30, its stamp found in 32 and sent in 33; read in
// 34, response in 43, depth write in 44, and in 45, behind interpolation, the colour write.
TEST_F(RasterTopTiming, OneStampTakesFortySixCycles) {
  const auto result = run({{2, 2}, {cover()}});
  EXPECT_EQ(cycles_of(record_.prims), Cycles{29});
  EXPECT_EQ(cycles_of(record_.stamps), Cycles{33});
  EXPECT_EQ(cycles_of(record_.depths), Cycles{44});
  EXPECT_EQ(cycles_of(record_.colors), Cycles{45});
  EXPECT_EQ(result.cycles, 46);
  EXPECT_EQ(result.spent.drained, 46);
}

// The depth that is compared is interpolated in 4 cycles, in which a latency of 3 is hidden.
TEST_F(RasterTopTiming, EachCycleOfLatencyCostsOne) {
  for (int latency = 1; latency <= 64; ++latency) {
    top_.set_depth_latency_cycles(latency);
    EXPECT_EQ(run({{2, 2}, {cover()}}).cycles, 38 + std::max(latency, 3));
  }
}

TEST_F(RasterTopTiming, DepthOffDoesNotWaitForTheMemory) {
  top_.set_depth_latency_cycles(64);
  const auto result = run({{2, 2, spec::Cull::kNone, spec::DepthFunc::kOff}, {cover(), cover()}});
  EXPECT_EQ(cycles_of(record_.colors), (Cycles{40, 46}));
  EXPECT_TRUE(record_.depths.empty());
  EXPECT_EQ(result.of(Unit::kInterpZtest)[Cause::kHazard], 0);
}

TEST_F(RasterTopTiming, FrameWithoutWritesLastsToItsClear) {
  EXPECT_EQ(run({{2, 2}, {}}).cycles, 2);
  const auto dropped = run({{2, 2}, {flat_triangle(0, 0, 1, 1, 2, 2)}});
  EXPECT_EQ(dropped.cycles, 2);
  EXPECT_EQ(dropped.spent.drained, 8);
}

// The second stamp of the same address arrives in 40. The first one's read is accepted in 34, its
// write in 34 + 66: the address is free in 101.
TEST_F(RasterTopTiming, StampOfAnAddressInFlightWaitsForItsWrite) {
  top_.set_depth_latency_cycles(64);
  const auto result = run({{2, 2}, {cover(1000), cover(999)}});
  EXPECT_EQ(cycles_of(record_.depths), (Cycles{100, 167}));
  EXPECT_EQ(result.of(Unit::kInterpZtest)[Cause::kHazard], 101 - 40);
}

// The address of a stamp that fails the test is in flight as long as if it had been written.
TEST_F(RasterTopTiming, HazardDoesNotDependOnDepth) {
  top_.set_depth_latency_cycles(64);
  const auto result = run({{2, 2}, {cover(1000), cover(2000), cover(500)}});
  EXPECT_EQ(cycles_of(record_.depths), (Cycles{100, 234}));
  EXPECT_EQ(result.cycles, 236);
}

TEST_F(RasterTopTiming, StampEveryCycleAtTheLongestLatency) {
  top_.set_depth_latency_cycles(16);
  const auto result = run({{64, 64}, {cover()}});
  ASSERT_EQ(record_.colors.size(), 1024u);
  for (size_t i = 0; i < 1024; ++i) ASSERT_EQ(record_.colors[i].cycle, 53 + i);
  EXPECT_EQ(result.of(Unit::kStamps)[Cause::kBusy], 1024);
  EXPECT_EQ(result.of(Unit::kInterpZtest)[Cause::kBusy], 1024);
  EXPECT_EQ(result.of(Unit::kInterpZtest)[Cause::kBlocked], 0);
}

// 20 stamps are in flight: the 21st waits until the first one's write in 34 + 102 has freed a slot.
TEST_F(RasterTopTiming, LatencyBeyondTheTableIsSlower) {
  top_.set_depth_latency_cycles(100);
  const auto result = run({{8, 16}, {cover()}});
  ASSERT_EQ(record_.colors.size(), 32u);
  EXPECT_EQ(record_.colors[19].cycle, 137u + 19);
  EXPECT_EQ(record_.colors[20].cycle, 137u + 103);
  EXPECT_EQ(result.of(Unit::kInterpZtest)[Cause::kBlocked], 137 - 54);
}

// Reads are accepted in 34 .. 53, then the table holds 20 stamps until the first write in 500.
TEST_F(RasterTopTiming, FullTableBlocksUntilTheOldestStampIsWritten) {
  top_.set_ready([](ExternalPort port, Cycle cycle) {
    return port != ExternalPort::kDepthWrite || cycle >= 500;
  });
  const auto result = run({{64, 64}, {cover()}});
  EXPECT_EQ(record_.depths.front().cycle, 500u);
  EXPECT_EQ(result.of(Unit::kInterpZtest)[Cause::kBlocked], 501 - 54);
  // The 21st read is accepted in 501, in time for its write in 520: the writes do not pause.
  EXPECT_EQ(record_.depths.back().cycle, 500u + 1023);
}

TEST_F(RasterTopTiming, ClearThatWaitsDelaysTheFirstTriangle) {
  top_.set_ready(
      [](ExternalPort port, Cycle cycle) { return port != ExternalPort::kClear || cycle >= 11; });
  EXPECT_EQ(run({{2, 2}, {cover()}}).cycles, 46 + 10);
  EXPECT_EQ(run({{2, 2}, {}}).cycles, 12);
}

// ---- Properties of any scene

Record core_record(const Scene& scene, core::FrameCounters* counters, core::FrameBuffer* buffer) {
  struct Sink {
    Record record;
    void prim(const spec::SetupPrim& t) { record.prims.push_back({0, t}); }
    void stamp(const spec::Stamp& t) { record.stamps.push_back({0, t}); }
    void fragment(const spec::Stamp&, const spec::Fragment&) {}
    void depth(const spec::DepthWrite& t) { record.depths.push_back({0, t}); }
    void color(const spec::ColorWrite& t) { record.colors.push_back({0, t}); }
  } sink;
  core::Renderer renderer(kContract, scene.frame);
  for (const spec::Triangle& t : scene.triangles) renderer.draw(t, sink);
  *counters = renderer.counters();
  *buffer = renderer.buffer();
  return sink.record;
}

class RasterTopScenes : public RasterTopTiming, public testing::WithParamInterface<Kind> {};

TEST_P(RasterTopScenes, BitsAndCountersAreThoseOfCore) {
  uint64_t stamps = 0;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene = random_scene(GetParam(), 1000 + seed, 30);
    core::FrameCounters expected;
    core::FrameBuffer buffer;
    const Record tokens = core_record(scene, &expected, &buffer);
    const auto result = run(scene);
    ASSERT_EQ(difference(tokens, record_, false), "") << "seed " << seed;
    ASSERT_EQ(top_.buffer().depth, buffer.depth);
    ASSERT_EQ(top_.buffer().color, buffer.color);
    const core::FrameCounters& got = result.counters;
    for (const core::FrameCounter& row : core::kFrameCounters) {
      ASSERT_EQ(row.of(got), row.of(expected)) << row.name;
    }
    stamps += got.stamps;
  }
  EXPECT_GT(stamps, 200u);
}

TEST_P(RasterTopScenes, CausesOfEachUnitAddUpToTheFrame) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    // Each port is not ready in every third cycle, each in another one.
    top_.set_ready([seed](ExternalPort port, Cycle cycle) {
      return (cycle + static_cast<Cycle>(port)) % 3 != static_cast<Cycle>(seed % 3);
    });
    const auto result = run(random_scene(GetParam(), 2000 + seed, 30));
    for (const auto& unit : result.spent.units) {
      ASSERT_EQ(unit.total(), result.spent.drained);
      ASSERT_GE(*std::min_element(unit.spent.begin(), unit.spent.end()), 0);
    }
    for (const auto& levels : result.spent.levels) {
      ASSERT_EQ(std::accumulate(levels.begin(), levels.end(), Cycle{0}), result.spent.drained);
    }
    const core::FrameCounters& n = result.counters;
    ASSERT_EQ(result.of(Unit::kSetup)[Cause::kBusy], 6 * static_cast<Cycle>(n.triangles));
    ASSERT_EQ(result.of(Unit::kTiles)[Cause::kBusy], static_cast<Cycle>(n.tiles_tested));
    ASSERT_EQ(result.of(Unit::kInterpZtest)[Cause::kBusy], static_cast<Cycle>(n.stamps));
    ASSERT_GE(result.spent.drained, result.cycles);
  }
}

TEST_P(RasterTopScenes, FrameDoesNotDependOnTheFramesBefore) {
  const Scene scene = random_scene(GetParam(), 5, 40);
  const auto first = run(scene);
  const Record expected = record_;
  run(random_scene(Kind::kMixed, 6, 40));
  const auto again = run(scene);
  EXPECT_EQ(difference(expected, record_, true), "");
  EXPECT_EQ(first.cycles, again.cycles);
  EXPECT_EQ(first.counters.passed, again.counters.passed);
  EXPECT_EQ(first.of(Unit::kInterpZtest)[Cause::kHazard],
            again.of(Unit::kInterpZtest)[Cause::kHazard]);
}

void expect_same(const timing::FrameResult& got, const timing::FrameResult& expected) {
  EXPECT_EQ(got.cycles, expected.cycles);
  EXPECT_EQ(got.spent.drained, expected.spent.drained);
  for (size_t i = 0; i < timing::kUnits; ++i) {
    EXPECT_EQ(got.spent.units[i].spent, expected.spent.units[i].spent)
        << timing::unit_name(static_cast<Unit>(i));
  }
  EXPECT_EQ(got.spent.levels, expected.spent.levels);
  EXPECT_EQ(got.spent.stamps_by_samples, expected.spent.stamps_by_samples);
  EXPECT_EQ(got.spent.samples_passed, expected.spent.samples_passed);
  EXPECT_EQ(got.spent.samples_failed, expected.spent.samples_failed);
  for (const core::FrameCounter& row : core::kFrameCounters) {
    EXPECT_EQ(row.of(got.counters), row.of(expected.counters)) << row.name;
  }
}

class RasterTopGroups : public testing::TestWithParam<const char*> {};

// Small triangles among others, and dropped ones of each kind: those in memory are looked at sixteen at
// a time, with something left over at the end.
TEST_P(RasterTopGroups, TrianglesInMemoryAreTimedAsThoseThatComeOneByOne) {
  const spec::Contract contract = spec::contract(*spec::find_design(GetParam()));
  timing::RasterTop top("top", contract);
  uint64_t stamps = 0;
  for (const Kind kind : kKinds) {
    for (uint64_t seed = 0; seed < 6; ++seed) {
      const Scene scene = random_scene(kind, 3000 + seed, 75, contract);
      for (const bool bits : {false, true}) {
        top.set_bits(bits);
        const auto one_by_one = top.run(scene.frame, pull_from(scene));
        const core::FrameBuffer buffer = top.buffer();
        const auto in_memory = top.run(scene.frame, scene.triangles);
        expect_same(in_memory, one_by_one);
        if (bits) {
          EXPECT_EQ(top.buffer().color, buffer.color);
        }
        ASSERT_FALSE(HasFailure()) << kind_name(kind) << " " << seed;
        stamps += in_memory.counters.stamps;
      }
    }
  }
  EXPECT_GT(stamps, 1000u);
}
INSTANTIATE_TEST_SUITE_P(Designs, RasterTopGroups,
                         testing::Values("high_tile", "flat", "wide", "tiny", "persp"));

// Frames of one size, one after the other, in the same memory: with a listener, without one, and
// computing time only, where depths are cleared when they are first needed.
TEST_F(RasterTopTiming, EachFrameIsClearedToItsOwnDepth) {
  timing::RasterTop& top = top_;
  int passed = 0;
  for (const double depth : {1., .5, 0., .5, .25, 1.}) {
    for (const auto func : {spec::DepthFunc::kLess, spec::DepthFunc::kGreater}) {
      Scene scene = random_scene(Kind::kMedium, 9, 30);
      scene.frame = {60, 50, spec::Cull::kNone, func};
      scene.frame.clear_depth = depth;
      core::Renderer renderer(kContract, scene.frame);
      for (const spec::Triangle& t : scene.triangles) renderer.draw(t);
      const core::FrameBuffer& wanted = renderer.buffer();
      passed += renderer.counters().passed > 0 ? 1 : 0;
      top.set_bits(true);
      const auto direct = top.run(scene.frame, scene.triangles);
      EXPECT_EQ(top.buffer().depth, wanted.depth) << depth;
      EXPECT_EQ(top.buffer().color, wanted.color) << depth;
      EXPECT_EQ(run(scene).cycles, direct.cycles);
      EXPECT_EQ(top.buffer().depth, wanted.depth) << depth;
      top.set_bits(false);
      EXPECT_EQ(top.run(scene.frame, scene.triangles).cycles, direct.cycles) << depth;
    }
  }
  EXPECT_EQ(passed, 9);  // greater than the greatest or less than 0: none
}

INSTANTIATE_TEST_SUITE_P(Scenes, RasterTopScenes, testing::ValuesIn(kKinds),
                         [](const auto& p) { return kind_name(p.param); });

// With two slots nothing comes behind the first stamp of a tile until it is loaded, 66 cycles after
// it entered the FIFO; then there is room for the 15 others and the first one of the next tile.
// Without a listener too.
TEST(RasterTopPlanes, OfATileWaitForASlot) {
  spec::Design design = spec::kHighTile;
  design.plane_slots = 2;
  design.max_depth_latency_cycles = 64;
  timing::RasterTop top("top", spec::contract(design));
  top.set_depth_latency_cycles(64);
  const Scene scene{{64, 8}, {cover()}};
  Record record;
  Recorder recorder(&record);
  const auto watched = top.run(scene.frame, pull_from(scene), &recorder);
  ASSERT_EQ(record.colors.size(), 128u);
  for (size_t i = 0; i < 128; ++i) {
    const size_t wait = i % 16 == 0 ? 0 : 66;
    ASSERT_EQ(record.colors[i].cycle, 101 + i / 16 * 82 + i % 16 + wait) << i;
  }
  EXPECT_EQ(watched.of(Unit::kStamps)[Cause::kBlocked], 8 * 66);
  const auto alone = top.run(scene.frame, pull_from(scene), nullptr);
  EXPECT_EQ(alone.cycles, watched.cycles);
  EXPECT_EQ(alone.of(Unit::kStamps)[Cause::kBlocked], 8 * 66);
}

// ---- Errors

// SystemC reports on stdout, a death test listens to stderr.
void report_on_stderr() { dup2(STDERR_FILENO, STDOUT_FILENO); }

TEST_F(RasterTopTiming, LatencyOutsideItsRangeIsRefused) {
  EXPECT_THROW(top_.set_depth_latency_cycles(0), std::invalid_argument);
  EXPECT_THROW(top_.set_depth_latency_cycles(1025), std::invalid_argument);
  EXPECT_EQ(run({{2, 2}, {cover()}}).cycles, 46);  // still that of the design
}

TEST_F(RasterTopTiming, PortThatIsNeverReadyIsFatal) {
  top_.set_ready([](ExternalPort port, Cycle) { return port != ExternalPort::kColorWrite; });
  EXPECT_DEATH(
      {
        report_on_stderr();
        run({{2, 2}, {cover()}});
      },
      "pineda/port/stuck");
}

TEST(Unbound, EveryUnitSaysWhichPort) {
  EXPECT_DEATH(
      {
        report_on_stderr();
        timing::SetupUnit unit("unit", kContract);
        sc_core::sc_start();
      },
      "pineda/setup/unbound: unit.prim_o");
  EXPECT_DEATH(
      {
        report_on_stderr();
        timing::TraversalUnit unit("unit", kContract);
        sc_core::sc_start();
      },
      "pineda/traversal/unbound: unit.stamp_o");
  EXPECT_DEATH(
      {
        report_on_stderr();
        timing::InterpZtestUnit unit("unit", kContract);
        sc_core::sc_start();
      },
      "pineda/interp_ztest/unbound: unit.depth_io");
  EXPECT_DEATH(
      {
        report_on_stderr();
        timing::StampFifo fifo("fifo", 4);
        sc_core::sc_start();
      },
      "pineda/fifo/unbound: fifo.out_o");
}

}  // namespace
}  // namespace pineda::test
