#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "studies/error/error_pictures.h"
#include "tests/studies/cycles/sample_study.h"
#include "tests/studies/picture/markup.h"

namespace pineda::studies {
namespace {

using Rgb = std::array<int, 3>;
constexpr Rgb kBlack{0, 0, 0};
constexpr Rgb kCyan{0, 255, 255};
constexpr Rgb kMagenta{255, 0, 255};

// The colour of one pixel.
Rgb color_of(float error, uint8_t coverage, const ErrorScale& scale) {
  const auto rgb = error_map_rgb({{error}, {error}, {coverage}}, scale);
  return {rgb.at(0), rgb.at(1), rgb.at(2)};
}

// Lightness by Rec. 709, of the codes: it grows with perceived brightness.
double lightness(const Rgb& c) {
  const auto linear = [](int code) { return std::pow(code / 255., 2.2); };
  return .2126 * linear(c[0]) + .7152 * linear(c[1]) + .0722 * linear(c[2]);
}

TEST(ErrorMap, MissingExtraAndNothingHaveTheirOwnColors) {
  const ErrorScale scale(sample_study(), Quantity::kDepth);
  EXPECT_EQ(color_of(.3F, 1, scale), kCyan);
  EXPECT_EQ(color_of(.3F, 2, scale), kMagenta);
  EXPECT_EQ(color_of(.3F, 3, scale), kCyan);
  EXPECT_EQ(color_of(-1, 0, scale), kBlack);
  EXPECT_EQ(color_of(NAN, 0, scale), kBlack);
  EXPECT_EQ(color_of(-1, 1, scale), kCyan);
}

TEST(ErrorMap, DrawnPixelsAreNeverTheColorsOfCoverage) {
  const ErrorScale scale(sample_study(), Quantity::kDepth);
  for (double error = .01; error < 1e8; error *= 1.1) {
    const Rgb color = color_of(static_cast<float>(error), 0, scale);
    for (const Rgb& other : {kBlack, kCyan, kMagenta}) {
      const double away = std::hypot(color[0] - other[0], color[1] - other[1], color[2] - other[2]);
      EXPECT_GT(away, 50) << error;
    }
  }
  EXPECT_NE(color_of(0, 0, scale), kBlack);
}

TEST(ErrorMap, LighterMeansFurtherOffAllTheWay) {
  const ErrorScale scale(sample_study(), Quantity::kDepth);
  double last = 0;
  for (double error = .04; error < .9 * scale.greatest(); error *= 1.3) {
    const double now = lightness(color_of(static_cast<float>(error), 0, scale));
    EXPECT_GT(now, last) << error;
    last = now;
  }
}

TEST(ErrorMap, RoundingAndBeyondAreToldApart) {
  const ErrorScale scale(sample_study(), Quantity::kDepth);
  const Rgb rounding = color_of(.5F, 0, scale);
  const Rgb beyond = color_of(.51F, 0, scale);
  EXPECT_GT(rounding[2], rounding[0] + 50);  // blue
  EXPECT_GT(beyond[0], beyond[2]);           // purple
}

TEST(ErrorMap, OneScaleServesAWholeStudy) {
  ErrorStudy study = sample_study();
  EXPECT_EQ(ErrorScale(study, Quantity::kDepth).greatest(), 1e7);
  EXPECT_EQ(ErrorScale(study, Quantity::kColor).greatest(), 1e3);
  study.subjects = {*find(&study, "exact")};
  const ErrorScale scale(study, Quantity::kDepth);
  EXPECT_EQ(scale.greatest(), 10);
  EXPECT_EQ(scale.at(0), 0);
  EXPECT_LT(scale.at(.5), scale.at(.51));
  EXPECT_EQ(scale.at(10), 1);
  EXPECT_EQ(scale.at(1e9), 1);
}

TEST(ErrorMap, ShowsTheQuantityOfItsScale) {
  const ErrorStudy study = sample_study();
  const ErrorMap map{{.1F, 300}, {100, .1F}, {0, 0}};
  const auto depth = error_map_rgb(map, {study, Quantity::kDepth});
  const auto color = error_map_rgb(map, {study, Quantity::kColor});
  ASSERT_EQ(depth.size(), 6u);
  EXPECT_LT(depth[0], depth[3]);
  EXPECT_GT(color[0], color[3]);
}

TEST(ErrorMap, LegendIsWellFormedAndNamesItsEnds) {
  const auto legend = error_scale_svg({sample_study(), Quantity::kDepth});
  EXPECT_TRUE(is_well_formed(legend));
  for (const char* text : {">0<", ">½<", ">10⁷<", "sample missing", "one too many"}) {
    EXPECT_EQ(count(legend, text), 1) << text;
  }
}

TEST(ErrorMap, FileStaysInItsFolderWhateverTheName) {
  Subject s;
  s.name = "high_tile";
  EXPECT_EQ(map_file(s), "maps/high_tile.png");
  s.name = "../a b/<c>";
  EXPECT_EQ(map_file(s), "maps/.._a_b__c_.png");
}

}  // namespace
}  // namespace pineda::studies
