// A scene snapped once more: the same triangles as one opened for the other design.
#include "model/scene/resnap.h"

#include <gtest/gtest.h>

#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

spec::Contract smaller() {
  spec::Design d = spec::kHighTile;
  d.guard_bits = 9;
  d.depth_bits = 16;
  return spec::contract(d);
}

bool same(const spec::Triangle& a, const spec::Triangle& b) {
  if (a.id != b.id) return false;
  for (size_t i = 0; i < 3; ++i) {
    const spec::Vertex& v = a.v[i];
    const spec::Vertex& w = b.v[i];
    if (v.x != w.x || v.y != w.y || v.z != w.z || v.attr != w.attr) return false;
  }
  return true;
}

TEST(Unsnapped, IsTheSceneAsOpenedForTheOtherDesign) {
  Options options;
  options.size = Size{320, 240};
  options.tessellate = 4;
  const auto opened = all_triangles(open_scene(smaller(), "teapot", options).source.get());
  const Scene wide = open_scene(kContract, "teapot", options);
  SnappedSource again(smaller(), std::make_unique<Unsnapped>(wide.source.get()));
  const auto resnapped = all_triangles(&again);
  ASSERT_EQ(resnapped.size(), opened.size());
  for (size_t i = 0; i < opened.size(); ++i) EXPECT_TRUE(same(resnapped[i], opened[i])) << i;
  // Rewound, it is the same scene.
  again.rewind();
  EXPECT_EQ(all_triangles(&again).size(), opened.size());
  EXPECT_EQ(again.counters().triangles, wide.source->counters().triangles);
}

TEST(Unsnapped, CountsWhatTheScenesReaderAndSnappingFind) {
  const Scene wide = open_scene(kContract, "hard/not_numbers", {});
  const auto expected = [&] {
    all_triangles(wide.source.get());
    return wide.source->counters();
  }();
  wide.source->rewind();
  SnappedSource again(kContract, std::make_unique<Unsnapped>(wide.source.get()));
  all_triangles(&again);
  EXPECT_GT(expected.nan_dropped, 0u);
  EXPECT_EQ(again.counters().triangles, expected.triangles);
  EXPECT_EQ(again.counters().nan_dropped, expected.nan_dropped);
  EXPECT_EQ(again.counters().saturated, expected.saturated);
  EXPECT_EQ(again.counters().z_clamped, expected.z_clamped);
  EXPECT_EQ(again.counters().denormals, expected.denormals);
}

TEST(Unsnapped, StillSaysThatTheSlopeFactorWasRounded) {
  Options options;
  options.size = Size{16, 16};
  options.depth_bias = DepthBias{0, {77, true}};
  const Scene wide = open_scene(kContract, "grid", options);
  SnappedSource again(smaller(), std::make_unique<Unsnapped>(wide.source.get()));
  for (int pass = 0; pass < 2; ++pass) {
    all_triangles(&again);
    EXPECT_EQ(again.counters().rounded_slope, 1u);
    again.rewind();
  }
}

}  // namespace
}  // namespace pineda::scene
