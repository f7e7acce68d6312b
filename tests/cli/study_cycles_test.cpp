// pineda study cycles, as another program drives it.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/cli/program.h"

namespace pineda::test {
namespace {

TEST(StudyCycles, CountsWithoutMeasuringUnderStallsAndLatencies) {
  const Json json =
      figures({"study", "cycles", "--scene", "triangle,grid", "--size", "48x40", "--designs",
               "high_tile,low", "--latency", "1,64", "--stall", "none,both", "--runs", "0"});
  EXPECT_EQ(json.at("holds"), true);
  EXPECT_EQ(json.at("rows").size(), 16u);
  EXPECT_FALSE(json.contains("geometric_means"));
  for (const Json& row : json.at("rows")) {
    EXPECT_EQ(row.at("model_cycles"), row.at("rtl_cycles")) << row;
    EXPECT_GT(row.at("retire").at("triangles"), 0) << row;
    EXPECT_EQ(row.at("retire").at("off"), 0) << row;
    EXPECT_EQ(row.at("width"), 48);
    EXPECT_FALSE(row.contains("speed"));
  }
}

// The bare RTL was built before.
TEST(StudyCycles, MeasuresBothSidesInOneRun) {
  setenv("PINEDA_CACHE", PINEDA_BENCH_CACHE, 1);
  const Json json = figures({"study", "cycles", "--scene", "grid", "--size", "64x48", "--runs", "1",
                             "--compiler", "g++"});
  EXPECT_EQ(json.at("holds"), true);
  const Json& row = json.at("rows").at(0);
  EXPECT_GT(row.at("triangles"), 0);
  EXPECT_EQ(row.at("compiler").get<std::string>().substr(0, 3), "g++");
  EXPECT_EQ(row.at("rtl_seconds").size(), 1u);
  for (const char* side : {"rtl", "time", "bits"}) EXPECT_GT(row.at("speed").at(side), 0) << side;
  const double rtl = row.at("speed").at("rtl");
  const double time = row.at("speed").at("time");
  EXPECT_DOUBLE_EQ(row.at("ratio").at("time"), time / rtl);
  EXPECT_NEAR(json.at("geometric_means").at("ratio_time"), time / rtl, 1e-9);
}

TEST(StudyCycles, BunnyThatIsNotThereIsLeftOutUnlessItIsAskedFor) {
  const Json json =
      figures({"study", "cycles", "--bunny", "nowhere.obj", "--size", "16x16", "--runs", "0"});
  EXPECT_EQ(json.at("left_out"), Json::array({"bunny"}));
  EXPECT_EQ(json.at("rows").size(), 4u);
  EXPECT_TRUE(is_refused(pineda({"study", "cycles", "--scene", "bunny", "--bunny", "nowhere.obj"}),
                         "nowhere.obj"));
}

TEST(StudyCycles, BadUsageIsRefused) {
  const auto study = [](const Arguments& more) {
    Arguments arguments{"study", "cycles", "--scene", "triangle", "--runs", "0"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return pineda(arguments);
  };
  EXPECT_TRUE(is_refused(study({"--designs", "exact"}), "functional model"));
  EXPECT_TRUE(is_refused(study({"--designs", "highest"}), "--design"));
  EXPECT_TRUE(is_refused(study({"--latency", "65"}), "--latency: expected 1 to 64, got 65"));
  EXPECT_TRUE(is_refused(study({"--stall", "all"}), "--stall"));
  EXPECT_TRUE(is_refused(study({"--compiler", "cc"}), "--compiler"));
  EXPECT_TRUE(is_refused(study({"--size", "48"}), "--size"));
  EXPECT_TRUE(is_refused(pineda({"study", "cycles", "--runs", "-1"}), "--runs"));
  EXPECT_TRUE(is_refused(pineda({"study", "cycles", "--scene", "random/px2"}), "px1, px1000"));
}

}  // namespace
}  // namespace pineda::test
