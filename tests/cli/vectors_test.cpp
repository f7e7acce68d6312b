// pineda vectors, as another program drives it.
#include <gtest/gtest.h>

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
  const size_t content = text.find("content ") + 8;
  const size_t body = text.find('\n', content) + 1;
  return text.replace(content, 16, hash_of(text.substr(body)));
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
}

TEST_F(Vectors, ABitThatDiffersIsNamed) {
  for (const auto& [unit, keyword, field] : {std::tuple{"setup", "setup_prim", "setup_prim"},
                                             {"traversal", "stamp", "stamp"},
                                             {"interp_ztest", "color_write", "color_write"},
                                             {"frame", "hits", "hits"}}) {
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
  EXPECT_TRUE(is_refused(refused("pineda-vectors 9\n"), "bad.txt:1: expected 'pineda-vectors 1'"));
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
