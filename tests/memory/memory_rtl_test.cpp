// The Verilated RTL on memories of any timing: slower, never wrong.
#include <gtest/gtest.h>

#include "model/memory/dram_timing.h"
#include "model/memory/kinds.h"
#include "model/scene/scene.h"
#include "tb/scoreboard.h"

namespace pineda::tb {
namespace {

class MemoryRtl : public testing::Test {
 protected:
  MemoryRtl() {
    scene::Options options;
    options.size = scene::Size{120, 88};
    options.tessellate = 4;
    const scene::Scene scene = scene::open_scene(library_.contract(), "teapot", options);
    frame_ = scene.frame;
    for (spec::Triangle t; scene.source->next(&t);) triangles_.push_back(t);
  }

  NextTriangle triangles() const {
    return [this, i = size_t{0}](spec::Triangle* t) mutable {
      if (i == triangles_.size()) return false;
      *t = triangles_[i++];
      return true;
    };
  }

  // The cycles of the frame; every token at every boundary, and the memories, are those of core.
  Cycle run(std::shared_ptr<MemoryTiming> memory, StallMode mode = StallMode::kNone) {
    BenchOptions options;
    options.memory = std::move(memory);
    options.stall_mode = mode;
    options.seed = 5;
    FrameBench bench(library_, options);
    Cycle cycles[2];
    for (Cycle& c : cycles) {
      Scoreboard scoreboard("RTL", library_.contract(), frame_, triangles());
      c = bench.run(frame_, triangles(), &scoreboard).cycles;
      scoreboard.finish();
      EXPECT_EQ(scoreboard.first_divergence(), "");
      EXPECT_EQ(bench.buffer().depth, scoreboard.renderer().buffer().depth);
      EXPECT_EQ(bench.buffer().color, scoreboard.renderer().buffer().color);
    }
    // Stall patterns go on from frame to frame, so cycles repeat only without stalls; the memory
    // starts anew.
    if (mode == StallMode::kNone) {
      EXPECT_EQ(cycles[0], cycles[1]);
    }
    return cycles[0];
  }
  std::shared_ptr<MemoryTiming> make(memory::Kind kind) const {
    return memory::make_timing(kind, library_.contract(), 8);
  }

  RtlLibrary library_{spec::contract(spec::kHighTile)};
  spec::FrameState frame_;
  std::vector<spec::Triangle> triangles_;
};

TEST_F(MemoryRtl, DramIsSlowerThanIdealAndOneChannelSlowerThanTwo) {
  const Cycle ideal = run(make(memory::Kind::kIdeal));
  EXPECT_EQ(ideal, run(nullptr));  // the default's latency is 8, too
  const Cycle dram = run(make(memory::Kind::kDram));
  const Cycle merged = run(make(memory::Kind::kDramMerged));
  EXPECT_LT(ideal, dram);
  EXPECT_LT(dram, merged);
}

TEST_F(MemoryRtl, DramUnderEveryStall) {
  for (const StallMode mode : {StallMode::kSource, StallMode::kSink, StallMode::kBoth}) {
    run(make(memory::Kind::kDramMerged), mode);
  }
}

// Far beyond the latency at which the RTL keeps up: fills of hundreds of cycles, refreshes that
// take half of the time, hits that are answered in 150 cycles.
TEST_F(MemoryRtl, AnySlownessIsHarmless) {
  memory::DramParameters slow;
  slow.bus_bytes = 1;
  slow.refresh_interval_cycles = 700;
  slow.refresh_cycles = 350;
  slow.hit_latency_cycles = 150;
  slow.set_columns_log2 = slow.set_rows_log2 = 1;
  slow.merged = true;
  const auto timing = std::make_shared<memory::DramTiming>(library_.contract(), slow);
  EXPECT_GT(run(timing), run(make(memory::Kind::kDram)) * 2);
  EXPECT_GT(timing->depth_cache().write_backs, 50u);
  EXPECT_GT(timing->depth_channel().refresh_wait, 1000);
}

// The mutant: a memory that answers two reads in one cycle is not one that this bench can drive.
TEST_F(MemoryRtl, MemoryThatBreaksItsRulesIsNoticed) {
  class Twice final : public MemoryTiming {
   public:
    void begin_frame(const spec::FrameState&) override {}
    memory::Cycle ready_from(MemoryPort, memory::Cycle from) override { return from; }
    memory::Cycle accept(MemoryPort, memory::Cycle cycle, int, int) override {
      return (cycle / 8 + 1) * 8;
    }
  };
  BenchOptions options;
  options.memory = std::make_shared<Twice>();
  FrameBench bench(library_, options);
  EXPECT_THROW(bench.run(frame_, triangles(), nullptr), RtlError);
}

}  // namespace
}  // namespace pineda::tb
