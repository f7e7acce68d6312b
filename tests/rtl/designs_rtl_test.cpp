// Other named designs than the default one: units and top against the model at every boundary,
// under every stall mode; the rate of setup as derived.
#include <map>
#include <memory>
#include <tuple>

#include "tests/rtl/support.h"

namespace pineda::tb {
namespace {

constexpr size_t kTrianglesPerRun = 400;
constexpr const char* kDesigns[] = {"low", "med", "div28", "persp", "flat", "wide", "tiny"};

const RtlLibrary& rtl_of(std::string_view name) {
  static std::map<std::string, std::unique_ptr<RtlLibrary>> libraries;
  const std::string design(name);
  auto& library = libraries[design];
  if (!library) library = std::make_unique<RtlLibrary>(spec::contract(*spec::find_design(design)));
  return *library;
}

class DesignRtl : public testing::TestWithParam<std::tuple<const char*, StallMode>> {
 protected:
  const RtlLibrary& library() const { return rtl_of(std::get<0>(GetParam())); }
  const spec::Contract& contract() const { return library().contract(); }
  BenchOptions options(int latency_cycles = 8) const {
    BenchOptions o;
    o.stall_mode = std::get<1>(GetParam());
    o.seed = 21;
    o.depth_latency_cycles = latency_cycles;
    return o;
  }

  vectors::SetupCase random_setup(int frame_px, int size_px) {
    vectors::SetupCase c;
    c.name = "random";
    const auto width = random_.between(1, frame_px);
    const auto height = random_.between(1, frame_px);
    c.frame = random_raster_state(&random_, width, height, contract());
    c.in = random_triangles(&random_, c.frame, size_px, kTrianglesPerRun, contract());
    return vectors::run_model(contract(), c);
  }
  vectors::TraversalCase random_traversal(int frame_px, int size_px) {
    const auto setup = random_setup(frame_px, size_px);
    vectors::TraversalCase c{"random", setup.frame, setup.out, {}};
    return vectors::run_model(contract(), c);
  }

  spec::Random random_{505};
};
INSTANTIATE_TEST_SUITE_P(
    , DesignRtl, testing::Combine(testing::ValuesIn(kDesigns), testing::ValuesIn(kStallModes)),
    [](const auto& p) {
      return std::string(std::get<0>(p.param)) + "_" + stall_mode_name(std::get<1>(p.param));
    });

TEST_P(DesignRtl, SetupMatchesModel) {
  SetupBench bench(library(), options());
  for (const int size_px : {4, 64, 2048, 32767}) {
    const auto expected = random_setup(300, size_px);
    ASSERT_EQ(first_difference(&bench, expected, contract()), "") << size_px << " px";
  }
}

TEST_P(DesignRtl, TraversalMatchesModel) {
  TraversalBench bench(library(), options());
  for (const int size_px : {4, 16, 120}) {
    const auto expected = random_traversal(300, size_px);
    ASSERT_EQ(first_difference(&bench, expected, contract()), "") << size_px << " px";
  }
}

TEST_P(DesignRtl, InterpZtestMatchesModel) {
  size_t writes = 0;
  for (const int latency_cycles : {1, 8, contract().design.max_depth_latency_cycles, 100}) {
    InterpZtestBench bench(library(), options(latency_cycles));
    for (int i = 0; i < 3; ++i) {
      const auto traversal = random_traversal(40, 16);
      vectors::InterpZtestCase inputs{"random", traversal.frame, traversal.out, {}, {}};
      inputs.frame.depth = i == 0 ? spec::DepthFunc::kLequal : spec::DepthFunc::kLess;
      const auto expected = vectors::run_model(contract(), inputs);
      writes += expected.color.size();
      ASSERT_EQ(first_difference(&bench, expected, contract()), "") << latency_cycles << " cycles";
    }
  }
  EXPECT_GT(writes, 200u);
}

TEST_P(DesignRtl, TopMatchesModel) {
  for (const int latency_cycles : {1, 8, contract().design.max_depth_latency_cycles, 100}) {
    FrameBench bench(library(), options(latency_cycles));
    for (const int size_px : {6, 40, 2000}) {
      const auto setup = random_setup(90, size_px);
      ASSERT_EQ(check_frame(&bench, setup.frame, setup.in, contract()), "")
          << size_px << " px, " << latency_cycles << " cycles";
    }
  }
}

TEST(DesignRtlRate, SetupTakesATriangleAtEveryInterval) {
  for (const char* design : kDesigns) {
    const RtlLibrary& library = rtl_of(design);
    spec::Triangle triangle;
    triangle.v[1].x = triangle.v[2].y = 40 << 8;
    spec::FrameState frame;
    frame.width = frame.height = 64;
    SetupBench bench(library, BenchOptions());
    bench.set_frame(frame);
    std::vector<Cycle> accepted;
    const auto out = bench.run(std::vector<spec::Triangle>(20, triangle), &accepted);
    EXPECT_EQ(out.tokens.size(), 20u);
    const Cycle interval = library.contract().width.setup_interval_cycles;
    for (size_t i = 1; i < accepted.size(); ++i) {
      EXPECT_EQ(accepted[i] - accepted[i - 1], interval) << design;
    }
  }
}

// The mutant: the same formats with another reciprocal have other low bits.
TEST(DesignRtlMutant, PlanesOfAnotherReciprocalAreCaught) {
  spec::Random random(9);
  spec::FrameState frame;
  frame.width = frame.height = 64;
  vectors::SetupCase inputs{
      "random", frame, random_triangles(&random, frame, 64, kTrianglesPerRun), {}, {}};
  spec::Design design = *spec::find_design("div28");
  design.reciprocal_scheme = spec::ReciprocalScheme::kQuadratic;
  design.reciprocal_lut_bits = 7;
  const auto expected = vectors::run_model(spec::contract(design), inputs);
  SetupBench bench(rtl_of("div28"), BenchOptions());
  const std::string text = first_difference(&bench, expected, rtl_of("div28").contract());
  EXPECT_NE(text.find("z_d"), std::string::npos) << text;
}

}  // namespace
}  // namespace pineda::tb
