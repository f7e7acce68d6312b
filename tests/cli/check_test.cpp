// pineda check under stalls and latencies, and its exit 1.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "tests/cli/frames.h"
#include "tests/cli/program.h"

namespace pineda::test {
namespace {

struct Memory {
  std::string stall;
  std::string latency;
};
std::ostream& operator<<(std::ostream& to, const Memory& m) { return to << m.stall << m.latency; }

class CheckUnder : public testing::TestWithParam<Memory> {};

TEST_P(CheckUnder, EveryCommandCountsTheSameCycles) {
  const Scratch scratch;
  for (const char* name : {"CullNoneDepthLess", "TileBorders"}) {
    const std::string text = scratch.write("scene.tri", tri_text(frame(name)));
    for (const char* seed : {"0", "7"}) {
      const auto run = [&](const char* command) {
        return figures({command, text, "--stall", GetParam().stall, "--latency", GetParam().latency,
                        "--seed", seed});
      };
      const Json check = run("check");
      EXPECT_EQ(check.at("mismatches"), 0);
      EXPECT_EQ(check.at("cycles").at("model"), check.at("cycles").at("rtl"));
      EXPECT_EQ(run("time").at("cycles"), check.at("cycles").at("model"));
      EXPECT_EQ(run("rtl").at("cycles"), check.at("cycles").at("rtl"));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cli, CheckUnder,
                         testing::Values(Memory{"none", "1"}, Memory{"none", "8"},
                                         Memory{"none", "64"}, Memory{"source", "8"},
                                         Memory{"sink", "8"}, Memory{"both", "1"},
                                         Memory{"both", "8"}, Memory{"both", "64"}),
                         [](const auto& param) {
                           return param.param.stall + "_" + param.param.latency;
                         });

TEST(Stalls, CostTimeAndChangeNoBit) {
  const Scratch scratch;
  const std::string text = scratch.write("scene.tri", tri_text(frame("CullNoneDepthLess")));
  const auto cycles = [&](const Arguments& more) {
    Arguments arguments{"rtl", text, "--dump", scratch.path("dump")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return figures(arguments).at("cycles").get<int64_t>();
  };
  const int64_t free_running = cycles({});
  const std::string color = read_bytes(scratch.path("dump/color.rgba"));
  EXPECT_GT(cycles({"--latency", "64"}), free_running);
  EXPECT_TRUE(read_bytes(scratch.path("dump/color.rgba")) == color);
  const int64_t stalled = cycles({"--stall", "both"});
  EXPECT_GT(stalled, free_running);
  EXPECT_TRUE(read_bytes(scratch.path("dump/color.rgba")) == color);
  EXPECT_NE(cycles({"--stall", "both", "--seed", "1"}), stalled);
}

/// A copy of the program that finds the RTL with one fault in each unit beside it.
class FaultyRtl : public testing::Test {
 protected:
  FaultyRtl() {
    namespace fs = std::filesystem;
    fs::create_directory(scratch_.path("lib"));
    fs::copy_file(PINEDA_PROGRAM, scratch_.path("pineda"));
    fs::copy_file(PINEDA_RTL_MUTANT, scratch_.path("lib/pineda_rtl_high_tile.so"));
    copy_.program = scratch_.path("pineda");
  }

  Scratch scratch_;
  Surroundings copy_;
};

TEST_F(FaultyRtl, MakesCheckExitOne) {
  const std::string text = scratch_.write("scene.tri", tri_text(frame("TileBorders")));
  const Outcome run = pineda({"check", text, "--json", "-", "-o", scratch_.path("out")}, copy_);
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_GT(run.json().at("mismatches"), 0);
  EXPECT_NE(run.err.find("DOES NOT HOLD"), std::string::npos) << run.err;
  EXPECT_NE(read_bytes(scratch_.path("out/report.html")).find("does not hold"), std::string::npos);
}

/// An environment variable for as long as this lives; the program inherits it.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name) {
    if (const char* old = std::getenv(name); old != nullptr) old_ = old;
    setenv(name, value.c_str(), 1);
  }
  ~Environment() {
    if (old_) {
      setenv(name_, old_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::optional<std::string> old_;
};

TEST_F(FaultyRtl, WithoutAnyRtlAndNoToolsOneLineSaysSo) {
  std::filesystem::remove_all(scratch_.path("lib"));
  const Environment no_tools("PATH", scratch_.path("nowhere"));
  const Environment cache("PINEDA_CACHE", scratch_.path("cache"));
  const Outcome run = pineda({"rtl", "triangle"}, copy_);
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_NE(run.err.find("high_tile"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("verilator"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(scratch_.path("cache")));
}

// A design of one's own: verilated the first time, taken from the cache the second.
TEST(DesignFile, IsBuiltOnceAndHoldsThreeWays) {
  const Scratch scratch;
  const Environment cache("PINEDA_CACHE", scratch.path("cache"));
  const Environment quick("CXXFLAGS", "-O0");
  const std::string design =
      scratch.write("own.toml",
                    "base = \"low\"\nguard_bits = 10\ndepth_bits = 16\nattributes = 1\n"
                    "flat_attributes = 3\n"
                    "tile_px = 4\nstamp_width_px = 2\nstamp_height_px = 1\n");
  const std::string text = scratch.write("scene.tri", tri_text(frame("TileBorders")));
  const Outcome first = pineda({"check", text, "--design", design, "--json", "-"});
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_NE(first.err.find("building the RTL of design 'own'"), std::string::npos) << first.err;
  const Json json = first.json();
  EXPECT_EQ(json.at("design"), "own");
  EXPECT_EQ(json.at("mismatches"), 0);
  EXPECT_EQ(json.at("cycles").at("model"), json.at("cycles").at("rtl"));
  EXPECT_EQ(json.at("coverage").at("missing"), 0);
  EXPECT_EQ(json.at("coverage").at("extra"), 0);
  const Outcome second = pineda({"check", text, "--design", design});
  EXPECT_EQ(second.exit_code, 0) << second.err;
  EXPECT_EQ(second.err.find("building"), std::string::npos) << second.err;
}

TEST(DesignFile, BadOneIsRefusedWithItsLine) {
  const Scratch scratch;
  const std::string design = scratch.write("bad.toml", "# mine\ndepth_bits = 12\n");
  for (const char* command : {"render", "time", "check", "error"}) {
    EXPECT_TRUE(
        is_refused(pineda({command, "triangle", "--design", design}), "bad.toml:2: expected"))
        << command;
  }
  EXPECT_TRUE(is_refused(pineda({"render", "triangle", "--design", "no.toml"}), "no.toml"));
}

}  // namespace
}  // namespace pineda::test
