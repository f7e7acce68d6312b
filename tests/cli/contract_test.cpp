// What the contract fixes of every command: help, figures, exit codes, silence.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/frames.h"
#include "tests/cli/program.h"
#include "tests/cli/verdict.h"

namespace pineda::test {
namespace {

TEST(Help, EveryCommandHasIt) {
  const Outcome all = pineda({"--help"});
  EXPECT_TRUE(ended_silently(all));
  for (const char* command :
       {"check", "render", "time", "rtl", "error", "walk", "designs", "scenes"}) {
    EXPECT_NE(all.out.find(std::string("\n  ") + command), std::string::npos) << command;
    const Outcome run = pineda({command, "--help"});
    EXPECT_TRUE(ended_silently(run)) << command;
    for (const char* word : {"Usage: ", "--help", "--json", "--quiet"}) {
      EXPECT_NE(run.out.find(word), std::string::npos) << command << " " << word;
    }
  }
}

TEST(Designs, ListHighTileWithItsBounds) {
  const Json design = figures({"designs"}).at("designs").at("high_tile");
  EXPECT_EQ(design.at("subpixel_bits"), 8);
  EXPECT_LE(design.at("depth_bound_ulp"), kDepthBoundUlp);
  EXPECT_LE(design.at("color_bound_lsb"), kColorBoundLsb);
  EXPECT_NE(pineda({"designs"}).out.find("high_tile"), std::string::npos);
}

/// A scene of hidden, culled and dropped triangles.
class Figures : public testing::Test {
 protected:
  Json of(const std::string& command) const {
    const Json json = figures({command, text_});
    EXPECT_TRUE(json.at("seconds").is_number_float()) << command;
    EXPECT_GT(json.at("seconds"), 0) << command;
    EXPECT_TRUE(json.at("triangles").is_number_unsigned()) << command;
    EXPECT_EQ(json.at("triangles"), scene_.triangles.size()) << command;
    return json;
  }
  static bool is_count(const Json& value) {
    return value.is_number_integer() && value.get<int64_t>() >= 0;
  }

  Scene scene_ = frame("CullBackDepthLequal");
  Scratch scratch_;
  std::string text_ = scratch_.write("scene.tri", tri_text(scene_));
};

TEST_F(Figures, OfCheckAreNumbersUnderFixedKeys) {
  const Json json = of("check");
  for (const char* key : {"mismatches", "stamps", "fragments"}) {
    EXPECT_TRUE(is_count(json.at(key))) << key;
  }
  EXPECT_TRUE(is_count(json.at("cycles").at("model")));
  EXPECT_TRUE(is_count(json.at("cycles").at("rtl")));
  // A stamp has 1 to 4 samples.
  EXPECT_GE(json.at("fragments"), json.at("stamps"));
  EXPECT_LE(json.at("fragments"), json.at("stamps").get<uint64_t>() * 4);
}

TEST_F(Figures, OfAllCommandsAgree) {
  const Json check = of("check");
  const Json time = of("time");
  const Json rtl = of("rtl");
  of("render");
  EXPECT_TRUE(is_count(time.at("cycles")));
  EXPECT_TRUE(is_count(rtl.at("cycles")));
  EXPECT_EQ(time.at("cycles"), rtl.at("cycles"));
  EXPECT_EQ(time.at("cycles"), check.at("cycles").at("model"));
  EXPECT_EQ(rtl.at("cycles"), check.at("cycles").at("rtl"));
  // A stamp a cycle is the most the hardware can do.
  EXPECT_GT(time.at("cycles"), check.at("stamps"));
}

TEST_F(Figures, OfRepeatedRunsAreThoseOfOne) {
  for (const char* command : {"render", "time", "rtl"}) {
    Json once = of(command);
    Json often = figures({command, text_, "--bench", "3"});
    EXPECT_GT(often.at("seconds"), 0) << command;
    once.erase("seconds");
    often.erase("seconds");
    EXPECT_EQ(once, often) << command;
  }
}

TEST_F(Figures, GoToAFileUnderTheSameKeys) {
  for (const auto& command : kSceneCommands) {
    const std::string file = scratch_.path("new/" + command + ".json");
    const Outcome run = pineda({command, text_, "--json", file});
    EXPECT_TRUE(ended_silently(run)) << command;
    EXPECT_NE(run.out.find("seconds"), std::string::npos) << command << ": " << run.out;
    Json in_file = Json::parse(read_bytes(file));
    Json on_stdout = figures({command, text_});
    EXPECT_EQ(in_file.flatten().size(), on_stdout.flatten().size()) << command;
    EXPECT_EQ(in_file.at("triangles"), on_stdout.at("triangles")) << command;
  }
}

TEST_F(Figures, OnStandardOutputLeaveTheTableToStandardError) {
  for (const auto& command : kSceneCommands) {
    const Outcome table = pineda({command, text_});
    const Outcome json = pineda({command, text_, "--json", "-"});
    EXPECT_TRUE(json.json().is_object()) << command;
    const auto lines = [](const std::string& text) {
      return std::count(text.begin(), text.end(), '\n');
    };
    EXPECT_GT(lines(table.out), 2) << command;
    EXPECT_EQ(lines(json.err), lines(table.out)) << command;
  }
}

TEST_F(Figures, AreLeftOutByQuiet) {
  for (const auto& command : kSceneCommands) {
    const Outcome run = pineda({command, text_, "--quiet"});
    EXPECT_TRUE(ended_silently(run)) << command;
    EXPECT_EQ(run.out, "") << command;
    const Outcome json = pineda({command, text_, "--quiet", "--json", "-"});
    EXPECT_TRUE(ended_silently(json)) << command;
    EXPECT_TRUE(json.json().is_object()) << command;
  }
  const Outcome designs = pineda({"designs", "--quiet"});
  EXPECT_TRUE(ended_silently(designs));
  EXPECT_EQ(designs.out, "");
}

TEST_F(Figures, ComeFromAnyWorkingFolder) {
  for (const auto& command : kSceneCommands) {
    const Json here = figures({command, text_});
    const Json there = figures({command, "scene.tri"}, inside(scratch_.path(".")));
    EXPECT_EQ(here.at("triangles"), there.at("triangles")) << command;
  }
  const Arguments check{"check", "scene.tri", "-o", "out"};
  EXPECT_TRUE(ended_silently(pineda(check, inside(scratch_.path(".")))));
  EXPECT_EQ(scratch_.files("out"),
            (Arguments{"check.json", "color.png", "depth.png", "report.html"}));
}

TEST_F(Figures, OfBuiltInScenesNeedNoFile) {
  for (const char* scene : {"teapot", "triangle", "grid"}) {
    const Json json = figures({"check", scene, "--size", "60x44"});
    EXPECT_EQ(json.at("mismatches"), 0) << scene;
    EXPECT_GT(json.at("fragments"), 0) << scene;
    EXPECT_EQ(json.at("width"), 60) << scene;
  }
}

TEST(Scenes, ListEveryBuiltInScene) {
  const Json scenes = figures({"scenes"}).at("scenes");
  EXPECT_EQ(scenes.at("teapot").at("triangles"), 6320);
  EXPECT_EQ(scenes.at("triangle").at("width"), 64);
  EXPECT_GT(scenes.at("hard/sliver").at("right_answer").get<std::string>().size(), 10u);
  const Outcome table = pineda({"scenes"});
  EXPECT_TRUE(ended_silently(table));
  for (const auto& [name, scene] : scenes.items()) {
    EXPECT_NE(table.out.find(name + " "), std::string::npos) << name;
    EXPECT_FALSE(scene.at("summary").empty()) << name;
  }
}

TEST(Scenes, HardCasesHoldThreeWays) {
  const Json scenes = figures({"scenes"}).at("scenes");
  int cases = 0;
  for (const auto& [name, scene] : scenes.items()) {
    if (name.rfind("hard/", 0) != 0) continue;
    ++cases;
    const Outcome check = pineda({"check", name, "--json", "-"});
    EXPECT_EQ(check.exit_code, 0) << name;
    const Json json = check.json();
    EXPECT_EQ(json.at("mismatches"), 0) << name;
    EXPECT_EQ(json.at("cycles").at("model"), json.at("cycles").at("rtl")) << name;
    EXPECT_EQ(json.at("triangles"), scene.at("triangles")) << name;
    EXPECT_EQ(json.at("width"), scene.at("width")) << name;
  }
  EXPECT_GT(cases, 20);
}

TEST(Walk, ShowsEveryStageOfATriangle) {
  const Outcome run = pineda({"walk", "triangle"});
  EXPECT_TRUE(ended_silently(run));
  for (const char* stage : {"Triangle", "SetupPrim", "Stamp", "DepthWrite", "ColorWrite"}) {
    EXPECT_NE(run.out.find(std::string("\n") + stage), std::string::npos) << stage;
  }
}

TEST(Walk, WritesEveryFieldAsJson) {
  const Outcome run = pineda({"walk", "triangle", "--stamp", "10", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0);
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json.at("setup_prim").at("e[0]").at("value"), 1539.99609375);
  EXPECT_EQ(json.at("stamp").at("mask").at("code"), 5);
  EXPECT_EQ(json.at("depth_write").at("z[0]").at("code"), 0x54d34d);
  EXPECT_EQ(json.at("color_write").at("attr[0]").at("unit"), "LSB");
  EXPECT_EQ(json.at("counters").at("stamps"), 409);
  const Outcome dropped = pineda({"walk", "triangle", "--cull", "front", "--json", "-"});
  const Outcome culled = pineda({"walk", "triangle", "--cull", "back", "--json", "-"});
  // The triangle faces one way, so exactly one of the two cull states drops it.
  EXPECT_NE(Json::parse(dropped.out).contains("dropped"),
            Json::parse(culled.out).contains("dropped"));
}

// Long enough for several updates, which come ten times a second.
const Arguments kLongRun{"check", "teapot", "--tessellate", "14"};

TEST(Progress, IsShownOnATerminalOnly) {
  Surroundings terminal;
  terminal.error_is_a_terminal = true;
  EXPECT_NE(pineda(kLongRun, terminal).err.find(" triangles"), std::string::npos);
  EXPECT_TRUE(ended_silently(pineda(kLongRun)));
}

TEST(Progress, IsLeftOutByQuiet) {
  Surroundings terminal;
  terminal.error_is_a_terminal = true;
  Arguments quiet = kLongRun;
  quiet.emplace_back("--quiet");
  EXPECT_TRUE(ended_silently(pineda(quiet, terminal)));
}

}  // namespace
}  // namespace pineda::test
