// pineda time's timeline, waveform and heat map agree with the figures that it prints.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "tests/cli/program.h"

namespace pineda::test {
namespace {

const std::vector<std::string> kUnits{"setup", "tiles", "coverage", "stamps", "interp_ztest"};

// Cycles of each unit by cause, "UNIT CAUSE", except those without work.
using Sums = std::map<std::string, int64_t>;

Sums sums_of_figures(const Json& figures) {
  Sums sums;
  for (const auto& unit : kUnits) {
    for (const auto& [cause, cycles] : figures.at("units").at(unit).items()) {
      if (cause != "starved" && cycles != 0) sums[unit + " " + cause] = cycles;
    }
  }
  return sums;
}

Sums sums_of_timeline(const std::string& path) {
  Sums sums;
  const Json file = Json::parse(read_bytes(path));
  std::map<int, std::string> lanes;
  for (const Json& e : file.at("traceEvents")) {
    if (e.at("name") == "thread_name") lanes[e.at("tid")] = e.at("args").at("name");
    if (e.at("ph") != "X" || e.at("name").get<std::string>().rfind("triangle", 0) != 0) continue;
    for (const auto& [cause, cycles] : e.at("args").items()) {
      if (cause != "starved") sums[lanes.at(e.at("tid")) + " " + cause] += cycles.get<int64_t>();
    }
  }
  return sums;
}

// The end of the last slice of interp_ztest.
int64_t end_of_timeline(const std::string& path) {
  constexpr int kLane = 9;
  const Json file = Json::parse(read_bytes(path));
  int64_t end = 0;
  for (const Json& e : file.at("traceEvents")) {
    if (e.at("ph") != "X" || e.at("tid") != kLane) continue;
    end = std::max(end, e.at("ts").get<int64_t>() + e.at("dur").get<int64_t>());
  }
  return end;
}

// Cycles that each unit spent in each state, by the VCD file.
Sums sums_of_vcd(const std::string& path) {
  std::istringstream in(read_bytes(path));
  std::map<std::string, std::string> units;  // by code
  std::map<std::string, std::pair<std::string, int64_t>> states;
  Sums sums;
  std::string scope;
  int64_t now = 0;
  const auto end_of = [&](const std::string& unit) {
    const auto& [cause, since] = states[unit];
    if (!cause.empty() && cause != "starved" && since != now) {
      sums[unit + " " + cause] += now - since;
    }
  };
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "$scope") {
      words >> word >> scope;
    } else if (word == "$var") {
      std::string kind, bits, code;
      words >> kind >> bits >> code;
      if (kind == "string") units[code] = scope;
    } else if (word[0] == '#') {
      now = std::stoll(word.substr(1));
    } else if (word[0] == 's') {
      std::string code;
      words >> code;
      end_of(units.at(code));
      states[units.at(code)] = {word.substr(1), now};
    }
  }
  for (const auto& unit : kUnits) end_of(unit);
  return sums;
}

class SeeingTime : public testing::TestWithParam<Arguments> {};

TEST_P(SeeingTime, FilesAddUpToTheFigures) {
  const Scratch scratch;
  Arguments arguments{"time",         "teapot",
                      "--size",       "96x72",
                      "--tessellate", "4",
                      "--timeline",   scratch.path("new/frame.json"),
                      "--trace",      scratch.path("frame.vcd"),
                      "--heat-map",   scratch.path("frame.png")};
  arguments.insert(arguments.end(), GetParam().begin(), GetParam().end());
  const Json json = figures(arguments);
  const Sums expected = sums_of_figures(json);
  EXPECT_GT(expected.at("setup busy"), 0);
  EXPECT_GT(expected.at("interp_ztest busy"), 0);
  EXPECT_EQ(sums_of_timeline(scratch.path("new/frame.json")), expected);
  EXPECT_EQ(sums_of_vcd(scratch.path("frame.vcd")), expected);
  EXPECT_EQ(scratch.files(), (Arguments{"frame.gtkw", "frame.png", "frame.vcd", "new/frame.json"}));
  const Json& written = json.at("written");
  EXPECT_EQ(written.at("trace").at("save_file"), scratch.path("frame.gtkw"));
  EXPECT_GT(written.at("timeline").at("slices"), 100);
  // The last stamp is accepted in the last cycle of the last unit.
  EXPECT_EQ(written.at("heat_map").at("cycles"),
            end_of_timeline(scratch.path("new/frame.json")) - 1);
}

INSTANTIATE_TEST_SUITE_P(Cli, SeeingTime,
                         testing::Values(Arguments{}, Arguments{"--stall", "both"},
                                         Arguments{"--depth", "off", "--stall", "sink"},
                                         Arguments{"--latency", "64"}),
                         [](const auto& param) { return "Run" + std::to_string(param.index); });

TEST(SeeingTime, ChangesNoFigure) {
  const Scratch scratch;
  Json plain = figures({"time", "teapot", "--size", "64x48", "--bits"});
  Json seen =
      figures({"time", "teapot", "--size", "64x48", "--timeline", scratch.path("frame.json")});
  for (Json* json : {&plain, &seen}) json->erase("seconds");
  EXPECT_EQ(seen.at("written").size(), 1);
  seen.erase("written");
  EXPECT_EQ(seen, plain);
}

TEST(SeeingTime, WindowKeepsFilesSmall) {
  const Scratch scratch;
  const Arguments whole{"time",         "teapot",
                        "--size",       "96x72",
                        "--tessellate", "4",
                        "--trace",      scratch.path("a.vcd"),
                        "--timeline",   scratch.path("a.json")};
  Arguments part = whole;
  part.insert(part.end(), {"--from", "1000", "--until", "1100"});
  const Json all = figures(whole).at("written");
  const Json some = figures(part).at("written");
  EXPECT_LT(some.at("trace").at("changes"), all.at("trace").at("changes").get<int>() / 10);
  for (const auto& [name, cycles] : sums_of_timeline(scratch.path("a.json"))) {
    EXPECT_LE(cycles, 100) << name;
  }
}

TEST(SeeingTime, WritesAnFstFile) {
  const Scratch scratch;
  figures({"time", "triangle", "--size", "16x16", "--trace", scratch.path("frame.fst")});
  EXPECT_EQ(scratch.files(), (Arguments{"frame.fst", "frame.gtkw"}));
  // An FST file starts with a header block: type 0, length 329.
  EXPECT_EQ(read_bytes(scratch.path("frame.fst")).substr(0, 9),
            std::string("\0\0\0\0\0\0\0\x01\x49", 9));
}

TEST(SeeingTime, GoesWhereALinkLeads) {
  const Scratch scratch;
  scratch.write("target.json", "older");
  std::filesystem::create_symlink("target.json", scratch.path("link.json"));
  figures({"time", "triangle", "--timeline", scratch.path("link.json")});
  EXPECT_TRUE(std::filesystem::is_symlink(scratch.path("link.json")));
  EXPECT_TRUE(Json::parse(read_bytes(scratch.path("target.json"))).contains("traceEvents"));
}

struct Refusal {
  std::string name;
  Arguments arguments;
  std::string says;
};
std::ostream& operator<<(std::ostream& to, const Refusal& refusal) { return to << refusal.name; }

class SeeingRefusal : public testing::TestWithParam<Refusal> {};

// In the scratch folder "file" is a file and "folder.json" is a folder.
TEST_P(SeeingRefusal, IsOneLineAndLeavesNothing) {
  const Scratch scratch;
  scratch.write("file", "older");
  std::filesystem::create_directory(scratch.path("folder.json"));
  Arguments arguments{"time", "triangle"};
  arguments.insert(arguments.end(), GetParam().arguments.begin(), GetParam().arguments.end());
  const Outcome run = pineda(arguments, inside(scratch.path(".")));
  EXPECT_TRUE(is_refused(run, GetParam().says));
  EXPECT_EQ(run.out, "");  // refused before the frame was drawn
  EXPECT_EQ(scratch.files(), Arguments{"file"});
  EXPECT_FALSE(std::filesystem::exists(scratch.path("new")));
}

INSTANTIATE_TEST_SUITE_P(
    Cli, SeeingRefusal,
    testing::Values(
        Refusal{"TimelineOfAnotherEnding", {"--timeline", "a.txt"}, ".json"},
        Refusal{"TraceOfAnotherEnding", {"--trace", "a.json"}, ".fst or .vcd"},
        Refusal{"HeatMapOfAnotherEnding", {"--heat-map", "a.jpg"}, ".png"},
        Refusal{"TimelineInAFolderOfThatName", {"--timeline", "folder.json"}, "folder.json"},
        Refusal{"TimelineBelowAFile", {"--timeline", "file/a.json"}, "file/a.json"},
        Refusal{"TraceBelowAFile", {"--trace", "file/a.fst"}, "file/a.fst"},
        Refusal{"HeatMapBelowAFile", {"--heat-map", "file/a.png"}, "file/a.png"},
        Refusal{"OneOfTwo", {"--timeline", "new/a.json", "--trace", "file/a.vcd"}, "file/a.vcd"},
        Refusal{
            "WindowOfNothing", {"--timeline", "a.json", "--from", "9", "--until", "9"}, "--until"},
        Refusal{"WindowBeforeTheFrame", {"--timeline", "a.json", "--from", "-1"}, "--from"},
        Refusal{"WindowOfNoFile", {"--from", "9"}, "--timeline"},
        Refusal{"ManyRuns", {"--timeline", "a.json", "--bench", "2"}, "--bench"}),
    [](const auto& param) { return param.param.name; });

}  // namespace
}  // namespace pineda::test
