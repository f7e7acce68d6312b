// The design points and the reciprocals on random input: a slice of `pineda study`.
#include "studies/numerics/design_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "model/spec/bounds.h"
#include "studies/numerics/reciprocals.h"

namespace pineda::studies {
namespace {

TEST(DesignPoints, EachCoversTheRightSamplesOfSixClassesWithinItsBounds) {
  DesignPointOptions options;
  for (const spec::Design& d : spec::designs()) {
    if (same_formats(d, spec::kHighTile)) options.designs.push_back(d);
  }
  ASSERT_EQ(options.designs.size(), spec::designs().size() - 1);  // all but tiny
  options.triangles = 400;
  const auto points = study_design_points(options);
  for (const DesignPoint& p : points) {
    EXPECT_EQ(p.wrong_samples, 0u) << p.design.name;
    EXPECT_TRUE(p.broken.empty()) << p.design.name << ": " << p.broken.front();
    EXPECT_GT(p.samples, 500000u);
    // Final rounding alone gives this error, so enough was measured.
    EXPECT_GE(p.max_depth_ulp, p.design.depth_test ? .49 : 0);
  }
}

// The order of the front: each better design has a smaller error.
TEST(DesignPoints, ErrorFallsAlongTheFront) {
  DesignPointOptions options;
  for (const char* name : {"low", "med", "med_plus", "high"}) {
    options.designs.push_back(*spec::find_design(name));
  }
  options.triangles = 300;
  const auto points = study_design_points(options);
  for (size_t i = 1; i < points.size(); ++i) {
    EXPECT_LT(points[i].max_depth_ulp, .8 * points[i - 1].max_depth_ulp) << points[i].design.name;
    EXPECT_LT(points[i].max_color_lsb, points[i - 1].max_color_lsb) << points[i].design.name;
  }
}

TEST(DesignPoints, CodesOfCoplanarTrianglesDifferLessTheBetterTheDesign) {
  const auto differ = [](const char* name) {
    return coplanar_difference(*spec::find_design(name), 60, 1);
  };
  EXPECT_GT(differ("low"), .3);
  EXPECT_LT(differ("med"), .5 * differ("low"));
  EXPECT_LT(differ("med_plus"), .5 * differ("med"));
  EXPECT_LT(differ("high_tile"), .001);
  EXPECT_EQ(differ("exact"), 0);
}

TEST(SetupProducts, CountedByHandForTheDefault) {
  // Area and edges 8*24*24; depth 4*33*24 + 2*56*30 + 2*52*24; a colour 4*9*24 + 2*32*30 + 2*36*24,
  // four of them; two Newton steps 4*32*32.
  const int64_t depth = 4 * 33 * 24 + 2 * 56 * 30 + 2 * 52 * 24;
  const int64_t color = 4 * 9 * 24 + 2 * 32 * 30 + 2 * 36 * 24;
  EXPECT_EQ(setup_product_bits(spec::kHighTile), 8 * 24 * 24 + depth + 4 * color + 4 * 32 * 32);
}

class Reciprocals : public testing::TestWithParam<size_t> {};
INSTANTIATE_TEST_SUITE_P(Schemes, Reciprocals, testing::Range<size_t>(0, 9));

TEST_P(Reciprocals, KeepTheirBoundAndComeNearIt) {
  const auto rows = reciprocal_rows();
  ASSERT_EQ(rows.size(), 9u);
  const ReciprocalRow& row = rows[GetParam()];
  const ReciprocalError worst = reciprocal_error(row.design, int64_t{1} << 18);
  const double bound = spec::reciprocal_error_bound(row.design);
  EXPECT_LE(worst.error, bound) << row.name << ": area2 " << worst.area2;
  EXPECT_EQ(worst.exhaustive, row.design.reciprocal_bits <= 17) << row.name;
  EXPECT_GE(worst.error, bound / 2) << row.name;
  EXPECT_GE(worst.good_bits(), row.prototype_good_bits - .2) << row.name;
}

TEST(ReciprocalSchemes, BothRadicesGiveTheNearestMantissa) {
  spec::Design radix2 = spec::kHighTile;
  radix2.reciprocal_scheme = spec::ReciprocalScheme::kRestoring2;
  spec::Design radix4 = radix2;
  radix4.reciprocal_scheme = spec::ReciprocalScheme::kRestoring4;
  EXPECT_LT(spec::reciprocal_cycles(radix4), spec::reciprocal_cycles(radix2));
  EXPECT_LE(reciprocal_error(radix2, 1 << 16).error, std::exp2(-30));
  EXPECT_EQ(reciprocal_error(radix2, 1 << 16).area2, reciprocal_error(radix4, 1 << 16).area2);
}

// The search sees a scheme that is too coarse: here a Newton step is missing.
TEST(ReciprocalSchemes, MissingNewtonStepIsSeen) {
  spec::Design d = spec::kHighTile;
  const double bound = spec::reciprocal_error_bound(d);
  d.reciprocal_newton_steps = 1;
  EXPECT_GT(reciprocal_error(d, 1 << 16).error, 100 * bound);
}

TEST(ReciprocalRom, SizesOfTheTable) {
  const auto rows = reciprocal_rows();
  const auto bits = [&](size_t i) { return reciprocal_rom_size_bits(rows[i].design); };
  EXPECT_EQ(bits(0), 1024 * 11);
  EXPECT_EQ(bits(1), 256 * 9);
  EXPECT_EQ(bits(3), 128 * (27 + 21 + 14));
  EXPECT_EQ(bits(7), 0);
}

}  // namespace
}  // namespace pineda::studies
