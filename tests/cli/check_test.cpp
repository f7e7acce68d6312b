// pineda check under stalls and latencies, and its exit 1.
#include <gtest/gtest.h>
#include <gtkwave/fstapi.h>

#include <algorithm>
#include <cstdlib>
#include <map>
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
      const auto run = [&](const char* command, const char* option = "--quiet") {
        return figures({command, text, "--stall", GetParam().stall, "--latency", GetParam().latency,
                        "--seed", seed, option});
      };
      const Json check = run("check");
      EXPECT_EQ(check.at("mismatches"), 0);
      EXPECT_EQ(check.at("cycles").at("model"), check.at("cycles").at("rtl"));
      EXPECT_TRUE(check.at("counters_differ").empty()) << check.at("counters_differ");
      EXPECT_EQ(check.at("counters_compared"), 58);
      const Json time_alone = run("time");
      const Json time = run("time", "--bits");
      const Json rtl = run("rtl");
      EXPECT_EQ(time.at("cycles"), check.at("cycles").at("model"));
      EXPECT_EQ(time_alone.at("cycles"), check.at("cycles").at("model"));
      EXPECT_EQ(rtl.at("cycles"), check.at("cycles").at("rtl"));
      for (const char* key : {"drained", "units", "fifos", "port_stalls", "stamps_by_samples",
                              "depth_tests", "counters"}) {
        EXPECT_EQ(time.at(key), check.at(key)) << key;
        EXPECT_EQ(rtl.at(key), check.at(key)) << key;
      }
      for (const char* key : {"drained", "units", "fifos", "port_stalls", "stamps_by_samples"}) {
        EXPECT_EQ(time_alone.at(key), check.at(key)) << key;
      }
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

TEST(MemoryKinds, CostTimeAndChangeNoBit) {
  const Scratch scratch;
  const std::string text = scratch.write("scene.tri", tri_text(frame("CullNoneDepthLess")));
  const auto run = [&](const char* kind) {
    return figures({"rtl", text, "--dump", scratch.path("dump"), "--memory", kind});
  };
  const Json ideal = run("ideal");
  const std::string color = read_bytes(scratch.path("dump/color.rgba"));
  for (const char* kind : {"dram", "dram_merged"}) {
    const Json dram = run(kind);
    EXPECT_TRUE(read_bytes(scratch.path("dump/color.rgba")) == color) << kind;
    EXPECT_GT(dram.at("cycles"), ideal.at("cycles")) << kind;
    EXPECT_EQ(dram.at("memory"), kind);
    EXPECT_GT(dram.at("dram").at("depth").at("misses"), 0) << kind;
    EXPECT_EQ(figures({"check", text, "--memory", kind}).at("mismatches"), 0) << kind;
  }
}

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

/// A copy of the program, placed where it finds RTL with one fault in each unit.
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
  const Outcome run =
      pineda({"check", text, "--stall", "sink", "--json", "-", "-o", scratch_.path("out")}, copy_);
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_GT(run.json().at("mismatches"), 0);
  const Json differ = run.json().at("counters_differ");
  EXPECT_TRUE(std::any_of(differ.begin(), differ.end(), [](const Json& d) {
    return d.at("name") == "stamps.blocked";
  })) << differ;
  EXPECT_NE(run.err.find("DOES NOT HOLD"), std::string::npos) << run.err;
  EXPECT_NE(read_bytes(scratch_.path("out/report.html")).find("does not hold"), std::string::npos);
}

// The fault changes no frame's cycles, but the cycles in which triangles retire.
TEST_F(FaultyRtl, MakesStudyCyclesExitOne) {
  const Outcome run =
      pineda({"study", "cycles", "--scene", "hard/sliver", "--runs", "0", "--json", "-"}, copy_);
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const Json json = run.json();
  EXPECT_EQ(json.at("holds"), false);
  EXPECT_GT(json.at("rows").at(0).at("retire").at("off"), 0);
  EXPECT_EQ(json.at("worst").at(0).at("rows_off"), 1);
}

// Under stalls a retirement may differ, a counter may not.
TEST_F(FaultyRtl, MakesStudyCyclesExitOneOverACounter) {
  const std::string text = scratch_.write("scene.tri", tri_text(frame("TileBorders")));
  const Outcome run = pineda(
      {"study", "cycles", "--scene", text, "--stall", "sink", "--runs", "0", "--json", "-"}, copy_);
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const Json row = run.json().at("rows").at(0);
  EXPECT_EQ(row.at("holds"), false);
  EXPECT_GT(row.at("counters_off"), 0);
  EXPECT_FALSE(row.at("first_counter_off").get<std::string>().empty());
}

/// A waveform as GTKWave reads it.
class Waveform {
 public:
  explicit Waveform(const std::string& path) : file_(fstReaderOpen(path.c_str())) {
    std::string scope;
    while (const fstHier* item = file_ == nullptr ? nullptr : fstReaderIterateHier(file_)) {
      if (item->htyp == FST_HT_SCOPE) scope += std::string(item->u.scope.name) + ".";
      if (item->htyp == FST_HT_UPSCOPE) scope.erase(scope.rfind('.', scope.size() - 2) + 1);
      if (item->htyp == FST_HT_VAR) handles_[scope + item->u.var.name] = item->u.var.handle;
    }
  }
  ~Waveform() {
    if (file_ != nullptr) fstReaderClose(file_);
  }
  Waveform(const Waveform&) = delete;
  Waveform& operator=(const Waveform&) = delete;

  bool is_open() const { return file_ != nullptr; }
  uint64_t start() const { return fstReaderGetStartTime(file_); }
  uint64_t end() const { return fstReaderGetEndTime(file_); }
  std::string at(uint64_t time, const std::string& signal) const {
    std::string bits(1024, '\0');
    return fstReaderGetValueFromHandleAtTime(file_, time, handles_.at(signal), bits.data());
  }

 private:
  void* file_;
  std::map<std::string, fstHandle> handles_;
};

TEST_F(FaultyRtl, MakesCheckNameTheTriangleThatRetiresAtAnotherCycle) {
  const std::string file = scratch_.path("out/differ.fst");
  const Outcome run =
      pineda({"check", "hard/sliver", "--json", "-", "-o", scratch_.path("out")}, copy_);
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_GT(run.json().at("retirement").at("off"), 0);
  const Json found = run.json().at("first_retire_difference");
  EXPECT_NE(found.at("model"), found.at("rtl"));
  // The faulty unit sends one stamp too many: the difference shows at traversal's output.
  EXPECT_EQ(found.at("unit"), "traversal");
  const Json token = found.at("token");
  EXPECT_EQ(token.at("boundary"), "stamp");
  EXPECT_EQ(token.at("model"), -1);
  const auto cycle = token.at("rtl").get<uint64_t>();
  const Json sent = {{"triangle", found.at("triangle")}, {"cycle", cycle}};
  const Json around = found.at("around");
  const auto holds = [&sent](const Json& side) {
    const Json& stamps = side.at("tokens").at("stamp");
    return std::find(stamps.begin(), stamps.end(), sent) != stamps.end();
  };
  EXPECT_TRUE(holds(around.at("rtl"))) << around;
  EXPECT_FALSE(holds(around.at("model"))) << around;
  const std::string line = "first triangle      " + found.at("triangle").dump() + " retires";
  EXPECT_NE(run.err.find(line), std::string::npos) << run.err;
  EXPECT_NE(run.err.find(file), std::string::npos) << run.err;
  EXPECT_NE(read_bytes(scratch_.path("out/report.html")).find(file), std::string::npos);

  const Waveform wave(file);
  ASSERT_TRUE(wave.is_open());
  const auto time_of = [](uint64_t c) { return 2 * c + 4; };  // as the reported line says
  EXPECT_EQ(wave.start(), time_of(cycle < 200 ? 0 : cycle - 200));
  EXPECT_EQ(wave.end(), time_of(cycle + 200) + 1);  // the clock edge that ends the last cycle
  EXPECT_EQ(wave.at(time_of(cycle), "TOP.raster_top.stamp_valid"), "1");
  EXPECT_EQ(wave.at(time_of(cycle), "TOP.raster_top.stamp_ready"), "1");
}

TEST(SoundRtl, LeavesNoWaveformOfADifference) {
  const Scratch scratch;
  const std::string old = scratch.write("out/differ.fst", "of another run");
  const Outcome run = pineda({"check", "hard/sliver", "--json", "-", "-o", scratch.path("out")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.json().at("first_retire_difference").is_null());
  EXPECT_EQ(run.json().at("retirement").at("off"), 0);
  EXPECT_EQ(run.err.find("first triangle"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("triangles, all equal"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(old));
}

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

// A user's own design: verilated the first time, taken from the cache the second.
TEST(DesignFile, IsBuiltOnceAndHoldsThreeWays) {
  const Scratch scratch;
  const Environment cache("PINEDA_CACHE", scratch.path("cache"));
  const Environment quick("CXXFLAGS", "-O0");
  const Environment small("UNITS", "raster_top");
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
