// pineda needs and --design auto, as another program uses them.
#include <gtest/gtest.h>

#include "tests/cli/frames.h"
#include "tests/cli/program.h"

namespace pineda::test {
namespace {

/// Two triangles of one colour each that do not overlap.
Scene two_flat_triangles() {
  Scene scene;
  for (const float x : {2.f, 34.f}) {
    const auto c = static_cast<uint8_t>(x);
    const std::array<uint8_t, 4> rgba{c, 100, 200, 255};
    scene.triangles.push_back({{{x, 2, .25f, rgba}, {x + 24, 2, .25f, rgba}, {x, 40, .5f, rgba}}});
  }
  return scene;
}

std::string dump_of(const Scratch& scratch, Arguments arguments,
                    const Surroundings& surroundings = {}) {
  for (const auto& more : {std::string("--dump"), scratch.path("dump"), std::string("--quiet")}) {
    arguments.push_back(more);
  }
  EXPECT_EQ(pineda(arguments, surroundings).exit_code, 0);
  return read_bytes(scratch.path("dump/hits.u16")) + read_bytes(scratch.path("dump/depth.u32")) +
         read_bytes(scratch.path("dump/color.rgba"));
}

TEST(NeedsCommand, WritesTheDesignThatItFound) {
  const Scratch scratch;
  const std::string file = scratch.path("new/own.toml");
  const Arguments scene{"teapot", "--size", "96x72", "--tessellate", "4"};
  Arguments needs{"needs"};
  needs.insert(needs.end(), scene.begin(), scene.end());
  needs.insert(needs.end(), {"-o", file});
  const Json json = figures(needs);
  EXPECT_EQ(json.at("holds"), true);
  EXPECT_EQ(json.at("toml"), read_bytes(file));
  EXPECT_LE(json.at("judgement").at("max_depth_ulp"), 1);
  EXPECT_LE(json.at("judgement").at("max_color_lsb"), 1);
  EXPECT_EQ(json.at("judgement").at("missing"), 0);
  EXPECT_EQ(json.at("judgement").at("extra"), 0);
  EXPECT_LT(json.at("bits").at("total"), json.at("base_bits").at("total"));
  int smaller = 0;
  for (const auto& p : json.at("parameters")) smaller += p.at("saved_bits") > 0 ? 1 : 0;
  EXPECT_GE(smaller, 4);

  Arguments with_file{"render"};
  with_file.insert(with_file.end(), scene.begin(), scene.end());
  Arguments with_auto = with_file;
  with_file.insert(with_file.end(), {"--design", file});
  with_auto.insert(with_auto.end(), {"--design", "auto"});
  EXPECT_EQ(dump_of(scratch, with_auto), dump_of(scratch, with_file));
}

TEST(NeedsCommand, PrintsADesignFileLast) {
  const Scratch scratch;
  const std::string text = scratch.write("two.tri", tri_text(two_flat_triangles()));
  const Outcome run = pineda({"needs", text});
  ASSERT_TRUE(ended_silently(run));
  const size_t toml = run.out.find("\n# Judged at every sample");
  ASSERT_NE(toml, std::string::npos);
  const std::string design = scratch.write("two_needs.toml", run.out.substr(toml));
  const Json time = figures({"time", text, "--design", design});
  EXPECT_EQ(time.at("design"), "two_needs");
  EXPECT_EQ(time.at("cycles"), figures({"time", text, "--design", "auto"}).at("cycles"));
  EXPECT_NE(run.out.find("depth_test = false"), std::string::npos);
  EXPECT_NE(run.out.find("\nattributes = 0"), std::string::npos);
}

TEST(NeedsCommand, SaysWhereTheBaseItselfDoesNotHold) {
  const Outcome run = pineda({"needs", "triangle", "--color-lsb", ".4", "--json", "-"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.json().at("holds"), false);
  EXPECT_NE(run.err.find("high_tile itself does not hold"), std::string::npos) << run.err;
}

TEST(NeedsCommand, TakesAnotherBase) {
  const Scratch scratch;
  const std::string base = scratch.write("base.toml", "base = \"wide\"\ndepth_bits = 20\n");
  const std::string text = scratch.write("two.tri", tri_text(two_flat_triangles()));
  const Json json = figures({"needs", text, "--design", base});
  EXPECT_EQ(json.at("base"), "base");
  const std::string design = scratch.write("d.toml", json.at("toml").get<std::string>());
  EXPECT_EQ(figures({"render", text, "--design", design}).at("design"), "two_needs");
  // An unnamed base cannot be referred to, so every parameter is stated.
  EXPECT_NE(json.at("toml").get<std::string>().find("stamp_width_px = 4"), std::string::npos);
}

TEST(AutoDesign, ReadsStandardInputOnce) {
  const Scratch scratch;
  const std::string bytes = ptrb_bytes(two_flat_triangles());
  const std::string file = scratch.write("two.ptrb", bytes);
  Surroundings piped;
  piped.input = bytes;
  EXPECT_EQ(dump_of(scratch, {"render", "-", "--design", "auto"}, piped),
            dump_of(scratch, {"render", file, "--design", "auto"}));
}

// Nothing is said about what the design leaves out, since the scene does not need it.
TEST(AutoDesign, SaysWhatItChose) {
  const Scratch scratch;
  const std::string text = scratch.write("scene.tri", tri_text(two_flat_triangles()));
  const Outcome run = pineda({"render", text, "--design", "auto"});
  EXPECT_TRUE(ended_silently(run));
  EXPECT_NE(run.out.find("--design auto: high_tile with depth_test false"), std::string::npos);
}

// All steps: the design is found, verilated, and compared at every boundary.
TEST(AutoDesign, HoldsThreeWays) {
  const Scratch scratch;
  const Environment cache("PINEDA_CACHE", scratch.path("cache"));
  const Environment quick("CXXFLAGS", "-O0");
  const Environment small("UNITS", "raster_top");
  const std::string text = scratch.write("two.tri", tri_text(two_flat_triangles()));
  const Outcome run = pineda({"check", text, "--design", "auto", "--json", "-"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const Json json = run.json();
  EXPECT_EQ(json.at("holds"), true);
  EXPECT_EQ(json.at("mismatches"), 0);
  EXPECT_EQ(json.at("design"), "two_needs");
  EXPECT_EQ(json.at("needs").at("holds"), true);
  EXPECT_EQ(json.at("cycles").at("model"), json.at("cycles").at("rtl"));
}

}  // namespace
}  // namespace pineda::test
