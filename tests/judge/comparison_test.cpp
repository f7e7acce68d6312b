// The comparison that every judge makes: the nearest codes pass, and each fault is reported where
// it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>

#include "tests/judge/support.h"

namespace pineda::judge {
namespace {

constexpr spec::ErrorBounds kHalf{.5, .5};
constexpr uint32_t kNumber = 7;  // of the triangle

using Samples = std::vector<Drawn>;

Verdict compared(const Truth& truth, const Samples& samples, const Values& values = {},
                 const spec::ErrorBounds& bounds = kHalf) {
  Verdict verdict;
  Comparison comparison(values, &verdict);
  comparison.begin(truth, bounds, kNumber);
  for (const Drawn& drawn : samples) comparison.sample(drawn);
  comparison.end();
  return verdict;
}

ScreenTruth truth_of(const exact::ScreenJudge& judge) {
  ScreenTruth truth;
  truth.judge(judge);
  return truth;
}

TEST(Comparison, NearestCodesHold) {
  const ScreenTruth truth = truth_of(judge_of());
  ASSERT_GT(truth.samples().size(), 500u);
  const Verdict verdict = compared(truth, nearest(truth));
  EXPECT_TRUE(verdict.holds());
  EXPECT_EQ(verdict.first, std::nullopt);
  EXPECT_EQ(verdict.samples, truth.samples().size());
  EXPECT_GT(verdict.max_depth_ulp, .49);
  EXPECT_GT(verdict.max_color_lsb, .49);
}

/// Something wrong with one of the samples of a triangle.
struct Fault {
  const char* name;
  std::function<void(Samples*, Drawn*)> commit;
  uint64_t missing, extra, beyond;
  const char* what;
};

const Fault kFaults[] = {
    {"Lost", [](Samples* s, Drawn* at) { s->erase(s->begin() + (at - s->data())); }, 1, 0, 0,
     "sample (20, 20) is missing"},
    {"TooMany",
     [](Samples* s, Drawn*) {
       s->push_back({0, 0, 0, {}});
     },
     0, 1, 0, "sample (0, 0) is not covered"},
    {"BelowAllRows",
     [](Samples* s, Drawn*) {
       s->push_back({11, 47, 0, {}});
     },
     0, 1, 0, "sample (11, 47) is not covered"},
    {"Twice", [](Samples* s, Drawn* at) { s->push_back(*at); }, 0, 1, 0,
     "sample (20, 20) is drawn twice"},
    {"InThePlaceOfAnother", [](Samples*, Drawn* at) { --at->x; }, 1, 1, 0,
     "sample (19, 20) is drawn twice"},
    {"DepthOneOff", [](Samples*, Drawn* at) { ++at->z; }, 0, 0, 1, "depth at (20, 20) is "},
    {"DepthOneOffBelow", [](Samples*, Drawn* at) { --at->z; }, 0, 0, 1, "depth at (20, 20) is -"},
    {"RedOneOff", [](Samples*, Drawn* at) { ++at->attr[0]; }, 0, 0, 1,
     "attribute 0 at (20, 20) is "},
    {"AlphaOneOff", [](Samples*, Drawn* at) { --at->attr[3]; }, 0, 0, 1,
     "attribute 3 at (20, 20) is -1 LSB off"},
    {"AllOff", [](Samples*, Drawn* at) { at->z = at->attr[1] = 9999; }, 0, 0, 1,
     "depth at (20, 20) is "},
};

// The mutants: the comparison must see each of them.
class ComparisonMutant : public testing::TestWithParam<Fault> {};
INSTANTIATE_TEST_SUITE_P(, ComparisonMutant, testing::ValuesIn(kFaults),
                         [](const auto& f) { return std::string(f.param.name); });

TEST_P(ComparisonMutant, IsSeenWhereItIs) {
  const ScreenTruth truth = truth_of(judge_of());
  Samples samples = nearest(truth);
  const auto at = std::find_if(samples.begin(), samples.end(),
                               [](const Drawn& s) { return s.x == 20 && s.y == 20; });
  ASSERT_NE(at, samples.end());
  GetParam().commit(&samples, &*at);
  const Verdict verdict = compared(truth, samples);
  EXPECT_FALSE(verdict.holds());
  EXPECT_EQ(verdict.missing, GetParam().missing);
  EXPECT_EQ(verdict.extra, GetParam().extra);
  EXPECT_EQ(verdict.beyond, GetParam().beyond);
  EXPECT_EQ(verdict.samples, samples.size());
  ASSERT_TRUE(verdict.first);
  EXPECT_EQ(verdict.first->what.find(GetParam().what), 0u) << verdict.first->what;
  EXPECT_EQ(verdict.first->triangle, kNumber);
  const std::string place = "(" + std::to_string(verdict.first->x) + ", ";
  EXPECT_NE(verdict.first->what.find(place), std::string::npos) << verdict.first->what;
}

TEST(Comparison, FirstIsThatOfTheFirstTriangle) {
  const ScreenTruth truth = truth_of(judge_of());
  Verdict verdict;
  Comparison comparison({}, &verdict);
  for (uint32_t triangle = 0; triangle < 4; ++triangle) {
    Samples samples = nearest(truth);
    if (triangle > 0) samples[triangle].z += 1000 * triangle;
    comparison.begin(truth, kHalf, triangle);
    for (const Drawn& drawn : samples) comparison.sample(drawn);
    comparison.end();
  }
  EXPECT_EQ(verdict.beyond, 3u);
  EXPECT_EQ(verdict.first->triangle, 1u);
  EXPECT_EQ(verdict.first->x, truth.samples()[1].x);
  EXPECT_NEAR(verdict.max_depth_ulp, 3000, .5);
}

TEST(Comparison, AnErrorAtItsBoundHoldsAndOneBeyondDoesNot) {
  const ScreenTruth truth = truth_of(judge_of());
  const Verdict all = compared(truth, nearest(truth));
  const auto below = [](double x) { return std::nextafter(x, 0); };
  const spec::ErrorBounds just{all.max_depth_ulp, all.max_color_lsb};
  EXPECT_TRUE(compared(truth, nearest(truth), {}, just).holds());
  spec::ErrorBounds depth = just, color = just;
  depth.depth_ulp = below(just.depth_ulp);
  color.attribute_lsb = below(just.attribute_lsb);
  const Verdict deep = compared(truth, nearest(truth), {}, depth);
  const Verdict bright = compared(truth, nearest(truth), {}, color);
  EXPECT_GE(deep.beyond, 1u);
  EXPECT_EQ(deep.first->what.find("depth"), 0u);
  EXPECT_GE(bright.beyond, 1u);
  EXPECT_EQ(bright.first->what.find("attribute"), 0u);
}

TEST(Comparison, WithoutDepthNoDepthIsWrong) {
  const ScreenTruth truth = truth_of(judge_of());
  Samples samples = nearest(truth);
  for (Drawn& drawn : samples) drawn.z = 0;
  Values values;
  EXPECT_EQ(compared(truth, samples, values).beyond, samples.size());
  values.depth = false;
  EXPECT_TRUE(compared(truth, samples, values).holds());
  EXPECT_EQ(compared(truth, samples, values).max_depth_ulp, 0);
}

TEST(Comparison, AFlatAttributeMustBeTheFirstVertexsWhateverTheBounds) {
  const ScreenTruth truth = truth_of(judge_of());
  const Values values{true, 2, 4, false};
  Samples samples = nearest(truth, values);
  EXPECT_TRUE(compared(truth, samples, values).holds());
  EXPECT_FALSE(compared(truth, samples, {}).holds());  // blue varies
  ++samples[5].attr[2];
  const Verdict verdict = compared(truth, samples, values, {100, 100});
  EXPECT_EQ(verdict.beyond, 1u);
  EXPECT_EQ(verdict.max_color_lsb, 1);
}

TEST(Comparison, AttributesBehindTheColourAreNought) {
  spec::Design d = spec::kHighTile;
  d.attributes = 7;
  const ScreenTruth truth = truth_of(judge_of(d));
  Samples samples = nearest(truth, values_of(d));
  for (const Drawn& drawn : samples) {
    EXPECT_TRUE(drawn.attr[4] == 0 && drawn.attr[5] == 0 && drawn.attr[6] == 0);
  }
  EXPECT_TRUE(compared(truth, samples, values_of(d)).holds());
  samples[3].attr[6] = 1;
  EXPECT_EQ(compared(truth, samples, values_of(d)).beyond, 1u);
}

TEST(Comparison, PerspectiveAndAffineColoursAreNotTakenForEachOther) {
  const ScreenTruth truth = truth_of(judge_of());
  const Values affine, perspective{true, 4, 4, true};
  EXPECT_TRUE(compared(truth, nearest(truth, perspective), perspective).holds());
  EXPECT_GT(compared(truth, nearest(truth, affine), perspective).max_color_lsb, 20);
  EXPECT_GT(compared(truth, nearest(truth, perspective), affine).max_color_lsb, 20);
}

TEST(Seen, SaysWhatASampleIsAndWhichAreMissing) {
  const ScreenTruth truth = truth_of(judge_of());
  Seen seen;
  for (int pass = 0; pass < 2; ++pass) {  // the second triangle starts without state of the first
    seen.begin(truth);
    for (const exact::Sample& s : truth.samples()) {
      if (s.y == 20) continue;
      ASSERT_EQ(seen.draw(s.x, s.y), Found::kRight);
      ASSERT_EQ(seen.draw(s.x, s.y), Found::kTwice);
    }
    const exact::Span row = truth.span(20);
    EXPECT_EQ(seen.draw(row.first - 1, 20), Found::kExtra);
    EXPECT_EQ(seen.draw(row.last + 1, 20), Found::kExtra);
    EXPECT_EQ(seen.draw(20, truth.rows().first - 1), Found::kExtra);
    EXPECT_EQ(seen.draw(11, truth.rows().last + 1), Found::kExtra);
    int next = row.first;
    seen.for_each_missing([&](int x, int y) {
      EXPECT_EQ(y, 20);
      EXPECT_EQ(x, next++);
    });
    EXPECT_EQ(next, row.last + 1);
  }
}

TEST(Seen, OfATriangleWithoutSamplesEveryOneIsTooMany) {
  spec::FrameState culled = kFrame;
  culled.cull = spec::Cull::kBack;
  exact::ScreenTriangle turned = stated();
  std::swap(turned[1], turned[2]);
  Seen seen;
  int empty = 0;
  for (const auto& triangle : {stated(), turned}) {
    const exact::ScreenJudge judge(triangle, {}, exact_frame(culled));
    if (!judge.culled()) continue;
    ++empty;
    seen.begin(truth_of(judge));
    EXPECT_EQ(seen.draw(20, 20), Found::kExtra);
    EXPECT_EQ(seen.draw(0, 0), Found::kExtra);
    seen.for_each_missing([](int, int) { ADD_FAILURE(); });
  }
  EXPECT_EQ(empty, 1);
}

/// In the order of tiles of 8 x 8 px.
Samples by_tiles(Samples samples) {
  std::stable_sort(samples.begin(), samples.end(), [](const Drawn& a, const Drawn& b) {
    return std::pair(a.y >> 3, a.x >> 3) < std::pair(b.y >> 3, b.x >> 3);
  });
  return samples;
}

Verdict streamed(const Samples& samples, const Values& values = {}) {
  Verdict verdict;
  TileRowComparison comparison(values, 3, &verdict);
  const exact::ScreenJudge judge = judge_of();
  comparison.begin(judge, kHalf, kNumber);
  for (const Drawn& drawn : samples) comparison.sample(drawn);
  comparison.end();
  return verdict;
}

void expect_same(const Verdict& a, const Verdict& b) {
  EXPECT_EQ(a.samples, b.samples);
  EXPECT_EQ(a.missing, b.missing);
  EXPECT_EQ(a.extra, b.extra);
  EXPECT_EQ(a.beyond, b.beyond);
  EXPECT_EQ(a.max_depth_ulp, b.max_depth_ulp);
  EXPECT_EQ(a.max_color_lsb, b.max_color_lsb);
}

TEST(TileRowComparison, IsThatOfTheWholeTriangle) {
  const ScreenTruth truth = truth_of(judge_of());
  const Values perspective{true, 4, 4, true};
  for (const Values& values : {Values{}, perspective}) {
    const Samples right = by_tiles(nearest(truth, values));
    EXPECT_TRUE(streamed(right, values).holds());
    expect_same(streamed(right, values), compared(truth, right, values));
    for (const Fault& fault : kFaults) {
      SCOPED_TRACE(fault.name);
      Samples wrong = right;
      fault.commit(&wrong, &wrong[wrong.size() / 2]);
      wrong = by_tiles(std::move(wrong));
      const Verdict verdict = streamed(wrong, values);
      EXPECT_FALSE(verdict.holds());
      EXPECT_TRUE(verdict.first);
      expect_same(verdict, compared(truth, wrong, values));
    }
  }
}

TEST(TileRowComparison, MissesWholeRowsOfTiles) {
  const ScreenTruth truth = truth_of(judge_of());
  for (const int row : {0, 2, truth.rows().last >> 3}) {
    Samples samples = by_tiles(nearest(truth));
    const auto gone = std::remove_if(samples.begin(), samples.end(),
                                     [&](const Drawn& s) { return s.y >> 3 == row; });
    const auto lost = static_cast<uint64_t>(samples.end() - gone);
    ASSERT_GT(lost, 0u);
    samples.erase(gone, samples.end());
    EXPECT_EQ(streamed(samples).missing, lost) << row;
    EXPECT_EQ(streamed(samples).extra, 0u) << row;
  }
  EXPECT_EQ(streamed({}).missing, truth.samples().size());
}

// A late sample must not make up for one that is missing.
TEST(TileRowComparison, ASampleOfARowThatHasGoneByIsOneTooMany) {
  const ScreenTruth truth = truth_of(judge_of());
  Samples samples = by_tiles(nearest(truth));
  std::rotate(samples.begin(), samples.begin() + 1, samples.end());
  const Verdict late = streamed(samples);
  EXPECT_EQ(late.missing, 1u);
  EXPECT_EQ(late.extra, 1u);
  samples.push_back(samples[samples.size() / 2]);
  EXPECT_EQ(streamed(samples).extra, 2u);
}

TEST(TriangleBounds, AreTheDesignsWithTheBiasOfTheTriangle) {
  const spec::Design& d = spec::kHighTile;
  const spec::ErrorBounds plain = spec::error_bounds(d);
  spec::FrameState frame = kFrame;
  EXPECT_EQ(triangle_bounds(d, frame, 1e5).depth_ulp, plain.depth_ulp);
  EXPECT_EQ(triangle_bounds(d, frame, 1e5).attribute_lsb, plain.attribute_lsb);
  frame.bias_slope = -512;  // units of 2^-8
  const double biased = triangle_bounds(d, frame, 1e5).depth_ulp;
  EXPECT_EQ(biased, plain.depth_ulp + spec::depth_bias_error_bound(d, 2, 1e5));
  EXPECT_GT(biased, plain.depth_ulp);
  frame.shade = spec::Shade::kFlat;
  EXPECT_EQ(triangle_bounds(d, frame, 1e5).attribute_lsb, 0);
}

}  // namespace
}  // namespace pineda::judge
