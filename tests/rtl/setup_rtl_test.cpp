// The setup unit's RTL in every style, alone: its bits against core, its cycles against the model
// of timing.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "Vsetup_flat.h"
#include "Vsetup_high_tile.h"
#include "Vsetup_late_vertex.h"
#include "Vsetup_least_slope.h"
#include "Vsetup_persp.h"
#include "Vsetup_pipelined_affine.h"
#include "Vsetup_pipelined_edges.h"
#include "Vsetup_pipelined_persp.h"
#include "Vsetup_pipelined_z16.h"
#include "Vsetup_pipelined_z32.h"
#include "Vsetup_rom.h"
#include "Vsetup_serial_affine.h"
#include "Vsetup_serial_high.h"
#include "Vsetup_serial_persp.h"
#include "Vsetup_serial_z16.h"
#include "Vsetup_serial_z32.h"
#include "Vsetup_slow_affine.h"
#include "Vsetup_slow_edges.h"
#include "Vsetup_slow_persp.h"
#include "Vsetup_slow_z32.h"
#include "Vsetup_stepped_affine.h"
#include "Vsetup_stepped_z32.h"
#include "Vsetup_tiny.h"
#include "Vsetup_wide.h"
#include "Vsetup_wide_scissor.h"
#include "model/timing/units/setup_unit.h"
#include "tests/rtl/setup_bench.h"

namespace pineda::tb {
namespace {

using timing::Cycle;

// A module and its design.
template <class Model>
struct Of;
#define SETUP(name)                               \
  template <>                                     \
  struct Of<Vsetup_##name> {                      \
    static constexpr const char* kDesign = #name; \
  };
SETUP(rom)
SETUP(high_tile)
SETUP(persp)
SETUP(flat)
SETUP(wide)
SETUP(tiny)
SETUP(stepped_z32)
SETUP(stepped_affine)
SETUP(pipelined_z32)
SETUP(pipelined_z16)
SETUP(pipelined_affine)
SETUP(pipelined_persp)
SETUP(pipelined_edges)
SETUP(slow_z32)
SETUP(slow_affine)
SETUP(slow_persp)
SETUP(slow_edges)
SETUP(serial_z32)
SETUP(serial_z16)
SETUP(serial_high)
SETUP(serial_affine)
SETUP(serial_persp)
#undef SETUP
using SetupModels =
    testing::Types<Vsetup_rom, Vsetup_high_tile, Vsetup_persp, Vsetup_flat, Vsetup_wide,
                   Vsetup_tiny, Vsetup_stepped_z32, Vsetup_stepped_affine, Vsetup_pipelined_z32,
                   Vsetup_pipelined_z16, Vsetup_pipelined_affine, Vsetup_pipelined_persp,
                   Vsetup_pipelined_edges, Vsetup_slow_z32, Vsetup_slow_affine, Vsetup_slow_persp,
                   Vsetup_slow_edges, Vsetup_serial_z32, Vsetup_serial_z16, Vsetup_serial_high,
                   Vsetup_serial_affine, Vsetup_serial_persp>;

template <class Model>
class SetupRtl : public testing::Test {
 protected:
  const spec::Contract contract_ = contract_of(Of<Model>::kDesign);
};
struct DesignName {
  template <class Model>
  static std::string GetName(int) {
    return Of<Model>::kDesign;
  }
};
TYPED_TEST_SUITE(SetupRtl, SetupModels, DesignName);

// How many of 60 scenes differ from core: without stalls, with stalls of source, of sink, of both.
template <class Model>
int wrong_scenes(const spec::Contract& contract, size_t* prims = nullptr) {
  int wrong = 0;
  for (uint64_t seed = 0; seed < 60; ++seed) {
    const SetupScene scene = random_setup_scene(contract, seed, 40);
    const Script script = random_script(contract, seed, seed % 2 != 0, seed % 4 >= 2, 40);
    const SetupRun run = run_setup<Model>(contract, scene, script);
    wrong += run.prims == expected_prims(contract, scene) ? 0 : 1;
    if (prims != nullptr) *prims += run.prims.size();
  }
  return wrong;
}

TYPED_TEST(SetupRtl, BitsMatchCoreUnderStalls) {
  size_t prims = 0;
  EXPECT_EQ(wrong_scenes<TypeParam>(this->contract_, &prims), 0);
  EXPECT_GT(prims, 500u);
}

// Takes primitive i from takes[i] on.
class Sink final : public timing::StreamOut<spec::SetupPrim> {
 public:
  explicit Sink(const Script& script) : script_(script) {}
  Cycle push(const spec::SetupPrim&, Cycle earliest) override {
    taken.push_back(std::max(earliest, script_.takes[taken.size()]));
    return taken.back();
  }

  std::vector<Cycle> taken;

 private:
  const Script& script_;
};

/// A unit of the timing model, its script, and what the RTL did under it.
template <class Model>
class Timed {
 public:
  Timed(const spec::Contract& contract, const spec::Contract& timed_as, uint64_t seed, bool source,
        bool sink)
      : scene_(random_setup_scene(contract, seed, 300)),
        script_(random_script(contract, seed, source, sink, 300)),
        rtl_(run_setup<Model>(contract, scene_, script_)),
        sink_(script_),
        unit_(sc_core::sc_gen_unique_name("setup"), timed_as) {
    unit_.prim_o(sink_);
    frame_.state = scene_.frame;
  }

  const SetupRun& rtl() const { return rtl_; }
  /// After sc_start(). Triangle i is offered from offers[i] on.
  SetupRun model() {
    unit_.begin_frame(&frame_);
    std::vector<Cycle> taken;
    for (const spec::Triangle& triangle : scene_.triangles) {
      taken.push_back(unit_.take(triangle, script_.offers[taken.size()]));
    }
    return {{}, taken, sink_.taken, unit_.idle_from()};
  }

 private:
  SetupScene scene_;
  Script script_;
  SetupRun rtl_;
  Sink sink_;
  timing::Frame frame_;
  timing::SetupUnit unit_;
};

TYPED_TEST(SetupRtl, CyclesMatchTheModelUnderStalls) {
  std::vector<std::unique_ptr<Timed<TypeParam>>> all;
  for (uint64_t seed = 0; seed < 12; ++seed) {
    all.push_back(std::make_unique<Timed<TypeParam>>(this->contract_, this->contract_, seed,
                                                     seed % 2 != 0, seed % 4 >= 2));
  }
  sc_core::sc_start();
  size_t prims = 0;
  for (const auto& one : all) {
    const SetupRun model = one->model();
    EXPECT_TRUE(one->rtl().same_cycles(model));
    EXPECT_EQ(one->rtl().idle_from, model.idle_from);
    prims += one->rtl().taken.size();
  }
  EXPECT_GT(prims, 500u);
}

// The sink is always ready.
TYPED_TEST(SetupRtl, TakesTheDerivedIntervalAndLatency) {
  SetupScene scene;
  scene.frame.width = scene.frame.height = 16;
  spec::Triangle t;
  const int px = 1 << this->contract_.design.subpixel_bits;
  t.v[1].x = t.v[2].y = 8 * px;
  for (spec::Vertex& v : t.v) v.inverse_w = 1 << (this->contract_.design.inverse_w_bits - 1);
  scene.triangles.assign(20, t);
  const Script script{std::vector<int64_t>(21, 0), std::vector<int64_t>(21, 0)};
  const SetupRun run = run_setup<TypeParam>(this->contract_, scene, script);
  const spec::Widths& width = this->contract_.width;
  ASSERT_EQ(run.taken.size(), 20u);
  for (size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(run.accepted[i], static_cast<int64_t>(i) * width.setup_interval_cycles);
    EXPECT_EQ(run.taken[i], run.accepted[i] + width.setup_latency_cycles);
  }
}

TEST(SetupRtlMutant, LesserOfTwoSlopesIsCaught) {
  EXPECT_GT(wrong_scenes<Vsetup_least_slope>(contract_of("high_tile")), 0);
}

TEST(SetupRtlMutant, ScissorAPixelTooWideIsCaught) {
  EXPECT_GT(wrong_scenes<Vsetup_wide_scissor>(contract_of("flat")), 0);
}

TEST(SetupRtlMutant, FlatShadingByTheAnchorIsCaught) {
  EXPECT_GT(wrong_scenes<Vsetup_late_vertex>(contract_of("tiny")), 0);
}

TEST(SetupRtlMutant, CycleLessInTheModelIsNoticed) {
  const spec::Contract wide = contract_of("wide");
  spec::Contract quicker = wide;
  --quicker.width.setup_latency_cycles;
  Timed<Vsetup_wide> one(wide, quicker, 1, true, true);
  sc_core::sc_start();
  EXPECT_FALSE(one.rtl().same_cycles(one.model()));
}

}  // namespace
}  // namespace pineda::tb
