// pineda error and pineda study, as other programs drive them.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/frames.h"
#include "tests/cli/program.h"

namespace pineda::test {
namespace {

const std::string kTriangle = "v 0 0 .2 1 1 2 3 4\nv 8 0 .4 1 1 2 3 4\nv 0 8 .9 1 9 2 3 4\n";

std::string repeated(const std::string& head, const std::string& triangle, int times) {
  std::string text = head;
  for (int i = 0; i < times; ++i) text += triangle;
  return text;
}

/// The subjects hold the fixed keys, with figures of the right kind.
void expect_keys(const Json& subjects) {
  for (const auto& [name, s] : subjects.items()) {
    EXPECT_TRUE(s.at("coverage").at("missing").is_number_unsigned()) << name;
    EXPECT_TRUE(s.at("coverage").at("extra").is_number_unsigned()) << name;
    EXPECT_TRUE(s.at("depth").at("max_ulp").is_number()) << name;
    EXPECT_TRUE(s.at("color").at("max_lsb").is_number()) << name;
    for (const char* key : {"p999_ulp", "rms_ulp", "misrounded"}) {
      EXPECT_TRUE(s.at("depth").contains(key)) << name << ' ' << key;
    }
    EXPECT_GT(s.at("seconds"), 0) << name;
    EXPECT_GT(s.at("triangles_per_second"), 0) << name;
  }
}

TEST(Error, JudgesEveryDesignAndBaselineUnderFixedKeys) {
  const Json json = figures({"error", "triangle"});
  EXPECT_EQ(json.at("triangles"), 1);
  EXPECT_EQ(json.at("samples"), 1510);
  EXPECT_EQ(json.at("holds"), true);
  EXPECT_GT(json.at("seconds"), 0);
  const Json& designs = json.at("designs");
  for (const char* name :
       {"low", "med", "med_plus", "high", "high_tile", "high_plus", "div28", "exact"}) {
    ASSERT_TRUE(designs.contains(name)) << name;
    EXPECT_EQ(designs.at(name).at("coverage").at("missing"), 0) << name;
    EXPECT_EQ(designs.at(name).at("coverage").at("extra"), 0) << name;
    EXPECT_LE(designs.at(name).at("depth").at("max_ulp"),
              designs.at(name).at("depth").at("bound_ulp"));
    EXPECT_EQ(designs.at(name).contains("cycles"), std::string(name) != "exact") << name;
  }
  expect_keys(designs);
  for (const char* name : {"edge_walk", "edge_smooth", "barycentric", "fp64", "fp32", "painter",
                           "subdivision", "points"}) {
    EXPECT_TRUE(json.at("baselines").contains(name)) << name;
  }
  expect_keys(json.at("baselines"));
  EXPECT_GT(json.at("baselines").at("points").at("coverage").at("missing"), 1000);
}

// The cycles are those that `pineda time` prints.
TEST(Error, CyclesAreTheCycleModels) {
  const Json json = figures({"error", "triangle", "--design", "high_tile,low"});
  for (const char* name : {"high_tile", "low"}) {
    EXPECT_EQ(json.at("designs").at(name).at("cycles").at("total"),
              figures({"time", "triangle", "--design", name}).at("cycles"))
        << name;
  }
  EXPECT_EQ(json.at("designs").size(), 2u);
}

class SinglePrecision : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Error, SinglePrecision, testing::Values("sliver", "far_mesh"));

TEST_P(SinglePrecision, FailsAndTheExactFormsDoNot) {
  const Json json = figures({"error", std::string("hard/") + GetParam(), "--design", "high_tile"});
  const Json& baselines = json.at("baselines");
  const auto wrong = [&](const char* name) {
    const Json& coverage = baselines.at(name).at("coverage");
    return coverage.at("missing").get<int64_t>() + coverage.at("extra").get<int64_t>();
  };
  EXPECT_GT(wrong("fp32"), 10);
  EXPECT_GT(wrong("edge_fp32_determinant"), 10);
  for (const char* name : {"edge_walk", "edge_smooth", "barycentric", "barycentric_incremental",
                           "fp64", "subdivision"}) {
    EXPECT_EQ(wrong(name), 0) << name;
  }
}

TEST(Error, WritesThePagePlotsAndMaps) {
  const Scratch scratch;
  const Outcome run = pineda({"error", "triangle", "-o", scratch.path("out")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("It holds"), std::string::npos);
  for (const char* name : {"high_tile", "fp32", "painter"}) {
    EXPECT_NE(run.out.find(name), std::string::npos) << name;
  }
  for (const char* file : {"report.html", "speed_error.svg", "histogram.svg", "error.json",
                           "maps/high_tile.png", "maps/fp32.png"}) {
    EXPECT_GT(read_bytes(scratch.path(std::string("out/") + file)).size(), 200u) << file;
  }
}

TEST(Error, EveryNthTriangleOfASceneThatIsTooLargeIsJudged) {
  const Scratch scratch;
  const std::string large =
      "v -900 -900 .2 1 1 2 3 4\nv 4000 -900 .4 1 1 2 3 4\n"
      "v -900 4000 .9 1 9 2 3 4\n";
  const std::string path =
      scratch.write("large.tri", repeated("pineda-tri 1\nsize 1024 1024\n", large, 33));
  EXPECT_TRUE(is_refused(pineda({"error", path}), "large"));
  const std::string says = pineda({"error", path}).err;
  EXPECT_NE(says.find("33,554,432 covered samples"), std::string::npos) << says;
  EXPECT_NE(says.find("--every"), std::string::npos) << says;
  EXPECT_NE(says.find("pineda check"), std::string::npos) << says;
  const Json json = figures({"error", path, "--every", "33", "--design", "high_tile"});
  EXPECT_EQ(json.at("triangles"), 33);
  EXPECT_EQ(json.at("judged_triangles"), 1);
}

TEST(Error, BadInputIsOneLineAndNothingIsWritten) {
  const Scratch scratch;
  const auto refused = [&](const Arguments& arguments, const char* says) {
    Arguments all{"error"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    all.insert(all.end(), {"-o", scratch.path("out")});
    EXPECT_TRUE(is_refused(pineda(all), says));
    EXPECT_FALSE(std::filesystem::exists(scratch.path("out")));
  };
  refused({"triangle", "--design", "best"}, "high_tile");
  refused({"triangle", "--design", "high,best"}, "'best'");
  refused({"triangle", "--design", ""}, "--design");
  refused({"triangle", "--every", "0"}, "--every");
  refused({"grid", "--size", "4096x2048"}, "4,194,304 pixels");
  refused({scratch.write("empty.tri", "pineda-tri 1\nsize 8 8\n")}, "at least one triangle");
  const std::string nan = "v nan 0 0 1 1 2 3 4\nv 8 0 0 1 1 2 3 4\nv 0 8 0 1 1 2 3 4\n";
  refused({scratch.write("nan.tri", "pineda-tri 1\nsize 8 8\n" + nan)}, "at least one triangle");
  refused({scratch.write("bad.tri", "pineda-tri 1\nsize 8 8\n" + kTriangle + "w\n")},
          "bad.tri:6: expected ");
}

// Commands that cannot use a design refuse it, with the reason.
TEST(Designs, ExactHasNeitherCyclesNorRtl) {
  for (const char* command : {"time", "rtl", "check"}) {
    EXPECT_TRUE(is_refused(pineda({command, "triangle", "--design", "exact"}), "functional model"))
        << command;
  }
  EXPECT_EQ(figures({"check", "triangle", "--design", "div28"}).at("mismatches"), 0);
  EXPECT_EQ(figures({"render", "triangle", "--design", "exact"}).at("triangles"), 1);
}

TEST(Study, DesignPointsHoldOnRandomTriangles) {
  const Json json = figures({"study", "design-points", "--triangles", "50"});
  EXPECT_EQ(json.at("holds"), true);
  EXPECT_EQ(json.at("designs").size(), 8u);
  const Json& high_tile = json.at("designs").at("high_tile");
  EXPECT_EQ(high_tile.at("wrong_samples"), 0);
  EXPECT_EQ(high_tile.at("z_adder_bits"), 34);
  EXPECT_NE(pineda({"study", "design-points", "--triangles", "20"}).out.find("It holds"),
            std::string::npos);
}

// One parameter at a time: more bits cost more, and every point keeps its bounds.
TEST(Study, ParametersSayWhatEachCostsAndBuys) {
  const Json json = figures(
      {"study", "parameters", "grid", "--size", "64x48", "--parameter", "depth_bits,stamp_px"});
  EXPECT_TRUE(json.at("holds").get<bool>());
  int64_t cost = 0;
  int64_t cycles = INT64_MAX;
  int bases = 0;
  for (const Json& point : json.at("points")) {
    bases += point.at("is_base").get<bool>() ? 1 : 0;
    EXPECT_EQ(point.at("missing"), 0);
    EXPECT_LE(point.at("depth").at("max_ulp"), point.at("depth").at("bound_ulp"));
    EXPECT_LE(point.at("color").at("max_lsb"), point.at("color").at("bound_lsb"));
    if (point.at("parameter") == "depth_bits") {
      EXPECT_GT(point.at("cost_bits").at("total"), cost);
      cost = point.at("cost_bits").at("total");
    } else {
      EXPECT_LT(point.at("cycles"), cycles);  // the larger the stamp
      cycles = point.at("cycles");
    }
  }
  EXPECT_EQ(bases, 2);
  EXPECT_TRUE(is_refused(pineda({"study", "parameters", "grid", "--parameter", "colour"}),
                         "--parameter: expected one of subpixel_bits"));
}

TEST(Study, BadUsageIsRefused) {
  EXPECT_TRUE(is_refused(pineda({"study"}), "design-points"));
  EXPECT_TRUE(is_refused(pineda({"study", "everything"}), "design-points"));
  EXPECT_TRUE(is_refused(pineda({"study", "design-points", "--triangles", "0"}), "--triangles"));
  EXPECT_TRUE(is_refused(pineda({"study", "reciprocals", "--sead", "1"}), "--sead"));
}

}  // namespace
}  // namespace pineda::test
