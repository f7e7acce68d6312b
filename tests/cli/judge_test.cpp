// pineda judge, as another program drives it.
#include <gtest/gtest.h>

#include "tests/cli/program.h"
#include "tests/cli/scene_file.h"

namespace pineda::test {
namespace {

class Judge : public testing::Test {
 protected:
  std::string folder() const { return scratch_.path("dump"); }

  /// Draws a scene, with perspective-correct colours.
  void draw(const std::string& scene, const std::string& design = "persp") const {
    const Arguments arguments{"render", scene, "--dump", folder(), "--quiet", "--design", design};
    ASSERT_EQ(pineda(arguments).exit_code, 0) << scene;
  }
  Outcome judge(const std::string& scene, const Arguments& more = {}) const {
    Arguments arguments{"judge", scene, "--dump", folder(), "--json", "-", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return pineda(arguments);
  }
  /// Adds to a byte of a file of the dump.
  void add(const std::string& file, size_t byte, int amount) const {
    std::string bytes = read_bytes(folder() + "/" + file);
    bytes[byte] = static_cast<char>(bytes[byte] + amount);
    scratch_.write("dump/" + file, bytes);
  }

  Scratch scratch_;
};

TEST_F(Judge, OurOwnFramesOfAllScenesHold) {
  const Json scenes = pineda({"scenes", "--json", "-"}).json().at("scenes");
  int judged = 0;
  for (const auto& [name, scene] : scenes.items()) {
    draw(name);
    const Outcome run = judge(name);
    EXPECT_EQ(run.exit_code, 0) << name << run.out << run.err;
    EXPECT_EQ(run.json().at("verdict"), "holds") << name;
    EXPECT_EQ(run.json().at("samples_wrong"), 0) << name;
    ++judged;
  }
  EXPECT_GT(judged, 40);
}

TEST_F(Judge, AByteThatIsChangedIsNamedByItsSample) {
  Random random(1);
  for (const char* scene :
       {"triangle", "hard/shared_edges", "hard/perspective", "hard/reversed_z"}) {
    draw(scene);
    const Json whole = judge(scene).json();
    const int width = whole.at("width");
    const int samples = whole.at("samples");
    for (const auto& [file, bytes, least] :
         {std::tuple{"hits.u16", 2, 1}, {"depth.u32", 4, 1}, {"color.rgba", 4, 3}}) {
      for (int n = 0; n < 6; ++n) {
        const int sample = random.between(0, samples - 1);
        // Of a depth not the last byte, whose change may be within the tolerance.
        const int byte = random.between(std::string(file) == "depth.u32" ? 1 : 0, bytes - 1);
        const int amount = random.between(least, 128);
        const auto at = static_cast<size_t>(bytes * sample + byte);
        add(file, at, amount);
        const Outcome run = judge(scene);
        add(file, at, -amount);
        ASSERT_EQ(run.exit_code, 1) << scene << " " << file << " " << at << " " << amount;
        const Json json = run.json();
        EXPECT_EQ(json.at("verdict"), "fails");
        EXPECT_EQ(json.at("samples_wrong"), 1);
        EXPECT_EQ(json.at("first").at("x"), sample % width);
        EXPECT_EQ(json.at("first").at("y"), sample / width);
      }
    }
    EXPECT_EQ(judge(scene).exit_code, 0);
  }
}

TEST_F(Judge, ToleranceAndFormatsCount) {
  draw("triangle");
  const size_t middle = 4 * (64 * 30 + 32);
  add("depth.u32", middle, 3);
  EXPECT_EQ(judge("triangle").json().at("first").at("rule"), "depth_value");
  EXPECT_EQ(judge("triangle", {"--depth-ulp", "4"}).exit_code, 0);
  add("depth.u32", middle, -3);
  add("color.rgba", middle, 3);
  EXPECT_EQ(judge("triangle").json().at("first").at("rule"), "color_value");
  EXPECT_EQ(judge("triangle", {"--color-lsb", "4"}).exit_code, 0);
  EXPECT_EQ(judge("triangle", {"--color-lsb", "0.25"}).exit_code, 1);

  // Positions and depths of another rasterizer: right by its own formats alone.
  const std::string coarse =
      scratch_.write("coarse.toml", "base = \"persp\"\nsubpixel_bits = 4\ndepth_bits = 16\n");
  draw("grid", coarse);
  EXPECT_EQ(judge("grid", {"--subpixel-bits", "4", "--depth-bits", "16"}).exit_code, 0);
  EXPECT_EQ(judge("grid", {"--design", coarse}).exit_code, 0);
  EXPECT_EQ(judge("grid", {"--subpixel-bits", "4"}).exit_code, 1);
  EXPECT_EQ(judge("grid", {"--depth-bits", "16"}).exit_code, 1);
}

TEST_F(Judge, PartsOfADumpAreEnough) {
  draw("hard/shared_edges");
  std::filesystem::remove(folder() + "/hits.u16");
  EXPECT_EQ(judge("hard/shared_edges").json().at("judged"), Json::array({"depth", "colour"}));
  std::filesystem::remove(folder() + "/depth.u32");
  EXPECT_EQ(judge("hard/shared_edges").json().at("judged"), Json::array({"colour"}));
  std::filesystem::remove(folder() + "/color.rgba");
  EXPECT_TRUE(is_refused(judge("hard/shared_edges"), "expected hits.u16, depth.u32 or color.rgba"));
}

// What it writes shows the fault alone: drawn right and changed likewise, it is judged alike.
TEST_F(Judge, TheSmallestSceneShowsIt) {
  draw("hard/shared_edges");
  add("hits.u16", 2 * (64 * 20 + 30), 1);
  const std::string smallest = scratch_.path("smallest.tri");
  const Json first = judge("hard/shared_edges", {"-o", smallest}).json().at("first");
  draw(smallest);
  EXPECT_EQ(judge(smallest).exit_code, 0);
  add("hits.u16", 2 * (64 * 20 + 30), 1);
  const Json again = judge(smallest).json();
  EXPECT_EQ(again.at("triangles"), 1);
  for (const char* same : {"x", "y", "rule"}) EXPECT_EQ(again.at("first").at(same), first.at(same));
}

TEST_F(Judge, PrintsWhatAPersonNeeds) {
  draw("triangle");
  add("color.rgba", 4 * (64 * 30 + 32) + 1, 100);
  const Outcome run = pineda({"judge", "triangle", "--dump", folder()});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find("1 of 4,096"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("(32, 30), color_value, triangle 0"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("IT DOES NOT HOLD."), std::string::npos) << run.out;
}

TEST_F(Judge, RefusesWhatItCannotJudge) {
  draw("triangle");
  EXPECT_TRUE(is_refused(pineda({"judge", "triangle"}), "--dump"));
  EXPECT_TRUE(is_refused(pineda({"judge", "triangle", "--dump", scratch_.path("none")}),
                         "none: expected hits.u16, depth.u32 or color.rgba, there is none"));
  EXPECT_TRUE(is_refused(judge("grid"), "expected 614400 bytes, 2 for each of 307200 samples"));
  EXPECT_TRUE(is_refused(judge("nowhere"), "nowhere"));
  EXPECT_TRUE(is_refused(judge("triangle", {"--depth-ulp", "-1"}), "--depth-ulp"));
  EXPECT_TRUE(is_refused(judge("triangle", {"--color-lsb", "256"}), "--color-lsb"));
  EXPECT_TRUE(is_refused(judge("triangle", {"--subpixel-bits", "40"}), "subpixel_bits"));
  EXPECT_TRUE(is_refused(judge("triangle", {"--depth-bits", "4"}), "depth_bits"));
  EXPECT_TRUE(is_refused(judge("triangle", {"-o", "scene.obj"}), "-o: expected a file .tri"));
}

}  // namespace
}  // namespace pineda::test
