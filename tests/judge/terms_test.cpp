// The design's contract translated for the judge, the samples of stamps, the depth functions.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "model/judge/drawing.h"
#include "model/judge/visible_frame.h"
#include "tests/judge/support.h"

namespace pineda::judge {
namespace {

TEST(ExactTerms, EveryFieldOfAFrameCounts) {
  const exact::Frame f = exact_frame({9, 8, spec::Cull::kFront, spec::DepthFunc::kLess, true,
                                      spec::Shade::kFlat, 1, 2, 7, 6, -5, 4});
  EXPECT_EQ(std::tie(f.width, f.height, f.x0, f.y0, f.x1, f.y1), std::tuple(9, 8, 1, 2, 7, 6));
  EXPECT_EQ(f.cull, exact::Cull::kFront);
  EXPECT_TRUE(f.flat);
  EXPECT_EQ(f.bias_constant, -5);
  EXPECT_EQ(f.bias_slope, 4);
  EXPECT_EQ(exact_frame({9, 8, spec::Cull::kNone}).cull, exact::Cull::kNone);
  EXPECT_EQ(exact_frame({9, 8, spec::Cull::kBack}).cull, exact::Cull::kBack);
  EXPECT_FALSE(exact_frame({9, 8}).flat);
}

TEST(ExactTerms, FormatIsThatOfTheDesignsInput) {
  spec::Design d = spec::kHighTile;
  d.subpixel_bits = 5;
  d.guard_bits = 11;
  d.depth_bits = 17;
  d.attributes = 2;
  d.flat_attributes = 3;
  d.attribute_bits = 9;
  const exact::Format f = format_of(d);
  EXPECT_EQ(std::tie(f.subpixel_bits, f.guard_bits, f.depth_bits, f.attributes, f.attribute_bits),
            std::tuple(5, 11, 17, 5, 9));
}

TEST(ExactTerms, ASnappedTriangleIsThatOfTheScene) {
  const exact::ScreenJudge from_floats = judge_of();
  const exact::Judge judge = exact_judge(spec::kHighTile, kFrame, snapped());
  EXPECT_EQ(judge.samples(), from_floats.snapped().samples());
  EXPECT_EQ(judge.doubled_area(), from_floats.snapped().doubled_area());
  spec::FrameState flat = kFrame;
  flat.shade = spec::Shade::kFlat;
  const spec::Triangle t = snapped();
  for (int a = 0; a < 4; ++a) {
    const int32_t first = t.v[0].attr[static_cast<size_t>(a)];
    EXPECT_EQ(exact_judge(spec::kHighTile, flat, t).attribute_error(20, 20, a, first), 0);
    EXPECT_EQ(judge.attribute_error(20, 20, a, first) == 0, a == 3) << a;  // alpha alone is flat
  }
}

TEST(ExactTerms, ScissorAndCullingAreThoseOfTheFrame) {
  spec::FrameState frame = kFrame;
  frame.scissor_x0 = 20;
  frame.scissor_x1 = 21;
  frame.scissor_y0 = 20;
  frame.scissor_y1 = 22;
  EXPECT_EQ(exact_judge(spec::kHighTile, frame, snapped()).samples(), 2);
  int culled = 0;
  for (const auto cull : {spec::Cull::kBack, spec::Cull::kFront}) {
    culled += exact_judge(spec::kHighTile, {64, 48, cull}, snapped()).culled() ? 1 : 0;
  }
  EXPECT_EQ(culled, 1);
}

// A stamp is W x H px, lane i at (i % W, i / W): core's own frame buffer has the same places.
TEST(Lanes, LieWhereTheFrameBufferHasThem) {
  for (const int w_log2 : {0, 1, 2}) {
    for (const int h_log2 : {0, 1}) {
      spec::Design d = spec::kHighTile;
      d.stamp_width_log2 = w_log2;
      d.stamp_height_log2 = h_log2;
      const spec::Contract contract = spec::contract(d);
      const core::FrameBuffer buffer(contract, kFrame);
      spec::Stamp stamp;
      stamp.x = 3;
      stamp.y = 5;
      for (stamp.mask = 0; stamp.mask < 1u << contract.width.lanes; ++stamp.mask) {
        std::set<std::pair<size_t, size_t>> wanted, got;
        buffer.for_each_lane(contract, stamp.x, stamp.y, stamp.mask,
                             [&](size_t lane, size_t at) { wanted.emplace(lane, at); });
        for_each_lane(d, stamp, [&](int x, int y, size_t lane) {
          got.emplace(lane, static_cast<size_t>(y * kFrame.width + x));
        });
        ASSERT_EQ(got, wanted) << w_log2 << h_log2 << " " << stamp.mask;
      }
    }
  }
}

TEST(Lanes, FlatAttributesStandBehindTheInterpolatedOnes) {
  spec::Design d = spec::kHighTile;
  d.attributes = 2;
  d.flat_attributes = 3;
  spec::Stamp stamp;
  stamp.mask = 2;
  stamp.planes.flat = {7, 8, 9, -1};
  spec::Fragment fragment;
  fragment.z[1] = 0xffffffff;
  fragment.attr[1] = {1, 2, -1};
  int count = 0;
  for_each_sample(d, stamp, fragment, [&](const Drawn& drawn) {
    ++count;
    EXPECT_EQ(drawn.z, 0xffffffff);
    EXPECT_EQ(drawn.attr, (spec::Attributes{1, 2, 7, 8, 9}));
  });
  EXPECT_EQ(count, 1);
}

// What core draws passes the comparison, with flat attributes, scissor and bias.
TEST(Drawing, OfCoreHoldsOnEveryDesign) {
  spec::FrameState frame = kFrame;
  frame.scissor_x0 = 9;
  frame.scissor_y1 = 33;
  frame.bias_constant = -3;
  frame.bias_slope = 300;
  int designs = 0;
  for (const spec::Design& d : spec::designs()) {
    if (d.subpixel_bits != 8 || d.depth_bits != 24) continue;  // snapped() is not for it
    ++designs;
    const exact::ScreenJudge judge = judge_of(d, frame);
    ScreenTruth truth;
    truth.judge(judge);
    Verdict verdict;
    Comparison comparison(values_of(d), &verdict);
    comparison.begin(truth, triangle_bounds(d, frame, judge.depth_slope()), 0);
    for_each_sample(spec::contract(d), frame, snapped(),
                    [&](const Drawn& drawn) { comparison.sample(drawn); });
    comparison.end();
    EXPECT_TRUE(verdict.holds()) << d.name << ": " << verdict.first->what;
    EXPECT_EQ(verdict.samples, truth.samples().size()) << d.name;
  }
  EXPECT_GT(designs, 5);
}

TEST(DepthFunctions, PassAsTheModelPasses) {
  const spec::Contract contract = spec::contract(spec::kHighTile);
  for (int f = 0; f < 9; ++f) {
    const auto func = static_cast<spec::DepthFunc>(f);
    for (const int order : {-1, 0, 1}) {
      const uint32_t passed =
          core::depth_test(contract, func, 1, {static_cast<uint32_t>(5 + order)}, {5});
      EXPECT_EQ(passes(func, order), passed == 1) << f << " " << order;
    }
  }
}

TEST(VisibleFrame, WritesWhatPassesAndKeepsDepthsWhereTheyAreNotWritten) {
  for (int f = 0; f < 9; ++f) {
    for (const bool writes : {false, true}) {
      spec::FrameState state{2, 1};
      state.depth = static_cast<spec::DepthFunc>(f);
      state.depth_write = writes;
      state.clear_depth = .5;
      VisibleFrame frame(spec::kHighTile, state);
      const int64_t cleared = frame.z(1);
      ASSERT_EQ(cleared, 0x800000);
      for (const int order : {-1, 0, 1}) {
        frame.clear();
        frame.write(1, 0, cleared + order, {1, 2, 3, 4});
        EXPECT_EQ(frame.drawn(1), passes(state.depth, order)) << f << " " << order;
        EXPECT_EQ(frame.z(1), frame.drawn(1) && writes ? cleared + order : cleared);
        EXPECT_EQ(frame.rgba(1)[3], frame.drawn(1) ? 4 : 0);
        EXPECT_FALSE(frame.drawn(0));
      }
    }
  }
}

TEST(VisibleFrame, WithoutADepthTestTheLastIsSeen) {
  spec::Design none = spec::kHighTile;
  none.depth_test = false;
  VisibleFrame frame(none, {1, 1});
  frame.write(0, 0, 5, {1, 1, 1, 1});
  frame.write(0, 0, 9, {2, 2, 2, 2});
  EXPECT_EQ(frame.rgba(0)[0], 2);
}

}  // namespace
}  // namespace pineda::judge
