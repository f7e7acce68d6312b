// Every hard frame through render, rtl and check.
#include <gtest/gtest.h>

#include "tests/cli/frames.h"
#include "tests/cli/program.h"
#include "tests/cli/verdict.h"

namespace pineda::test {
namespace {

class EveryFrame : public testing::TestWithParam<Frame> {
 protected:
  const Scene& scene() const { return GetParam().scene; }
  std::string text() const { return scratch_.write("scene.tri", tri_text(scene())); }

  /// Dumps into a folder of the given name.
  void dump(const std::string& folder, Arguments arguments) const {
    arguments.insert(arguments.end(), {"--quiet", "--dump", scratch_.path(folder)});
    const Outcome run = pineda(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
  }
  void expect_same(const std::string& a, const std::string& b) const {
    const Arguments files{"color.rgba", "depth.u32", "hits.u16"};
    ASSERT_EQ(scratch_.files(a), files);
    ASSERT_EQ(scratch_.files(b), files);
    for (const auto& file : files) {
      // Not EXPECT_EQ, which would print both.
      EXPECT_TRUE(bytes(a, file) == bytes(b, file)) << file << " of " << a << " and " << b;
    }
  }

  Scratch scratch_;

 private:
  std::string bytes(const std::string& folder, const std::string& file) const {
    return read_bytes(scratch_.path(folder + "/" + file));
  }
};

TEST_P(EveryFrame, RenderIsWhatExactArithmeticAllows) {
  dump("render", {"render", text()});
  const Verdict verdict = judge(scene(), read_dump(scratch_.path("render"), scene()));
  EXPECT_TRUE(verdict.holds()) << verdict;
  EXPECT_EQ(verdict.covered > 0, !scene().triangles.empty());
}

TEST_P(EveryFrame, RtlDumpsTheBytesOfRender) {
  dump("render", {"render", text()});
  dump("rtl", {"rtl", text()});
  expect_same("render", "rtl");
}

TEST_P(EveryFrame, ThreadsChangeNoByte) {
  dump("one", {"render", text()});
  dump("three", {"render", text(), "--threads", "3"});
  dump("many", {"render", text(), "--threads", "256"});
  expect_same("one", "three");
  expect_same("one", "many");
}

TEST_P(EveryFrame, BinarySceneGivesTheSameBytes) {
  dump("text", {"render", text()});
  const std::string plain = scratch_.write("plain.ptrb", ptrb_bytes(scene()));
  const std::string with_w = scratch_.write("with_w.ptrb", ptrb_bytes(scene(), true));
  dump("plain", {"render", plain});
  dump("with_w", {"render", with_w});
  expect_same("text", "plain");
  expect_same("text", "with_w");
}

TEST_P(EveryFrame, CheckHolds) {
  dump("render", {"render", text()});
  const Json check = figures({"check", text()});
  EXPECT_EQ(check.at("mismatches"), 0);
  EXPECT_EQ(check.at("triangles"), scene().triangles.size());
  EXPECT_EQ(check.at("fragments"), read_dump(scratch_.path("render"), scene()).covered());
  EXPECT_EQ(check.at("cycles").at("model"), check.at("cycles").at("rtl"));
  EXPECT_EQ(check.at("coverage").at("missing"), 0);
  EXPECT_EQ(check.at("coverage").at("extra"), 0);
  EXPECT_LE(check.at("depth").at("max_ulp"), kDepthBoundUlp);
  EXPECT_LE(check.at("color").at("max_lsb"), kColorBoundLsb);
}

INSTANTIATE_TEST_SUITE_P(Cli, EveryFrame, testing::ValuesIn(frames()),
                         [](const auto& param) { return param.param.name; });

}  // namespace
}  // namespace pineda::test
