// The judge of what a netlist's bench writes: it takes the vectors' own words, and no others.
#include "studies/netlist/unit_vectors.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <sstream>

#include "studies/area/area_error.h"
#include "studies/netlist/netlist_words.h"
#include "vectors/grammar/file.h"

namespace pineda::studies {
namespace {

/// What the bench writes of a netlist without a fault; each word in a cycle of its own.
class Log {
 public:
  template <class T>
  void words(const std::string& stream, std::vector<T> tokens) {
    const NetlistWords<T> words(contract);
    for (T& token : tokens) {
      token.id &= 1;
      lines.push_back(fmt::format("out {} {} {}", stream, cycle++, words.hex(token)));
    }
  }
  void done() { lines.push_back(fmt::format("done {}", cycle++)); }

  Replay compared(const UnitVectors& vectors) const {
    std::istringstream text(fmt::format("{}\n", fmt::join(lines, "\n")));
    return vectors.compare(text);
  }

  spec::Contract contract = spec::contract(spec::Design());
  std::vector<std::string> lines;
  int cycle = 0;
};

template <class Case>
std::vector<Case> committed() {
  const std::string unit = spec::name_of(Case::kUnit);
  return vectors::read<Case>(std::string(PINEDA_VECTORS) + "/" + unit + "/level1_seed1.txt").cases;
}

Log interpolation_log() {
  Log log;
  for (const auto& c : committed<vectors::InterpZtestCase>()) {
    log.words("color_write", c.color);
    log.words("depth_write", c.depth);
    log.lines.push_back(fmt::format("out depth_read {} 0", log.cycle));
    log.done();
  }
  log.lines.emplace_back("end");
  return log;
}

Log setup_log() {
  Log log;
  for (const auto& c : committed<vectors::SetupCase>()) {
    log.words("setup_prim", c.out);
    log.done();
  }
  log.lines.emplace_back("end");
  return log;
}

class UnitVectorsTest : public testing::Test {
 protected:
  std::unique_ptr<UnitVectors> of(const std::string& unit, size_t cases = 0) const {
    return committed_vectors(spec::contract(spec::Design()), unit, cases);
  }
};

TEST_F(UnitVectorsTest, TheirOwnWordsHold) {
  const Replay setup = setup_log().compared(*of("setup"));
  EXPECT_EQ(setup.difference, "");
  EXPECT_TRUE(setup.is_complete);
  EXPECT_EQ(setup.cases, of("setup")->cases());
  const Replay interpolation = interpolation_log().compared(*of("interp_ztest"));
  EXPECT_EQ(interpolation.difference, "");
  EXPECT_TRUE(interpolation.is_complete);
  EXPECT_EQ(interpolation.cases, of("interp_ztest")->cases());
}

TEST_F(UnitVectorsTest, OneChangedBitOfAnyWordIsFound) {
  const Log log = setup_log();
  const auto vectors = of("setup");
  for (size_t i = 0; i < log.lines.size(); i += 97) {
    if (log.lines[i].rfind("out", 0) != 0) continue;
    Log changed = log;
    char& digit = changed.lines[i].back();
    digit = digit == '0' ? '1' : '0';
    const Replay replay = changed.compared(*vectors);
    EXPECT_NE(replay.difference.find("attr_ref[0]: expected 0x"), std::string::npos)
        << replay.difference;
  }
}

TEST_F(UnitVectorsTest, ADifferenceNamesCaseWordCycleAndField) {
  Log log = setup_log();
  const auto cases = committed<vectors::SetupCase>();
  char& digit = log.lines[0].back();
  digit = digit == '0' ? '1' : '0';
  const std::string difference = log.compared(*of("setup")).difference;
  EXPECT_EQ(
      difference.rfind("setup case " + cases[0].name + ": setup_prim 0, cycle 0: attr_ref[0]", 0),
      0u)
      << difference;
}

TEST_F(UnitVectorsTest, UnknownBitsMissingAndFurtherWordsAreFound) {
  const Log log = setup_log();
  const auto difference = [&](const std::function<void(std::vector<std::string>*)>& change) {
    Log changed = log;
    change(&changed.lines);
    return changed.compared(*of("setup")).difference;
  };
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(has(difference([](auto* lines) { lines->front().back() = 'x'; }), "x"));
  EXPECT_TRUE(has(difference([](auto* lines) { lines->erase(lines->begin()); }), "expected"));
  EXPECT_TRUE(has(difference([](auto* lines) { lines->insert(lines->end() - 2, lines->front()); }),
                  "expected the end, got one more"));
  EXPECT_TRUE(has(difference([](auto* lines) { lines->erase(lines->end() - 3); }),
                  "expected one more, got the end"));
  EXPECT_TRUE(has(
      difference([](auto* lines) { lines->insert(lines->begin(), "fault 7 stamp: valid is x"); }),
      ": cycle 7: stamp: valid is x"));
}

TEST_F(UnitVectorsTest, ALogThatIsCutIsNotComplete) {
  Log log = setup_log();
  log.lines.pop_back();
  EXPECT_FALSE(log.compared(*of("setup")).is_complete);
  log.lines.resize(log.lines.size() / 2);
  EXPECT_FALSE(log.compared(*of("setup")).is_complete);
}

TEST_F(UnitVectorsTest, AreSpreadOverTheFile) {
  EXPECT_EQ(of("traversal", 200)->cases(), 200u);
  const size_t all = of("traversal")->cases();
  EXPECT_EQ(of("traversal", all + 1)->cases(), all);
}

TEST_F(UnitVectorsTest, ThereAreOnlyOfCommittedFormats) {
  spec::Design deeper;
  deeper.name = "deeper";
  deeper.prim_fifo_depth = 8;  // decides no bit
  EXPECT_GT(committed_vectors(spec::contract(deeper), "setup", 0)->cases(), 300u);
  EXPECT_THROW(committed_vectors(spec::contract(*spec::find_design("low")), "setup", 0), AreaError);
}

}  // namespace
}  // namespace pineda::studies
