// pineda study cycles, as another program drives it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "tests/cli/program.h"

namespace pineda::test {
namespace {

TEST(StudyCycles, CountsWithoutMeasuringUnderStallsAndMemories) {
  const Json json = figures({"study", "cycles", "--scene", "triangle,grid", "--size", "48x40",
                             "--designs", "high_tile,low", "--memory", "ideal,dram,dram_merged",
                             "--latency", "1,64", "--stall", "none,both", "--runs", "0"});
  EXPECT_EQ(json.at("holds"), true);
  EXPECT_EQ(json.at("rows").size(), 32u);
  EXPECT_FALSE(json.contains("geometric_means"));
  for (const Json& row : json.at("rows")) {
    EXPECT_EQ(row.at("model_cycles"), row.at("rtl_cycles")) << row;
    EXPECT_GT(row.at("retire").at("triangles"), 0) << row;
    EXPECT_EQ(row.at("retire").at("off"), 0) << row;
    EXPECT_EQ(row.at("counters_compared"), 58) << row;
    EXPECT_EQ(row.at("counters_off"), 0) << row;
    EXPECT_EQ(row.contains("depth_latency_cycles"), row.at("memory") == "ideal") << row;
    EXPECT_EQ(row.at("width"), 48);
    EXPECT_FALSE(row.contains("speed"));
  }
  const Json& worst = json.at("worst");
  ASSERT_EQ(worst.size(), 3u);
  EXPECT_EQ(worst.at(1).at("design"), "low");
  EXPECT_EQ(worst.at(1).at("rows"), 16);
  EXPECT_EQ(worst.at(2).at("design"), "all");
  EXPECT_EQ(worst.at(2).at("rows"), 32);
  EXPECT_EQ(worst.at(2).at("rows_off"), 0);
}

/// "memory, latency, stalls" of each row, with the RTL's cycles.
std::vector<std::pair<std::string, int64_t>> parts_of(const Arguments& more) {
  Arguments arguments{"study",    "cycles", "--all", "--designs", "tiny", "--scene",
                      "triangle", "--size", "32x24", "--runs",    "0"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Json json = figures(arguments);
  std::vector<std::pair<std::string, int64_t>> parts;
  for (const Json& row : json.at("rows")) {
    const std::string latency =
        row.contains("depth_latency_cycles") ? row.at("depth_latency_cycles").dump() : "";
    parts.emplace_back(
        row.at("memory").get<std::string>() + latency + " " + row.at("stall").get<std::string>(),
        row.at("rtl_cycles").get<int64_t>());
  }
  return parts;
}

// Setup is slow in this design, so stalls of the source cost no cycles.
TEST(StudyCycles, AllIsEveryMemoryAndEveryStallUnlessGiven) {
  const char* expected[] = {"ideal1 none",      "ideal8 none",   "ideal64 none", "dram none",
                            "dram_merged none", "ideal8 source", "ideal8 sink",  "ideal8 both"};
  const auto parts = parts_of({});
  ASSERT_EQ(parts.size(), std::size(expected));
  std::set<int64_t> cycles;
  for (size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(parts[i].first, expected[i]);
    cycles.insert(parts[i].second);
  }
  EXPECT_EQ(cycles.size(), 6u);

  const auto given = parts_of({"--stall", "sink", "--memory", "ideal,dram", "--latency", "2"});
  ASSERT_EQ(given.size(), 2u);
  EXPECT_EQ(given[0].first, "ideal2 sink");
  EXPECT_EQ(given[1].first, "dram sink");
}

// The bare RTL was built before the tests.
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

// The bare RTL has the same memory and the same stalls.
TEST(StudyCycles, MeasuresWhereMemoriesAndPortsStall) {
  setenv("PINEDA_CACHE", PINEDA_BENCH_CACHE, 1);
  const Json json =
      figures({"study", "cycles", "--scene", "grid", "--size", "64x48", "--runs", "1", "--compiler",
               "g++", "--memory", "ideal,dram,dram_merged", "--stall", "none,source,sink,both"});
  EXPECT_EQ(json.at("holds"), true);
  ASSERT_EQ(json.at("rows").size(), 12u);
  std::set<int64_t> cycles;
  for (const Json& row : json.at("rows")) {
    cycles.insert(row.at("rtl_cycles").get<int64_t>());
    const Json& speed = row.at("speed");
    for (const char* side : {"rtl", "time", "bits"}) EXPECT_GT(speed.at(side), 0) << row;
    EXPECT_DOUBLE_EQ(row.at("ratio").at("bits"),
                     speed.at("bits").get<double>() / speed.at("rtl").get<double>());
  }
  EXPECT_EQ(cycles.size(), 6u);  // of each memory, with and without stalls of the sink
}

// A program whose bare RTL has a memory that answers a cycle late: its speed would be that of
// another frame.
TEST(StudyCycles, BareRtlThatTakesOtherCyclesIsRefused) {
  setenv("PINEDA_CACHE", PINEDA_BENCH_CACHE, 1);
  Surroundings with_fault;
  with_fault.program = std::string(PINEDA_MUTANTS) + "bare";
  const auto study = [&](const char* memory, const char* stall) {
    return pineda({"study", "cycles", "--scene", "grid", "--size", "64x48", "--runs", "1",
                   "--compiler", "g++", "--memory", memory, "--stall", stall},
                  with_fault);
  };
  const std::pair<const char*, const char*> asked[] = {
      {"ideal", "sink"}, {"dram", "sink"}, {"dram", "none"}};
  for (const auto& [memory, stall] : asked) {
    const Outcome run = study(memory, stall);
    EXPECT_EQ(run.exit_code, 1) << memory << ", " << stall;
    EXPECT_NE(run.err.find("the bare RTL takes"), std::string::npos) << run.err;
  }
  EXPECT_EQ(study("ideal", "none").exit_code, 0);  // the memory is not asked there
}

TEST(StudyCycles, BunnyThatIsNotThereIsLeftOutUnlessItIsAskedFor) {
  const Json json =
      figures({"study", "cycles", "--bunny", "nowhere.obj", "--size", "16x16", "--runs", "0"});
  EXPECT_EQ(json.at("left_out"), Json::array({"bunny"}));
  EXPECT_EQ(json.at("rows").size(), 4u);
  EXPECT_TRUE(is_refused(pineda({"study", "cycles", "--scene", "bunny", "--bunny", "nowhere.obj"}),
                         "nowhere.obj"));
}

// A design with frames up to 1024 px.
TEST(StudyCycles, BunnyIsSmallerWhereTheFrameIsTooLarge) {
  const Scratch scratch;
  const std::string mesh = scratch.write("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Json json = figures({"study", "cycles", "--scene", "bunny", "--bunny", mesh, "--designs",
                             "tiny,low", "--runs", "0"});
  EXPECT_EQ(json.at("rows").at(0).at("width"), 640);
  EXPECT_EQ(json.at("rows").at(1).at("width"), 1920);
}

// Refused before anything is drawn, whichever design cannot draw the frame.
TEST(StudyCycles, FrameThatADesignCannotDrawIsRefused) {
  EXPECT_TRUE(is_refused(pineda({"study", "cycles", "--scene", "triangle", "--designs", "low,tiny",
                                 "--size", "1920x1080", "--runs", "0"}),
                         "1024x1024"));
}

TEST(StudyCycles, BadUsageIsRefused) {
  const auto study = [](const Arguments& more) {
    Arguments arguments{"study", "cycles", "--scene", "triangle", "--runs", "0"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return pineda(arguments);
  };
  EXPECT_TRUE(is_refused(study({"--designs", "exact"}), "functional model"));
  EXPECT_TRUE(is_refused(study({"--designs", "highest"}), "--design"));
  EXPECT_TRUE(is_refused(study({"--latency", "1025"}), "--latency: expected 1 to 1024, got 1025"));
  EXPECT_TRUE(is_refused(study({"--stall", "all"}), "--stall"));
  EXPECT_TRUE(is_refused(study({"--memory", "sram"}), "--memory"));
  EXPECT_TRUE(is_refused(study({"--memory", "dram", "--latency", "8"}), "only an ideal memory"));
  EXPECT_TRUE(is_refused(study({"--compiler", "cc"}), "--compiler"));
  EXPECT_TRUE(is_refused(study({"--size", "48"}), "--size"));
  EXPECT_TRUE(is_refused(pineda({"study", "cycles", "--runs", "-1"}), "--runs"));
  EXPECT_TRUE(is_refused(pineda({"study", "cycles", "--scene", "random/px2"}), "px1, px1000"));
}

}  // namespace
}  // namespace pineda::test
