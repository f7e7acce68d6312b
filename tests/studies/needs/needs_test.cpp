// The smallest design of a scene: it holds by an independent judge, and nothing smaller does.
#include "studies/needs/needs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/judge/drawing.h"
#include "model/judge/exact_terms.h"
#include "model/spec/bounds.h"
#include "model/spec/design_file.h"
#include "studies/needs/shrink.h"
#include "studies/numerics/design_points.h"
#include "tests/studies/small_scenes.h"

namespace pineda::studies {
namespace {

const Need& need(const Needs& needs, const std::string& name) {
  return *std::find_if(needs.parameters.begin(), needs.parameters.end(),
                       [&](const Need& n) { return n.parameter == name; });
}

TEST(Needs, TeapotKeepsFewerBitsInAtLeastFourParametersAndHolds) {
  const scene::Scene scene = teapot(320, 240);
  const Needs needs = find_needs(scene, {});
  ASSERT_TRUE(needs.found);
  int smaller = 0;
  for (const Need& n : needs.parameters) smaller += n.saved_bits > 0 ? 1 : 0;
  EXPECT_GE(smaller, 4);
  EXPECT_LT(needs.design.guard_bits, 10);
  EXPECT_EQ(needs.design.attributes, 3);  // alpha is the same everywhere
  EXPECT_LT(needs.cost.total(), .7 * static_cast<double>(needs.base_cost.total()));

  // Read back from its file, and judged from its snapped vertices.
  const spec::Design read = spec::parse_design(spec::design_toml(needs.design), "teapot");
  const spec::Contract contract = spec::contract(read);
  scene::Options options;
  options.size = scene::Size{320, 240};
  const scene::Scene again = scene::open_scene(contract, "teapot", options);
  double depth_ulp = 0;
  int64_t covered = 0, exact_samples = 0;
  spec::Triangle triangle;
  while (again.source->next(&triangle)) {
    const exact::Judge judge = judge::exact_judge(read, again.frame, triangle);
    judge::for_each_sample(contract, again.frame, triangle, [&](const judge::Drawn& drawn) {
      ASSERT_TRUE(judge.covers(drawn.x, drawn.y));
      ++covered;
      depth_ulp = std::max(depth_ulp, std::abs(judge.depth_error(drawn.x, drawn.y, drawn.z)));
    });
    exact_samples += judge.samples();
  }
  EXPECT_EQ(covered, exact_samples);
  EXPECT_LE(depth_ulp, 1);
  EXPECT_EQ(depth_ulp, needs.judgement.max_depth_ulp);
}

TEST(Needs, TwoFlatTrianglesDropDepthAndInterpolation) {
  const Needs needs = find_needs(two_flat_triangles(), {});
  ASSERT_TRUE(needs.found);
  EXPECT_FALSE(needs.design.depth_test);
  EXPECT_EQ(needs.design.attributes, 0);
  EXPECT_EQ(needs.design.flat_attributes, 4);
  EXPECT_EQ(needs.design.guard_bits, 6);
  EXPECT_FALSE(spec::has_reciprocal(needs.design));
  EXPECT_EQ(need(needs, "depth_bits").value, "-");
  EXPECT_EQ(need(needs, "guard_bits").forbids, "positions or the frame beyond 32 px");
}

TEST(Needs, DepthIsKeptWhereItDecides) {
  const auto near = half_square(0, 0, 8, .25f, kRed);
  const auto far = half_square(0, 0, 8, .5f, kBlue);
  const auto depth_test = [](std::vector<scene::ScreenTriangle> triangles) {
    return find_needs(scene_of(std::move(triangles), frame_of(8, 8)), {}).design.depth_test;
  };
  EXPECT_TRUE(depth_test({near, far}));
  EXPECT_FALSE(depth_test({far, near}));  // the painter's order
}

TEST(Needs, DepthBitsTellTheLeastGapApart) {
  // The second pair is a fifth of a 20-bit code apart and drawn far to near, so its depths must
  // differ: in 20 bits they do not, however values are rounded. The first pair, drawn near to far,
  // keeps the depth test.
  const auto z = [](double codes) { return static_cast<float>(codes * 0x1p-20); };
  const Needs needs = find_needs(
      scene_of({half_square(0, 0, 8, .25f, kRed), half_square(0, 0, 8, .5f, kBlue),
                half_square(16, 0, 8, z(4096.2), kBlue), half_square(16, 0, 8, z(4096), kRed)},
               frame_of(32, 8)),
      {});
  ASSERT_TRUE(needs.found);
  EXPECT_EQ(needs.use.gap_bits(), 23);
  EXPECT_EQ(needs.design.depth_bits, 21);
  EXPECT_EQ(need(needs, "depth_bits").forbids, "28 samples show another triangle");
}

TEST(Needs, NextSmallerValuesBreakWhatIsSaid) {
  const scene::Scene scene = teapot(96, 72, 4);
  const Needs needs = find_needs(scene, {});
  ASSERT_TRUE(needs.found);
  Winners winners;
  scene_use(scene, spec::contract(spec::kHighTile), &winners);
  int judged = 0;
  for (const auto& parameter : shrinkable_parameters()) {
    const auto smaller = parameter.smaller(needs.design);
    if (smaller.empty() || !spec::invalid_reason(smaller[0]).empty()) continue;
    if (smaller[0].guard_bits < needs.use.guard_bits) continue;
    if (design_cost(smaller[0]).total() >= needs.cost.total()) continue;
    ++judged;
    const auto judgement = judge_scene(scene, smaller[0], 14, winners, {});
    EXPECT_FALSE(judgement.holds(needs.limits)) << parameter.name;
    EXPECT_EQ(judgement.broken(needs.limits), need(needs, parameter.name).forbids);
  }
  EXPECT_GE(judged, 3);
}

TEST(Needs, WiderLimitsNeedNoMore) {
  const scene::Scene scene = teapot(96, 72, 4);
  NeedsOptions wide;
  wide.depth_ulp = wide.color_lsb = 4;
  EXPECT_LE(find_needs(scene, wide).cost.total(), find_needs(scene, {}).cost.total());
}

TEST(Needs, PerspectiveIsAddedWhereColoursNeedIt) {
  scene::ScreenTriangle t = half_square(1, 1, 30, .5f, kRed);
  t.v[2].rgba = kBlue;
  t.v[2].w = 8;
  const Needs needs = find_needs(scene_of({t}, frame_of(32, 32)), {});
  ASSERT_TRUE(needs.found);
  EXPECT_TRUE(needs.design.perspective);
  EXPECT_LT(need(needs, "perspective").saved_bits, 0);
  t.v[2].w = 1;
  EXPECT_FALSE(find_needs(scene_of({t}, frame_of(32, 32)), {}).design.perspective);
}

// Limits that cannot be held are reported; no near miss is returned.
TEST(Needs, NothingIsFoundWithinLimitsThatTheBaseBreaks) {
  NeedsOptions options;
  options.color_lsb = .4;
  const Needs needs = find_needs(teapot(96, 72, 4), options);
  EXPECT_FALSE(needs.found);
  EXPECT_NE(needs.of_start.broken(needs.limits).find("colour"), std::string::npos);
}

// The bias brings the far triangle to the front, so it decides what is seen; it is in the base's
// codes.
TEST(Needs, DepthBiasKeepsItsFormat) {
  scene::ScreenTriangle tilted = half_square(0, 0, 16, .25f, kRed);
  tilted.v[1].z = .5f;
  const auto flat = half_square(0, 0, 16, .375f, kBlue);
  scene::Scene scene = scene_of({tilted, flat, half_square(0, 0, 16, .3f, kRed)}, frame_of(16, 16));
  EXPECT_EQ(find_needs(scene, {}).design.depth_bits, 16);
  scene.frame.bias_constant = -500;
  scene.frame.bias_slope = -768;
  const Needs needs = find_needs(scene, {});
  ASSERT_TRUE(needs.found);
  EXPECT_EQ(needs.design.depth_bits, 24);
  EXPECT_EQ(need(needs, "depth_bits").forbids, "the depth bias is in codes of 24 bits");
}

TEST(DesignCost, CountedByHandForTheDefault) {
  const DesignCost cost = design_cost(spec::kHighTile);
  const int64_t newton = 4 * 32 * 32;
  EXPECT_EQ(cost.setup, setup_product_bits(spec::kHighTile) - newton);
  EXPECT_EQ(cost.reciprocal, newton + 128 * 8 / 8);
  EXPECT_EQ(cost.interpolation, 4 * (2 * 34 + 4 * 2 * 18));
  EXPECT_GT(cost.buffers, 4 * (3 * (24 + 24 + 39) + 3 * 44 + 4 * 3 * 28));
}

TEST(DesignCost, FallsWithEachParameter) {
  spec::Design d = *spec::find_design("persp");
  d.attributes = 3;
  d.flat_attributes = 1;
  for (const auto& parameter : shrinkable_parameters()) {
    const auto smaller = parameter.smaller(d);
    ASSERT_FALSE(smaller.empty()) << parameter.name;
    EXPECT_LT(design_cost(smaller[0]).total(), design_cost(d).total()) << parameter.name;
  }
}

TEST(DesignCost, WhatASchemeDoesNotUseCostsNothing) {
  spec::Design d = *spec::find_design("div28");
  const DesignCost cost = design_cost(d);
  for (const int anything : {-1, 12, 1000000}) {
    d.reciprocal_lut_bits = d.reciprocal_newton_steps = d.inverse_w_bits = anything;
    EXPECT_EQ(design_cost(d).reciprocal, cost.reciprocal);
    EXPECT_EQ(design_cost(d).total(), cost.total());
  }
}

TEST(ReciprocalFront, RisesInCostAndFallsInError) {
  const auto front = reciprocal_front(spec::kHighTile);
  EXPECT_GT(front.size(), 8u);
  for (size_t i = 0; i < front.size(); ++i) {
    EXPECT_EQ(spec::invalid_reason(front[i]), "");
    EXPECT_LE(spec::widths(front[i]).setup_interval_cycles,
              spec::widths(spec::kHighTile).setup_interval_cycles);
    if (i == 0) continue;
    EXPECT_GE(design_cost(front[i]).total(), design_cost(front[i - 1]).total());
    EXPECT_LT(spec::reciprocal_error_bound(front[i]), spec::reciprocal_error_bound(front[i - 1]));
  }
}

}  // namespace
}  // namespace pineda::studies
