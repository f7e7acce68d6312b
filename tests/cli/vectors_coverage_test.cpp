// pineda vectors coverage and report, as another program drives them: traversal of the default design.
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace pineda::test {
namespace {

class CodeCoverage : public testing::Test {
 protected:
  Arguments of_traversal(const char* command, const Arguments& more = {}) const {
    Arguments arguments{"vectors", command, "--unit", "traversal"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  /// A file of a few cases, which leave much unseen.
  std::string few() const {
    const std::string path = scratch_.path("few.txt");
    const Outcome run = pineda(
        {"vectors", "generate", "--unit", "traversal", "--count", "2", "-o", path, "--quiet"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return path;
  }

  Environment cache_{"PINEDA_CACHE", PINEDA_COVERAGE_CACHE};
  Scratch scratch_;
};

TEST_F(CodeCoverage, OfLevelOneIsWhatItMustBe) {
  const Outcome run = pineda(of_traversal(
      "coverage", {"-o", scratch_.path("out"), "--json", scratch_.path("coverage.json")}));
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_NE(run.out.find("\nIt holds.\n"), std::string::npos) << run.out;
  const Json json = Json::parse(read_bytes(scratch_.path("coverage.json")));
  EXPECT_EQ(json.at("design"), "high_tile");
  EXPECT_EQ(json.at("units"), Json::array({"traversal"}));
  EXPECT_EQ(json.at("holds"), true);
  EXPECT_EQ(json.at("lines").at("percent"), 100);
  EXPECT_GE(json.at("toggles").at("percent"), 95);
  for (const char* kind : {"lines", "toggles"}) {
    uint64_t points = 0;
    for (const auto& [file, entry] : json.at("files").items())
      points += entry.at(kind).at("points").get<uint64_t>();
    EXPECT_EQ(json.at(kind).at("points"), points) << kind;
    EXPECT_GT(points, 40u) << kind;
  }
  EXPECT_GT(json.at("files").at("traversal/tile_walker.sv").at("toggles").at("hit"), 100);

  EXPECT_EQ(scratch_.files("out"),
            (std::vector<std::string>{"coverage.dat", "coverage.info", "pineda_pkg.sv"}));
  EXPECT_EQ(read_bytes(scratch_.path("out/coverage.dat")).find("# SystemC::Coverage-3\n"), 0u);
  const std::string info = read_bytes(scratch_.path("out/coverage.info"));
  EXPECT_NE(info.find("/rtl/traversal/tile_walker.sv\n"), std::string::npos);
}

TEST_F(CodeCoverage, WhatFewCasesMissIsNamed) {
  const std::string file = few();
  const Outcome run = pineda({"vectors", "coverage", file, "--json", scratch_.path("few.json")});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_NE(run.out.find("\nIT DOES NOT HOLD.\n"), std::string::npos) << run.out;
  const Json json = Json::parse(read_bytes(scratch_.path("few.json")));
  EXPECT_EQ(json.at("holds"), false);
  EXPECT_EQ(json.at("cases"), 2);
  const Json missed = json.at("files").at("traversal/tile_walker.sv").at("missed");
  ASSERT_FALSE(missed.empty());
  EXPECT_NE(run.out.find("traversal/tile_walker.sv:" + missed[0].at("line").dump() + ": " +
                         missed[0].at("what").get<std::string>()),
            std::string::npos)
      << run.out;
}

TEST_F(CodeCoverage, AWaiverExcusesWhatIsMissedAndHasAReason) {
  const std::string file = few();
  const auto run_with = [&](const std::string& waivers) {
    return pineda({"vectors", "coverage", file, "--json", "-", "--quiet", "--waivers",
                   scratch_.write("waivers.toml", waivers)});
  };
  const std::string file_alone = "[[waiver]]\nfile = \"traversal/tile_walker.sv\"\n";
  const std::string head = file_alone + "designs = [\"high_tile\"]\n";
  const auto percent_of = [](const Outcome& run) {
    return run.json().at("toggles").at("percent").get<double>();
  };
  const Outcome none = run_with("");
  const Outcome all = run_with(head + "bits = [\"*\"]\nreason = \"few cases\"\n");
  EXPECT_GT(percent_of(all), percent_of(none));
  const Json tile_walker = all.json().at("files").at("traversal/tile_walker.sv");
  EXPECT_EQ(tile_walker.at("toggles").at("percent"), 100);
  EXPECT_EQ(tile_walker.at("waived").at(0).at("reason"), "few cases");

  const auto refused = [&](const std::string& waivers, const std::string& part) {
    return is_refused(run_with(waivers), part);
  };
  EXPECT_TRUE(
      refused(head + "bits = [\"no_such_signal\"]\nreason = \"x\"\n",
              "waivers.toml:1: expected a point of traversal/tile_walker.sv that high_tile does "
              "not hit, got 'no_such_signal'"));
  EXPECT_TRUE(refused(head + "bits = [\"clk_i\"]\nreason = \"it is hit\"\n", "got 'clk_i'"));
  EXPECT_TRUE(
      refused(head + "bits = [\"*\"]\nreason = \" \"\n", "waivers.toml:1: expected a reason"));
  EXPECT_TRUE(refused(head + "bits = [\"*\"]\n", "waivers.toml:1: expected a text reason"));
  EXPECT_TRUE(refused(head + "reason = \"x\"\n", "waivers.toml:1: expected blocks or bits"));
  EXPECT_TRUE(refused(head + "lines = [1]\n", "got lines"));
  EXPECT_TRUE(refused(file_alone + "bits = [\"*\"]\nreason = \"x\"\n", "expected designs"));
  EXPECT_TRUE(
      refused(file_alone + "designs = [\"tinny\"]\nbits = [\"*\"]\nreason = \"x\"\n", "got tinny"));
  EXPECT_TRUE(refused(
      "[[waiver]]\nfile = \"no.sv\"\ndesigns = [\"high_tile\"]\nbits = [\"*\"]\nreason = \"x\"\n",
      "got no.sv"));
  EXPECT_TRUE(refused("[[waiver\n", "waivers.toml:1: expected TOML"));
  EXPECT_TRUE(
      is_refused(pineda({"vectors", "coverage", file, "--waivers", scratch_.path("none.toml")}),
                 "none.toml: expected"));
}

TEST_F(CodeCoverage, RefusesWhatItCannotRun) {
  const std::string file = few();
  EXPECT_TRUE(is_refused(pineda({"vectors", "coverage", scratch_.write("bad.txt", "no vectors\n")}),
                         "bad.txt:1: expected"));
  EXPECT_TRUE(is_refused(
      pineda({"vectors", "coverage", file, PINEDA_VECTORS "/traversal/persp_level1_seed1.txt"}),
      "level1_seed1.txt: expected vectors of high_tile"));
  EXPECT_TRUE(is_refused(pineda({"vectors", "coverage", file, "--level", "2"}), "--level"));
  EXPECT_TRUE(is_refused(pineda({"vectors", "coverage", "--design", "exact"}), "exact"));
  EXPECT_TRUE(is_refused(pineda({"vectors", "coverage", "--unit", "rop"}), "--unit"));
  EXPECT_TRUE(is_refused(pineda({"vectors", "coverage", file, "-o", file}), "few.txt/"));
}

TEST_F(CodeCoverage, StandsOnOnePageWithPlanBinsAndMutants) {
  const std::string page = scratch_.path("page.html");
  const std::string mutants = scratch_.write(
      "score.json",
      R"({"units": {"traversal": {"mutants": 350, "killed_level1": 300, "killed_level2": 20,
                                  "equivalent": 17, "undecided": 2}}})");
  const Outcome run = pineda(of_traversal("report", {"-o", page, "--mutants", mutants}));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const std::string html = read_bytes(page);
  for (const char* part : {"<h1>Verification of high_tile</h1>", "traversal_tile_test", "rejected",
                           "traversal/tile_walker.sv", "of 350 mutants survive", ">11<"}) {
    EXPECT_NE(html.find(part), std::string::npos) << part;
  }
  for (const char* fetched : {"http:", "https:", "src=", "<script", "@import", "url("}) {
    EXPECT_EQ(html.find(fetched), std::string::npos) << fetched;
  }

  const std::string other = scratch_.path("other.html");
  const auto refused = [&](const Arguments& more, const std::string& part) {
    Arguments arguments = of_traversal("report", {"-o", other});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return is_refused(pineda(arguments), part);
  };
  EXPECT_TRUE(refused({"--mutants", scratch_.write("m.json", "{}")}, "m.json: expected"));
  EXPECT_TRUE(refused({"--mutants", scratch_.write("m.json", R"({"units": {"setup": {}}})")},
                      "m.json: expected a count 'mutants'"));
  EXPECT_TRUE(refused({"--plan", scratch_.write("p.hjson", "{\"testpoints\": [{}]}")},
                      "p.hjson: expected a text 'name'"));
  EXPECT_TRUE(refused({"--plan", scratch_.write("p.hjson", "[")}, "p.hjson: expected JSON"));
  EXPECT_FALSE(std::filesystem::exists(other));
  EXPECT_TRUE(is_refused(pineda(of_traversal("report")), "--out"));
}

}  // namespace
}  // namespace pineda::test
