#include "studies/picture/svg.h"

#include <gtest/gtest.h>

#include <cmath>

#include "studies/picture/numbers.h"
#include "tests/studies/picture/markup.h"

namespace pineda::studies {
namespace {

TEST(Escaped, MarkupQuotesAndControlCharactersDoNotSurvive) {
  EXPECT_EQ(escaped("a<b>&\"c'\n\x01é"), "a&lt;b&gt;&amp;&quot;c&#39;  é");
  EXPECT_EQ(escaped("high_tile"), "high_tile");
}

TEST(Svg, EveryShapeIsWellFormedWithHostileText) {
  Svg svg(100, 50, kHostileName);
  svg.line({0, 0}, {1, 1}, {"none", kInk, 1, "2 2"});
  svg.arrow({0, 0}, {9, 9}, {"none", kInk});
  svg.rectangle({1, 2, 3, 4}, {kInk});
  svg.circle({1, 2}, 3, {kInk});
  svg.polygon({{1, 2}, {3, 4}, {5, 6}}, {kInk});
  svg.text({1, 2}, kHostileName, {12, kInk, Anchor::kEnd, true, true, true});
  EXPECT_TRUE(is_well_formed(svg.file()));
  EXPECT_EQ(count(svg.file(), "<script"), 0);
}

TEST(Svg, MutantsAreNotWellFormed) {
  EXPECT_FALSE(is_well_formed("<svg><text>a</svg>"));
  EXPECT_FALSE(is_well_formed("<svg><text x=\"1>a</text></svg>"));
  EXPECT_FALSE(is_well_formed("<svg><title></svg></title></svg>"));
}

TEST(Svg, AFileNamesItsNameSpaceAndAPageDoesNot) {
  const Svg svg(10, 10, "a");
  EXPECT_EQ(count(svg.file(), "http"), 1);
  EXPECT_EQ(count(inlined(svg.file()), "http"), 0);
  EXPECT_TRUE(is_well_formed(inlined(svg.file())));
}

TEST(LogAxis, DecadesAreEvenlySpacedAndUpsideDownToo) {
  const LogAxis axis(.1, 1000, 400, 0);
  EXPECT_DOUBLE_EQ(axis.at(.1), 400);
  EXPECT_NEAR(axis.at(1), 300, 1e-9);
  EXPECT_NEAR(axis.at(std::sqrt(10)), 250, 1e-9);
  EXPECT_DOUBLE_EQ(axis.at(1000), 0);
}

TEST(LogAxis, ZeroAndWhatIsBeyondLieOnTheEnds) {
  const LogAxis axis(.5, 50, 10, 20);
  EXPECT_DOUBLE_EQ(axis.at(0), 10);
  EXPECT_DOUBLE_EQ(axis.at(-1), 10);
  EXPECT_DOUBLE_EQ(axis.at(INFINITY), 20);
}

// Ticks lie on the axis, rise, and those with a text are at least two and at most `most`.
void expect_good_ticks(const LogAxis& axis, double low, double high, int most) {
  double last = 0;
  int texts = 0;
  for (const auto& tick : axis.ticks()) {
    EXPECT_GE(tick.value, low);
    EXPECT_LE(tick.value, high);
    EXPECT_GT(tick.value, last);
    last = tick.value;
    texts += tick.text.empty() ? 0 : 1;
  }
  EXPECT_GE(texts, 2);
  EXPECT_LE(texts, most);
}

TEST(LogAxis, TicksAreFewFromOneValueToThirtyDecades) {
  expect_good_ticks(LogAxis(.4, 60, 0, 1), .4, 60, 9);
  expect_good_ticks(LogAxis(.4, 4e8, 0, 1), .4, 4e8, 9);
  expect_good_ticks(LogAxis(1e-15, 1e15, 0, 1), 1e-15, 1e15, 9);
  expect_good_ticks(LogAxis::around({7, 7}, 0, 1), 1.7, 28, 9);
}

TEST(LogAxis, HoldsItsValuesAndIgnoresWhatHasNoLogarithm) {
  const LogAxis axis = LogAxis::around({0, -3, NAN, INFINITY, 2, 2000}, 0, 100);
  EXPECT_GT(axis.at(2), 0);
  EXPECT_LT(axis.at(2), 10);
  EXPECT_GT(axis.at(2000), 90);
  EXPECT_LT(axis.at(2000), 100);
  EXPECT_GT(LogAxis::around({}, 0, 100).at(5), 0);
}

TEST(Powers, AreWrittenAsAReaderExpects) {
  EXPECT_EQ(power_of_ten(-1), "0.1");
  EXPECT_EQ(power_of_ten(3), "1000");
  EXPECT_EQ(power_of_ten(14), "10¹⁴");
  EXPECT_EQ(power_of_two(-8), "2⁻⁸");
  EXPECT_EQ(power_of_two(8), "256");
  EXPECT_EQ(power_of_two(10), "2¹⁰");
}

TEST(Figures, HaveThreeDigitsThatCountAndFiveCharacters) {
  EXPECT_EQ(figure(0), "0");
  EXPECT_EQ(figure(.0002), "<.001");
  EXPECT_EQ(figure(.5), "0.500");
  EXPECT_EQ(figure(6.414), "6.41");
  EXPECT_EQ(figure(88.24), "88.2");
  EXPECT_EQ(figure(.9996), "1.00");
  EXPECT_EQ(figure(99.96), "100");
  EXPECT_EQ(figure(99'999), "99999");
  EXPECT_EQ(figure(99'999.6), "1.0e5");
  EXPECT_EQ(figure(8.31e6), "8.3e6");
  for (double value = 1e-6; value < 9e9; value *= 1.0371) EXPECT_LE(figure(value).size(), 5u);
  EXPECT_EQ(count_figure(999'999), "999,999");
  EXPECT_EQ(count_figure(1'234'567), "1.2e6");
  EXPECT_EQ(grouped(1'234'567), "1,234,567");
}

}  // namespace
}  // namespace pineda::studies
