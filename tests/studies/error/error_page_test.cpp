#include "studies/error/error_page.h"

#include <gtest/gtest.h>

#include "studies/error/error_pictures.h"
#include "tests/studies/cycles/sample_study.h"
#include "tests/studies/picture/markup.h"

namespace pineda::studies {
namespace {

// Text by which a page would fetch or run something from elsewhere.
constexpr const char* kForeign[] = {"http", "<script", "<link", "@import", "url(", "<iframe", "//"};

bool stands_alone(const std::string& page) {
  for (const char* part : kForeign) {
    if (count(page, part) != 0) return false;
  }
  // Its only files are the error maps.
  return count(page, "src=") == count(page, "src=\"maps/") &&
         count(page, "href=") == count(page, "href=\"maps/");
}

TEST(ErrorPage, ShowsEverySubjectInEachTableAndTheGallery) {
  const auto study = sample_study();
  const auto page = error_page(study, "teapot");
  for (const Subject& s : study.subjects) {
    const std::string judged = s.judged_by_frame ? s.name + " (frame)" : s.name;
    EXPECT_EQ(count(page, ">" + s.name + "</th>"), s.judged_by_frame ? 1 : 2) << s.name;
    EXPECT_GE(count(page, ">" + judged + "</th>"), 1) << s.name;
    EXPECT_EQ(count(page, "<img src=\"" + map_file(s) + "\""), 1) << s.name;
  }
  EXPECT_EQ(count(page, "<table>"), 2);
  EXPECT_EQ(count(page, "<svg "), 5);  // three plots, the histogram, the legend
}

TEST(ErrorPage, NeedsNothingFromElsewhere) {
  EXPECT_TRUE(stands_alone(error_page(sample_study(), "teapot")));
}

TEST(ErrorPage, MutantsThatFetchAreSeen) {
  const auto page = error_page(sample_study(), "teapot");
  EXPECT_FALSE(stands_alone(page + "<img src=\"https://example.org/a.png\">"));
  EXPECT_FALSE(stands_alone(page + "<img src=\"other.png\">"));
  EXPECT_FALSE(stands_alone(page + "<script>alert(1)</script>"));
}

TEST(ErrorPage, HostileNamesAreText) {
  auto study = sample_study();
  find(&study, "low")->name = kHostileName;
  find(&study, "med")->summary = kHostileName;
  EXPECT_TRUE(stands_alone(error_page(study, kHostileName)));
}

TEST(ErrorPage, VerdictNamesTheDesignsThatFail) {
  auto study = sample_study();
  EXPECT_EQ(count(error_page(study, "teapot"), "<p class=\"good\">It holds"), 1);
  find(&study, "fp32")->missing = 5;  // baselines promise nothing
  EXPECT_EQ(count(error_page(study, "teapot"), "class=\"bad\""), 0);
  find(&study, "div28")->extra = 1;
  find(&study, "med")->color.add(99, true);
  EXPECT_EQ(
      count(error_page(study, "teapot"), "<p class=\"bad\">It does not hold: med, div28.</p>"), 1);
}

TEST(ErrorPage, WithoutMapsThereIsNoGallery) {
  auto study = sample_study();
  for (Subject& s : study.subjects) s.map = {};
  const auto page = error_page(study, "teapot");
  EXPECT_EQ(count(page, "<img"), 0);
  EXPECT_EQ(count(page, "Where the error is"), 0);
  EXPECT_EQ(count(error_page({}, "nothing"), "</html>"), 1);
}

TEST(ErrorPage, PerspectiveIsMentionedWhereItMatters) {
  auto study = sample_study();
  EXPECT_EQ(count(error_page(study, "teapot"), "3.40 LSB"), 1);
  study.affine_lsb = 0;
  EXPECT_EQ(count(error_page(study, "teapot"), "perspective"), 0);
}

}  // namespace
}  // namespace pineda::studies
