// pineda study area, as another program drives it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "tests/cli/program.h"

namespace pineda::test {
namespace {

// The smallest there is: a pixel a stamp, no depth, a flat colour.
constexpr const char* kDesign = R"(base = "flat"
guard_bits = 8
subpixel_bits = 4
stamp_width_px = 1
stamp_height_px = 1
attribute_bits = 4
flat_attributes = 1
)";

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

constexpr const char* kMissing = "Yosys, OpenSTA or the cells of osu018 are not here";

bool can_measure() {
  const auto on_path = [](const char* tool) {
    return std::system((std::string("command -v ") + tool + " > /dev/null").c_str()) == 0;
  };
  return on_path("yosys") && on_path("sta") &&
         std::filesystem::exists("/usr/share/qflow/tech/osu018");
}

class StudyArea : public testing::Test {
 protected:
  void SetUp() override { setenv("PINEDA_CACHE", scratch_.path("cache").c_str(), 1); }
  void TearDown() override { unsetenv("PINEDA_CACHE"); }

  Outcome study(Arguments more) const {
    more.insert(more.begin(), {"study", "area"});
    return pineda(more);
  }

  Scratch scratch_;
  std::string design_ = scratch_.write("smallest.toml", kDesign);
};

TEST_F(StudyArea, OfASmallDesignAddsUpAndIsKept) {
  if (!can_measure()) GTEST_SKIP() << kMissing;
  const Arguments arguments{"--design", design_,    "--clock",   "8000",
                            "--scene",  "triangle", "--size",    "64x48",
                            "--json",   "-",        "--picture", scratch_.path("area.svg")};
  const Outcome run = study(arguments);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(has(run.err, "pineda: mapping ")) << run.err;
  const Json json = run.json();
  EXPECT_EQ(json.at("technology"), "osu018");
  EXPECT_EQ(json.at("design"), "smallest");
  EXPECT_EQ(json.at("clocks_ps"), Json::array({8000}));
  const double area = json.at("area_um2");
  EXPECT_GT(area, 100'000);
  EXPECT_LE(json.at("area_without_memory_um2").get<double>(), area);
  EXPECT_GT(json.at("flip_flops"), 500);
  double of_units = 0, of_modules = 0;
  double slowest = 0;
  for (const auto& [name, unit] : json.at("units").items()) {
    of_units += unit.at("area_um2").get<double>();
    if (unit.contains("slowest_path")) {
      slowest = std::max(slowest, unit.at("slowest_path").at("ps").get<double>());
    }
  }
  for (const Json& module : json.at("modules")) of_modules += module.at("area_um2").get<double>();
  EXPECT_NEAR(of_units, area, 1e-6 * area);
  EXPECT_NEAR(of_modules, area, 1e-6 * area);
  for (const char* unit : {"setup", "traversal", "interp_ztest"}) {
    EXPECT_GT(json.at("units").at(unit).at("fmax_mhz"), 20) << unit;
    EXPECT_GT(json.at("units").at(unit).at("flip_flops"), 20) << unit;
    EXPECT_FALSE(json.at("units").at(unit).contains("input_to_output")) << unit;
  }
  // The top's path is at least that of its slowest unit, but for loads on the unit's outputs.
  EXPECT_GT(json.at("slowest_path").at("ps").get<double>(), .9 * slowest);
  const Json& scene = json.at("scenes").at("triangle");
  EXPECT_NEAR(scene.at("triangles_per_second").get<double>(),
              1e6 * json.at("fmax_mhz").get<double>() / scene.at("cycles").get<double>(), 1);
  EXPECT_TRUE(has(read_bytes(scratch_.path("area.svg")), "u_setup.u_style"));

  // Nothing is run again, and nothing else comes out.
  const Outcome again = study(arguments);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_FALSE(has(again.err, "mapping")) << again.err;
  EXPECT_EQ(again.json(), json);
}

// The steps of pipelined setup advance together: without a FIFO behind it, ready passes through.
TEST_F(StudyArea, SaysWhereAPathLeadsThroughAUnit) {
  if (!can_measure()) GTEST_SKIP() << kMissing;
  const std::string pipelined =
      scratch_.write("pipelined.toml",
                     std::string(kDesign) + "setup_style = \"pipelined\"\nprim_fifo_depth = 0\n");
  const Outcome run = study({"--design", pipelined, "--clock", "8000", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json units = run.json().at("units");
  EXPECT_GT(units.at("setup").at("input_to_output").at("ps"), 50);
  EXPECT_FALSE(units.at("traversal").contains("input_to_output"));
  EXPECT_FALSE(units.at("interp_ztest").contains("input_to_output"));

  const Outcome held = study(
      {"--design", pipelined, "--clock", "8000", "--update", scratch_.path("pipelined.json")});
  EXPECT_EQ(held.exit_code, 1);
  EXPECT_TRUE(has(held.out, "IT DOES NOT HOLD: a path leads from an input to an output of setup"))
      << held.out;
}

TEST_F(StudyArea, IsHeldToItsFigures) {
  if (!can_measure()) GTEST_SKIP() << kMissing;
  const std::string file = scratch_.path("figures.json");
  const Arguments update{"--design", design_, "--update", file};
  const Arguments check{"--design", design_, "--check", file};
  Arguments at_8000 = update;
  at_8000.insert(at_8000.end(), {"--clock", "8000"});
  ASSERT_EQ(study(at_8000).exit_code, 0);
  const Outcome same = study(check);
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_TRUE(has(same.out, "It holds: no figure has grown by more than 2 %.")) << same.out;
  const Json stored = Json::parse(read_bytes(file));
  EXPECT_EQ(stored.at("clock_ps"), 8000);

  // One figure 3 % smaller: the check fails and names it, and nothing is stored unasked.
  const std::string tools = stored.at("figures").begin().key();
  for (const auto& [figure, name] :
       {std::pair{"area_um2", "area of traversal by"},
        std::pair{"slowest_path_ps", "slowest path of traversal by"}}) {
    Json smaller = stored;
    Json& value = smaller["figures"][tools]["traversal"][figure];
    value = .97 * value.get<double>();
    const std::string text = smaller.dump();
    scratch_.write("figures.json", text);
    const Outcome grown = study(check);
    EXPECT_EQ(grown.exit_code, 1) << grown.err;
    EXPECT_TRUE(has(grown.out, "IT DOES NOT HOLD: more than 2 %: ")) << grown.out;
    EXPECT_TRUE(has(grown.out, name)) << grown.out;
    EXPECT_EQ(study(update).exit_code, 1);
    EXPECT_EQ(read_bytes(file), text);
    Arguments allowed = update;
    allowed.push_back("--allow-growth");
    EXPECT_EQ(study(allowed).exit_code, 0);
    EXPECT_EQ(Json::parse(read_bytes(file)), stored);
  }

  // Greater ones: what has shrunk by more than 2 % is stored, what is within them stays.
  Json greater = stored;
  for (const auto& [unit, share] : {std::pair{"setup", 1.03}, std::pair{"traversal", 1.01}}) {
    Json& value = greater["figures"][tools][unit]["area_um2"];
    value = std::round(share * value.get<double>());
  }
  scratch_.write("figures.json", greater.dump());
  EXPECT_TRUE(has(study(check).out, "Smaller by more than 2 %: area of setup by 2.9 %"));
  EXPECT_EQ(study(update).exit_code, 0);
  Json ratcheted = greater;
  ratcheted["figures"][tools]["setup"] = stored["figures"][tools]["setup"];
  EXPECT_EQ(Json::parse(read_bytes(file)), ratcheted);

  // Of other tools there is nothing to check; an update adds these.
  Json other{{"design", "smallest"}, {"technology", "osu018"}, {"clock_ps", 8000}};
  other["figures"]["other tools"] = stored["figures"][tools];
  scratch_.write("figures.json", other.dump());
  EXPECT_TRUE(is_refused(study(check), "figures.json: no figures of " + tools));
  EXPECT_EQ(study(update).exit_code, 0);
  EXPECT_EQ(Json::parse(read_bytes(file)).at("figures").size(), 2u);

  Arguments at_7000 = check;
  at_7000.insert(at_7000.end(), {"--clock", "7000"});
  EXPECT_TRUE(is_refused(study(at_7000), "at a clock of 7000 ps, they are at 8000 ps"));
  EXPECT_TRUE(is_refused(study({"--design", "low", "--check", file}),
                         "expected figures of low on osu018, they are of smallest on osu018"));
}

TEST_F(StudyArea, RefusesFiguresThatAreNone) {
  if (!can_measure()) GTEST_SKIP() << kMissing;
  const auto refused = [&](const std::string& text) {
    return study({"--design", design_, "--check", scratch_.write("bad.json", text)});
  };
  EXPECT_TRUE(is_refused(study({"--design", design_, "--check", scratch_.path("none.json")}),
                         "none.json: expected figures, cannot read it"));
  const std::string head = R"({"design": "smallest", "technology": "osu018", "clock_ps": )";
  EXPECT_TRUE(is_refused(refused("figures"), "bad.json: expected figures in JSON"));
  EXPECT_TRUE(is_refused(refused("[]"), "bad.json: expected a member design"));
  EXPECT_TRUE(is_refused(refused(R"({"design": 1})"), "design to be a text"));
  EXPECT_TRUE(is_refused(refused(head + "0}"), "clock_ps to be a positive number"));
  EXPECT_TRUE(is_refused(refused(head + "1.5}"), "clock_ps to be a whole number"));
  EXPECT_TRUE(is_refused(refused(head + "8000}"), "expected a member figures"));
  EXPECT_TRUE(is_refused(refused(head + R"(8000, "figures": 1})"), "figures by the versions"));
  EXPECT_TRUE(is_refused(refused(head + R"(8000, "figures": {"a": {}}})"), "a member setup"));
  EXPECT_TRUE(is_refused(refused(head + R"(8000, "figures": {"a": {"setup": {"area_um2": -1}}}})"),
                         "area_um2"));
}

TEST_F(StudyArea, CountsTheCellsOfAnFpga) {
  if (!can_measure()) GTEST_SKIP() << kMissing;
  const Outcome run = study({"--design", design_, "--fpga", "ice40,ecp5", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json json = run.json();
  EXPECT_EQ(json.at("design"), "smallest");
  EXPECT_EQ(json.at("fpga").size(), 2u);
  for (const auto& [family, cells] : json.at("fpga").items()) {
    EXPECT_GT(cells.at("luts"), 300) << family;
    EXPECT_GT(cells.at("flip_flops"), 500) << family;
    EXPECT_GT(cells.at("carries"), 50) << family;
    EXPECT_GE(cells.at("dsps"), 1) << family;  // area and edges share one multiplier
  }
}

TEST_F(StudyArea, RefusesWhatItCannotMeasure) {
  EXPECT_TRUE(is_refused(study({"--technology", "tsmc5"}), "expected asap7, osu018, sg13g2 or"));
  EXPECT_TRUE(is_refused(study({"--technology", "asap7"}), "--liberty: expected the Liberty file"));
  EXPECT_TRUE(is_refused(study({"--technology", scratch_.path("none.toml")}), "cannot read it"));
  EXPECT_TRUE(is_refused(study({"--liberty", scratch_.write("bad.lib", "module m;\n")}),
                         "bad.lib:1: expected library (NAME) {"));
  EXPECT_TRUE(is_refused(study({"--liberty", scratch_.path("")}), "cannot read it"));
  EXPECT_TRUE(is_refused(study({"--design", "exact"}), "exact"));
  EXPECT_TRUE(is_refused(study({"--design", "bigger"}), "bigger"));
  EXPECT_TRUE(is_refused(study({"--picture", "area.png"}), ".svg"));
  EXPECT_TRUE(is_refused(study({"--designs", "low,high", "--picture", scratch_.path("x.svg")}),
                         "--picture: expected one design"));
  EXPECT_TRUE(is_refused(study({"--clock", "0"}), "--clock"));
  EXPECT_TRUE(is_refused(study({"--fpga", "spartan"}),
                         "--fpga: expected ice40, ecp5, xilinx or all, got 'spartan'"));
  EXPECT_TRUE(is_refused(study({"--fpga", "ice40", "--clock", "900"}), "--clock excludes --fpga"));
  EXPECT_TRUE(is_refused(study({"--scene", "nowhere"}), "nowhere"));
  EXPECT_TRUE(is_refused(study({"--check", "a.json", "--update", "a.json"}), "excludes"));
  EXPECT_TRUE(is_refused(study({"--check", "a.json", "--memory-bits", "9"}), "excludes"));
  EXPECT_TRUE(is_refused(study({"--fpga", "ice40", "--check", "a.json"}), "excludes"));
  EXPECT_TRUE(is_refused(study({"--designs", "low,high", "--check", "a.json"}),
                         "--check, --update: expected one design"));
  EXPECT_TRUE(is_refused(study({"--check", "a.json", "--allow-growth"}),
                         "--allow-growth: expected --update"));
  EXPECT_FALSE(std::filesystem::exists(scratch_.path("cache")));
}

TEST_F(StudyArea, SaysWhichCellIsMissing) {
  if (!can_measure()) GTEST_SKIP() << kMissing;
  // The only flip-flop allowed has no reset.
  const std::string simple = scratch_.write("simple.toml", R"(process = "simple"
driving_cell = "BUFX2"
load_ff = 30
first_clock_ps = 8000
flip_flops = ["DFFPOSX1"]
)");
  const std::string cells = "/usr/share/qflow/tech/osu018/osu018_stdcells.lib";
  const Outcome run = study({"--design", design_, "--technology", simple, "--liberty", cells});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(has(run.err, "simple.toml: expected cells for gates, and flip-flops with low resets"))
      << run.err;

  // No gate has a delay.
  const std::string no_gates = scratch_.write("gates.lib", R"lib(library (gates) {
  time_unit : "1ns"; capacitive_load_unit (1, pf);
  cell (INV) { area : 1; }
  cell (DFF) { area : 5; ff (IQ, IQN) { next_state : "D"; clocked_on : "C"; }
    pin (D) { direction : input; } pin (C) { direction : input; clock : true; }
    pin (Q) { direction : output; function : "IQ"; } }
})lib");
  const std::string gates = scratch_.write("gates.toml", R"(process = "gates"
driving_cell = "INV"
load_ff = 3
first_clock_ps = 1000
flip_flops = ["DFF"]
)");
  const Outcome other = study({"--design", design_, "--technology", gates, "--liberty", no_gates});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_TRUE(has(other.err, "gates.toml: expected cells for gates")) << other.err;
}

}  // namespace
}  // namespace pineda::test
