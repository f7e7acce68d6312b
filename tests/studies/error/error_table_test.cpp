#include "studies/error/error_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/studies/cycles/sample_study.h"

namespace pineda::studies {
namespace {

using Lines = std::vector<std::string>;

std::string line_of(const Lines& lines, const std::string& name) {
  for (const auto& line : lines) {
    if (line.rfind(name + " ", 0) == 0) return line;
  }
  return {};
}

std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

// Does each line have an entry that ends in the column in which the n-th head `name` ends?
bool is_aligned(const Lines& lines, const std::string& name, int n, const std::string& subject) {
  size_t at = lines[1].find(name);
  for (int i = 1; i < n; ++i) at = lines[1].find(name, at + 1);
  const size_t end = at + name.size();
  const std::string line = line_of(lines, subject);
  return line.size() >= end && line[end - 1] != ' ' && (line.size() == end || line[end] == ' ');
}

TEST(ErrorTables, FitTheTerminal) {
  const auto study = sample_study();
  for (const Lines& lines : {accuracy_table(study), speed_table(study)}) {
    EXPECT_GE(lines.size(), 25u);
    for (const auto& line : lines) {
      EXPECT_LE(line.size(), 110u) << line;
      EXPECT_TRUE(line.empty() || line.back() != ' ') << line;
    }
  }
}

TEST(AccuracyTable, FiguresEndBelowTheirHeads) {
  const auto study = sample_study();
  const auto lines = accuracy_table(study);
  for (const Subject& s : study.subjects) {
    for (const char* head : {"missing", "extra"}) {
      EXPECT_TRUE(is_aligned(lines, head, 1, s.name)) << s.name << " " << head;
    }
    for (const char* head : {"max", "p99.9", "rms", "off%"}) {
      EXPECT_TRUE(is_aligned(lines, head, 1, s.name)) << s.name << " " << head;
      EXPECT_TRUE(is_aligned(lines, head, 2, s.name)) << s.name << " " << head;
    }
  }
}

TEST(AccuracyTable, AMutantOutOfLineIsSeen) {
  auto lines = accuracy_table(sample_study());
  for (auto& line : lines) {
    if (line.rfind("med ", 0) == 0) line.insert(5, " ");
  }
  EXPECT_FALSE(is_aligned(lines, "max", 1, "med"));
}

TEST(AccuracyTable, HoldsTheFiguresOfEachSubject) {
  const auto lines = accuracy_table(sample_study());
  auto low = words(line_of(lines, "low"));
  ASSERT_EQ(low.size(), 12u);
  EXPECT_EQ(low[1], "0");
  EXPECT_EQ(low[3], "88.2");
  EXPECT_EQ(low[7], "17.9");
  EXPECT_EQ(low[11], "193/33.4");
  auto determinant = words(line_of(lines, "edge_fp32_determinant"));
  EXPECT_EQ(determinant[1], "12,345");
  EXPECT_EQ(determinant[2], "9,876");
  EXPECT_EQ(determinant[11], "-");
  EXPECT_EQ(words(line_of(lines, "points")),
            (std::vector<std::string>{"points", "1.2e6", "0", "-", "-", "-", "-", "-", "-", "-",
                                      "-", "-"}));
}

TEST(AccuracyTable, DesignsAndBaselinesStandApart) {
  const auto lines = accuracy_table(sample_study());
  const auto is_rule = [](const std::string& line) { return line.rfind("----", 0) == 0; };
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), is_rule), 2);
  const auto rule = std::find_if(lines.rbegin(), lines.rend(), is_rule);
  EXPECT_EQ(rule[1].rfind("exact ", 0), 0u);
  EXPECT_EQ(rule[-1].rfind("edge_walk ", 0), 0u);
}

TEST(AccuracyTable, ADesignBeyondItsBoundIsMarkedAndOnlyThen) {
  auto study = sample_study();
  const auto good = accuracy_table(study);
  EXPECT_EQ(line_of(good, "!"), "");
  EXPECT_NE(line_of(good, "(frame)"), "");  // painter
  find(&study, "high")->depth.add(.7, true);
  const auto bad = accuracy_table(study);
  EXPECT_NE(line_of(bad, "!"), "");
  EXPECT_EQ(words(line_of(bad, "high")).back(), "!");
  EXPECT_EQ(words(line_of(bad, "high_tile")).back(), "0.680/0.660");
}

TEST(SpeedTable, HoldsRatesAndCyclesAndMarksVisitedPixels) {
  const auto lines = speed_table(sample_study());
  const auto low = words(line_of(lines, "low"));
  EXPECT_EQ(low[1], "0.916");  // 6320 triangles in 284113 / 41.2e6 s
  EXPECT_EQ(low[2], "41.2");
  EXPECT_EQ(low[3], "18.0");  // .401 * 284113 / 6320
  EXPECT_EQ(low[4], "0.401");
  const auto walk = words(line_of(lines, "edge_walk"));
  EXPECT_EQ(walk[2], "58.0");
  EXPECT_EQ(walk[4], "1.10*");
  const auto points = words(line_of(lines, "points"));
  EXPECT_EQ(points[1], "-");
  EXPECT_NE(line_of(lines, "*"), "");
}

TEST(SpeedTable, LongSummariesAreCutInTheTerminalAlone) {
  const auto study = sample_study();
  const auto line = line_of(speed_table(study), "high_tile");
  EXPECT_EQ(line.size(), 110u);
  EXPECT_EQ(line.substr(107), "...");
  EXPECT_EQ(speed(study).designs.at(4).back(),
            "default: error at the rounding limit, in-tile steps of 8 fraction bits");
}

TEST(ErrorTables, WithoutSubjectsHaveHeadsAlone) {
  EXPECT_EQ(accuracy_table({}).size(), 3u);
  EXPECT_EQ(speed_table({}).size(), 3u);
}

}  // namespace
}  // namespace pineda::studies
