// The derived bounds against the worst triangles that a directed search finds: never exceeded, and
// approached, so that they are tight.
#include "model/spec/bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "studies/numerics/bound_search.h"

namespace pineda::studies {
namespace {

constexpr int kStarts = 24;
constexpr int kSteps = 6000;

double worst(const spec::Design& design, Value value) {
  return search_worst(spec::contract(design), value, kStarts, kSteps, 71).error;
}

class Bound : public testing::TestWithParam<spec::Design> {};
INSTANTIATE_TEST_SUITE_P(Designs, Bound, testing::ValuesIn(spec::designs()),
                         [](const auto& d) { return std::string(d.param.name); });

TEST_P(Bound, BeforeTheRoundingHoldsAndIsApproached) {
  const spec::Design& d = GetParam();
  const auto bounds = spec::error_bounds_before_rounding(d);
  if (d.reciprocal_scheme == spec::ReciprocalScheme::kNone) {
    EXPECT_EQ(bounds.depth_ulp, 0);  // ExactPlanes.EveryCodeIsTheNearest shows that it holds
    EXPECT_EQ(bounds.attribute_lsb, 0);
    return;
  }
  if (!d.depth_test) {
    EXPECT_EQ(bounds.depth_ulp, 0);
  } else {
    const double depth = worst(d, Value::kDepth);
    EXPECT_LE(depth, bounds.depth_ulp);
    EXPECT_GE(depth, bounds.depth_ulp / 2) << "the bound is not approached";
  }
  if (d.attributes == 0) {
    EXPECT_EQ(bounds.attribute_lsb, 0);
  } else if (!d.perspective) {  // with it: tests/core, Perspective
    const double color = worst(d, Value::kColor);
    EXPECT_LE(color, bounds.attribute_lsb);
    EXPECT_GE(color, bounds.attribute_lsb / 2) << "the bound is not approached";
  }
}

// The search is useful: it finds far larger errors than as many random triangles of the same size.
TEST(BoundSearch, FindsMoreThanChanceDoes) {
  const spec::Contract c = spec::contract(spec::kHighTile);
  constexpr int kGuard = 1 << 22;
  Random random(72);
  double by_chance = 0;
  for (int n = 0; n < kStarts * kSteps; ++n) {
    spec::Triangle t;
    for (auto& v : t.v) {
      v.x = random.between(-kGuard, kGuard - 1);
      v.y = random.between(-kGuard, kGuard - 1);
      v.z = random.between(0, ((int64_t{1} << 24) - 1) << 8);
    }
    const int x = random.between(0, 16383);
    const int y = random.between(0, 16383);
    by_chance = std::max(by_chance, error_before_rounding(c, Value::kDepth, t, x, y));
  }
  EXPECT_GT(by_chance, 0);
  EXPECT_GT(worst(spec::kHighTile, Value::kDepth), 1.1 * by_chance);
}

// A bound that is too tight is refuted: two fraction bits less than the formula takes.
TEST(BoundSearch, RefutesTheBoundOfAFinerDesign) {
  spec::Design finer = spec::kHighTile;
  finer.gradient_fraction_bits += 2;
  finer.tile_fraction_bits += 2;
  EXPECT_GT(worst(spec::kHighTile, Value::kDepth),
            spec::error_bounds_before_rounding(finer).depth_ulp);
}

TEST(BoundFormula, GivesTheDocumentedFigures) {
  const auto depth = [](const char* name) {
    return spec::error_bounds(*spec::find_design(name)).depth_ulp;
  };
  EXPECT_NEAR(depth("high"), .65, .005);
  EXPECT_NEAR(depth("high_tile"), .68, .005);
  EXPECT_NEAR(depth("exact"), .5, .002);
  EXPECT_NEAR(spec::error_bounds(spec::kHighTile).attribute_lsb, .66, .01);
}

}  // namespace
}  // namespace pineda::studies
