// pineda vectors, as another program drives it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "tests/cli/program.h"

namespace pineda::test {
namespace {

constexpr const char* kUnits[] = {"setup", "traversal", "interp_ztest", "frame"};

class Vectors : public testing::Test {
 protected:
  std::string made(const std::string& unit, const Arguments& more = {}) const {
    std::string path = scratch_.path(unit + ".txt");
    Arguments arguments{"vectors", "generate", "--unit", unit, "-o", path, "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = pineda(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return path;
  }

  Scratch scratch_;
};

/// FNV-1a, 64 bits, in hex.
std::string hash_of(const std::string& text) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<uint8_t>(c)) * 0x100000001b3u;
  char hex[17];
  std::snprintf(hex, sizeof hex, "%016llx", static_cast<unsigned long long>(hash));
  return hex;
}

/// The file with the last digit of its last line of `keyword` changed, and the hash of its content.
std::string with_another_bit(std::string text, const std::string& keyword) {
  size_t at = text.find('\n', text.rfind("\n" + keyword + " ") + 1) - 1;
  text[at] = text[at] == '0' ? '1' : '0';
  const size_t body = text.find('\n', text.find("\nformats ") + 1) + 1;
  const size_t cases = text.rfind("\ncases ") + 1;
  const size_t content = text.rfind("content ") + 8;
  return text.replace(content, 16, hash_of(text.substr(body, cases - body)));
}

TEST_F(Vectors, AreTheCommittedOnesAndHoldOnModelAndRtl) {
  for (const std::string unit : kUnits) {
    const std::string path = made(unit, {"--level", "1", "--seed", "1"});
    EXPECT_EQ(read_bytes(path),
              read_bytes(std::string(PINEDA_VECTORS) + "/" + unit + "/level1_seed1.txt"))
        << unit;
    for (const char* side : {"model", "rtl"}) {
      const Outcome run = pineda(
          {"vectors", "run", path, "--on", side, "--stall", "both", "--json", "-", "--quiet"});
      EXPECT_EQ(run.exit_code, 0) << unit << run.err;
      const Json json = run.json();
      EXPECT_EQ(json.at("unit"), unit);
      EXPECT_EQ(json.at("on"), side);
      EXPECT_EQ(json.at("holds"), true);
      EXPECT_EQ(json.at("mismatches"), 0);
      EXPECT_GT(json.at("cases"), 200);
    }
  }
}

TEST_F(Vectors, AnotherSeedGivesOthersAndLevelTwoMore) {
  const std::string first = read_bytes(made("setup", {"--seed", "1"}));
  EXPECT_NE(read_bytes(made("setup", {"--seed", "2"})), first);
  EXPECT_GT(read_bytes(made("setup", {"--level", "2"})).size(), 4 * first.size());
}

TEST_F(Vectors, InfoSaysWhatAFileHolds) {
  const Json json =
      pineda({"vectors", "info", made("frame", {"--seed", "7"}), "--json", "-", "--quiet"}).json();
  EXPECT_EQ(json.at("unit"), "frame");
  EXPECT_EQ(json.at("design"), "high_tile");
  EXPECT_EQ(json.at("level"), 1);
  EXPECT_EQ(json.at("seed"), 7);
  size_t cases = 0;
  for (const auto& [name, count] : json.at("classes").items()) cases += count.get<size_t>();
  EXPECT_EQ(json.at("cases"), cases);
  EXPECT_GT(json.at("tokens").at("triangles"), 1000);
  const Json coverage = json.at("coverage");
  EXPECT_GT(coverage.at("bins"), 700);
  EXPECT_EQ(coverage.at("hit"), coverage.at("bins"));
  EXPECT_GT(coverage.at("points").at("drop").at("hits").at("zero_area"), 0);
  EXPECT_EQ(coverage.at("points").at("frame_size").at("unreachable").size(), 2u);
}

TEST_F(Vectors, SoManyCasesAsAskedForAndWhatTheyLeaveOut) {
  const std::string path = made("setup", {"--count", "5"});
  const Outcome run = pineda({"vectors", "info", path, "--json", scratch_.path("info.json")});
  EXPECT_NE(run.out.find("\nnot hit\n"), std::string::npos) << run.out;
  const Json json = Json::parse(read_bytes(scratch_.path("info.json")));
  EXPECT_EQ(json.at("cases"), 5);
  EXPECT_LT(json.at("coverage").at("hit"), json.at("coverage").at("bins"));
}

// A case at a time: ten times the cases take no more memory.
TEST_F(Vectors, AreWrittenAndReadInBoundedMemory) {
  const auto peak = [&](const std::string& count, int64_t* reading) {
    const std::string path = scratch_.path("many.txt");
    const Outcome run =
        pineda({"vectors", "generate", "--unit", "setup", "--count", count, "-o", path});
    const Outcome info = pineda({"vectors", "info", path, "--quiet"});
    EXPECT_EQ(run.exit_code + info.exit_code, 0) << run.err << info.err;
    *reading = info.peak_kib;
    return run.peak_kib;
  };
  int64_t few = 0, many = 0;
  const int64_t writing_few = peak("4000", &few);
  EXPECT_LT(peak("40000", &many),
            writing_few + 16384);  // what each thread's allocator keeps varies
  EXPECT_LT(many, few + 4096);
}

/// A copy of the program, placed where it finds RTL with one fault in each unit.
class FaultyVectors : public Vectors {
 protected:
  FaultyVectors() {
    namespace fs = std::filesystem;
    fs::create_directory(scratch_.path("lib"));
    fs::copy_file(PINEDA_PROGRAM, scratch_.path("pineda"));
    fs::copy_file(PINEDA_RTL_MUTANT, scratch_.path("lib/pineda_rtl_high_tile.so"));
    copy_.program = scratch_.path("pineda");
  }

  Surroundings copy_;
};

TEST_F(FaultyVectors, AreFoundByEachUnitAndShrunkToAFewInputs) {
  for (const auto& [unit, most, named] : {std::tuple{"setup", 1, "setup_prim: e"},
                                          {"traversal", 1, "stamp"},
                                          {"interp_ztest", 3, "write"},
                                          {"frame", 3, "sample"}}) {
    const std::string path = made(unit);
    EXPECT_EQ(pineda({"vectors", "run", path, "--quiet"}, copy_).exit_code, 1) << unit;
    const Outcome run = pineda({"vectors", "shrink", path, "--json", "-", "--quiet"}, copy_);
    EXPECT_EQ(run.exit_code, 1) << unit << run.err;
    const Json json = run.json();
    EXPECT_LE(json.at("inputs").at("after"), most) << unit << json;
    EXPECT_LE(json.at("inputs").at("after"), json.at("inputs").at("before"));
    EXPECT_NE(json.at("what").get<std::string>().find(std::string(unit) + " case "),
              std::string::npos);
    // The small file still fails on the faulty RTL, and holds on the sound one.
    const std::string small = json.at("result");
    EXPECT_EQ(small, scratch_.path(std::string(unit) + "_shrunk.txt"));
    EXPECT_EQ(pineda({"vectors", "run", small, "--quiet"}, copy_).exit_code, 1) << unit;
    EXPECT_EQ(pineda({"vectors", "run", small, "--quiet"}).exit_code, 0) << unit;
    if (std::string(unit) != "frame") continue;
    EXPECT_EQ(json.at("first").get<std::string>().find("RTL "), 0u) << json;
    EXPECT_GT(json.at("cycle"), 0);
    EXPECT_GT(std::filesystem::file_size(json.at("waveform").at("file").get<std::string>()), 500u);
  }
}

// Any program that exits non-zero. This one fails where a case culls back faces.
TEST_F(Vectors, AreShrunkForAForeignProgram) {
  const std::string path = made("setup");
  const std::string command = "! grep -q '^drop facing' {}";
  const Outcome run = pineda({"vectors", "shrink", path, "--run", command, "-o",
                              scratch_.path("small.txt"), "--json", "-", "--quiet"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_EQ(run.json().at("inputs").at("after"), 1);
  EXPECT_NE(read_bytes(scratch_.path("small.txt")).find("\ndrop facing\n"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(scratch_.path("small.txt.trial")));

  EXPECT_EQ(pineda({"vectors", "shrink", path, "--run", "true {}"}).exit_code, 0);
  EXPECT_TRUE(is_refused(pineda({"vectors", "shrink", path, "--run", "true"}), "--run"));
  EXPECT_TRUE(is_refused(pineda({"vectors", "shrink", path, "--run", "./no_such_program {} 2>&1"}),
                         "--run: expected a command that runs"));
}

// The first digit is of the top bits; the last line is that of the last token.
TEST_F(Vectors, AreExportedAsMemoriesTablesAndJson) {
  const std::string path = made("setup", {"--count", "20"});
  for (const char* form : {"--readmemh", "--csv", "--json"}) {
    EXPECT_EQ(pineda({"vectors", "export", path, form, "-o", scratch_.path(form + 2)}).exit_code,
              0);
  }
  const auto lines = [&](const std::string& name) {
    const std::string text = read_bytes(scratch_.path(name));
    return std::count(text.begin(), text.end(), '\n');
  };
  const Json json = Json::parse(read_bytes(scratch_.path("json")));
  ASSERT_EQ(json.at("cases").size(), 20u);
  std::ptrdiff_t triangles = 0, prims = 0;
  for (const Json& one : json.at("cases")) {
    triangles += static_cast<std::ptrdiff_t>(one.at("triangle").size());
    prims += static_cast<std::ptrdiff_t>(one.at("setup_prim").size());
    EXPECT_EQ(one.at("drop").size(), one.at("triangle").size());
    EXPECT_EQ(one.at("case").size(), 1u);
  }
  EXPECT_EQ(scratch_.files("readmemh"),
            (std::vector<std::string>{"case.hex", "drop.hex", "rows.hex", "setup_prim.hex",
                                      "triangle.hex", "vectors.svh"}));
  EXPECT_EQ(lines("readmemh/rows.hex"), 20);
  EXPECT_EQ(lines("readmemh/triangle.hex"), triangles);
  EXPECT_EQ(lines("readmemh/setup_prim.hex"), prims);
  EXPECT_EQ(lines("csv/triangle.csv"), triangles + 1);
  EXPECT_NE(read_bytes(scratch_.path("readmemh/vectors.svh"))
                .find("localparam int triangle_rows = " + std::to_string(triangles)),
            std::string::npos);
  EXPECT_TRUE(
      is_refused(pineda({"vectors", "export", path, "-o", scratch_.path("x")}), "--readmemh"));
  EXPECT_TRUE(
      is_refused(pineda({"vectors", "export", path, "--csv", "--json", "-o", "x"}), "--readmemh"));

  const std::string text = read_bytes(path);
  const std::string cut = scratch_.write("cut.txt", text.substr(0, text.size() / 2));
  for (const char* form : {"--readmemh", "--csv", "--json"}) {
    const std::string out = scratch_.path(std::string("cut") + form);
    EXPECT_TRUE(is_refused(pineda({"vectors", "export", cut, form, "-o", out}), "cut.txt:"));
    EXPECT_FALSE(std::filesystem::exists(out)) << form;
  }
}

TEST_F(Vectors, ABitThatDiffersIsNamed) {
  for (const auto& [unit, keyword, field] : {std::tuple{"setup", "setup_prim", "setup_prim"},
                                             {"traversal", "stamp", "stamp"},
                                             {"interp_ztest", "color_write", "color_write"},
                                             {"frame", "sample", "sample"}}) {
    const std::string path = made(unit);
    scratch_.write("changed.txt", with_another_bit(read_bytes(path), keyword));
    const Outcome run = pineda({"vectors", "run", scratch_.path("changed.txt"), "--on", "model"});
    EXPECT_EQ(run.exit_code, 1) << unit << run.err;
    EXPECT_NE(run.out.find(std::string(unit) + " case "), std::string::npos) << run.out;
    EXPECT_NE(run.out.find(field), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("IT DOES NOT HOLD."), std::string::npos) << run.out;
  }
}

TEST_F(Vectors, ADesignFromAFileTravelsAlong) {
  const std::string design =
      scratch_.write("mine.toml", "base = \"tiny\"\nsubpixel_bits = 5\nguard_bits = 9\n");
  const std::string path = made("traversal", {"--design", design});
  std::filesystem::remove(design);
  const Outcome run = pineda({"vectors", "run", path, "--on", "model", "--json", "-", "--quiet"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.json().at("design"), "mine");
}

TEST_F(Vectors, WhatIsDamagedIsRefused) {
  const std::string path = made("setup");
  const std::string text = read_bytes(path);
  const auto refused = [&](const std::string& bytes) {
    return pineda({"vectors", "run", scratch_.write("bad.txt", bytes), "--on", "model"});
  };
  std::string changed = text;
  changed[changed.size() - 20] ^= 1;
  EXPECT_TRUE(is_refused(refused(changed), "bad.txt:"));
  EXPECT_TRUE(is_refused(refused(text.substr(0, text.size() / 2)), "bad.txt:"));
  EXPECT_TRUE(is_refused(refused("pineda-vectors 9\n"), "bad.txt:1: expected 'pineda-vectors 2'"));
  EXPECT_TRUE(
      is_refused(pineda({"vectors", "info", scratch_.path("none.txt")}), "none.txt: expected"));
}

TEST_F(Vectors, RefusesWhatItCannotMake) {
  const std::string out = scratch_.path("out.txt");
  EXPECT_TRUE(is_refused(pineda({"vectors"}), "subcommand"));
  EXPECT_TRUE(is_refused(pineda({"vectors", "generate", "--unit", "rop", "-o", out}), "--unit"));
  EXPECT_TRUE(is_refused(pineda({"vectors", "generate", "--unit", "setup"}), "--out"));
  EXPECT_TRUE(is_refused(
      pineda({"vectors", "generate", "--unit", "setup", "--level", "3", "-o", out}), "--level"));
  EXPECT_TRUE(is_refused(
      pineda({"vectors", "generate", "--unit", "setup", "--design", "exact", "-o", out}), "exact"));
  EXPECT_TRUE(is_refused(
      pineda({"vectors", "generate", "--unit", "setup", "-o", scratch_.path("no/folder.txt")}),
      "folder.txt"));
  EXPECT_TRUE(is_refused(pineda({"vectors", "run", made("setup"), "--on", "paper"}), "--on"));
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace pineda::test
