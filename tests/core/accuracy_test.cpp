// Depth and colour against the judge: the documented bounds hold on every covered sample.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>

#include "tests/core/support.h"

namespace pineda::test {
namespace {

constexpr double kDepthBoundCodes = .68;
constexpr double kAttrBoundLsb = .66;

void record(const Errors& e) {
  testing::Test::RecordProperty("max_depth_codes", std::to_string(e.depth_codes));
  testing::Test::RecordProperty("max_attr_lsb", std::to_string(e.attr_lsb));
  testing::Test::RecordProperty("samples", std::to_string(e.samples));
}

void expect_bounds(const Errors& e) {
  record(e);
  EXPECT_LE(e.depth_codes, kDepthBoundCodes);
  EXPECT_LE(e.attr_lsb, kAttrBoundLsb);
  // Rounding alone costs up to half a code: a smaller maximum means that little was measured.
  EXPECT_GT(e.depth_codes, .49);
  EXPECT_GT(e.attr_lsb, .49);
}

struct AccuracyCase {
  const char* name;
  Shape shape;
  int count;
  int64_t least_samples;
};
class Accuracy : public testing::TestWithParam<AccuracyCase> {};
INSTANTIATE_TEST_SUITE_P(Shapes, Accuracy,
                         testing::Values(AccuracyCase{"Tiny16Px", Shape::k16Px, 8000, 100000},
                                         AccuracyCase{"Size256Px", Shape::k256Px, 1500, 500000},
                                         AccuracyCase{"Size8192Px", Shape::k8192Px, 1000, 500000},
                                         AccuracyCase{"GuardBand", Shape::kGuardBand, 1000, 300000},
                                         AccuracyCase{"Needle", Shape::kNeedle, 15000, 100000},
                                         AccuracyCase{"Sliver", Shape::kSliver, 20000, 2000}),
                         [](const auto& c) { return std::string(c.param.name); });

TEST_P(Accuracy, WithinTheBoundOnEveryCoveredSample) {
  Random random(91);
  Errors errors;
  for (int n = 0; n < GetParam().count; ++n) {
    spec::Triangle t = random_triangle(random, GetParam().shape);
    randomize_values(random, &t);
    measure(frame_of(GetParam().shape), t, &errors);
  }
  EXPECT_GE(errors.samples, GetParam().least_samples);
  if (GetParam().shape == Shape::kSliver) {
    // A sliver's samples lie on its corners, where values are exact except for dropped fraction
    // bits.
    record(errors);
    EXPECT_LE(errors.depth_codes, kDepthBoundCodes);
    EXPECT_LE(errors.attr_lsb, kAttrBoundLsb);
    return;
  }
  expect_bounds(errors);
}

// Triangles as great as the greatest frame, walked from the first tile to the last: errors grow
// with the distance from the anchor. One stamp in some thousands is judged.
TEST(AccuracyHuge, WithinTheBoundFarFromTheAnchor) {
  Random random(92);
  Errors errors;
  for (int n = 0; n < 4; ++n) {
    const auto near = [&](int corner) { return corner + random.between(-300 * kPx, 300 * kPx); };
    spec::Triangle t =
        triangle({std::max(near(kGuardLow), kGuardLow), std::max(near(kGuardLow), kGuardLow)},
                 {std::min(near(kGuardHigh), kGuardHigh), near(0)},
                 {near(0), std::min(near(kGuardHigh), kGuardHigh)});
    randomize_values(random, &t);
    measure(kHugeFrame, t, &errors, 1999);
  }
  EXPECT_GT(errors.samples, 10000);
  expect_bounds(errors);
}

// The worst triangles that a search by hill climbing found, each with its sample.
struct WorstCase {
  spec::Triangle t;
  int x;
  int y;
  double error_codes;
};

WorstCase worst_case(std::array<Point, 3> corners, std::array<int64_t, 3> z, int x, int y,
                     double error_codes) {
  WorstCase c{triangle(corners[0], corners[1], corners[2]), x, y, error_codes};
  for (size_t i = 0; i < 3; ++i) c.t.v[i].z = z[i];
  return c;
}

TEST(AccuracyHuge, WorstTrianglesKnownComeNearTheBoundAndKeepIt) {
  const WorstCase cases[] = {
      worst_case({{{-4194223, -4194238}, {4194303, 4194303}, {152913, 4193974}}},
                 {441948840, 3871770918, 157197731}, 16375, 16375, .66269),
      worst_case({{{-4191880, -4194265}, {4193964, 4194295}, {-4194304, 4193922}}},
                 {4079127734, 232025191, 3575345517}, 16359, 16375, .66131),
  };
  for (const WorstCase& c : cases) {
    spec::SetupPrim prim;
    ASSERT_EQ(core::setup(kContract, kHugeFrame, c.t, &prim), core::Drop::kNone);
    const exact::Judge exact = judge(kHugeFrame, c.t);
    ASSERT_TRUE(exact.covers(c.x, c.y));
    double error = 0;
    core::for_each_stamp(kContract, prim, [&](const spec::Stamp& stamp) {
      if (stamp.x != c.x / 2 || stamp.y != c.y / 2) return;
      spec::Fragment fragment;
      core::interpolate(kContract, stamp, &fragment);
      const auto lane = static_cast<size_t>(c.x % 2 + 2 * (c.y % 2));
      error = std::abs(exact.depth_error(c.x, c.y, fragment.z[lane]));
    });
    EXPECT_NEAR(error, c.error_codes, .00001);
    EXPECT_LE(error, kDepthBoundCodes);
  }
}

// Constant planes keep their value exactly: 0 and the greatest code need no clamp.
TEST(AccuracyConstant, PlaneOfOneValueIsThatValueEverywhere) {
  Random random(93);
  Errors errors;
  for (int n = 0; n < 500; ++n) {
    spec::Triangle t = random_triangle(random, n % 2 == 0 ? Shape::kGuardBand : Shape::kNeedle);
    const bool top = random.between(0, 1) != 0;
    for (auto& v : t.v) {
      v.z = top ? kMaxDepthInput : 0;
      v.attr = {top ? 255 : 0, 0, 255, static_cast<int32_t>(n % 256)};
    }
    measure(kWindow, t, &errors);
  }
  EXPECT_GT(errors.samples, 50000);
  EXPECT_EQ(errors.depth_codes, 0);
  EXPECT_EQ(errors.attr_lsb, 0);
}

using Codes = std::map<std::pair<int, int>, int64_t>;

// Depth codes of a triangle on the plane that rises by (gx, gy) codes a px.
Codes codes_on_plane(std::array<Point, 3> corners, int64_t gx, int64_t gy) {
  constexpr spec::FrameState kFrame{300, 300, spec::Cull::kNone, spec::DepthFunc::kLess};
  spec::Triangle t = triangle(corners[0], corners[1], corners[2]);
  for (auto& v : t.v) v.z = (int64_t{1} << 31) + gx * (v.x - 150 * kPx) + gy * (v.y - 150 * kPx);
  Codes codes;
  spec::SetupPrim prim;
  if (core::setup(kContract, kFrame, t, &prim) != core::Drop::kNone) return codes;
  core::for_each_stamp(kContract, prim, [&](const spec::Stamp& stamp) {
    spec::Fragment fragment;
    core::interpolate(kContract, stamp, &fragment);
    for_each_sample(stamp, [&](int x, int y, size_t lane) { codes[{x, y}] = fragment.z[lane]; });
  });
  return codes;
}

// Triangles that share a corner and a plane: samples compared, samples whose codes differ.
std::pair<int, int> compare_coplanar(bool whole_codes_at_centres) {
  Random random(94);
  int compared = 0;
  int different = 0;
  for (int n = 0; n < 40; ++n) {
    int64_t gx = random.between(-20000, 20000);
    int64_t gy = random.between(-20000, 20000);
    gx -= whole_codes_at_centres ? gx % 2 : 0;
    gy += (gx + gy + (whole_codes_at_centres ? 0 : 1)) % 2;  // odd sum: halves at the centres
    const auto near_middle = [&random] {
      return Point{random.between(100 * kPx, 200 * kPx), random.between(100 * kPx, 200 * kPx)};
    };
    const Point shared = near_middle();
    const Codes outer = codes_on_plane({{{0, 0}, {299 * kPx + 7, 3}, shared}}, gx, gy);
    const Codes inner = codes_on_plane({{near_middle(), near_middle(), shared}}, gx, gy);
    for (const auto& [place, code] : inner) {
      const auto other = outer.find(place);
      if (other == outer.end()) continue;
      ++compared;
      different += code == other->second ? 0 : 1;
      EXPECT_LE(std::abs(code - other->second), 1) << n;
    }
  }
  return {compared, different};
}

TEST(Coplanar, CodesAreEqualWhereThePlaneIsWholeAtTheCentres) {
  const auto [compared, different] = compare_coplanar(true);
  EXPECT_GT(compared, 5000);
  EXPECT_EQ(different, 0);
}

// At halves a code may round either way, but two codes never differ by more than one: the bound.
// Some do differ, so the comparison works.
TEST(Coplanar, CodesDifferByAtMostOneWhereThePlaneIsHalfwayAtTheCentres) {
  const auto [compared, different] = compare_coplanar(false);
  EXPECT_GT(compared, 5000);
  EXPECT_GT(different, 0);
  EXPECT_LT(different, compared / 10);
}

// The measurement can fail: a gradient of 6 fraction bits breaks the bound.
TEST(AccuracyMutant, CoarseGradientsBreakTheBound) {
  Random random(95);
  int broken = 0;
  for (int n = 0; n < 200; ++n) {
    spec::Triangle t = random_triangle(random, Shape::k8192Px);
    randomize_values(random, &t);
    spec::SetupPrim prim;
    if (core::setup(kContract, kWindow, t, &prim) != core::Drop::kNone) continue;
    prim.planes.z.dx &= ~int64_t{0xFFF};  // 6 fraction bits, truncated
    const exact::Judge exact = judge(kWindow, t);
    core::for_each_stamp(kContract, prim, [&](const spec::Stamp& stamp) {
      spec::Fragment fragment;
      core::interpolate(kContract, stamp, &fragment);
      for_each_sample(stamp, [&](int x, int y, size_t lane) {
        const double error = exact.depth_error(x, y, fragment.z[lane]);
        broken += std::abs(error) > kDepthBoundCodes ? 1 : 0;
      });
    });
  }
  EXPECT_GT(broken, 100);
}

}  // namespace
}  // namespace pineda::test
