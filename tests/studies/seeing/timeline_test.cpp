// The timeline file: its format, and the cycles in it.
#include "studies/seeing/timeline.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

namespace pineda::test {
namespace {

using Json = nlohmann::json;
using studies::Timeline;
using studies::Window;
using timing::Cause;
using timing::Cycle;
using timing::Fifo;
using timing::Unit;

// What is wrong with a file of trace events: slices of a lane must not overlap, and the causes of a
// triangle must add up. Empty: nothing.
std::string fault(const Json& file) {
  std::map<int, Cycle> ends;
  for (const Json& e : file.at("traceEvents")) {
    for (const char* key : {"ph", "pid", "name", "args"}) {
      if (!e.contains(key)) return std::string("no ") + key + ": " + e.dump();
    }
    const std::string phase = e.at("ph");
    if (phase == "M") continue;
    if (!e.at("ts").is_number_integer()) return "no time: " + e.dump();
    if (phase == "C") continue;
    if (phase != "X") return "unknown: " + e.dump();
    const Cycle from = e.at("ts");
    const Cycle cycles = e.at("dur");
    const int lane = e.at("tid");
    if (cycles < 1 || from < ends[lane]) return "overlaps: " + e.dump();
    ends[lane] = from + cycles;
    if (lane % 2 == 0) continue;
    Cycle sum = 0;
    for (const auto& [cause, spent] : e.at("args").items()) sum += spent.get<Cycle>();
    if (sum != cycles) return "causes do not add up: " + e.dump();
  }
  return {};
}

template <class Feed>
Json timeline(const Window& window, Feed feed) {
  std::FILE* file = std::tmpfile();
  Timeline timeline(file, window, R"({"scene":"by hand"})");
  feed(&timeline);
  EXPECT_TRUE(timeline.finish());
  std::string text(static_cast<size_t>(std::ftell(file)), '\0');
  std::rewind(file);
  EXPECT_EQ(std::fread(text.data(), 1, text.size(), file), text.size());
  std::fclose(file);
  const Json json = Json::parse(text, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << text;
  uint64_t slices = 0;
  for (const Json& e : json.at("traceEvents")) slices += e.at("ph") == "X" ? 1 : 0;
  EXPECT_EQ(slices, timeline.slices());
  return json;
}

// The slices of a lane as "name@from+cycles{arguments}".
std::string lane(const Json& file, int number) {
  std::string text;
  for (const Json& e : file.at("traceEvents")) {
    if (e.at("ph") != "X" || e.at("tid") != number) continue;
    text += e.at("name").get<std::string>() + "@" + e.at("ts").dump() + "+" + e.at("dur").dump() +
            e.at("args").dump() + " ";
  }
  return text;
}

// "cycle:level" in the order of the cycles.
std::string levels(const Json& file, const std::string& fifo) {
  std::map<Cycle, int> all;
  for (const Json& e : file.at("traceEvents")) {
    if (e.at("ph") == "C" && e.at("name") == fifo) all[e.at("ts")] = e.at("args").at("level");
  }
  std::string text;
  for (const auto& [cycle, level] : all) {
    text += std::to_string(cycle) + ":" + std::to_string(level) + " ";
  }
  return text;
}

// Tiles of two triangles: the first one is tested, waits for room, is starved meanwhile, and goes
// on.
void feed_tiles(timing::Listener* to) {
  for (Cycle cycle = 4; cycle < 8; ++cycle)
    to->spent(Unit::kTiles, Cause::kBusy, cycle, cycle + 1, 5);
  to->spent(Unit::kTiles, Cause::kBlocked, 8, 10, 5);
  to->spent(Unit::kTiles, Cause::kBusy, 12, 13, 5);
  to->spent(Unit::kTiles, Cause::kBusy, 20, 21, 6);
}

TEST(Timeline, TriangleIsOneSliceWithItsCausesInIt) {
  const Json file = timeline({}, feed_tiles);
  EXPECT_EQ(fault(file), "");
  EXPECT_EQ(lane(file, 3),
            "triangle 5@4+9{\"blocked\":2,\"busy\":5,\"starved\":2} triangle 6@20+1{\"busy\":1} ");
  EXPECT_EQ(lane(file, 4), "blocked@8+2{\"triangle\":5} starved@10+2{\"triangle\":5} ");
}

// Setup takes triangle 2 while the output of triangle 1 waits.
TEST(Timeline, FrozenOutputOfAnEarlierTriangleIsASliceOfItsOwn) {
  const Json file = timeline({}, [](timing::Listener* to) {
    to->spent(Unit::kSetup, Cause::kBusy, 2, 14, 1);
    to->spent(Unit::kSetup, Cause::kBusy, 14, 21, 2);
    to->spent(Unit::kSetup, Cause::kBlocked, 21, 30, 1);
    to->spent(Unit::kSetup, Cause::kBusy, 30, 35, 2);
  });
  EXPECT_EQ(fault(file), "");
  EXPECT_EQ(lane(file, 1),
            "triangle 1@2+12{\"busy\":12} triangle 2@14+7{\"busy\":7} "
            "triangle 1@21+9{\"blocked\":9} triangle 2@30+5{\"busy\":5} ");
  EXPECT_EQ(lane(file, 2), "blocked@21+9{\"triangle\":1} ");
}

TEST(Timeline, WindowCutsSlicesAndCounts) {
  const Json file = timeline({6, 9}, feed_tiles);
  EXPECT_EQ(fault(file), "");
  EXPECT_EQ(lane(file, 3), "triangle 5@6+3{\"blocked\":1,\"busy\":2} ");
  EXPECT_EQ(lane(file, 4), "blocked@8+1{\"triangle\":5} ");
}

void feed_slots(timing::Listener* to) {
  to->slot(Fifo::kStamps, 1, 4);
  to->slot(Fifo::kStamps, 2, 6);
  to->slot(Fifo::kPrims, 3, 9);
}

TEST(Timeline, CountersAreTheLevelsOfTheFifos) {
  const Json file = timeline({}, feed_slots);
  EXPECT_EQ(levels(file, "fifo stamps"), "0:0 2:1 3:2 5:1 7:0 ");
  EXPECT_EQ(levels(file, "fifo prims"), "0:0 4:1 10:0 ");
  EXPECT_EQ(levels(file, "fifo tiles"), "0:0 ");
}

TEST(Timeline, CountersBeginWithTheLevelOfTheWindow) {
  const Json file = timeline({3, 7}, feed_slots);
  EXPECT_EQ(levels(file, "fifo stamps"), "3:2 5:1 ");
  EXPECT_EQ(levels(file, "fifo prims"), "3:0 4:1 ");
}

TEST(Timeline, SaysWhatItsTimeIs) {
  const Json file = timeline({}, [](timing::Listener*) {});
  EXPECT_EQ(file.at("otherData").at("scene"), "by hand");
  EXPECT_EQ(file.at("traceEvents").at(0).at("args").at("name"), "pineda, 1 us = 1 cycle");
}

TEST(Timeline, FullDiskIsNotSilent) {
  std::FILE* full = std::fopen("/dev/full", "w");
  ASSERT_NE(full, nullptr);
  Timeline timeline(full, {}, "{}");
  EXPECT_FALSE(timeline.finish());
  std::fclose(full);
}

// The mutants: the check that the files above pass must find each of them.
TEST(Timeline, PlantedFaultsAreFound) {
  const Json good = timeline({}, feed_tiles);
  const auto slice = [&](Json* file) -> Json& {
    for (Json& e : file->at("traceEvents")) {
      if (e.at("ph") == "X" && e.at("tid") == 3) return e;
    }
    return file->at("traceEvents").at(0);
  };
  Json longer = good;
  slice(&longer)["dur"] = 10;
  EXPECT_NE(fault(longer).find("add up"), std::string::npos);
  Json twice = good;
  twice.at("traceEvents").push_back(slice(&twice));
  EXPECT_NE(fault(twice).find("overlaps"), std::string::npos);
  Json nameless = good;
  slice(&nameless).erase("name");
  EXPECT_NE(fault(nameless).find("no name"), std::string::npos);
}

}  // namespace
}  // namespace pineda::test
