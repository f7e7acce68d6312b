// pineda vectors score, as another program drives it, on a unit that is built in seconds.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/cli/program.h"

namespace pineda::test {
namespace {

class VectorsScore : public testing::Test {
 protected:
  static bool has_yosys() { return std::system("command -v yosys > /dev/null") == 0; }
  static constexpr const char* kMissing = "Yosys is not here";

  Outcome score(const Arguments& more) const {
    Arguments arguments{"vectors", "score"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return pineda(arguments);
  }
  std::string made(const std::string& unit, const std::string& design,
                   const Arguments& more) const {
    std::string path = scratch_.path(unit + "_" + design + ".txt");
    Arguments arguments{"vectors", "generate", "--unit", unit,     "--design",
                        design,    "-o",       path,     "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(pineda(arguments).exit_code, 0);
    return path;
  }

  Scratch scratch_;
  Environment cache_{"PINEDA_CACHE", PINEDA_SCORE_CACHE};  // of all scores of the tests
};

// The counts add up, each mutant has its place in the source, and each that died its case.
TEST_F(VectorsScore, SaysOfEachMutantWhatBecameOfIt) {
  if (!has_yosys()) GTEST_SKIP() << kMissing;
  const Outcome run = score({"--unit", "interp_ztest", "--design", "flat", "--mutants", "100",
                             "--level", "1", "--no-proofs", "--json", "-"});
  const Json unit = run.json().at("units").at("interp_ztest");
  EXPECT_EQ(unit.at("mutants"), 100);
  EXPECT_EQ(unit.at("list").size(), 100u);
  EXPECT_EQ(unit.at("killed_level1").get<int>() + unit.at("undecided").get<int>(), 100);
  EXPECT_EQ(unit.at("equivalent"), 0);
  for (const Json& mutant : unit.at("list")) {
    EXPECT_EQ(mutant.at("file").get<std::string>().rfind("rtl/", 0), 0u) << mutant;
    EXPECT_FALSE(mutant.at("source").get<std::string>().empty()) << mutant;
    EXPECT_EQ(mutant.contains("case"), mutant.at("fate") != "undecided") << mutant;
  }
}

// The mutant of this suite: vectors that are too few must not pass.
TEST_F(VectorsScore, OneCaseKillsTooFew) {
  if (!has_yosys()) GTEST_SKIP() << kMissing;
  const std::string few = made("interp_ztest", "flat", {"--count", "1"});
  const Outcome run = score({few, "--mutants", "100", "--no-proofs", "--json", "-"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const Json json = run.json();
  EXPECT_EQ(json.at("holds"), false);
  EXPECT_LT(json.at("all").at("percent_level1").get<double>(), 95.);
}

// Vectors that the RTL does not fulfil have no score.
TEST_F(VectorsScore, WrongVectorsAreRefused) {
  EXPECT_TRUE(is_refused(score({made("frame", "flat", {"--count", "1"})}),
                         "expected vectors of a unit, got those of frames"));
  const std::string one = made("traversal", "flat", {"--count", "1"});
  EXPECT_TRUE(is_refused(score({one, one}), "expected one file a unit, got a second of traversal"));
  EXPECT_TRUE(is_refused(score({one, made("setup", "tiny", {"--count", "1"})}),
                         "expected vectors of design flat, got those of tiny"));
  EXPECT_TRUE(is_refused(score({one, "--unit", "setup"}), "expected a file of setup"));
  EXPECT_TRUE(is_refused(score({"--mutants", "0"}), "--mutants"));
  EXPECT_TRUE(is_refused(score({"--design", "exact"}), "exact"));
}

}  // namespace
}  // namespace pineda::test
