// Every hard case through the Verilated top: core's tokens at every boundary, the judge's hits.
#include "tests/hard/support.h"
#include "tests/rtl/support.h"

namespace pineda::hard {
namespace {

tb::BenchOptions options(tb::StallMode mode) {
  tb::BenchOptions o;
  o.stall_mode = mode;
  o.seed = 11;
  return o;
}

using HardCaseRtl = HardCaseTest;
INSTANTIATE_TEST_SUITE_P(, HardCaseRtl, testing::ValuesIn(scene::hard_cases()), case_name);

TEST_P(HardCaseRtl, MatchesTheModelAndTheJudgeUnderEveryStall) {
  const spec::Contract& contract = tb::rtl().contract();
  const Snapped scene = snapped(GetParam(), contract);
  const auto hits = judged_hits(contract, scene);
  for (const tb::StallMode mode : tb::kStallModes) {
    SCOPED_TRACE(tb::stall_mode_name(mode));
    tb::FrameBench bench(tb::rtl(), options(mode));
    EXPECT_EQ(tb::check_frame(&bench, scene.frame, scene.triangles), "");
    EXPECT_EQ(bench.buffer().hits, hits);
  }
}

/// Counts stamps that follow a stamp of another triangle at the same place.
struct Followers : timing::Listener {
  void stamp(timing::Cycle, const spec::Stamp& s) override {
    count += s.x == last.x && s.y == last.y && s.id != last.id ? 1 : 0;
    last = s;
  }
  spec::Stamp last;
  int count = 0;
};

TEST(BackToBackRtl, StampsOfOnePlaceFollowEachOtherAndWait) {
  const Snapped scene = snapped("back_to_back");
  tb::FrameBench bench(tb::rtl(), options(tb::StallMode::kNone));
  Followers followers;
  const auto result = bench.run(scene.frame, tb::from(scene.triangles), &followers);
  EXPECT_GE(followers.count, 16);
  EXPECT_GE(result.of(timing::Unit::kInterpZtest)[timing::Cause::kHazard], followers.count);
}

// The mutant has a fault in each unit: shared edges are hit twice, tiles get lost, less passes
// equal depths.
TEST(HardCaseRtlMutant, IsCaughtByTheScoreboardAndByTheJudge) {
  const spec::Contract& contract = tb::mutant().contract();
  for (const char* name : {"half_pixel_lattice", "edges_through_centers", "fan", "tile_corners"}) {
    const Snapped scene = snapped(hard_case(name), contract);
    tb::FrameBench bench(tb::mutant(), options(tb::StallMode::kNone));
    EXPECT_EQ(tb::check_frame(&bench, scene.frame, scene.triangles).substr(0, 4), "RTL ") << name;
    EXPECT_NE(bench.buffer().hits, judged_hits(contract, scene)) << name;
  }
}

}  // namespace
}  // namespace pineda::hard
