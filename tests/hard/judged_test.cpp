// Every hard case on every design: coverage, depth and colours judged by exact arithmetic.
#include <algorithm>
#include <memory>

#include "model/scene/snap.h"
#include "model/spec/bounds.h"
#include "studies/judge/scorer.h"
#include "studies/judge/stated.h"
#include "tests/hard/support.h"

namespace pineda::hard {
namespace {

/// The case before the judge, from its floats on.
studies::Subject judged(const spec::Design& design, const scene::HardCase& hard_case) {
  const spec::Contract contract = spec::contract(design);
  scene::SnappedSource source(contract, std::make_unique<scene::ListReader>(hard_case.make()));
  studies::DesignScorer scorer(design, hard_case.frame, false);
  judge::ScreenTruth truth;
  for (spec::Triangle t; source.next(&t);) {
    truth.judge(exact::ScreenJudge(studies::stated(source.screen()), judge::format_of(design),
                                   judge::exact_frame(hard_case.frame)));
    scorer.score(t, truth);
  }
  return scorer.subject();
}

INSTANTIATE_TEST_SUITE_P(, HardCaseTest, testing::ValuesIn(scene::hard_cases()), case_name);

TEST_P(HardCaseTest, CoverageIsExactAndValuesAreWithinTheBounds) {
  for (const auto& design : spec::designs()) {
    const spec::FrameState& frame = GetParam().frame;
    if (std::max(frame.width, frame.height) > 1 << design.guard_bits) continue;  // refused
    SCOPED_TRACE(design.name);
    const studies::Subject subject = judged(design, GetParam());
    EXPECT_EQ(subject.missing, 0u);
    EXPECT_EQ(subject.extra, 0u);
    EXPECT_LE(subject.depth.max(), subject.bounds->depth_ulp);
    EXPECT_LE(subject.color.max(), subject.bounds->attribute_lsb);
    // No case is without samples.
    EXPECT_GT(subject.judged, 5u);
  }
}

TEST_P(HardCaseTest, IsTheSameOnEveryCallAndSmallEnoughForTheRtl) {
  const scene::HardCase& c = GetParam();
  const auto once = c.make();
  const auto again = c.make();
  ASSERT_EQ(once.size(), again.size());
  EXPECT_LE(once.size(), 2000u);
  const auto same = [](float a, float b) { return a == b || (a != a && b != b); };
  for (size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].id, again[i].id);
    for (size_t k = 0; k < 3; ++k) {
      const scene::ScreenVertex &a = once[i].v[k], &b = again[i].v[k];
      EXPECT_TRUE(same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z) && same(a.w, b.w));
      EXPECT_EQ(a.rgba, b.rgba);
    }
  }
}

// The checks above can fail. Values: a design of coarse gradients is beyond the default's bounds on
// the cases that are about values.
TEST(HardCaseMutant, CoarseGradientsBreakTheBounds) {
  spec::Design coarse = spec::kHighTile;
  coarse.gradient_fraction_bits = 8;
  const spec::ErrorBounds bounds = spec::error_bounds(spec::kHighTile);
  for (const char* name : {"huge", "needles"}) {
    EXPECT_GT(judged(coarse, hard_case(name)).depth.max(), bounds.depth_ulp) << name;
  }
}

// Coverage: triangles one subpixel off are not the same to the judge.
TEST(HardCaseMutant, OneSubpixelToTheRightIsSeen) {
  const spec::Contract contract = spec::contract(spec::kHighTile);
  for (const char* name :
       {"edges_through_centers", "fan", "sliver", "box_on_centers", "t_junction", "tile_corners"}) {
    Snapped scene = snapped(name);
    const auto hits = judged_hits(contract, scene);
    for (auto& t : scene.triangles) {
      for (auto& v : t.v) v.x = std::min(v.x + 1, (1 << 22) - 1);
    }
    EXPECT_NE(drawn(scene).buffer().hits, hits) << name;
  }
}

}  // namespace
}  // namespace pineda::hard
