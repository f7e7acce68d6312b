#include "studies/area/technology.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "studies/area/area_error.h"
#include "tests/scene/scratch.h"

namespace pineda::studies {
namespace {

using scene::Scratch;

constexpr const char* kLibrary = R"(library (small) {
  time_unit : "1ns"; capacitive_load_unit (1, pf);
  cell (BUF) { area : 2; }
  cell (DFF) { area : 7; ff (IQ, IQN) { } }
  cell (SDFF) { area : 9; ff (IQ, IQN) { } }
  cell (DELAY) { area : 3; }
  cell (LATCH) { area : 5; latch (IQ, IQN) { } }
})";

constexpr const char* kMacro = R"(library (ram) {
  time_unit : "1ns"; capacitive_load_unit (1, pf);
  cell (RAM) { area : 1000; }
})";

constexpr const char* kTechnology = R"(process = "a process"
driving_cell = "BUF"
load_ff = 3
first_clock_ps = 1000
flip_flops = ["DFF"]
not_used = ["DELAY"]
[[macro]]
liberty = "ram.lib"
words = 64
bits = 8
ports = 2
[[macro]]
liberty = "not_there.lib"
words = 64
bits = 8
ports = 1
)";

class TechnologyFile : public testing::Test {
 protected:
  std::string refused(const std::string& text) const {
    const std::string file = scratch_.write("bad.toml", text);
    try {
      read_technology(file, scratch_.path("small.lib"));
    } catch (const AreaError& error) {
      const std::string what = error.what();
      return what.rfind(file, 0) == 0 ? what.substr(file.size()) : what;
    }
    return "read";
  }
  std::string refused_with(const std::string& from, const std::string& to) const {
    std::string text = kTechnology;
    text.replace(text.find(from), from.size(), to);
    return refused(text);
  }

  Scratch scratch_;
  std::string library_ = scratch_.write("small.lib", kLibrary);
  std::string macro_ = scratch_.write("ram.lib", kMacro);
};

TEST_F(TechnologyFile, IsRead) {
  const auto t = read_technology(scratch_.write("mine.toml", kTechnology), library_);
  EXPECT_EQ(t.name, "mine");
  EXPECT_EQ(t.process, "a process");
  EXPECT_EQ(t.load_ff, 3);
  EXPECT_EQ(t.first_clock_ps, 1000);
  EXPECT_TRUE(t.allows("BUF"));
  EXPECT_TRUE(t.allows("DFF"));
  EXPECT_FALSE(t.allows("SDFF"));
  EXPECT_FALSE(t.allows("DELAY"));
  EXPECT_FALSE(t.allows("LATCH"));
  ASSERT_EQ(t.macros.size(), 1u);  // the other one's file is not there
  EXPECT_EQ(t.macros[0].area_um2, 1000);
  EXPECT_EQ(t.macros[0].ports, 2);
}

TEST_F(TechnologyFile, IsRefusedWithTheLine) {
  EXPECT_EQ(refused_with("load_ff = 3", "load_ff = \"3\""),
            ":3: expected load_ff to be a number from 0 to 1000000");
  EXPECT_EQ(
      refused_with("load_ff", "load"),
      ":3: expected process, liberty, models, package, driving_cell, load_ff, first_clock_ps, "
      "flip_flops, not_used, macro, got load");
  EXPECT_EQ(refused_with("first_clock_ps = 1000\n", ""), ":1: expected the key first_clock_ps");
  EXPECT_EQ(refused_with("[\"DFF\"]", "\"DFF\""), ":5: expected flip_flops to be a list of texts");
  EXPECT_EQ(refused_with("words = 64", "words = 0"),
            ":9: expected words to be a whole number from 1 to 1048576");
  EXPECT_EQ(refused_with("process = ", "process "),
            ":1: expected TOML: Error while parsing key-value pair: expected '=', saw '\"'");
  EXPECT_EQ(refused_with("[\"DFF\"]", "[]"), ": expected a flip-flop");
  EXPECT_EQ(refused_with("[\"DFF\"]", "[\"BUF\"]"),
            ": expected flip_flops to be flip-flops, BUF is none");
  EXPECT_EQ(refused_with("\"BUF\"", "\"BUF2\""),
            ": expected driving_cell to be a cell of " + library_ + ", it has no BUF2");
}

TEST_F(TechnologyFile, ThoseKnownByNameAreRight) {
  EXPECT_EQ(technology_names(), (std::vector<std::string>{"asap7", "osu018", "sg13g2"}));
  const auto error = [](const std::string& name) -> std::string {
    try {
      read_technology(name, "");
    } catch (const AreaError& refused) {
      return refused.what();
    }
    return "read";
  };
  EXPECT_EQ(error("asap7"), "--liberty: expected the Liberty file of asap7 (plain or gzip)");
  EXPECT_EQ(error("tsmc5"),
            "--technology: expected asap7, osu018, sg13g2 or FILE.toml, got 'tsmc5'");
  // With Debian's cells, where they are installed.
  const std::string cells = "/usr/share/qflow/tech/osu018/osu018_stdcells.lib";
  EXPECT_EQ(error("osu018"), std::filesystem::exists(cells)
                                 ? "read"
                                 : cells +
                                       ": expected the cells of osu018: install "
                                       "qflow-tech-osu018, or give --liberty");
}

TEST(Technology, MacrosOfOnePortTakeTwoBanks) {
  // 100 words of 20 bits: two banks of 50 words, three macros of 8 bits side by side each.
  const std::vector<Macro> one_port{{"", 64, 8, 1, 10}};
  EXPECT_EQ(macro_area(one_port, 100, 2000), 60);
  // One of two ports is two macros high and three wide.
  const std::vector<Macro> two_ports{{"", 64, 8, 2, 10}};
  EXPECT_EQ(macro_area(two_ports, 100, 2000), 60);
  // The cheapest counts.
  const std::vector<Macro> both{{"", 64, 8, 1, 10}, {"", 64, 32, 1, 25}};
  EXPECT_EQ(macro_area(both, 100, 2000), 50);
}

}  // namespace
}  // namespace pineda::studies
