// The collector sees what there is to see, and level 1 leaves nothing of it out.
#include "vectors/coverage/coverage.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/vectors/samples.h"
#include "vectors/generator/generate.h"

namespace pineda::vectors {
namespace {

/// Hits by the name of point and bin.
std::map<std::string, uint64_t> hits(const Coverage& coverage) {
  std::map<std::string, uint64_t> all;
  for (const PointHits& point : coverage.points()) {
    for (size_t i = 0; i < point.bins.size(); ++i) {
      all[point.name + ": " + point.bins[i].name] = point.count[i];
    }
  }
  return all;
}

// In subpixels; high_tile has 256 a pixel. The half-pixel lattice holds the samples.
SetupCase setup_of(std::array<std::array<int, 2>, 3> corners) {
  SetupCase value;
  value.frame = sample_frame();
  spec::Triangle triangle;
  for (size_t i = 0; i < 3; ++i) {
    triangle.v[i].x = corners[i][0];
    triangle.v[i].y = corners[i][1];
  }
  value.in = {triangle};
  return value;
}

TEST(Coverage, OfASetupCaseByHand) {
  Coverage coverage(Unit::kSetup, kContract);
  // Right-angled at (.5, .5) px, legs of 4 px: clockwise from vertex 0, whose sample is drawn.
  coverage.see(setup_of({{{128, 128}, {1152, 128}, {128, 1152}}}));
  auto seen = hits(coverage);
  EXPECT_EQ(seen["drop: kept"], 1u);
  EXPECT_EQ(seen["cull_facing: cull none, clockwise"], 1u);
  EXPECT_EQ(seen["order: clockwise, 0 is the anchor"], 1u);
  EXPECT_EQ(seen["anchor: two are, the left one"], 1u);
  EXPECT_EQ(seen["area: 21 bits"], 1u);  // 2^20 squared subpixels
  EXPECT_EQ(seen["extent: width, 11 bits"], 1u);
  EXPECT_EQ(seen["edge_direction: 0 edge, east"], 1u);
  EXPECT_EQ(seen["edge_direction: 1 edge, southwest"], 1u);
  EXPECT_EQ(seen["edge_direction: 2 edge, north"], 1u);
  EXPECT_EQ(seen["sample_on_vertex: 0 is on a sample"], 1u);
  EXPECT_EQ(seen["sample_on_edge: 0 edge, east"], 3u);  // of five, less the ends
  EXPECT_EQ(seen["sample_on_edge: 2 edge, north"], 3u);
  EXPECT_EQ(seen["box_in_tile: left, first of its tile"], 1u);
  EXPECT_EQ(seen["box_side: right, by nothing"], 1u);
  EXPECT_EQ(seen["reciprocal_end: a power of two"], 1u);
  EXPECT_EQ(seen["reciprocal_entry: 0 is taken"], 1u);
  EXPECT_EQ(seen["ports: none"], 1u);

  coverage.see(setup_of({{{0, 0}, {256, 256}, {512, 512}}}));
  // Beyond the frame of 7 x 6 px on the right: it cuts the box.
  coverage.see(setup_of({{{1500, 100}, {2500, 400}, {1400, 900}}}));
  seen = hits(coverage);
  EXPECT_EQ(seen["drop: zero_area"], 1u);
  EXPECT_EQ(seen["box_side: right, by the frame"], 1u);
  EXPECT_EQ(seen["frame_size: width, 3 bits"], 1u);
}

TEST(Coverage, OfStampsByHand) {
  InterpZtestCase value = sample_case<InterpZtestCase>();
  value.frame.depth = spec::DepthFunc::kLequal;
  value.ports.mode = memory::StallMode::kSink;
  value.in.resize(1);
  value.in.push_back(value.in[0]);  // the same depths once more: equal, and a hazard at distance 1
  Coverage coverage(Unit::kInterpZtest, kContract);
  coverage.see(value);
  auto seen = hits(coverage);
  EXPECT_EQ(seen["hazard: 1 stamps"], 1u);
  EXPECT_EQ(seen["hazard: 2 stamps"], 0u);
  EXPECT_EQ(seen["depth_function: lequal, written, all pass"], 2u);
  const auto lanes = static_cast<uint64_t>(core::count_lanes(value.in[0].mask));
  EXPECT_EQ(seen["comparison: lequal, nearer"], lanes);
  EXPECT_EQ(seen["comparison: lequal, equal"], lanes);
  EXPECT_EQ(seen["ports: sink"], 1u);
}

// A vertex beyond the guard band.
TEST(Coverage, NamesWhatIsHitAndCalledUnreachable) {
  Coverage setup(Unit::kSetup, kContract);
  SetupCase large = setup_of({{{0, 0}, {4000, 0}, {0, 4000}}});
  large.frame.width = 1 << kContract.design.guard_bits;
  large.in[0].v[1].x = 1 << 23;  // beyond the guard band
  setup.see(large);
  ASSERT_EQ(contradictions(setup.points()).size(), 1u);
  EXPECT_EQ(
      contradictions(setup.points())[0].find("frame_size: width, 15 bits, called unreachable: "),
      0u);
  EXPECT_EQ(setup.hit(), hit_bins(setup.points()));
  EXPECT_LE(setup.hit(), reachable_bins(setup.points()));
}

// A frame is seen at every unit, a unit's case at that unit alone.
TEST(Coverage, OfAFrameHoldsThatOfItsUnits) {
  Coverage frame(Unit::kFrame, kContract), setup(Unit::kSetup, kContract),
      traversal(Unit::kTraversal, kContract), interp(Unit::kInterpZtest, kContract);
  frame.see(sample_case<FrameCase>());
  setup.see(sample_case<SetupCase>());
  traversal.see(sample_case<TraversalCase>());
  interp.see(sample_case<InterpZtestCase>());
  const auto whole = hits(frame);
  for (const Coverage* unit : {&setup, &traversal, &interp}) {
    EXPECT_GT(unit->hit(), 10u);
    for (const auto& [bin, count] : hits(*unit)) {
      if (bin.rfind("attribute_range", 0) == 0) continue;  // of given stamps alone
      EXPECT_EQ(whole.at(bin), count) << bin;
    }
  }
  EXPECT_LT(frame.hit(), reachable_bins(frame.points()));
}

template <class Case>
void expect_covered(const spec::Design& design) {
  const auto contract = spec::contract(design);
  Coverage coverage(Case::kUnit, contract);
  const Tally tally = for_each_case<Case>(contract, {}, spec::error_bounds(design),
                                          [&](const Case& value) { coverage.see(value); });
  EXPECT_EQ(tally.missed, 0u) << design.name << " " << spec::name_of(Case::kUnit);
  EXPECT_EQ(coverage.hit(), reachable_bins(coverage.points())) << design.name;
  EXPECT_EQ(contradictions(coverage.points()), std::vector<std::string>()) << design.name;
  EXPECT_GT(reachable_bins(coverage.points()), 25u);
}

class LevelOne : public testing::TestWithParam<const char*> {};
TEST_P(LevelOne, HitsEveryReachableBin) {
  const spec::Design& design = *spec::find_design(GetParam());
  expect_covered<SetupCase>(design);
  expect_covered<TraversalCase>(design);
  expect_covered<InterpZtestCase>(design);
  expect_covered<FrameCase>(design);
}
INSTANTIATE_TEST_SUITE_P(, LevelOne, testing::Values("high_tile", "persp", "tiny", "wide", "flat"),
                         [](const auto& test) { return std::string(test.param); });

// A rasterizer that keeps the low bits of the frame's size draws the small frames right, and others not.
TEST(LevelOneFrames, TellAFrameSizeOfTooFewBits) {
  const auto file = generate<FrameCase>(kContract, {}, kBounds);
  for (int bits = 1; bits <= kContract.design.guard_bits; ++bits) {
    for (const bool is_width : {true, false}) {
      bool is_told = false;
      for (const FrameCase& expected : file.cases) {
        FrameCase got = expected;
        int& size = is_width ? got.frame.width : got.frame.height;
        const int kept = size & ((1 << bits) - 1);
        if (kept == size) continue;
        size = kept;  // nothing is drawn on a frame of 0 px
        got = kept == 0 ? FrameCase{} : run_model(kContract, got);
        is_told |= difference(kContract, expected, got).has_value();
      }
      EXPECT_TRUE(is_told) << bits << " bits of " << (is_width ? "width" : "height");
    }
  }
}

}  // namespace
}  // namespace pineda::vectors
