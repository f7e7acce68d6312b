// pineda study netlist, as another program drives it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/cli/program.h"

namespace pineda::test {
namespace {

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

constexpr const char* kMissing = "Yosys, OpenSTA, Icarus or the cells of osu018 are not here";

bool can_replay() {
  const auto on_path = [](const char* tool) {
    return std::system((std::string("command -v ") + tool + " > /dev/null").c_str()) == 0;
  };
  return on_path("yosys") && on_path("sta") && on_path("iverilog") &&
         std::filesystem::exists("/usr/share/qflow/tech/osu018");
}

class StudyNetlist : public testing::Test {
 protected:
  Outcome study(Arguments more) const {
    more.insert(more.begin(), {"study", "netlist"});
    return pineda(more);
  }

  Scratch scratch_;
  Environment cache_{"PINEDA_CACHE", PINEDA_AREA_CACHE};  // of all area studies of the tests
};

TEST_F(StudyNetlist, OneInvertedGateIsFound) {
  if (!can_replay()) GTEST_SKIP() << kMissing;
  const Arguments few{"--unit", "traversal", "--cases", "8"};
  Arguments keep = few;
  keep.insert(keep.end(), {"-o", scratch_.path("netlists")});
  const Outcome run = study(keep);
  ASSERT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_TRUE(has(run.out, "It holds: every word is that of the vectors.")) << run.out;
  EXPECT_EQ(scratch_.files("netlists"), std::vector<std::string>{"traversal_unit.v"});

  std::string netlist = read_bytes(scratch_.path("netlists/traversal_unit.v"));
  const std::string gate = "  NAND2X1 \\u_stamps.";
  const size_t place = netlist.find(gate);
  ASSERT_NE(place, std::string::npos);
  netlist.replace(place, gate.size(), "  AND2X1 \\u_stamps.");
  Arguments inverted = few;
  inverted.insert(inverted.end(), {"--netlist", scratch_.write("inverted.v", netlist)});
  inverted.insert(inverted.end(), {"--json", "-"});
  const Outcome faulty = study(inverted);
  EXPECT_EQ(faulty.exit_code, 1) << faulty.err;
  const Json json = faulty.json();
  EXPECT_EQ(json.at("holds"), false);
  const std::string difference = json.at("units").at("traversal").at("difference");
  EXPECT_EQ(difference.rfind("traversal case ", 0), 0u) << difference;
  EXPECT_TRUE(has(difference, "cycle ")) << difference;
}

TEST_F(StudyNetlist, RefusesWhatItCannotReplay) {
  EXPECT_TRUE(is_refused(study({"--unit", "raster"}),
                         "--unit: expected setup, traversal, interp_ztest, got 'raster'"));
  EXPECT_TRUE(is_refused(study({"--cases", "0"}), "--cases"));
  EXPECT_TRUE(is_refused(study({"--clock", "0"}), "--clock"));
  EXPECT_TRUE(is_refused(study({"--seed", "x"}), "--seed"));
  EXPECT_TRUE(is_refused(study({"--design", "exact"}), "exact"));
  EXPECT_TRUE(is_refused(study({"--design", "low"}), "expected vectors in the formats of low"));
  EXPECT_TRUE(is_refused(study({"--technology", "asap7"}), "--liberty: expected the Liberty file"));
  const std::string netlist = scratch_.write("netlist.v", "module setup_unit(;\n");
  EXPECT_TRUE(is_refused(study({"--netlist", netlist}), "--netlist: expected --unit, one"));
  EXPECT_TRUE(is_refused(study({"--unit", "setup", "--netlist", scratch_.path("none.v")}),
                         "none.v: cannot read it"));
  EXPECT_TRUE(is_refused(study({"--netlist", netlist, "--clock", "900"}), "excludes"));
  if (!can_replay()) GTEST_SKIP() << kMissing;
  EXPECT_TRUE(is_refused(study({"--unit", "setup", "--models", scratch_.path("none.v")}),
                         "--models: " + scratch_.path("none.v")));
  const Outcome bad = study({"--unit", "setup", "--cases", "1", "--netlist", netlist, "--quiet"});
  EXPECT_TRUE(is_refused(bad, "netlist.v:1: syntax error"));
  EXPECT_TRUE(is_refused(study({"--unit", "setup", "-o", netlist}), "netlist.v"));
}

}  // namespace
}  // namespace pineda::test
