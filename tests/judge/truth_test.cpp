// The exact values of a triangle, from its floats and from its snapped vertices, are the same.
#include "model/judge/truth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/judge/support.h"

namespace pineda::judge {
namespace {

// Errors below this are only the last bits of doubles.
constexpr double kNone = 1e-9;

/// Compares the errors of both truths on all samples, some codes off; returns the samples.
size_t expect_equal_errors(const Values& values) {
  ScreenTruth screen;
  screen.judge(judge_of());
  const SnappedTruth snapped_truth(spec::kHighTile, kFrame, snapped());
  for (Drawn drawn : nearest(screen, values)) {
    drawn.z += drawn.x % 3 - 1;
    drawn.attr[1] += drawn.y % 3 - 1;
    const Errors a = screen.errors(values, drawn);
    const Errors b = snapped_truth.errors(values, drawn);
    EXPECT_NEAR(a.depth.units, b.depth.units, kNone);
    EXPECT_EQ(a.depth.is_misrounded, b.depth.is_misrounded);
    for (size_t i = 0; i < a.attr.size(); ++i) {
      EXPECT_NEAR(a.attr[i].units, b.attr[i].units, kNone) << i;
      EXPECT_EQ(a.attr[i].is_misrounded, b.attr[i].is_misrounded) << i;
    }
  }
  return screen.samples().size();
}

TEST(Truth, FromFloatsAndFromSnappedVerticesIsTheSame) {
  EXPECT_GT(expect_equal_errors({}), 500u);
  EXPECT_GT(expect_equal_errors({true, 4, 4, true}), 500u);    // with perspective
  EXPECT_GT(expect_equal_errors({false, 2, 4, false}), 500u);  // two flat ones, no depth
}

TEST(Truth, SpansAreTheSame) {
  ScreenTruth screen;
  screen.judge(judge_of());
  const SnappedTruth snapped_truth(spec::kHighTile, kFrame, snapped());
  ASSERT_EQ(screen.rows().first, snapped_truth.rows().first);
  ASSERT_EQ(screen.rows().last, snapped_truth.rows().last);
  for (int y = screen.rows().first; y <= screen.rows().last; ++y) {
    EXPECT_EQ(screen.span(y).first, snapped_truth.span(y).first) << y;
    EXPECT_EQ(screen.span(y).last, snapped_truth.span(y).last) << y;
  }
}

// z = 1/2 code, and a colour halfway between two, everywhere.
TEST(Truth, AnErrorIsCodeMinusExactAndHalvesRoundUp) {
  spec::Triangle t = snapped();
  for (auto& v : t.v) v.z = 5 * 256 + 128;
  const SnappedTruth truth(spec::kHighTile, kFrame, t);
  const auto depth = [&](int64_t z) { return truth.errors({}, {20, 20, z, {}}).depth; };
  EXPECT_EQ(depth(5).units, -.5);
  EXPECT_TRUE(depth(5).is_misrounded);
  EXPECT_EQ(depth(6).units, .5);
  EXPECT_FALSE(depth(6).is_misrounded);
  EXPECT_EQ(depth(9).units, 3.5);
  EXPECT_TRUE(depth(9).is_misrounded);
}

TEST(ScreenTruth, SomeRowsHaveTheirSamplesAlone) {
  const exact::ScreenJudge judge = judge_of();
  ScreenTruth whole, part;
  whole.judge(judge);
  part.judge(judge, {16, 23});
  size_t found = 0;
  for (const exact::Sample& s : whole.samples()) {
    const exact::Sample* other = part.find(s.x, s.y);
    ASSERT_EQ(other != nullptr, s.y >= 16 && s.y <= 23);
    if (other == nullptr) continue;
    ++found;
    EXPECT_EQ(other->x, s.x);
    EXPECT_EQ(other->y, s.y);
    EXPECT_EQ(other->z.whole, s.z.whole);
  }
  EXPECT_EQ(found, part.samples().size());
  EXPECT_GT(found, 100u);
  EXPECT_EQ(part.depth_slope(), whole.depth_slope());
}

TEST(ScreenTruth, WithoutPerspectiveValuesAreAffine) {
  ScreenTruth both, affine(false);
  both.judge(judge_of());
  affine.judge(judge_of());
  const Values perspective{true, 4, 4, true};
  for (const Drawn& drawn : nearest(both)) {
    EXPECT_EQ(affine.errors(perspective, drawn).attr[0].units,
              both.errors({}, drawn).attr[0].units);
  }
  // The two differ, so the test means something.
  const Drawn middle{20, 20, 0, {}};
  EXPECT_GT(std::abs(both.errors(perspective, middle).attr[0].units -
                     both.errors({}, middle).attr[0].units),
            10);
}

TEST(SnappedTruth, ABiasIsTakenAsGivenAndMayEndAtTheEndsOfTheRange) {
  const int64_t top = (int64_t{1} << spec::kHighTile.depth_bits) - 1;
  const auto error = [](double bias, int64_t z) {
    const SnappedTruth truth(spec::kHighTile, kFrame, snapped(), bias);
    return truth.errors({}, {20, 20, z, {}}).depth.units;
  };
  const double plain = error(0, 1000);
  EXPECT_DOUBLE_EQ(error(12.5, 1000), plain - 12.5);
  EXPECT_DOUBLE_EQ(error(-7, 1000), plain + 7);
  EXPECT_EQ(error(0x1p25, top), 0);
  EXPECT_EQ(error(-0x1p25, 0), 0);
  // Wrong at the other end, at the code beside it, and where the bias does not reach the end.
  EXPECT_NE(error(0x1p25, 0), 0);
  EXPECT_NE(error(-0x1p25, top), 0);
  EXPECT_NE(error(0x1p25, top - 1), 0);
  EXPECT_NE(error(1, top), 0);
  EXPECT_NE(error(0, top), 0);
}

}  // namespace
}  // namespace pineda::judge
