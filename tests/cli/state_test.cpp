// Raster state through the program: every depth function with and without writes and on several
// cleared depths, scissors, biases and flat shading, compared with a rasterizer of a few lines in
// exact arithmetic.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "model/exact/exact.h"
#include "tests/cli/frames.h"
#include "tests/cli/program.h"
#include "tests/cli/verdict.h"

namespace pineda::test {
namespace {

constexpr int kWidth = 61;
constexpr int kHeight = 43;

struct Function {
  const char* name;
  bool tests;
  std::function<bool(int64_t, int64_t)> passes;
};

const std::vector<Function>& functions() {
  using L = int64_t;
  static const std::vector<Function> all{
      {"off", false, [](L, L) { return true; }},
      {"never", true, [](L, L) { return false; }},
      {"less", true, std::less<L>()},
      {"equal", true, std::equal_to<L>()},
      {"lequal", true, std::less_equal<L>()},
      {"greater", true, std::greater<L>()},
      {"notequal", true, std::not_equal_to<L>()},
      {"gequal", true, std::greater_equal<L>()},
      {"always", true, [](L, L) { return true; }},
  };
  return all;
}

struct State {
  std::string name;
  Function function;
  bool write = true;
  exact::Frame frame{kWidth, kHeight};
  float clear = 1;

  /// A binary32 times 24 bits: exact in a double, so rounded once.
  int64_t clear_code() const {
    return static_cast<int64_t>(std::floor(double{clear} * kClearedDepth + .5));
  }
  /// On a cleared frame, can nothing pass, or only samples at one end of the range? The program
  /// says so.
  bool lets_little_pass() const {
    const auto passes = [&](int64_t depth) { return function.passes(depth, clear_code()); };
    const bool is_end = clear == 0 || clear == 1;
    return function.tests && std::string(function.name) != "equal" && !passes(kClearedDepth / 2) &&
           (is_end || std::string(function.name) == "never");
  }
  std::string lines() const {
    std::string text = std::string("depth ") + function.name + "\n";
    if (!write) text += "depthwrite off\n";
    if (frame.x1 < INT32_MAX) {
      text += "scissor " + std::to_string(frame.x0) + " " + std::to_string(frame.y0) + " " +
              std::to_string(frame.x1 - frame.x0) + " " + std::to_string(frame.y1 - frame.y0) +
              "\n";
    }
    if (frame.bias_constant != 0 || frame.bias_slope != 0) {
      text += "depthbias " + std::to_string(frame.bias_constant) + " " +
              std::to_string(frame.bias_slope / 256.) + "\n";
    }
    if (clear != 1) text += "cleardepth " + std::to_string(clear) + "\n";
    if (frame.flat) text += "shade flat\n";
    return text;
  }
};
std::ostream& operator<<(std::ostream& to, const State& state) { return to << state.name; }

std::vector<State> states() {
  std::vector<State> all;
  int n = 0;
  for (const Function& f : functions()) {
    for (const bool write : {true, false}) {
      State s{std::string(f.name) + (write ? "" : "Unwritten"), f, write};
      // Borders that cut tiles and stamps, reach beyond the frame, or leave nothing.
      static constexpr std::array<std::array<int, 4>, 4> kScissors{
          {{0, 0, INT32_MAX, INT32_MAX}, {5, 3, 50, 30}, {11, 20, 1000, 1000}, {0, 0, 60, 43}}};
      const auto& scissor = kScissors[static_cast<size_t>(n) % 4];
      s.frame.x0 = scissor[0];
      s.frame.y0 = scissor[1];
      s.frame.x1 = scissor[2];
      s.frame.y1 = scissor[3];
      s.frame.bias_constant = n % 3 == 0 ? 0 : n % 3 == 1 ? -5000000 : 9000000;
      s.frame.flat = n % 5 < 2;
      all.push_back(s);
      ++n;
    }
  }
  // Cleared depths that triangles have, too, and one that they do not have.
  for (const Function& f : functions()) {
    for (const float clear : {0.f, .5f, .6875f}) {
      State s{std::string(f.name) + "ClearedTo" + std::to_string(int(clear * 10000)), f, true};
      s.clear = clear;
      all.push_back(s);
    }
  }
  State empty{"lessEmptyScissor", functions()[2]};
  empty.frame.x0 = empty.frame.x1 = 7;
  empty.frame.y1 = 43;
  all.push_back(empty);
  return all;
}

/// Overlapping triangles, each of one depth out of few, so that codes are exact and many are equal.
Scene level_triangles(const State& state) {
  Scene scene = pile(kWidth, kHeight, 60, 71);
  Random random(72);
  for (auto& t : scene.triangles) {
    const float z = static_cast<float>(random.between(0, 8)) / 8;
    for (auto& v : t) v.z = z;
  }
  scene.state = state.lines();
  return scene;
}

/// The scene's text without the depth line of the format's default: the scene's state has its own.
std::string text_of(const Scene& scene) {
  std::string text = tri_text(scene);
  const std::string own = "depth less\n";
  return text.erase(text.find(own), own.size());
}

struct Expected {
  std::vector<uint16_t> hits;
  std::vector<int64_t> depth;
  std::vector<exact::Sample> color;
  std::vector<bool> drawn;
  int passed = 0;
};

Expected expected(const Scene& scene, const State& state) {
  const size_t samples = size_t{kWidth} * kHeight;
  Expected e{std::vector<uint16_t>(samples), std::vector<int64_t>(samples, state.clear_code()),
             std::vector<exact::Sample>(samples), std::vector<bool>(samples), 0};
  for (const Triangle& t : scene.triangles) {
    exact::ScreenTriangle stated;
    for (size_t i = 0; i < 3; ++i) {
      const Vertex& v = t[i];
      stated[i] = {v.x, v.y, v.z, v.w, {v.rgba[0], v.rgba[1], v.rgba[2], v.rgba[3]}};
    }
    const exact::ScreenJudge judge(stated, {}, state.frame);
    std::vector<exact::Sample> covered;
    for (int y = judge.rows().first; y <= judge.rows().last; ++y) judge.row(y, false, &covered);
    for (const exact::Sample& s : covered) {
      const size_t at = static_cast<size_t>(s.y) * kWidth + static_cast<size_t>(s.x);
      ++e.hits[at];
      if (!state.function.passes(s.z.nearest, e.depth[at])) continue;
      ++e.passed;
      e.color[at] = s;
      e.drawn[at] = true;
      if (state.function.tests && state.write) e.depth[at] = s.z.nearest;
    }
  }
  return e;
}

class EveryState : public testing::TestWithParam<State> {
 protected:
  Scene scene_ = level_triangles(GetParam());
  Scratch scratch_;
  std::string text_ = scratch_.write("scene.tri", text_of(scene_));

  Dump dump(const std::string& command, const Arguments& more = {}) const {
    Arguments arguments{command, text_, "--quiet", "--dump", scratch_.path(command)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = pineda(arguments);
    if (GetParam().lets_little_pass()) {
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_NE(run.err.find(std::string("depth ") + GetParam().function.name + ": "),
                std::string::npos)
          << run.err;
    } else {
      EXPECT_TRUE(ended_silently(run));
    }
    return read_dump(scratch_.path(command), scene_);
  }
};

TEST_P(EveryState, RenderDrawsWhatExactArithmeticDoes) {
  const Expected e = expected(scene_, GetParam());
  const Dump got = dump("render");
  EXPECT_EQ(got.hits, e.hits);
  int wrong_depths = 0, wrong_colors = 0;
  for (size_t i = 0; i < e.depth.size(); ++i) {
    wrong_depths += got.depth[i] != e.depth[i] ? 1 : 0;
    for (size_t k = 0; k < 4; ++k) {
      const double error =
          e.drawn[i] ? e.color[i].affine[k].error_of(got.color[i][k]) : 1.0 * got.color[i][k];
      const double bound = !e.drawn[i] || GetParam().frame.flat ? 0 : kColorBoundLsb;
      wrong_colors += std::abs(error) > bound ? 1 : 0;
    }
  }
  EXPECT_EQ(wrong_depths, 0);
  EXPECT_EQ(wrong_colors, 0);
}

TEST_P(EveryState, RtlDumpsTheBytesOfRenderAndCheckHolds) {
  const Dump render = dump("render", {"--threads", "3"});
  const Dump rtl = dump("rtl");
  EXPECT_TRUE(render.hits == rtl.hits);
  EXPECT_TRUE(render.depth == rtl.depth);
  EXPECT_TRUE(render.color == rtl.color);
  const Json check = figures({"check", text_});
  EXPECT_EQ(check.at("mismatches"), 0);
  EXPECT_EQ(check.at("beyond_bounds"), 0);
  EXPECT_EQ(check.at("cycles").at("model"), check.at("cycles").at("rtl"));
}

INSTANTIATE_TEST_SUITE_P(Cli, EveryState, testing::ValuesIn(states()),
                         [](const auto& param) { return param.param.name; });

// The mutants: the comparison sees another depth function, another cleared depth, a missing scissor
// or bias, and smooth shading.
TEST(EveryStateMutant, AnotherStateGivesAnotherFrame) {
  State state{"", functions()[2]};
  const Scene scene = level_triangles(state);
  const Expected less = expected(scene, state);
  EXPECT_GT(less.passed, 1000);
  for (const char* name : {"equal", "lequal", "greater", "notequal", "gequal", "always", "never"}) {
    const auto f = std::find_if(functions().begin(), functions().end(),
                                [&](const Function& g) { return std::string(g.name) == name; });
    state.function = *f;
    EXPECT_NE(expected(scene, state).passed, less.passed) << name;
  }
  state.function = functions()[2];
  state.clear = .5f;
  EXPECT_NE(expected(scene, state).depth, less.depth);
  state.clear = 1;
  state.frame.bias_constant = 9000000;
  EXPECT_NE(expected(scene, state).depth, less.depth);
  state.frame = {kWidth, kHeight, exact::Cull::kNone, 5, 3, 50, 30};
  EXPECT_NE(expected(scene, state).hits, less.hits);
}

TEST(State, IsSaidWhereItIsNotAsByDefault) {
  const Scratch scratch;
  const Scene scene = pile(64, 48, 5, 73);
  Scene other = scene;
  other.state =
      "scissor 4 8 100 16\ndepthwrite off\ndepthbias -9 1.5\ncleardepth 0.1\nshade flat\n";
  const std::string plain = scratch.write("plain.tri", tri_text(scene));
  const std::string unusual = scratch.write("unusual.tri", tri_text(other));
  const std::string said =
      "scissor 4,8,60,16 px, depth write off, depth bias -9,1.5, clear depth 0.1, "
      "shade flat";
  for (const char* command : {"render", "time", "error"}) {
    const Json by_default = figures({command, plain});
    for (const char* key : {"scissor", "depth_write", "depth_bias", "clear_depth", "shade"}) {
      EXPECT_FALSE(by_default.contains(key)) << command << " " << key;
    }
    const Json json = figures({command, unusual});
    EXPECT_EQ(json.at("scissor"), Json({{"x", 4}, {"y", 8}, {"width", 60}, {"height", 16}}))
        << command;
    EXPECT_EQ(json.at("depth_write"), "off") << command;
    EXPECT_EQ(json.at("depth_bias"), Json({{"constant", -9}, {"slope", 1.5}})) << command;
    EXPECT_EQ(json.at("clear_depth"), 0.1f) << command;
    EXPECT_EQ(json.at("shade"), "flat") << command;
    EXPECT_NE(pineda({command, unusual}).out.find(said), std::string::npos) << command;
  }
}

TEST(State, OptionsGiveABuiltInSceneTheStateOfAFile) {
  const Scratch scratch;
  const Json json = figures({"render", "grid", "--size", "64x48", "--depth", "gequal", "--scissor",
                             "4,8,60,16", "--depth-write", "off", "--depth-bias", "-9,.3",
                             "--clear-depth", "0x.8p-1", "--shade", "flat"});
  EXPECT_EQ(json.at("depth_func"), "gequal");
  EXPECT_EQ(json.at("scissor").at("y"), 8);
  EXPECT_EQ(json.at("depth_bias").at("slope"), 77 / 256.);
  EXPECT_EQ(json.at("clear_depth"), .25);
  EXPECT_EQ(json.at("input").at("rounded_slope"), 1);
  const Outcome run = pineda({"render", "grid", "--depth-bias", "-9,.3", "--quiet"});
  EXPECT_NE(run.err.find("slope factor is taken as 0.30078125"), std::string::npos) << run.err;
}

// Reversed z: depths mirrored, cleared to 0, with greater instead of less draw the same picture.
// Without the cleared depth nothing passes, which is said.
TEST(ReversedZ, DrawsThePictureOfLess) {
  const Scratch scratch;
  Scene scene = pile(64, 48, 60, 76);
  Random random(77);
  for (auto& t : scene.triangles) {
    const float z = static_cast<float>(random.between(1, 63)) / 64;
    for (auto& v : t) v.z = z;
  }
  Scene reversed = scene;
  for (auto& t : reversed.triangles) {
    for (auto& v : t) v.z = 1 - v.z;
  }
  const auto text = [](Scene s, const std::string& state) {
    s.state = state;
    return text_of(s);
  };
  const auto draw = [&](const std::string& name, const std::string& scene_text) {
    const std::string path = scratch.write(name + ".tri", scene_text);
    return pineda({"render", path, "--quiet", "--dump", scratch.path(name)}).err;
  };
  EXPECT_EQ(draw("less", text(scene, "depth less\n")), "");
  EXPECT_EQ(draw("greater", text(reversed, "depth greater\ncleardepth 0\n")), "");
  EXPECT_EQ(read_bytes(scratch.path("less/color.rgba")),
            read_bytes(scratch.path("greater/color.rgba")));
  const std::string said = draw("fresh", text(reversed, "depth greater\n"));
  EXPECT_NE(said.find("nothing is greater than what depth is cleared to; cleardepth 0"),
            std::string::npos)
      << said;
  EXPECT_NE(read_bytes(scratch.path("less/color.rgba")),
            read_bytes(scratch.path("fresh/color.rgba")));
}

TEST(State, WhatTheTextbookAlgorithmsDoNotKnowLeavesThemOut) {
  const Json known = figures({"error", "grid", "--size", "64x48", "--design", "high_tile"});
  EXPECT_GT(known.at("baselines").size(), 5u);
  const Outcome run = pineda({"error", "grid", "--size", "64x48", "--design", "high_tile",
                              "--depth", "greater", "--scissor", "0,0,9,9", "--json", "-"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.json().at("baselines").size(), 0u);
  EXPECT_EQ(run.json().at("designs").size(), 1u);
  EXPECT_NE(run.err.find("know no scissor 0,0,9,9 px, depth greater"), std::string::npos)
      << run.err;
}

TEST(PerspectiveDesign, TakesTheWOfATriAndSaysNothing) {
  const Scratch scratch;
  Scene scene = pile(64, 48, 20, 74);
  Random random(75);
  for (auto& t : scene.triangles) {
    for (auto& v : t) v.w = random.uniform(1.f, 1000.f);
  }
  const std::string text = scratch.write("w.tri", tri_text(scene));
  const Outcome affine = pineda({"render", text, "--quiet", "--dump", scratch.path("affine")});
  EXPECT_NE(affine.err.find("W other than 1"), std::string::npos) << affine.err;
  EXPECT_TRUE(ended_silently(
      pineda({"render", text, "--quiet", "--dump", scratch.path("persp"), "--design", "persp"})));
  EXPECT_EQ(read_bytes(scratch.path("affine/depth.u32")),
            read_bytes(scratch.path("persp/depth.u32")));
  EXPECT_NE(read_bytes(scratch.path("affine/color.rgba")),
            read_bytes(scratch.path("persp/color.rgba")));
}

TEST(FlatDesign, SaysThatItHasNoDepthAndShadesFlat) {
  const Outcome run = pineda({"render", "triangle", "--design", "flat", "--quiet"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("has no depth"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("shades flat"), std::string::npos) << run.err;
  EXPECT_TRUE(ended_silently(pineda(
      {"render", "triangle", "--design", "flat", "--quiet", "--depth", "off", "--shade", "flat"})));
}

}  // namespace
}  // namespace pineda::test
