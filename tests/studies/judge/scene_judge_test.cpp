// The judge of a whole scene: it finds no fault in the exact model, and each kind of planted fault.
#include "studies/judge/scene_judge.h"

#include <gtest/gtest.h>

#include "model/judge/visible_frame.h"
#include "model/spec/clear_depth.h"
#include "studies/numerics/random_triangles.h"
#include "tests/studies/small_scenes.h"

namespace pineda::studies {
namespace {

SceneJudgement judged(const scene::Scene& scene, const spec::Design& design,
                      const SceneJudgeOptions& options = {}) {
  Winners winners;
  scene_use(scene, spec::contract(spec::kHighTile), &winners);
  return judge_scene(scene, design, spec::kHighTile.guard_bits, winners, options);
}

std::vector<scene::ScreenTriangle> some_triangles(int count) {
  Random random(11);
  std::vector<scene::ScreenTriangle> triangles(static_cast<size_t>(count));
  for (auto& t : triangles) {
    for (auto& v : t.v) {
      v.x = static_cast<float>(-20 + 120 * random.unit());
      v.y = static_cast<float>(-20 + 110 * random.unit());
      v.z = static_cast<float>(random.unit());
      for (auto& c : v.rgba) c = static_cast<uint8_t>(random.between(0, 255));
    }
  }
  return triangles;
}

spec::Design exact32() {
  spec::Design d = *spec::find_design("exact");
  d.depth_bits = 32;
  return d;
}

TEST(SceneJudge, TheExactModelIsNearestAndShowsTheSameTriangles) {
  for (const auto func :
       {spec::DepthFunc::kLess, spec::DepthFunc::kGequal, spec::DepthFunc::kOff}) {
    spec::FrameState frame = frame_of(80, 70);
    frame.depth = func;
    const SceneJudgement j = judged(scene_of(some_triangles(60), frame), exact32());
    EXPECT_GT(j.samples, 50000u);
    EXPECT_EQ(j.missing + j.extra, 0u);
    EXPECT_EQ(j.other_winner, 0u);
    EXPECT_LE(j.max_depth_ulp, .5);
    EXPECT_LE(j.max_color_lsb, .5);
    EXPECT_GT(j.max_depth_ulp, .49);
  }
}

TEST(SceneJudge, ScissorFlatShadingAndUnwrittenDepthAreTheFrames) {
  spec::FrameState frame = frame_of(80, 70);
  frame.scissor_x0 = 5;
  frame.scissor_y0 = 9;
  frame.scissor_x1 = 61;
  frame.scissor_y1 = 50;
  frame.shade = spec::Shade::kFlat;
  frame.depth_write = false;
  const SceneJudgement j = judged(scene_of(some_triangles(60), frame), exact32());
  EXPECT_EQ(j.missing + j.extra, 0u);
  EXPECT_EQ(j.other_winner, 0u);
  EXPECT_EQ(j.max_color_lsb, 0);
}

// A scene states a cleared depth; each design has its own code for it.
TEST(SceneJudge, EachDesignClearsToItsOwnCode) {
  for (const float z : {0.f, .3f, .5f, 1.f}) {
    for (const auto func : {spec::DepthFunc::kLequal, spec::DepthFunc::kGreater}) {
      spec::FrameState frame = frame_of(32, 32);
      frame.depth = func;
      frame.clear_depth = z;
      const scene::Scene scene = scene_of(
          {half_square(0, 0, 30, z, kRed), half_square(2, 0, 28, (z + 1) / 2, kBlue)}, frame);
      for (const int bits : {16, 24, 32}) {
        spec::Design d = spec::kHighTile;
        d.depth_bits = bits;
        EXPECT_EQ(judged(scene, d).other_winner, 0u) << z << ", " << bits << " bits";
        EXPECT_EQ(judge::VisibleFrame(d, frame).z(0), spec::depth_code(z, bits));
      }
    }
  }
}

TEST(SceneJudge, SeesPositionsBeyondTheGuardBand) {
  spec::Design d = spec::kHighTile;
  d.guard_bits = 6;
  const SceneJudgement j = judged(scene_of(some_triangles(60), frame_of(64, 64)), d);
  EXPECT_GT(j.missing + j.extra, 0u);
  EXPECT_NE(j.broken({}).find("missing"), std::string::npos);
}

TEST(SceneJudge, SeesErrorsOfDepthAndColour) {
  const scene::Scene scene = scene_of(some_triangles(60), frame_of(80, 70));
  spec::Design coarse = spec::kHighTile;
  coarse.tile_fraction_bits = 1;
  const SceneJudgement j = judged(scene, coarse);
  EXPECT_GT(j.max_depth_ulp, 2);
  EXPECT_GT(j.max_color_lsb, 2);
  EXPECT_EQ(j.missing + j.extra, 0u);
  EXPECT_NE(j.broken({100, 1, 1 << 20}).find("colour"), std::string::npos);
  EXPECT_NE(j.broken({1, 100, 1 << 20}).find("depth"), std::string::npos);
  EXPECT_TRUE(j.holds({100, 100, 1 << 20}));
}

TEST(SceneJudge, SeesAFlatColourWhereItVaries) {
  scene::ScreenTriangle t = half_square(1, 1, 20, .5f, kRed);
  t.v[2].rgba[3] = 155;
  spec::Design flat = spec::kHighTile;
  flat.attributes = 3;
  flat.flat_attributes = 1;
  EXPECT_GT(judged(scene_of({t}, frame_of(32, 32)), flat).max_color_lsb, 80);
}

TEST(SceneJudge, SeesAnotherTriangleInFront) {
  spec::Design none = spec::kHighTile;
  none.depth_test = false;
  const auto near = half_square(0, 0, 8, .25f, kRed);
  const auto far = half_square(0, 0, 8, .5f, kBlue);
  EXPECT_EQ(judged(scene_of({near, far}, frame_of(8, 8)), none).other_winner, 28u);
  EXPECT_EQ(judged(scene_of({far, near}, frame_of(8, 8)), none).other_winner, 0u);
}

// The default design interpolates colours affinely: where w differs they break the limit, and the
// judge says so.
TEST(SceneJudge, ColoursAreJudgedWithPerspective) {
  scene::ScreenTriangle t = half_square(1, 1, 30, .5f, kRed);
  t.v[2].rgba = kBlue;
  t.v[2].w = 8;
  const scene::Scene scene = scene_of({t}, frame_of(32, 32));
  EXPECT_GT(judged(scene, spec::kHighTile).max_color_lsb, 50);
  EXPECT_LT(judged(scene, *spec::find_design("persp")).max_color_lsb, .6);
}

TEST(SceneJudge, StopsAtTheFirstTriangleOutOfTheLimits) {
  const scene::Scene scene = scene_of(some_triangles(60), frame_of(80, 70));
  spec::Design coarse = spec::kHighTile;
  coarse.tile_fraction_bits = 1;
  SceneJudgeOptions options;
  options.stop_early = true;
  const SceneJudgement stopped = judged(scene, coarse, options);
  EXPECT_FALSE(stopped.finished);
  EXPECT_LT(stopped.samples, judged(scene, coarse).samples / 4);
  EXPECT_FALSE(stopped.holds(options.limits));
}

}  // namespace
}  // namespace pineda::studies
