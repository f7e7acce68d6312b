// Portable cases and pineda judge --portable, as another program drives them.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/program.h"

namespace pineda::test {
namespace {

/// Twelve cases with perspective, their scenes, and a frame of each as our model draws it.
class JudgePortable : public testing::Test {
 protected:
  void SetUp() override {
    const std::string frames = scratch_.path("frames.txt");
    run({"vectors", "generate", "--unit", "frame", "--design", "persp", "--count", "12", "-o",
         frames});
    run({"vectors", "export", frames, "--portable", "-o", cases()});
    run({"vectors", "export", cases(), "--tri", "-o", scratch_.path("scenes")});
    for (const std::string& file : scratch_.files("scenes")) {
      names_.push_back(file.substr(0, file.size() - 4));
      run({"render", scratch_.path("scenes/" + file), "--design", "persp", "--dump",
           scratch_.path("dump/" + names_.back())});
    }
    ASSERT_EQ(names_.size(), 12u);
  }

  std::string cases() const { return scratch_.path("cases.txt"); }
  Outcome judge(const Arguments& more = {}) const {
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
  EXPECT_EQ(right.json().at("judged"), 12);
  EXPECT_EQ(right.json().at("not_drawn").size(), 0u);

  const std::string& wrong = names_[7];
  add("dump/" + wrong + "/hits.u16", 0, 1);
  const Outcome outcome = judge({"-o", scratch_.path("smallest.tri")});
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
  std::filesystem::remove_all(scratch_.path("dump/" + names_[3]));
  EXPECT_EQ(judge().exit_code, 1);
  EXPECT_EQ(judge().json().at("not_drawn"), Json::array({names_[3]}));
  EXPECT_EQ(judge({"--drawn-only"}).exit_code, 0);
  std::filesystem::remove_all(scratch_.path("dump"));
  EXPECT_TRUE(is_refused(judge({"--drawn-only"}), "expected a folder for each case"));
}

TEST_F(JudgePortable, ToleranceIsTheFilesOrTheOptions) {
  const std::string& name = names_[0];
  const size_t samples = read_bytes(scratch_.path("dump/" + name + "/hits.u16")).size() / 2;
  for (size_t i = 0; i < samples; ++i) add("dump/" + name + "/color.rgba", 4 * i, 3);
  EXPECT_EQ(judge().exit_code, 1);
  EXPECT_EQ(judge().json().at("rules").size(), 1u);
  EXPECT_EQ(judge({"--color-lsb", "255"}).exit_code, 0);
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
  EXPECT_EQ(json.at("cases"), 12);
  EXPECT_EQ(json.at("subpixel_bits"), 8);
  size_t cases_of_classes = 0;
  for (const auto& [name, count] : json.at("classes").items()) {
    cases_of_classes += count.get<size_t>();
  }
  EXPECT_EQ(cases_of_classes, 12u);

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
