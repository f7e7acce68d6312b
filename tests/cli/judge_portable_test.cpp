// Portable cases and pineda judge --portable, as another program drives them.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/program.h"

namespace pineda::test {
namespace {

/// The committed frames with perspective as portable cases, and of every fortieth a frame as our model
/// draws it.
class JudgePortable : public testing::Test {
 protected:
  void SetUp() override {
    run({"vectors", "export", std::string(PINEDA_VECTORS) + "/frame/persp_level1_seed1.txt",
         "--portable", "-o", cases()});
    run({"vectors", "export", cases(), "--tri", "-o", scratch_.path("scenes")});
    const std::vector<std::string> files = scratch_.files("scenes");
    ASSERT_GT(files.size(), 400u);
    for (size_t i = 0; i < files.size(); i += 40) {
      names_.push_back(files[i].substr(0, files[i].size() - 4));
      run({"render", scratch_.path("scenes/" + files[i]), "--design", "persp", "--dump",
           scratch_.path("dump/" + names_.back())});
    }
  }

  std::string cases() const { return scratch_.path("cases.txt"); }
  Outcome judge(const Arguments& more = {"--drawn-only"}) const {
    Arguments arguments{"judge",  "--portable", cases(),  "--dump", scratch_.path("dump"),
                        "--json", "-",          "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return pineda(arguments);
  }
  /// Adds to a byte of a frame.
  void add(const std::string& file, size_t byte, int amount) const {
    std::string bytes = read_bytes(scratch_.path(file));
    bytes.at(byte) = static_cast<char>(bytes[byte] + amount);
    scratch_.write(file, bytes);
  }

  Scratch scratch_;
  std::vector<std::string> names_;

 private:
  static void run(Arguments arguments) {
    arguments.push_back("--quiet");
    const Outcome outcome = pineda(arguments);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
};

TEST_F(JudgePortable, OurFramesHoldAndAWrongOneIsNamed) {
  const Outcome right = judge();
  EXPECT_EQ(right.exit_code, 0) << right.out;
  EXPECT_EQ(right.json().at("judged"), names_.size());
  EXPECT_EQ(right.json().at("not_drawn").size() + names_.size(), right.json().at("cases"));

  const std::string& wrong = names_[7];
  add("dump/" + wrong + "/hits.u16", 0, 1);
  const Outcome outcome = judge({"--drawn-only", "-o", scratch_.path("smallest.tri")});
  EXPECT_EQ(outcome.exit_code, 1);
  const Json json = outcome.json();
  EXPECT_EQ(json.at("cases_wrong"), 1);
  EXPECT_EQ(json.at("samples_wrong"), 1);
  EXPECT_EQ(json.at("first").at("case"), wrong);
  EXPECT_EQ(json.at("first").at("x"), 0);
  EXPECT_EQ(json.at("first").at("y"), 0);
  EXPECT_EQ(json.at("failures").at(0).at("case"), wrong);
  EXPECT_TRUE(std::filesystem::exists(scratch_.path("smallest.tri")));
}

TEST_F(JudgePortable, ACaseWithoutAFrameFailsUnlessLeftOut) {
  EXPECT_EQ(judge({}).exit_code, 1);
  EXPECT_EQ(judge().exit_code, 0);
  std::filesystem::remove_all(scratch_.path("dump"));
  EXPECT_TRUE(is_refused(judge(), "expected a folder for each case"));
}

TEST_F(JudgePortable, ToleranceIsTheFilesOrTheOptions) {
  for (const std::string& name : names_) {
    const std::string file = "dump/" + name + "/color.rgba";
    const std::string colors = read_bytes(scratch_.path(file));
    for (size_t i = 0; i < colors.size(); i += 4) {
      if (colors.compare(i, 4, std::string(4, 0)) != 0) add(file, i, 3);
    }
  }
  EXPECT_EQ(judge().exit_code, 1);
  EXPECT_EQ(judge().json().at("rules").size(), 1u);
  EXPECT_TRUE(judge().json().at("rules").contains("color_value"));
  EXPECT_EQ(judge({"--drawn-only", "--color-lsb", "255"}).exit_code, 0);
}

TEST_F(JudgePortable, WhatTheFileSaysIsComputedAnew) {
  const std::string text = read_bytes(cases());
  for (const std::string keyword : {"\nfragment ", "\npixel ", "\nsnapped ", "\nv "}) {
    std::string stale = text;
    const size_t end = stale.find('\n', stale.find(keyword) + 1);
    stale[end - 1] = stale[end - 1] == '0' ? '1' : '0';
    scratch_.write("cases.txt", stale);
    EXPECT_TRUE(is_refused(judge(), "cases.txt:")) << keyword;
  }
  scratch_.write("cases.txt", text.substr(0, text.size() / 2));
  EXPECT_TRUE(is_refused(judge(), "cases.txt:"));
  scratch_.write("cases.txt", text + "case\n");
  EXPECT_TRUE(is_refused(judge(), "expected the end of the file"));
  const Outcome out = pineda({"vectors", "export", cases(), "--tri", "-o", scratch_.path("none")});
  EXPECT_TRUE(is_refused(out, "cases.txt:"));
  EXPECT_FALSE(std::filesystem::exists(scratch_.path("none")));
}

TEST_F(JudgePortable, InfoCountsAndUsageIsChecked) {
  const Json json = pineda({"vectors", "info", cases(), "--json", "-", "--quiet"}).json();
  EXPECT_GT(json.at("cases"), 400);
  EXPECT_EQ(json.at("subpixel_bits"), 8);
  size_t cases_of_classes = 0;
  for (const auto& [name, count] : json.at("classes").items()) {
    cases_of_classes += count.get<size_t>();
  }
  EXPECT_EQ(cases_of_classes, json.at("cases"));

  EXPECT_TRUE(is_refused(judge({"triangle"}), "--portable"));
  EXPECT_TRUE(is_refused(judge({"--subpixel-bits", "4"}), "--portable"));
  EXPECT_TRUE(is_refused(pineda({"judge", "--dump", "x"}), "SCENE"));
  EXPECT_TRUE(
      is_refused(pineda({"judge", "triangle", "--dump", "x", "--drawn-only"}), "--portable"));
  const std::string setup = scratch_.path("setup.txt");
  pineda({"vectors", "generate", "--unit", "setup", "--count", "2", "-o", setup, "--quiet"});
  EXPECT_TRUE(is_refused(pineda({"vectors", "export", setup, "--portable", "-o", "x"}), "frame"));
  EXPECT_TRUE(is_refused(
      pineda({"vectors", "export", setup, "--csv", "--depth-ulp", "2", "-o", "x"}), "--portable"));
}

}  // namespace
}  // namespace pineda::test
