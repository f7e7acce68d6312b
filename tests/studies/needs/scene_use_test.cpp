// What a scene uses, against scenes whose figures are known by hand.
#include "studies/needs/scene_use.h"

#include <gtest/gtest.h>

#include "studies/judge/scene_truth.h"
#include "tests/studies/small_scenes.h"

namespace pineda::studies {
namespace {

const spec::Contract kContract = spec::contract(spec::kHighTile);

SceneUse use_of(const scene::Scene& scene, Winners* winners = nullptr) {
  Winners unused;
  return scene_use(scene, kContract, winners != nullptr ? winners : &unused);
}

// The half square has 28 samples: the eight on the hypotenuse, a right edge, do not belong to it.
TEST(SceneUse, CountsOverlapAndTheLeastGap) {
  std::vector<scene::ScreenTriangle> triangles{half_square(0, 0, 8, .5f, kRed),
                                               half_square(0, 0, 8, .25f, kRed),
                                               half_square(0, 0, 8, .75f, kBlue)};
  Winners winners;
  const SceneUse use = use_of(scene_of(triangles, frame_of(16, 8)), &winners);
  EXPECT_EQ(use.triangles, 3u);
  EXPECT_EQ(use.covered, 28u);
  EXPECT_EQ(use.samples, 84u);
  EXPECT_EQ(use.most_hits, 3u);
  EXPECT_EQ(use.mean_hits(), 3);
  EXPECT_EQ(use.compared, 56u);  // the second with the first, the third with the second
  EXPECT_EQ(use.equal, 0u);
  EXPECT_EQ(use.least_gap, .25);
  EXPECT_EQ(use.gap_bits(), 2);
  EXPECT_EQ(winners[0], 2u);
  EXPECT_EQ(winners[15], 0u);
}

// Reversed z, and a triangle at the cleared depth, which must count as equal however depths are
// snapped.
TEST(SceneUse, DepthsAreComparedWithWhatTheFrameIsClearedTo) {
  const auto winner = [](spec::DepthFunc func, float clear, std::vector<float> depths) {
    spec::FrameState frame = frame_of(16, 8);
    frame.depth = func;
    frame.clear_depth = clear;
    std::vector<scene::ScreenTriangle> triangles;
    for (const float z : depths) triangles.push_back(half_square(0, 0, 8, z, kRed));
    Winners winners;
    use_of(scene_of(std::move(triangles), frame), &winners);
    return winners[0];
  };
  using spec::DepthFunc;
  EXPECT_EQ(winner(DepthFunc::kGreater, 0, {.25f, .75f, .5f}), 2u);
  EXPECT_EQ(winner(DepthFunc::kGreater, 1, {.25f, .75f, .5f}), 0u);
  for (const float z : {.5f, .1f, .3f, 1 / 3.f, 0.f, 1.f}) {
    EXPECT_EQ(winner(DepthFunc::kLess, z, {z}), 0u) << z;
    EXPECT_EQ(winner(DepthFunc::kGreater, z, {z}), 0u) << z;
    EXPECT_EQ(winner(DepthFunc::kEqual, z, {z}), 1u) << z;
    EXPECT_EQ(winner(DepthFunc::kLequal, z, {z}), 1u) << z;
    EXPECT_EQ(winner(DepthFunc::kGequal, z, {z}), 1u) << z;
  }
}

TEST(SceneUse, EqualDepthsAreNoGapAndTheFirstStays) {
  scene::ScreenTriangle tilted = half_square(0, 0, 31, .1f, kRed);
  tilted.v[1].z = .7f;
  tilted.v[2].z = .3f;
  scene::ScreenTriangle turned = tilted;
  std::swap(turned.v[0], turned.v[1]);
  Winners winners;
  const SceneUse use = use_of(scene_of({tilted, turned}, frame_of(32, 32)), &winners);
  EXPECT_EQ(use.equal, use.compared);
  EXPECT_GT(use.equal, 400u);
  EXPECT_EQ(use.least_gap, 0);
  EXPECT_EQ(winners[0], 1u);
}

TEST(SceneUse, RangesAreThoseOfWhatIsDrawn) {
  scene::ScreenTriangle wide = half_square(-20, 1, 10, .5f, kRed);
  wide.v[1].x = 90.5f;
  const SceneUse use = use_of(
      scene_of({wide, half_square(3, 3, 4, .125f, kBlue), half_square(500, 3, 4, .9f, kBlue)},
               frame_of(64, 32)));
  EXPECT_EQ(use.x_low_px, -20);
  EXPECT_EQ(use.x_high_px, 90.5);
  EXPECT_EQ(use.widest_px, 110.5);
  EXPECT_EQ(use.tallest_px, 10);
  EXPECT_EQ(use.farthest_px, 120.5);
  EXPECT_EQ(use.largest_area_px2, 552.5);
  EXPECT_EQ(use.depth_low, .125);
  EXPECT_EQ(use.depth_high, .5);
  EXPECT_EQ(use.dropped[static_cast<size_t>(core::Drop::kOutside)], 1u);
  EXPECT_EQ(use.guard_bits, 9);  // 504 px: positions outside the frame count, too
}

TEST(SceneUse, GuardBitsHoldTheFrameAndBothEndsOfTheBand) {
  const auto bits = [](float x, int width) {
    return use_of(scene_of({half_square(x, 1, 4, .5f, kRed)}, frame_of(width, 8))).guard_bits;
  };
  EXPECT_EQ(bits(2, 128), 7);
  EXPECT_EQ(bits(2, 129), 8);
  EXPECT_EQ(bits(-128, 64), 7);
  EXPECT_EQ(bits(-128 - 1 / 256.f, 64), 8);
  EXPECT_EQ(bits(124 - 1 / 256.f, 64), 7);
  EXPECT_EQ(bits(124, 64), 8);
}

TEST(SceneUse, ColoursVaryOrNotByComponent) {
  scene::ScreenTriangle t = half_square(1, 1, 8, .5f, kRed);
  t.v[2].rgba[1] = 40;
  const SceneUse use = use_of(scene_of({t, half_square(1, 1, 8, .25f, kBlue)}, frame_of(16, 16)));
  EXPECT_EQ(use.color[0], Variation::kFlat);
  EXPECT_EQ(use.color[1], Variation::kVaries);
  EXPECT_EQ(use.color[2], Variation::kFlat);
  EXPECT_EQ(use.color[3], Variation::kConstant);
  EXPECT_EQ(use.color_value[3], 255);
  EXPECT_EQ(use.perspective_triangles, 0u);
}

TEST(SceneUse, PerspectiveIsWhereWAndColoursDiffer) {
  scene::ScreenTriangle gray = half_square(1, 1, 8, .5f, kRed);
  gray.v[1].w = 4;
  scene::ScreenTriangle colored = gray;
  colored.v[2].rgba = kBlue;
  scene::Scene scene = scene_of({gray, colored}, frame_of(16, 16));
  EXPECT_EQ(use_of(scene).perspective_triangles, 1u);
  scene.frame.shade = spec::Shade::kFlat;
  EXPECT_EQ(use_of(scene).perspective_triangles, 0u);
}

TEST(SceneUse, ScissorLeavesNothingOutside) {
  spec::FrameState frame = frame_of(16, 16);
  frame.scissor_x0 = 2;
  frame.scissor_y0 = 1;
  frame.scissor_x1 = 4;
  frame.scissor_y1 = 3;
  EXPECT_EQ(use_of(scene_of({half_square(0, 0, 14, .5f, kRed)}, frame)).samples, 4u);
}

// Every row is in one band, whatever the triangle; bands are whole rows of tiles.
TEST(Bands, PartitionTheRows) {
  const scene::Scene scene = scene_of(
      {half_square(-9, 3, 700, .5f, kRed), half_square(5, 30, 2, .5f, kRed)}, frame_of(16384, 512));
  int bands = 0;
  for_each_judged(scene, kContract, judge::format_of(kContract.design),
                  [&](const spec::Triangle&, const exact::ScreenJudge& judge) {
                    const exact::Span all = judge.rows();
                    int next_row = all.first;
                    int next_tile = 0;
                    for_each_band(judge, 16384, 3, [&](int first, int last, exact::Span rows) {
                      ++bands;
                      EXPECT_EQ(first, next_tile);
                      EXPECT_EQ(rows.first, next_row);
                      EXPECT_LE(rows.last - rows.first, 64);
                      next_tile = last + 1;
                      next_row = rows.last + 1;
                    });
                    EXPECT_EQ(next_row, all.last + 1);
                    EXPECT_GT(next_tile, 2048);  // beyond every frame
                    return true;
                  });
  EXPECT_GT(bands, 20);
}

}  // namespace
}  // namespace pineda::studies
