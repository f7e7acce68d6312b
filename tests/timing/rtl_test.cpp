// The cycles of the model are those of the Verilated RTL, token by token, at every unit boundary.
#include <gtest/gtest.h>

#include "model/scene/scene.h"
#include "model/spec/design_file.h"
#include "tb/frame_bench.h"
#include "tests/timing/support.h"

namespace pineda::test {
namespace {

using BenchRecorder = Recorder<tb::Listener, uint64_t>;

// The stalls of the benches, as the model takes them.
timing::Ready ready_of(const tb::Stalls& stalls) {
  return [stalls](timing::ExternalPort port, Cycle cycle) {
    static constexpr tb::Port kPorts[] = {tb::Port::kTriangle, tb::Port::kClear,
                                          tb::Port::kDepthRead, tb::Port::kDepthWrite,
                                          tb::Port::kColorWrite};
    return !stalls(kPorts[static_cast<int>(port)], static_cast<uint64_t>(cycle));
  };
}

// The first difference between RTL and model on a scene, each as after a reset; empty if none. The
// RTL runs with the memory latency of `options`, the model with `model_latency`.
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
    BenchRecorder bench_recorder(&expected);
    ModelRecorder model_recorder(&got);
    const auto rtl = bench.run(scene.frame, pull_from(scene), &bench_recorder);
    top_.set_depth_latency_cycles(model_latency);
    top_.set_ready(ready_of({options.stall_mode, options.seed}));
    const auto model = top_.run(scene.frame, pull_from(scene), &model_recorder);
    stamps_ += expected.stamps.size();
    hidden_ += model.counters.tiles_hidden;
    same_frame_ = same_frame_ && bench.buffer().depth == top_.buffer().depth &&
                  bench.buffer().color == top_.buffer().color;
    last_ = top_.buffer();
    if (const auto text = difference(expected, got, true, contract_); !text.empty()) return text;
    if (rtl.cycles == static_cast<uint64_t>(model.cycles)) return {};
    return "frame: expected " + std::to_string(rtl.cycles) + " cycles, got " +
           std::to_string(model.cycles);
  }
  std::string run(const Scene& scene, const tb::BenchOptions& options) {
    return run(scene, options, options.depth_latency_cycles);
  }
  size_t stamps() const { return stamps_; }
  uint64_t hidden() const { return hidden_; }
  /// Whether RTL and model left the same frame each time; the last one.
  bool same_frame() const { return same_frame_; }
  const core::FrameBuffer& last() const { return last_; }

 private:
  spec::Contract contract_;
  tb::RtlLibrary library_;
  timing::RasterTop top_{"top", contract_};
  size_t stamps_ = 0;
  uint64_t hidden_ = 0;
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
  for (const int latency : {1, 8, contract.design.max_depth_latency_cycles}) {
    for (const tb::StallMode mode : tb::kStallModes) {
      for (const Kind kind : kKinds) {
        tb::BenchOptions options;
        options.depth_latency_cycles = latency;
        options.stall_mode = mode;
        options.seed = ++seed;
        const Scene scene = random_scene(kind, seed, 20, contract);
        ASSERT_EQ(comparison.run(scene, options), "")
            << kind_name(kind) << ", latency " << latency << ", " << tb::stall_mode_name(mode);
      }
    }
  }
  EXPECT_GT(comparison.stamps(), 5000u);
}

// The end of a frame is taken in the cycle in which the model says that the pipeline has drained,
// and the next frame is offered in the one after.
TEST(RtlFrames, DrainedCyclesPlaceTheNextFrame) {
  const tb::RtlLibrary library(kContract);
  tb::FrameBench bench(library, {});
  timing::RasterTop top("top", kContract);
  uint64_t start = 0;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene = random_scene(kKinds[seed % 7], seed, static_cast<int>(seed % 5) * 6);
    Record expected;
    Record got;
    BenchRecorder bench_recorder(&expected, start);
    ModelRecorder model_recorder(&got);
    const auto rtl = bench.run(scene.frame, pull_from(scene), &bench_recorder);
    const auto model = top.run(scene.frame, pull_from(scene), &model_recorder);
    ASSERT_EQ(difference(expected, got, true), "") << "seed " << seed;
    ASSERT_EQ(rtl.cycles, static_cast<uint64_t>(model.cycles)) << "seed " << seed;
    start += static_cast<uint64_t>(model.drained_cycles) + 1;
  }
}

TEST(RtlLatency, OneCycleLessInTheModelIsNoticed) {
  Comparison comparison;
  tb::BenchOptions options;
  options.depth_latency_cycles = 9;
  const Scene scene = random_scene(Kind::kMedium, 3, 20);
  EXPECT_NE(comparison.run(scene, options, 8), "");
}

// The same design but for a division of two bits a cycle: other cycles, the same bits.
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
  BenchRecorder bench_recorder(&expected);
  ModelRecorder model_recorder(&got);
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
      // More tiles than are kept, borders that cut tiles and stamps.
      ASSERT_EQ(comparison_.run(layers(93, 61), options), "") << latency;
    }
  }
  EXPECT_TRUE(comparison_.same_frame());
  EXPECT_GT(comparison_.hidden(), 1000u);
}

// The frame is that of the design without it, and fewer stamps are sent.
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

// A model that sees depths some cycles later is noticed: one tile again and again, all but the
// first time behind what is there.
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
  BenchRecorder bench_recorder(&expected);
  ModelRecorder model_recorder(&got);
  bench.run(scene.frame, pull_from(scene), &bench_recorder);
  top.run(scene.frame, pull_from(scene), &model_recorder);
  EXPECT_LT(expected.stamps.size(), got.stamps.size());
}

}  // namespace
}  // namespace pineda::test
