// Traversal and interpolation with depth test in every kind of design: random tokens against the
// model, under every stall mode, in every raster state.
#include <tuple>

#include "model/core/interp.h"
#include "tests/rtl/support.h"

namespace pineda::tb {
namespace {

using spec::DepthFunc;

constexpr size_t kTrianglesPerRun = 400;

// Stamps, and memories in which some of them are already drawn, so that some depths are equal.
struct Drawing {
  spec::FrameState frame;
  std::vector<spec::Stamp> stamps;
  core::FrameBuffer memory;
};

// The writes that the model makes; *memory as they leave it.
vectors::InterpZtestCase model_writes(const spec::Contract& c, const Drawing& drawing,
                                      core::FrameBuffer* memory) {
  vectors::InterpZtestCase result{"random", drawing.frame, {}, {}, {}};
  for (const spec::Stamp& stamp : drawing.stamps) {
    spec::Fragment fragment;
    core::interpolate_depth(c, stamp, &fragment);
    const auto stored = memory->read(c, stamp.x, stamp.y, stamp.mask);
    const uint32_t passed =
        core::depth_test(c, drawing.frame.depth, stamp.mask, fragment.z, stored.z);
    if (passed == 0) continue;
    core::interpolate_attributes(c, stamp, passed, &fragment);
    if (core::tests_depth(c, drawing.frame) && drawing.frame.depth_write) {
      result.depth.push_back(core::depth_write(c, stamp, fragment, passed));
      memory->write(c, result.depth.back());
    }
    result.color.push_back(core::color_write(c, stamp, fragment, passed));
    memory->write(c, result.color.back());
  }
  return result;
}

Drawing random_drawing(spec::Random* random, const spec::Contract& c, DepthFunc func) {
  const auto traversal = random_traversal(random, c, 40, 16, kTrianglesPerRun);
  Drawing drawing{traversal.frame, {}, core::FrameBuffer(c, traversal.frame)};
  const auto part = static_cast<std::ptrdiff_t>(random->between(0, 300));
  const auto last = std::min(traversal.out.begin() + part, traversal.out.end());
  drawing.stamps.assign(traversal.out.begin(), last);
  drawing.frame.depth = DepthFunc::kAlways;
  model_writes(c, drawing, &drawing.memory);
  drawing.stamps = traversal.out;
  drawing.frame.depth = func;
  return drawing;
}

// The first difference between the RTL's writes in `drawing` and the model's in `expected`.
std::string difference_of(InterpZtestBench* bench, const spec::Contract& c, const Drawing& drawing,
                          const Drawing& expected, size_t* writes = nullptr) {
  core::FrameBuffer memory = expected.memory;
  const auto model = model_writes(c, expected, &memory);
  if (writes != nullptr) *writes += model.color.size();
  vectors::InterpZtestCase got{"random", drawing.frame, {}, {}, {}};
  auto written = bench->run_on(PagedBuffer(c, drawing.memory), drawing.frame, drawing.stamps);
  got.depth = std::move(written.depth.tokens);
  got.color = std::move(written.color.tokens);
  if (const auto text = vectors::difference(c, model, got)) return *text;
  return bench->buffer().depth == memory.depth && bench->buffer().color == memory.color
             ? ""
             : "memories differ";
}

class RasterRtl : public testing::TestWithParam<std::tuple<const char*, StallMode>> {
 protected:
  const RtlLibrary& library() const { return raster_rtl(std::get<0>(GetParam())); }
  const spec::Contract& contract() const { return library().contract(); }
  BenchOptions options(int latency_cycles) {
    BenchOptions o;
    o.stall_mode = std::get<1>(GetParam());
    o.seed = random_.bits();
    o.depth_latency_cycles = latency_cycles;
    return o;
  }

  spec::Random random_{606};
};
INSTANTIATE_TEST_SUITE_P(, RasterRtl,
                         testing::Combine(testing::ValuesIn(kRasterDesigns),
                                          testing::ValuesIn(kStallModes)),
                         [](const auto& p) {
                           return std::string(std::get<0>(p.param)) + "_" +
                                  stall_mode_name(std::get<1>(p.param));
                         });

TEST_P(RasterRtl, TraversalMatchesModel) {
  TraversalBench bench(library(), options(1));
  for (const int size_px : {4, 16, 120, 900}) {
    const auto expected = random_traversal(&random_, contract(), 300, size_px, kTrianglesPerRun);
    ASSERT_EQ(first_difference(&bench, expected, contract()), "") << size_px << " px";
  }
}

TEST_P(RasterRtl, InterpZtestMatchesModelInEveryRasterState) {
  for (const int latency_cycles : {1, 8, contract().design.max_depth_latency_cycles, 100}) {
    InterpZtestBench bench(library(), options(latency_cycles));
    for (int func = 0; func < 9; ++func) {
      const Drawing drawing = random_drawing(&random_, contract(), static_cast<DepthFunc>(func));
      ASSERT_EQ(difference_of(&bench, contract(), drawing, drawing), "")
          << latency_cycles << " cycles, depth function " << func;
    }
  }
}

// The same stamp repeatedly, back to back: each must see what the one before wrote.
TEST_P(RasterRtl, OneStampAgainAndAgain) {
  const spec::Contract& c = contract();
  for (const auto func : {DepthFunc::kLess, DepthFunc::kLequal, DepthFunc::kNotequal}) {
    vectors::SetupCase setup;
    setup.frame.width = setup.frame.height = 2;
    setup.frame.depth = func;
    setup.in = random_triangles(&random_, setup.frame, 6, kTrianglesPerRun, c);
    const vectors::TraversalCase traversal{"", setup.frame, vectors::run_model(c, setup).out, {}};
    const Drawing drawing{setup.frame, vectors::run_model(c, traversal).out,
                          core::FrameBuffer(c, setup.frame)};
    InterpZtestBench bench(library(), options(8));
    size_t writes = 0;
    EXPECT_EQ(difference_of(&bench, c, drawing, drawing, &writes), "");
    EXPECT_GT(writes, 4u);
  }
}

// The mutants: RTL in one state, model in another; one drawing of ten must show it.
class RasterRtlMutant : public testing::Test {
 protected:
  Drawing drawing(const spec::Contract& c, DepthFunc func) {
    Drawing d = random_drawing(&random_, c, func);
    while (d.stamps.size() < 200) d = random_drawing(&random_, c, func);
    d.frame.depth_write = true;
    return d;
  }
  template <class Change>
  bool is_seen(InterpZtestBench* bench, const spec::Contract& c, DepthFunc func, Change&& change) {
    for (int i = 0; i < 10; ++i) {
      const Drawing d = drawing(c, func);
      Drawing changed = d;
      change(&changed);
      if (!difference_of(bench, c, d, changed).empty()) return true;
    }
    return false;
  }
  spec::Random random_{7};
};

TEST_F(RasterRtlMutant, EveryPieceOfRasterStateIsSeen) {
  const spec::Contract& c = raster_rtl("many").contract();
  InterpZtestBench bench(raster_rtl("many"), BenchOptions());
  for (int func = 0; func < 9; ++func) {
    for (int other = 0; other < 9; ++other) {
      const bool seen = is_seen(&bench, c, static_cast<DepthFunc>(func), [other](Drawing* d) {
        d->frame.depth = static_cast<DepthFunc>(other);
      });
      EXPECT_EQ(seen, func != other) << func << " " << other;
    }
  }
  EXPECT_TRUE(
      is_seen(&bench, c, DepthFunc::kLess, [](Drawing* d) { d->frame.depth_write = false; }));
  EXPECT_TRUE(is_seen(&bench, c, DepthFunc::kLess, [](Drawing* d) {
    for (auto& stamp : d->stamps) stamp.planes.z_bias ^= 1 << spec::kBiasFractionBits;
  }));
}

// The same formats with another reciprocal, so other weights; flat attributes of another triangle.
TEST_F(RasterRtlMutant, WeightsAndFlatAttributesAreSeen) {
  const RtlLibrary& library = raster_rtl("deep");
  spec::Design design = library.contract().design;
  design.reciprocal_lut_bits = 4;
  InterpZtestBench bench(library, BenchOptions());
  const Drawing d = drawing(library.contract(), DepthFunc::kOff);
  EXPECT_EQ(difference_of(&bench, library.contract(), d, d), "");
  const std::string text = difference_of(&bench, spec::contract(design), d, d);
  EXPECT_NE(text.find("attr["), std::string::npos) << text;
  Drawing expected = d;
  expected.stamps[9].planes.flat[0] ^= 1;
  const std::string flat = difference_of(&bench, library.contract(), d, expected);
  EXPECT_NE(flat.find("flat"), std::string::npos) << flat;
}

}  // namespace
}  // namespace pineda::tb
