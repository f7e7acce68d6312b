#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "studies/error/error_pictures.h"
#include "tests/studies/cycles/sample_study.h"
#include "tests/studies/picture/markup.h"

namespace pineda::studies {
namespace {

// How often a whole text element stands in a picture.
int texts(const std::string& svg, const std::string& text) { return count(svg, ">" + text + "<"); }

// Shapes of the legend: a full one and a hollow one of each kind.
constexpr int kInLegend = 2;

// The elements of a picture, from their names to what closes them.
std::vector<std::string> elements(const std::string& svg, const std::string& name) {
  std::vector<std::string> all;
  const std::string start = "<" + name + " ";
  for (size_t at = svg.find(start); at != std::string::npos; at = svg.find(start, at + 1)) {
    all.push_back(svg.substr(at, svg.find('>', at) - at));
  }
  return all;
}

// Elements of that name that contain `more`.
int markers(const std::string& svg, const std::string& name, const std::string& more) {
  const auto all = elements(svg, name);
  return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const std::string& element) {
    return element.find(more) != std::string::npos;
  }));
}

// The number that an element gives to an attribute.
double number(const std::string& element, const std::string& attribute) {
  const std::string start = " " + attribute + "=\"";
  return std::stod(element.substr(element.find(start) + start.size()));
}

TEST(SpeedErrorPlot, EverySubjectHasAPointAndAName) {
  const auto study = sample_study();
  for (const Quantity quantity : {Quantity::kDepth, Quantity::kColor}) {
    for (const Pace pace : {Pace::kHost, Pace::kClock}) {
      const auto svg = speed_error_svg(study, "teapot", quantity, pace);
      EXPECT_TRUE(is_well_formed(svg));
      EXPECT_EQ(markers(svg, "circle", "stroke="), 8 + kInLegend);
      EXPECT_EQ(markers(svg, "polygon", "stroke="), 12 + kInLegend);
      for (const Subject& s : study.subjects) {
        EXPECT_EQ(texts(svg, s.name), s.name == "points" ? 0 : 1) << s.name;
      }
      EXPECT_EQ(texts(svg, "Not shown, nothing judged or timed: points. "), 1);
    }
  }
}

TEST(SpeedErrorPlot, WrongCoverageIsHollowAndCounted) {
  auto study = sample_study();
  const auto before = speed_error_svg(study, "teapot");
  EXPECT_EQ(markers(before, "circle", "fill=\"#ffffff\""), 1);
  EXPECT_EQ(markers(before, "polygon", "fill=\"#ffffff\""), 1 + 7);
  EXPECT_EQ(texts(before, "22,221 samples wrong"), 1);
  find(&study, "med")->missing = 1;
  const auto after = speed_error_svg(study, "teapot");
  EXPECT_EQ(markers(after, "circle", "fill=\"#ffffff\""), 2);
  EXPECT_EQ(texts(after, "1 sample wrong"), 1);
}

TEST(SpeedErrorPlot, NoErrorAtAllIsOnTheFloorAndSaysSo) {
  auto study = sample_study();
  Subject* points = find(&study, "points");
  points->depth.add(0, false);
  points->seconds = .01;
  const auto svg = speed_error_svg(study, "teapot");
  EXPECT_EQ(texts(svg, "points"), 1);
  EXPECT_EQ(texts(svg, "0 ulp, 1.2e6 samples wrong"), 1);
  EXPECT_EQ(count(svg, "\"nan"), 0);
  EXPECT_EQ(count(svg, "\"inf"), 0);
}

TEST(SpeedErrorPlot, PointsStandWhereTheAxesSay) {
  ErrorStudy study;
  study.samples = 1000;
  for (const double value : {1., 100.}) {
    Subject s;
    s.name = value == 1 ? "slow" : "fast";
    s.is_design = true;
    s.seconds = 1 / value;
    s.depth.add(value, false);
    study.subjects.push_back(s);
  }
  const auto svg = speed_error_svg(study, "two");
  std::vector<std::pair<double, double>> at;
  for (const std::string& circle : elements(svg, "circle")) {
    at.emplace_back(number(circle, "cx"), number(circle, "cy"));
  }
  ASSERT_EQ(at.size(), 4u);  // the last two: fast, then slow, since the first lies on top
  EXPECT_GT(at[2].first, at[3].first + 400);
  EXPECT_LT(at[2].second, at[3].second - 200);
}

TEST(SpeedErrorPlot, HostileAndEndlessNamesDoNoHarm) {
  auto study = sample_study();
  find(&study, "low")->name = kHostileName;
  find(&study, "med")->name = std::string(200, 'w');
  const auto svg = speed_error_svg(study, kHostileName + std::string(300, 'x'));
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(count(svg, "<script"), 0);
  EXPECT_EQ(count(svg, "Without room for a name: www"), 1);
}

TEST(SpeedErrorPlot, ALongNameIsNotCutInsideACharacter) {
  std::string scene;
  for (int i = 0; i < 40; ++i) scene += "é";
  for (const char* ending : {".tri", ".ptrb"}) {  // before one of them the cut is between two bytes
    const auto svg = speed_error_svg({}, scene + ending);
    const size_t cut = svg.find("...");
    ASSERT_NE(cut, std::string::npos);
    EXPECT_EQ(svg.substr(cut + 3, 2), "é");
  }
}

TEST(SpeedErrorPlot, NothingToShowIsAnEmptyPlot) {
  EXPECT_TRUE(is_well_formed(speed_error_svg({}, "nothing")));
  EXPECT_TRUE(is_well_formed(histogram_svg({})));
}

TEST(Histogram, EverySubjectHasARowWithBarsInBothColumns) {
  const auto study = sample_study();
  const auto svg = histogram_svg(study);
  EXPECT_TRUE(is_well_formed(svg));
  for (const Subject& s : study.subjects) EXPECT_EQ(texts(svg, s.name), 1) << s.name;
  EXPECT_EQ(texts(svg, "nothing judged"), 2);             // points
  EXPECT_EQ(markers(svg, "line", "#b3261e"), 2 * 8 + 1);  // bounds, and the legend
}

TEST(Histogram, BarsAreTheSharesOfOctaves) {
  ErrorStudy study;
  Subject s;
  s.name = "a";
  s.is_design = true;
  for (int i = 0; i < 4; ++i) s.depth.add(i == 0 ? 0 : .3, false);  // 1/4 exact, 3/4 one octave
  study.subjects.push_back(s);
  const auto svg = histogram_svg(study);
  EXPECT_EQ(markers(svg, "rect", "height=\"15.0\" fill=\"#0069a8\""), 1);  // 30 * sqrt(1/4)
  EXPECT_EQ(markers(svg, "rect", "height=\"26.0\" fill=\"#0069a8\""), 1);  // 30 * sqrt(3/4)
  EXPECT_EQ(markers(svg, "rect", "fill=\"#0069a8\""), 2 + 1);              // and the legend
}

}  // namespace
}  // namespace pineda::studies
