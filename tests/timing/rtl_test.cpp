// The cycles of the model are those of the Verilated RTL, token by token, at every unit boundary.
#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <string>

#include "model/scene/scene.h"
#include "model/spec/clear_depth.h"
#include "model/spec/design_file.h"
#include "model/timing/counted/counters.h"
#include "tb/frame_bench.h"
#include "tb/ready.h"
#include "tests/timing/support.h"

namespace pineda::test {
namespace {

// Do each unit's causes and each FIFO's levels add up to the frame's cycles?
bool adds_up(const timing::CycleCounters& spent) {
  bool all = true;
  for (const auto& unit : spent.units) all = all && unit.total() == spent.drained;
  for (const auto& levels : spent.levels) {
    all = all && std::accumulate(levels.begin(), levels.end(), Cycle{0}) == spent.drained;
  }
  return all;
}

// Every counter that differs; empty if none.
std::string counters_that_differ(const spec::Contract& c, const timing::FrameResult& model,
                                 const timing::FrameResult& rtl) {
  std::string text;
  for (const auto& d :
       timing::counter_differences(timing::counter_list(c, model), timing::counter_list(c, rtl))) {
    text +=
        d.name + ": expected " + std::to_string(d.rtl) + ", got " + std::to_string(d.model) + "; ";
  }
  if (!adds_up(rtl.spent)) text += "the cycles of the RTL do not add up";
  return text;
}

// The first difference between RTL and model on a scene, each from reset; empty if none. The RTL
// has the memory latency of `options`, the model `model_latency`.
class Comparison {
 public:
  explicit Comparison(const spec::Contract& contract = kContract)
      : contract_(contract), library_(contract_) {}
  Comparison(const spec::Contract& contract, const std::string& plugin)
      : contract_(contract), library_(contract_, plugin) {}

  std::string run(const Scene& scene, const tb::BenchOptions& options, int model_latency) {
    tb::FrameBench bench(library_, options);
    Record expected;
    Record got;
    Recorder bench_recorder(&expected);
    Recorder model_recorder(&got);
    const auto rtl = bench.run(scene.frame, pull_from(scene), &bench_recorder);
    top_.set_depth_latency_cycles(model_latency);
    top_.set_ready(tb::ready_of({options.stall_mode, options.seed}));
    const auto model = top_.run(scene.frame, pull_from(scene), &model_recorder);
    stamps_ += expected.stamps.size();
    hidden_ += model.counters.tiles_hidden;
    for (const auto& counter : timing::counter_list(contract_, rtl)) {
      counted_[counter.name] += counter.count;
    }
    same_frame_ = same_frame_ && bench.buffer().depth == top_.buffer().depth &&
                  bench.buffer().color == top_.buffer().color;
    last_ = top_.buffer();
    if (const auto text = difference(expected, got, true, contract_); !text.empty()) return text;
    if (const auto text = result_that_differs(rtl, model); !text.empty()) return text;
    // Where nobody listens, values are computed in another way, and then time alone.
    const auto alone = top_.run(scene.frame, pull_from(scene));
    same_frame_ =
        same_frame_ && last_.depth == top_.buffer().depth && last_.color == top_.buffer().color;
    if (const auto text = result_that_differs(rtl, alone); !text.empty()) return "alone: " + text;
    top_.set_bits(false);
    const auto time = top_.run(scene.frame, pull_from(scene));
    top_.set_bits(true);
    return time.cycles == rtl.cycles ? "" : "time alone: " + std::to_string(time.cycles);
  }
  std::string run(const Scene& scene, const tb::BenchOptions& options) {
    return run(scene, options, options.depth_latency_cycles);
  }
  std::string result_that_differs(const timing::FrameResult& rtl,
                                  const timing::FrameResult& model) const {
    if (rtl.cycles == model.cycles) return counters_that_differ(contract_, model, rtl);
    return "frame: expected " + std::to_string(rtl.cycles) + " cycles, got " +
           std::to_string(model.cycles);
  }
  size_t stamps() const { return stamps_; }
  uint64_t hidden() const { return hidden_; }
  /// What the RTL counted in all runs together.
  int64_t counted(const std::string& name) const { return counted_.at(name); }
  /// Did RTL and model leave the same frame each time? last(): that of the last run.
  bool same_frame() const { return same_frame_; }
  const core::FrameBuffer& last() const { return last_; }

 private:
  spec::Contract contract_;
  tb::RtlLibrary library_;
  timing::RasterTop top_{"top", contract_};
  size_t stamps_ = 0;
  uint64_t hidden_ = 0;
  std::map<std::string, int64_t> counted_;
  bool same_frame_ = true;
  core::FrameBuffer last_;
};

class RtlCycles : public testing::TestWithParam<Kind> {};

TEST_P(RtlCycles, EqualWhenNothingStalls) {
  Comparison comparison;
  for (uint64_t seed = 0; seed < 24; ++seed) {
    static constexpr int kLatencies[] = {1, 2, 3, 8, 33, 64};
    tb::BenchOptions options;
    options.depth_latency_cycles = kLatencies[seed % 6];
    const Scene scene = random_scene(GetParam(), seed, 12 + static_cast<int>(seed) * 3);
    ASSERT_EQ(comparison.run(scene, options), "") << "seed " << seed;
  }
  EXPECT_GT(comparison.stamps(), 500u);
}

TEST_P(RtlCycles, EqualUnderTheSameStalls) {
  Comparison comparison;
  for (uint64_t seed = 0; seed < 24; ++seed) {
    tb::BenchOptions options;
    options.depth_latency_cycles = 1 + static_cast<int>(seed * 17 % 64);
    options.stall_mode = tb::kStallModes[1 + seed % 3];
    options.seed = seed;
    const Scene scene = random_scene(GetParam(), 100 + seed, 10 + static_cast<int>(seed) * 2);
    ASSERT_EQ(comparison.run(scene, options), "") << "seed " << seed;
  }
  EXPECT_GT(comparison.stamps(), 400u);
}

INSTANTIATE_TEST_SUITE_P(Scenes, RtlCycles, testing::ValuesIn(kKinds),
                         [](const auto& p) { return kind_name(p.param); });

TEST(RtlLatency, EqualAtEveryLatency) {
  Comparison comparison;
  tb::BenchOptions options;
  for (int latency = 1; latency <= 64; ++latency) {
    options.depth_latency_cycles = latency;
    const Scene scene = random_scene(Kind::kMixed, static_cast<uint64_t>(latency), 20);
    ASSERT_EQ(comparison.run(scene, options), "") << "latency " << latency;
  }
}

class RtlDesigns : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(, RtlDesigns,
                         testing::Values("low", "med", "div28", "persp", "flat", "wide", "tiny"),
                         [](const auto& p) { return std::string(p.param); });

TEST_P(RtlDesigns, EqualAtEveryLatencyUnderEveryStall) {
  const spec::Contract contract = spec::contract(*spec::find_design(GetParam()));
  Comparison comparison(contract);
  uint64_t seed = 0;
  for (const int latency : {1, 8, contract.design.max_depth_latency_cycles, 100}) {
    for (const tb::StallMode mode : tb::kStallModes) {
      for (const Kind kind : kKinds) {
        tb::BenchOptions options;
        options.depth_latency_cycles = latency;
        options.stall_mode = mode;
        options.seed = ++seed;
        Scene scene = random_scene(kind, seed, 20, contract);
        scene.triangles[10].v[1] = scene.triangles[10].v[2];  // no area
        ASSERT_EQ(comparison.run(scene, options), "")
            << kind_name(kind) << ", latency " << latency << ", " << tb::stall_mode_name(mode);
      }
    }
  }
  EXPECT_GT(comparison.stamps(), 5000u);
  // Agreeing counters show nothing if they are 0.
  for (const char* name : {"dropped.zero_area", "dropped.facing", "dropped.no_sample",
                           "dropped.outside", "setup.blocked", "tiles.blocked", "coverage.blocked",
                           "stamps.blocked", "interp_ztest.starved", "tiles_rejected",
                           "tiles_accepted", "stamps.level_1", "color_write.stalls"}) {
    EXPECT_GT(comparison.counted(name), 0) << name;
  }
  if (!contract.design.depth_test) return;
  for (const char* name : {"interp_ztest.memory", "interp_ztest.hazard", "interp_ztest.blocked",
                           "depth_read.stalls", "depth_write.stalls", "samples_failed"}) {
    // With two slots for planes a tile waits for all stamps before it, so their addresses are free.
    const bool never =
        name == std::string("interp_ztest.hazard") && contract.design.plane_slots == 2;
    EXPECT_EQ(comparison.counted(name) > 0, !never) << name;
  }
}

// Cleared depths for each depth function. Every third triangle lies at the cleared depth.
std::vector<Scene> cleared_scenes() {
  std::vector<Scene> all;
  for (const double depth : {0., .5, 1.}) {
    for (int func = 0; func < 9; ++func) {
      Scene scene = random_scene(Kind::kMedium, all.size(), 24);
      scene.frame.width = 70;
      scene.frame.depth = static_cast<spec::DepthFunc>(func);
      scene.frame.clear_depth = depth;
      for (size_t i = 0; i < scene.triangles.size(); i += 3) {
        for (auto& v : scene.triangles[i].v) {
          v.z = int64_t{spec::cleared_depth(spec::kHighTile, scene.frame)} << 8;
        }
      }
      all.push_back(scene);
    }
  }
  return all;
}

TEST(RtlClearDepth, EqualInEveryDepthFunctionUnderEveryStall) {
  Comparison comparison;
  for (const tb::StallMode mode : tb::kStallModes) {
    tb::BenchOptions options;
    options.stall_mode = mode;
    options.seed = 5;
    for (const Scene& scene : cleared_scenes()) {
      ASSERT_EQ(comparison.run(scene, options), "")
          << static_cast<int>(scene.frame.depth) << " on " << scene.frame.clear_depth;
    }
  }
  EXPECT_TRUE(comparison.same_frame());
  EXPECT_GT(comparison.counted("samples_passed"), 1000);
  EXPECT_GT(comparison.counted("samples_failed"), 1000);
}

// The end of a frame is accepted in the cycle in which, by the model, the pipeline has drained. The
// next frame is offered in the cycle after.
TEST(RtlFrames, DrainedCyclesPlaceTheNextFrame) {
  const tb::RtlLibrary library(kContract);
  tb::FrameBench bench(library, {});
  timing::RasterTop top("top", kContract);
  Cycle start = 0;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene = random_scene(kKinds[seed % 7], seed, static_cast<int>(seed % 5) * 6);
    Record expected;
    Record got;
    Recorder bench_recorder(&expected, start);
    Recorder model_recorder(&got);
    const auto rtl = bench.run(scene.frame, pull_from(scene), &bench_recorder);
    const auto model = top.run(scene.frame, pull_from(scene), &model_recorder);
    ASSERT_EQ(difference(expected, got, true), "") << "seed " << seed;
    ASSERT_EQ(rtl.cycles, model.cycles) << "seed " << seed;
    ASSERT_EQ(counters_that_differ(kContract, model, rtl), "") << "seed " << seed;
    start += model.spent.drained + 1;
  }
}

TEST(RtlLatency, OneCycleLessInTheModelIsNoticed) {
  Comparison comparison;
  tb::BenchOptions options;
  options.depth_latency_cycles = 9;
  const Scene scene = random_scene(Kind::kMedium, 3, 20);
  EXPECT_NE(comparison.run(scene, options, 8), "");
}

// The mutant RTL counts coverage that waits as busy; its other faults do not show on this scene.
// Exactly the two wrong counters are named.
TEST(RtlCountersMutant, BlockedCountedAsBusyIsNoticed) {
  const tb::RtlLibrary library(kContract, PINEDA_RTL_MUTANT);
  tb::BenchOptions options;
  options.stall_mode = tb::StallMode::kSink;
  tb::FrameBench bench(library, options);
  timing::RasterTop top("top", kContract);
  top.set_ready(tb::ready_of({options.stall_mode, options.seed}));
  const Scene scene = random_scene(Kind::kMedium, 3, 20);
  const auto rtl = bench.run(scene.frame, pull_from(scene), nullptr);
  const auto model = top.run(scene.frame, pull_from(scene));
  const auto differences = timing::counter_differences(timing::counter_list(kContract, model),
                                                       timing::counter_list(kContract, rtl));
  ASSERT_EQ(differences.size(), 2u) << counters_that_differ(kContract, model, rtl);
  EXPECT_EQ(differences[0].name, "coverage.busy");
  EXPECT_EQ(differences[1].name, "coverage.blocked");
  EXPECT_EQ(differences[1].rtl, 0);
}

// The mutant: the model divides two bits a cycle, which gives other cycles and the same bits.
TEST(RtlDesignsMutant, QuickerReciprocalInTheModelIsNoticed) {
  const spec::Design div28 = *spec::find_design("div28");
  spec::Design quicker = div28;
  quicker.reciprocal_scheme = spec::ReciprocalScheme::kRestoring4;
  const tb::RtlLibrary library(spec::contract(div28));
  tb::FrameBench bench(library, {});
  timing::RasterTop top("top", spec::contract(quicker));
  const Scene scene = random_scene(Kind::kMedium, 3, 20);
  Record expected;
  Record got;
  Recorder bench_recorder(&expected);
  Recorder model_recorder(&got);
  bench.run(scene.frame, pull_from(scene), &bench_recorder);
  top.run(scene.frame, pull_from(scene), &model_recorder);
  EXPECT_EQ(difference(expected, got, false, library.contract()), "");
  EXPECT_NE(difference(expected, got, true, library.contract()).find("expected in cycle"),
            std::string::npos);
}

// ---- Hierarchical z

const spec::Contract& hidden_contract() {
  static const spec::Contract contract =
      spec::contract(spec::read_design(PINEDA_RASTER_DESIGNS "/hidden.toml"));
  return contract;
}

Scene layers(int width, int height) {
  scene::Options options;
  options.size = scene::Size{width, height};
  const scene::Scene scene = scene::open_scene(hidden_contract(), "layers", options);
  Scene result{scene.frame, {}};
  for (spec::Triangle t; scene.source->next(&t);) result.triangles.push_back(t);
  return result;
}

class Hidden : public testing::Test {
 protected:
  Comparison comparison_{hidden_contract(), PINEDA_RASTER_PLUGINS "/hidden.so"};
};

TEST_F(Hidden, CyclesAndTokensAreEqualAtEveryLatencyUnderEveryStall) {
  uint64_t seed = 0;
  for (const int latency : {1, 8, 64}) {
    for (const tb::StallMode mode : tb::kStallModes) {
      tb::BenchOptions options;
      options.depth_latency_cycles = latency;
      options.stall_mode = mode;
      options.seed = ++seed;
      for (const Kind kind : kKinds) {
        const Scene scene = random_scene(kind, seed, 20);
        ASSERT_EQ(comparison_.run(scene, options), "")
            << kind_name(kind) << ", latency " << latency << ", " << tb::stall_mode_name(mode);
      }
      // More tiles than hierarchical z keeps, and borders that cut tiles and stamps.
      ASSERT_EQ(comparison_.run(layers(93, 61), options), "") << latency;
    }
  }
  EXPECT_TRUE(comparison_.same_frame());
  EXPECT_GT(comparison_.hidden(), 1000u);
}

// If the frame is cleared to the middle, tiles behind it are hidden from the start; the functions
// of reversed z hide none. The frames are those of the design without hierarchical z.
TEST_F(Hidden, EqualOnEveryClearedDepthInEveryDepthFunctionUnderEveryStall) {
  for (const tb::StallMode mode : tb::kStallModes) {
    tb::BenchOptions options;
    options.stall_mode = mode;
    options.seed = 6;
    std::vector<Scene> scenes = cleared_scenes();
    for (const auto func : {spec::DepthFunc::kLess, spec::DepthFunc::kGreater}) {
      for (const double depth : {0., .3, .7}) {
        scenes.push_back(layers(93, 61));
        scenes.back().frame.depth = func;
        scenes.back().frame.clear_depth = depth;
      }
    }
    for (const Scene& scene : scenes) {
      const uint64_t before = comparison_.hidden();
      ASSERT_EQ(comparison_.run(scene, options), "")
          << static_cast<int>(scene.frame.depth) << " on " << scene.frame.clear_depth;
      if (scene.frame.depth > spec::DepthFunc::kLequal) {
        EXPECT_EQ(comparison_.hidden(), before);
      }
      core::Renderer renderer(kContract, scene.frame);
      for (const spec::Triangle& t : scene.triangles) renderer.draw(t);
      EXPECT_EQ(comparison_.last().depth, renderer.buffer().depth);
      EXPECT_EQ(comparison_.last().color, renderer.buffer().color);
    }
  }
  EXPECT_TRUE(comparison_.same_frame());
  EXPECT_GT(comparison_.hidden(), 1000u);
}

// The frame is that of the design without hierarchical z, and fewer stamps are sent.
TEST_F(Hidden, LeavesTheSameFrameAndSendsFewerStamps) {
  const Scene scene = layers(60, 40);
  ASSERT_EQ(comparison_.run(scene, {}), "");
  core::Renderer renderer(kContract, scene.frame);
  for (const spec::Triangle& t : scene.triangles) renderer.draw(t);
  EXPECT_EQ(comparison_.last().depth, renderer.buffer().depth);
  EXPECT_EQ(comparison_.last().color, renderer.buffer().color);
  EXPECT_GT(comparison_.hidden(), 100u);
  EXPECT_LT(comparison_.stamps(), renderer.counters().stamps * 3 / 4);
}

// The mutant: a model that sees written depths some cycles later. One tile is drawn repeatedly; all
// but the first time it lies behind the stored depth.
TEST(HiddenMutant, LongerDelayInTheModelIsNoticed) {
  spec::Design slower = hidden_contract().design;
  slower.hierarchical_z_delay_cycles += 12;
  const tb::RtlLibrary library(hidden_contract(), PINEDA_RASTER_PLUGINS "/hidden.so");
  tb::FrameBench bench(library, {});
  timing::RasterTop top("top", spec::contract(slower));
  Scene scene{{8, 8}, {}};
  for (int i = 0; i < 12; ++i) {
    scene.triangles.push_back(flat_triangle(-1, -1, 40, -1, -1, 40, i == 0 ? 1 << 20 : 1 << 22));
  }
  Record expected;
  Record got;
  Recorder bench_recorder(&expected);
  Recorder model_recorder(&got);
  bench.run(scene.frame, pull_from(scene), &bench_recorder);
  top.run(scene.frame, pull_from(scene), &model_recorder);
  EXPECT_LT(expected.stamps.size(), got.stamps.size());
}

// The mutant: a model that takes every frame as cleared to the greatest depth. The tile lies behind
// the cleared depth.
TEST(HiddenMutant, GreatestClearedDepthInTheModelIsNoticed) {
  const tb::RtlLibrary library(hidden_contract(), PINEDA_RASTER_PLUGINS "/hidden.so");
  tb::FrameBench bench(library, {});
  timing::RasterTop top("top", hidden_contract());
  Scene scene{{8, 8}, {flat_triangle(-1, -1, 40, -1, -1, 40, 3 << 22)}};
  scene.frame.clear_depth = .5;
  Record expected;
  Record got;
  Recorder bench_recorder(&expected);
  Recorder model_recorder(&got);
  bench.run(scene.frame, pull_from(scene), &bench_recorder);
  scene.frame.clear_depth = 1;
  top.run(scene.frame, pull_from(scene), &model_recorder);
  EXPECT_EQ(expected.stamps.size(), 0u);
  EXPECT_EQ(got.stamps.size(), 16u);
}

}  // namespace
}  // namespace pineda::test
