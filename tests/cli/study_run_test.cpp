// pineda study run, export and compare: results that last, whatever ends the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <random>

#include "tests/cli/program.h"
#include "tests/cli/running.h"

namespace pineda::test {
namespace {

constexpr const char* kSmall = R"(
scenes = ["triangle", "grid"]
designs = ["tiny", "low"]
memories = ["ideal", "dram"]
measures = ["cycles", "stalls", "bandwidth", "error"]
)";

/// A folder with a study, where the program runs.
class StudyRun : public testing::Test {
 protected:
  void write(const std::string& study) { scratch_.write("a.toml", study); }
  Outcome run(Arguments more = {}) const {
    more.insert(more.begin(), {"study", "run", "a.toml"});
    return pineda(more, here_);
  }
  Json json(const Arguments& more = {}) const {
    Arguments arguments{"--json", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.json();
  }
  /// The export of a database.
  std::string csv(const std::string& results) const {
    const Outcome outcome = pineda({"study", "export", results, "--csv", "-"}, here_);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  }

  Scratch scratch_;
  Surroundings here_ = inside(scratch_.path(""));
};

Json row(const Json& study, const std::string& scene, const std::string& design,
         const std::string& memory, const std::string& measure) {
  for (const Json& row : study.at("values")) {
    if (row.at("scene") == scene && row.at("design") == design && row.at("memory") == memory &&
        row.at("measure") == measure) {
      return row.at("figures");
    }
  }
  ADD_FAILURE() << "no row " << scene << " " << design << " " << memory << " " << measure;
  return {};
}

TEST_F(StudyRun, FiguresAreThoseOfTheCommands) {
  write(kSmall);
  const Json study = json();
  EXPECT_EQ(study.at("rows"), 2 * 2 * (2 * 3 + 1));
  EXPECT_EQ(study.at("added"), study.at("rows"));
  for (const std::string scene : {"triangle", "grid"}) {
    for (const std::string design : {"tiny", "low"}) {
      for (const std::string memory : {"ideal", "dram"}) {
        SCOPED_TRACE(scene + " " + design + " " + memory);
        const Json time =
            figures({"time", scene, "--design", design, "--memory", memory, "--bits"});
        const Json cycles = row(study, scene, design, memory, "cycles");
        EXPECT_EQ(cycles.at("cycles"), time.at("cycles"));
        EXPECT_EQ(cycles.at("fragments"), time.at("counters").at("fragments"));
        const Json stalls = row(study, scene, design, memory, "stalls");
        EXPECT_EQ(stalls.at("setup.busy"), time.at("units").at("setup").at("busy"));
        EXPECT_EQ(stalls.at("interp_ztest.memory"),
                  time.at("units").at("interp_ztest").at("memory"));
        if (memory == "ideal") continue;
        const Json bandwidth = row(study, scene, design, memory, "bandwidth");
        EXPECT_EQ(bandwidth.at("depth.misses"), time.at("dram").at("depth").at("misses"));
        EXPECT_EQ(bandwidth.at("color.write_backs"), time.at("dram").at("color").at("write_backs"));
      }
      const Json error = figures({"error", scene, "--design", design}).at("designs").at(design);
      const Json judged = row(study, scene, design, "", "error");
      EXPECT_EQ(judged.at("missing"), 0);
      EXPECT_EQ(judged.at("extra"), 0);
      EXPECT_NEAR(judged.at("depth_max_ulp").get<double>(),
                  error.at("depth").at("max_ulp").get<double>(), 1e-6);
    }
  }
}

TEST_F(StudyRun, DoesOnlyWhatIsMissing) {
  write(kSmall);
  const Json first = json();
  Json again = json();
  EXPECT_EQ(again.at("added"), 0);
  EXPECT_EQ(again.at("there"), first.at("rows"));
  EXPECT_EQ(again.at("values"), first.at("values"));
  // Another order, a design under another name, and one that is new.
  write(R"(
scenes = ["grid", "triangle"]
memories = ["dram", "ideal"]
measures = ["error", "bandwidth", "stalls", "cycles"]
designs = ["low"]
[[design]]
base = "tiny"
name = "least"
[[design]]
base = "tiny"
plane_slots = 7
)");
  again = json();
  EXPECT_EQ(again.at("there"), first.at("rows"));
  EXPECT_EQ(again.at("added"), 2 * (2 * 3 + 1));
  EXPECT_EQ(row(again, "grid", "least", "dram", "cycles"),
            row(first, "grid", "tiny", "dram", "cycles"));
}

TEST_F(StudyRun, FileThatHasChangedIsMeasuredAgain) {
  const std::string triangle =
      "v 1 1 .5 1 9 9 9 255\nv 14 1 .5 1 9 9 9 255\nv 1 14 .5 1 9 9 9 255\n";
  const std::string scene = "pineda-tri 1\nsize 16 16\n" + triangle;
  scratch_.write("one.tri", scene);
  write("scenes = ['one.tri']\ndesigns = ['tiny']\nmeasures = ['cycles']\n");
  EXPECT_EQ(json().at("added"), 1);
  EXPECT_EQ(json().at("added"), 0);
  scratch_.write("one.tri", scene + triangle);
  EXPECT_EQ(json().at("added"), 1);
}

TEST_F(StudyRun, CommittedRowsServe) {
  write(kSmall);
  json();
  scratch_.write("a.csv", csv("a.db"));
  const Json served = json({"--results", "new.db"});
  EXPECT_EQ(served.at("added"), 0);
  EXPECT_EQ(csv("new.db"), csv("a.db"));
}

// Killed at any moment, with all its children, until it is through: nothing is lost, nothing doubled.
TEST_F(StudyRun, KilledAtAnyMomentLosesNothing) {
  write(kSmall);
  json({"--results", "whole.db"});
  const std::string results = scratch_.path("killed.db");
  std::mt19937 random(1);
  int killed = 0;
  for (int i = 0; i < 12; ++i) {
    Running study({"study", "run", scratch_.path("a.toml"), "--results", results});
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 60 + 5));
    killed += study.end_by(SIGKILL) == SIGKILL ? 1 : 0;
  }
  EXPECT_GT(killed, 0);
  const Json rest = json({"--results", "killed.db"});
  EXPECT_EQ(rest.at("added").get<int>() + rest.at("there").get<int>(), rest.at("rows"));
  EXPECT_EQ(csv("killed.db"), csv("whole.db"));
}

TEST_F(StudyRun, TwoAtOnceDoTheStudyOnce) {
  write(kSmall);
  json({"--results", "whole.db"});
  const std::string results = scratch_.path("both.db");
  const Arguments arguments{"study", "run", scratch_.path("a.toml"), "--results", results};
  Running one(arguments), other(arguments);
  EXPECT_EQ(one.finish(), 0);
  EXPECT_EQ(other.finish(), 0);
  EXPECT_EQ(csv("both.db"), csv("whole.db"));
}

TEST_F(StudyRun, FullDiskLosesNothing) {
  write(kSmall);
  json({"--results", "whole.db"});
  Surroundings shell = here_;
  shell.program = "/bin/sh";
  // No file may grow beyond 24 KiB; the signal that says so is ignored, so the write fails.
  const Outcome full = pineda({"-c", "trap '' XFSZ; ulimit -f 48; exec " PINEDA_PROGRAM
                                     " study run a.toml --results full.db --json -"},
                              shell);
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_EQ(std::count(full.err.begin(), full.err.end(), '\n'), 1) << full.err;
  EXPECT_NE(full.err.find("full.db"), std::string::npos) << full.err;
  const Json rest = json({"--results", "full.db"});
  EXPECT_GT(rest.at("added"), 0);
  EXPECT_EQ(csv("full.db"), csv("whole.db"));
}

TEST_F(StudyRun, ProductsAndRangesAreDesigns) {
  write(R"(
scenes = ["triangle"]
measures = ["cycles"]
[[design]]
base = "tiny"
tile_px = [4, 8, 16]
stamp_width_px = [1, 2]
[[design]]
name = "k{reciprocal_bits}"
reciprocal_bits = "28..32:2"
)");
  const Json study = json();
  EXPECT_EQ(study.at("designs"), 9);
  EXPECT_EQ(study.at("left_out"), 0);
  row(study, "triangle", "tiny tile_px=16 stamp_width_px=2", "ideal", "cycles");
  row(study, "triangle", "k30", "ideal", "cycles");
}

TEST_F(StudyRun, CombinationsThatCannotBeBuiltAreCounted) {
  write(R"(
scenes = ["triangle"]
measures = ["cycles"]
[[design]]
base = "tiny"
gradient_fraction_bits = [10, 12]
tile_fraction_bits = [10, 12]
)");
  const Outcome outcome = run({"--json", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.json().at("designs"), 3);
  EXPECT_EQ(outcome.json().at("left_out"), 1);
  EXPECT_NE(outcome.err.find("1 combinations cannot be built"), std::string::npos) << outcome.err;
}

TEST_F(StudyRun, MemoriesTakeTheirParameters) {
  write(R"(
scenes = ["grid"]
designs = ["high_tile"]
measures = ["cycles", "bandwidth"]
memories = ["dram", "ideal"]
[[memory]]
name = "one set"
kind = "dram"
ways = 2
set_columns_log2 = 0
set_rows_log2 = 0
[[memory]]
name = "far"
kind = "ideal"
latency_cycles = 60
)");
  const Json study = json();
  const auto cycles = [&](const std::string& memory) {
    return row(study, "grid", "high_tile", memory, "cycles").at("cycles").get<int>();
  };
  const auto misses = [&](const std::string& memory) {
    return row(study, "grid", "high_tile", memory, "bandwidth").at("depth.misses").get<int>();
  };
  EXPECT_GT(misses("one set"), misses("dram"));
  EXPECT_GT(cycles("one set"), cycles("dram"));
  EXPECT_GT(cycles("far"), cycles("ideal"));
  EXPECT_EQ(cycles("far"), figures({"time", "grid", "--latency", "60"}).at("cycles"));
}

// The frame is too large for the design: the rest is done, and the program says so.
TEST_F(StudyRun, WhatHasNoResultIsSaid) {
  write("[[scene]]\nscene = 'grid'\nsize = '2000x100'\n[[scene]]\nscene = 'triangle'\n");
  scratch_.write("a.toml", read_bytes(scratch_.path("a.toml")) +
                               "[[design]]\nbase = 'tiny'\n[[design]]\nbase = 'high_tile'\n");
  const Outcome outcome = run({"--json", "-"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.json().at("failed"), 2);
  EXPECT_EQ(outcome.json().at("added"), 6);
  EXPECT_NE(outcome.err.find("grid, tiny, ideal: cycles: "), std::string::npos) << outcome.err;
}

TEST_F(StudyRun, HostSpeedStaysOutOfExports) {
  write("scenes = ['triangle']\ndesigns = ['tiny']\nmeasures = ['cycles', 'host_speed']\n");
  EXPECT_GT(row(json(), "triangle", "tiny", "ideal", "host_speed").at("cycles_per_second"), 0);
  EXPECT_EQ(csv("a.db").find("host_speed"), std::string::npos);
  const Outcome all = pineda({"study", "export", "a.db", "--csv", "-", "--host-speed"}, here_);
  EXPECT_NE(all.out.find("host_speed"), std::string::npos);
}

TEST_F(StudyRun, CompareSaysWhatChanged) {
  write(kSmall);
  json();
  std::string changed = csv("a.db");
  scratch_.write("before.csv", changed);
  const auto compare = [&](const Arguments& more) {
    Arguments arguments{"study", "compare", "before.csv", "after.csv", "--json", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return pineda(arguments, here_);
  };
  scratch_.write("after.csv", changed);
  EXPECT_EQ(compare({"--gate"}).exit_code, 0);
  EXPECT_EQ(compare({"--gate"}).json().at("changed"), 0);
  // One figure is 10 % greater, a row is gone.
  const std::string line = "grid,low,dram,cycles,cycles,";
  const size_t at = changed.find(line) + line.size();
  ASSERT_NE(changed.find(line), std::string::npos);
  const int cycles = std::stoi(changed.substr(at));
  changed.replace(at, std::to_string(cycles).size(), std::to_string(cycles + cycles / 10));
  scratch_.write("after.csv", changed);
  const Outcome other = compare({});
  EXPECT_EQ(other.exit_code, 0);
  ASSERT_EQ(other.json().at("changed"), 1);
  EXPECT_EQ(other.json().at("changes").at(0).at("before"), cycles);
  EXPECT_EQ(compare({"--gate"}).exit_code, 1);
  EXPECT_EQ(compare({"--gate", "--within", "11"}).exit_code, 0);
  scratch_.write("after.csv", changed.substr(0, changed.find("triangle,tiny,ideal,stalls")));
  EXPECT_EQ(compare({"--gate", "--within", "11"}).exit_code, 1);
}

TEST_F(StudyRun, BadInputIsOneLine) {
  const std::map<std::string, std::string> bad{
      {"", "a.toml:1: expected designs = "},
      {"designs = ['tiny']\n", "a.toml:1: expected scenes = "},
      {"designs = ['tiny']\nscenes = ['triangle']\nmeasures = ['speed']\n",
       "a.toml:3: expected one of cycles, "},
      {"designs = ['tiny']\nscenes = ['triangle', 'none.tri']\n",
       "a.toml:2: expected a scene, there is no file none.tri"},
      {"designs = ['tiny']\nscenes = ['tripod']\n", "a.toml:2: expected a scene's file"},
      {"designs = ['tiny', 'huge']\nscenes = ['triangle']\n", "a.toml:1: expected a named design"},
      {"designs = []\n", "a.toml:1: expected designs to be a list, not empty"},
      {"scenes = ['triangle']\n[[design]]\ntile_px = '8..4'\n",
       "a.toml:3: expected a range that is not empty"},
      {"scenes = ['triangle']\n[[design]]\ntile_px = []\n",
       "a.toml:3: expected tile_px to have a value"},
      {"scenes = ['triangle']\n[[design]]\ntile_px = [8, 9]\n",
       "a.toml:3: expected tile_px to be a power of two"},
      {"scenes = ['triangle']\n[[design]]\ntile_pixels = 8\n",
       "a.toml:3: expected base, name or a parameter"},
      {"scenes = ['triangle']\ndesigns = ['tiny', 'tiny']\n",
       "a.toml:2: expected another name, 'tiny'"},
      {"scenes = ['triangle']\ndesigns = ['tiny']\nmemories = ['sram']\n",
       "a.toml:3: expected one of ideal, "},
      {"scenes = ['triangle']\ndesigns = ['tiny']\n[[memory]]\nkind = 'dram'\nlatency_cycles = 3\n",
       "a.toml:5: expected one of name, kind, banks"},
      {"scenes = ['triangle']\ndesigns = ['tiny']\n[[memory]]\nkind = 'dram'\nbanks = 0\n",
       "a.toml:3: expected a memory that can be"},
      {"scenes = [triangle]\n", "a.toml:1: expected TOML"},
      {"colour = 1\n", "a.toml:1: expected one of name, scenes"},
      {"designs = ['tiny']\ntechnologies = ['cmos']\nmeasures = ['area']\n",
       "a.toml:2: expected one of asap7"},
  };
  for (const auto& [text, message] : bad) {
    write(text);
    EXPECT_TRUE(is_refused(run(), message)) << text;
    EXPECT_EQ(scratch_.files(), std::vector<std::string>{"a.toml"}) << text;
  }
  EXPECT_TRUE(
      is_refused(pineda({"study", "run", "none.toml"}, here_), "none.toml: expected a study"));
}

TEST_F(StudyRun, OtherDatabasesAreRefusedAndStay) {
  write("scenes = ['triangle']\ndesigns = ['tiny']\nmeasures = ['cycles']\n");
  scratch_.write(
      "other.db",
      "not a database, and long enough to be taken for one if nobody looked at its head");
  const std::string before = read_bytes(scratch_.path("other.db"));
  EXPECT_TRUE(
      is_refused(run({"--results", "other.db"}), "other.db: expected a database of results"));
  EXPECT_EQ(read_bytes(scratch_.path("other.db")), before);
  json();
  // The version of the tables, in SQLite's header.
  std::string bytes = read_bytes(scratch_.path("a.db"));
  bytes[63] = 9;
  scratch_.write("a.db", bytes);
  EXPECT_TRUE(is_refused(run(), "a.db: expected results of version 1, got version 9"));
  EXPECT_TRUE(
      is_refused(pineda({"study", "export", "none.db", "--csv", "-"}, here_), "none.db: expected"));
  scratch_.write(
      "cut.csv",
      "scene,design,memory,measure,figure,value,key,made_by\na,b,c,cycles,cycles,12x,1,2\n");
  EXPECT_TRUE(is_refused(pineda({"study", "export", "cut.csv", "--csv", "-"}, here_),
                         "cut.csv:2: expected a number as value, got '12x'"));
}

}  // namespace
}  // namespace pineda::test
