// Frames of a rasterizer of another kind: a plain box scan in doubles, with one bug at a time. Each is
// found, and named by the rule that it breaks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "model/judge/visible_frame.h"
#include "model/scene/resnap.h"
#include "model/scene/scene.h"
#include "model/spec/clear_depth.h"
#include "studies/judge/frame_diagnosis.h"
#include "tests/scene/scratch.h"

namespace pineda::studies {
namespace {

using scene::ScreenTriangle;

/// What is wrong with the rasterizer.
struct Bugs {
  bool inclusive = false;  // samples on any edge are drawn
  bool strict = false;     // and on none
  bool no_cull = false;
  bool no_scissor = false;
  std::optional<spec::DepthFunc> func;
  double depth_off = 0;         // codes
  bool swapped_color = false;   // red and green
  uint8_t cleared = 0;          // every byte of colour
  bool box_off_by_one = false;  // the last column of a triangle's box is left out
};

/// Draws a scene of 64 px or less a side, without perspective, bias or flat shading.
class BoxScan {
 public:
  BoxScan(const spec::FrameState& frame, const Bugs& bugs)
      : frame_(frame),
        bugs_(bugs),
        samples_(static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height)) {
    dump.hits.emplace(samples_);
    dump.depth.emplace(samples_, spec::depth_code(frame.clear_depth, 24));
    const uint8_t c = bugs.cleared;
    dump.color.emplace(samples_, std::array<uint8_t, 4>{c, c, c, c});
  }

  void draw(const ScreenTriangle& t) {
    std::array<int64_t, 3> x{}, y{};
    for (size_t i = 0; i < 3; ++i) {
      x[i] = std::llrint(256 * double{t.v[i].x});  // halves to even, as snapping does
      y[i] = std::llrint(256 * double{t.v[i].y});
    }
    const int64_t area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    if (area == 0) return;
    const bool is_back = area > 0;
    if (!bugs_.no_cull && ((frame_.cull == spec::Cull::kBack && is_back) ||
                           (frame_.cull == spec::Cull::kFront && !is_back))) {
      return;
    }
    const int64_t right = (*std::max_element(x.begin(), x.end()) + 127) / 256 - 1;
    for (int py = 0; py < frame_.height; ++py) {
      for (int px = 0; px < frame_.width; ++px) {
        if (!bugs_.no_scissor && (px < frame_.clip_x0() || px >= frame_.clip_x1() ||
                                  py < frame_.clip_y0() || py >= frame_.clip_y1())) {
          continue;
        }
        if (bugs_.box_off_by_one && px == right) continue;
        std::array<double, 3> weight{};
        bool inside = true;
        for (size_t i = 0; i < 3; ++i) {
          const size_t from = (i + 1) % 3, to = (i + 2) % 3;
          int64_t dx = x[to] - x[from], dy = y[to] - y[from];
          int64_t e = dx * (256 * py + 128 - y[from]) - dy * (256 * px + 128 - x[from]);
          weight[i] = static_cast<double>(e) / static_cast<double>(area);
          if (area < 0) {
            e = -e;
            dx = -dx;
            dy = -dy;
          }
          const bool top_left = dy < 0 || (dy == 0 && dx > 0);  // clockwise, y down
          inside &= e > 0 || (e == 0 && !bugs_.strict && (top_left || bugs_.inclusive));
        }
        if (inside) write(t, weight, px, py);
      }
    }
  }

  FrameDump dump;

 private:
  void write(const ScreenTriangle& t, const std::array<double, 3>& weight, int x, int y) {
    const auto at = static_cast<size_t>(y * frame_.width + x);
    ++(*dump.hits)[at];
    double z = 0;
    std::array<double, 4> color{};
    for (size_t i = 0; i < 3; ++i) {
      z += weight[i] * 16777215 * double{t.v[i].z};
      for (size_t k = 0; k < 4; ++k) color[k] += weight[i] * t.v[i].rgba[k];
    }
    const auto code = static_cast<int64_t>(std::floor(z + bugs_.depth_off + .5));
    const int64_t stored = (*dump.depth)[at];
    const int order = code < stored ? -1 : code > stored ? 1 : 0;
    if (!judge::passes(bugs_.func.value_or(frame_.depth), order)) return;
    if (frame_.depth_write && frame_.depth != spec::DepthFunc::kOff)
      (*dump.depth)[at] = static_cast<uint32_t>(code);
    if (bugs_.swapped_color) std::swap(color[0], color[1]);
    for (size_t k = 0; k < 4; ++k) {
      (*dump.color)[at][k] = static_cast<uint8_t>(std::floor(color[k] + .5));
    }
  }

  spec::FrameState frame_;
  Bugs bugs_;
  size_t samples_;
};

void for_each(const scene::Scene& scene, const std::function<void(const ScreenTriangle&)>& visit) {
  scene.source->rewind();
  scene::Unsnapped triangles(scene.source.get());
  scene::Counters counters;
  for (ScreenTriangle t; triangles.read(&t, &counters);) visit(t);
}

/// Nothing if the frame holds.
std::optional<Diagnosis> judged(const scene::Scene& scene, const FrameDump& dump) {
  FrameTolerance tolerance;
  FrameJudge judge(scene.frame, tolerance, dump);
  for_each(scene, [&](const ScreenTriangle& t) { judge.triangle(t); });
  const auto wrong = judge.wrong();
  if (wrong.empty()) return std::nullopt;
  FrameDiagnosis diagnosis(scene.frame, tolerance, dump, wrong.front(), scene.mesh.get());
  for_each(scene, [&](const ScreenTriangle& t) { diagnosis.triangle(t); });
  return diagnosis.result();
}

scene::Scene opened(const std::string& name, const scene::Options& options = {}) {
  return scene::open_scene(spec::contract(*spec::find_design("persp")), name, options);
}

FrameDump drawn(const scene::Scene& scene, const Bugs& bugs) {
  BoxScan foreign(scene.frame, bugs);
  for_each(scene, [&](const ScreenTriangle& t) { foreign.draw(t); });
  return foreign.dump;
}

/// The rule that a bug breaks on a scene: with all of a dump, without hits, and with colour alone.
std::string rules(const scene::Scene& scene, const Bugs& bugs) {
  FrameDump dump = drawn(scene, bugs);
  std::string text;
  for (int without = 0; without < 3; ++without) {
    if (without == 1) dump.hits.reset();
    if (without == 2) dump.depth.reset();
    const auto found = judged(scene, dump);
    text += (without == 0 ? "" : " ") + std::string(found ? spec::name_of(found->rule) : "holds");
  }
  return text;
}

class FrameJudgeTest : public testing::Test {
 protected:
  scene::Scene tri(const std::string& state, const std::string& vertices) {
    return opened(scratch_.write("scene.tri", "pineda-tri 1\nsize 16 16\n" + state + vertices));
  }
  scene::Scratch scratch_;
};

// Two triangles on a shared edge that runs through samples, far apart in colour.
constexpr const char* kQuad =
    "v 2.5 2.5 .5 1 255 0 0 255\nv 10.5 2.5 .5 1 255 0 0 255\nv 2.5 10.5 .5 1 255 0 0 255\n"
    "v 10.5 2.5 .5 1 0 0 255 255\nv 10.5 10.5 .5 1 0 0 255 255\nv 2.5 10.5 .5 1 0 0 255 255\n";
// The same triangle twice, in two colours.
constexpr const char* kTwice =
    "v 1 1 .25 1 255 0 0 255\nv 12 2 .5 1 255 0 0 255\nv 3 13 .75 1 255 0 0 255\n"
    "v 1 1 .25 1 0 0 255 255\nv 12 2 .5 1 0 0 255 255\nv 3 13 .75 1 0 0 255 255\n";
// One in front of another.
constexpr const char* kTwo =
    "v 1 1 .25 1 255 40 0 255\nv 12 2 .25 1 255 90 0 255\nv 3 13 .25 1 200 0 0 255\n"
    "v 1 1 .75 1 0 90 255 255\nv 12 2 .5 1 0 0 255 255\nv 3 13 .75 1 0 0 255 255\n";

TEST_F(FrameJudgeTest, RightFramesHold) {
  for (const char* name : {"hard/shared_edges", "hard/half_pixel_lattice", "hard/fan",
                           "hard/edges_through_centers", "hard/micro_triangles", "triangle"}) {
    EXPECT_EQ(rules(opened(name), {}), "holds holds holds") << name;
  }
  EXPECT_EQ(rules(tri("", kTwice), {}), "holds holds holds");
  EXPECT_EQ(rules(tri("depth lequal\n", kTwice), {}), "holds holds holds");
  EXPECT_EQ(rules(tri("scissor 3 4 5 6\n", kTwo), {}), "holds holds holds");
  EXPECT_EQ(rules(tri("depth off\n", kTwo), {}), "holds holds holds");
  EXPECT_EQ(rules(tri("depthwrite off\ncleardepth .6\n", kTwo), {}), "holds holds holds");
}

TEST_F(FrameJudgeTest, ASampleOnASharedEdgeIsNamedByTheFillRule) {
  Bugs inclusive, strict;
  inclusive.inclusive = strict.strict = true;
  EXPECT_EQ(rules(tri("", kQuad), inclusive), "fill_rule fill_rule fill_rule");
  EXPECT_EQ(rules(tri("", kQuad), strict), "fill_rule fill_rule fill_rule");
  const auto scene = opened("hard/half_pixel_lattice");
  EXPECT_EQ(judged(scene, drawn(scene, inclusive))->rule, Rule::kFillRule);
  EXPECT_EQ(judged(scene, drawn(scene, strict))->rule, Rule::kFillRule);
}

TEST_F(FrameJudgeTest, AColumnThatIsLeftOutIsCoverage) {
  Bugs bugs;
  bugs.box_off_by_one = true;
  const auto scene = tri("",
                         "v 1.25 1.25 .25 1 255 0 0 255\nv 12.75 3 .5 1 255 0 0 255\n"
                         "v 12.75 13 .75 1 255 0 0 255\n");
  EXPECT_EQ(rules(scene, bugs), "coverage coverage coverage");
  EXPECT_EQ(judged(scene, drawn(scene, bugs))->triangle, 0u);
}

TEST_F(FrameJudgeTest, WhatIsToBeCulledIsNamed) {
  Bugs bugs;
  bugs.no_cull = true;
  EXPECT_EQ(rules(tri("cull back\n", kTwo), bugs), "cull cull cull");
}

TEST_F(FrameJudgeTest, WhatIsOutsideTheScissorIsNamed) {
  Bugs bugs;
  bugs.no_scissor = true;
  EXPECT_EQ(rules(tri("scissor 3 4 5 6\n", kTwo), bugs), "scissor scissor scissor");
}

TEST_F(FrameJudgeTest, AnotherDepthFunctionIsNamed) {
  Bugs greater, lequal, less;
  greater.func = spec::DepthFunc::kAlways;
  lequal.func = spec::DepthFunc::kLequal;
  less.func = spec::DepthFunc::kLess;
  const auto two = tri("", kTwo);
  EXPECT_EQ(rules(two, greater), "depth_func depth_func depth_func");
  const auto found = judged(two, drawn(two, greater));
  EXPECT_EQ(found->triangle, 1u);  // it passed, and must not
  EXPECT_EQ(found->scene.size(), 2u);
  EXPECT_EQ(rules(tri("", kTwice), lequal), "depth_tie depth_tie depth_tie");
  EXPECT_EQ(rules(tri("depth lequal\n", kTwice), less), "depth_tie depth_tie depth_tie");
}

TEST_F(FrameJudgeTest, ValuesBeyondTheToleranceAreNamed) {
  Bugs depth, color;
  depth.depth_off = 2;
  color.swapped_color = true;
  EXPECT_EQ(rules(tri("", kTwo), depth), "depth_value depth_value holds");
  EXPECT_EQ(rules(tri("", kTwo), color), "color_value color_value color_value");
}

TEST_F(FrameJudgeTest, WhatWasNotClearedIsNamed) {
  Bugs bugs;
  bugs.cleared = 1;
  EXPECT_EQ(rules(tri("", kTwo), bugs), "clear clear clear");
}

// Depths closer than the tolerance may come in either order; equal ones of one plane may not.
TEST_F(FrameJudgeTest, AnOrderThatTheToleranceLeavesOpenIsNotJudged) {
  const auto scene =
      tri("",
          "v 1 1 .1 1 255 0 0 255\nv 12 2 .1 1 255 0 0 255\nv 3 13 .1 1 255 0 0 255\n"
          "v 1 1 .10000001 1 0 0 255 255\nv 12 2 .10000001 1 0 0 255 255\n"
          "v 3 13 .10000001 1 0 0 255 255\n");
  Bugs bugs;
  bugs.func = spec::DepthFunc::kAlways;
  bugs.depth_off = -1;  // of a code
  EXPECT_EQ(rules(scene, bugs), "holds holds holds");
}

// A mesh drawn without its near plane: what lies behind it is named.
TEST_F(FrameJudgeTest, WhatLiesBehindTheNearPlaneIsNamed) {
  scene::Options options;
  options.size = scene::Size{64, 64};
  options.camera = scene::Camera{};
  options.camera->eye = {0, 1.2, 1.2};
  const auto scene = opened("teapot", options);
  ASSERT_TRUE(scene.mesh);
  FrameDump right;
  right.hits.emplace(64 * 64);
  FrameTolerance tolerance;
  for_each(scene, [&](const ScreenTriangle& t) {
    exact::ScreenTriangle stated;
    for (size_t i = 0; i < 3; ++i) stated[i] = {t.v[i].x, t.v[i].y, t.v[i].z, t.v[i].w, {}};
    const exact::ScreenJudge judge(stated, tolerance.format, exact::Frame{64, 64});
    for (int y = judge.rows().first; y <= judge.rows().last && !judge.culled(); ++y) {
      const auto span = judge.span(y);
      for (int x = span.first; x <= span.last; ++x)
        ++(*right.hits)[static_cast<size_t>(64 * y + x)];
    }
  });
  ASSERT_FALSE(judged(scene, right));
  // One more hit where a ray meets a triangle between the eye and the near plane.
  int named = 0;
  for (size_t i = 0; i < 64 * 64; i += 29) {
    FrameDump dump = right;
    ++(*dump.hits)[i];
    const auto found = judged(scene, dump);
    ASSERT_TRUE(found);
    EXPECT_EQ(static_cast<size_t>(64 * found->y + found->x), i);
    named += found->rule == Rule::kNearPlane ? 1 : 0;
  }
  EXPECT_GT(named, 5);
}

}  // namespace
}  // namespace pineda::studies
