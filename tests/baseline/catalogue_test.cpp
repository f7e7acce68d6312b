// The catalogue, and what every baseline does with hard input.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/baseline/support.h"

namespace pineda::test {
namespace {

TEST(Catalogue, EveryRowHasAKeyASummaryASourceAndWorks) {
  std::set<std::string> names;
  const spec::FrameState frame{16, 16, spec::Cull::kNone, spec::DepthFunc::kLess};
  for (const baseline::Baseline& b : baseline::baselines()) {
    EXPECT_TRUE(names.insert(b.name).second) << b.name;
    EXPECT_EQ(std::string(b.name).find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
              std::string::npos);
    EXPECT_GT(std::string(b.summary).size(), 10u) << b.name;
    EXPECT_GT(std::string(b.source).size(), 10u) << b.name;
    const auto rasterizer = b.make(kContract, frame);
    EXPECT_EQ(rasterizer->visited(), 0u) << b.name;
    Gathered gathered;
    rasterizer->draw(triangle({0, 0}, {9 * kPx, 0}, {0, 9 * kPx}), &gathered);
    EXPECT_GT(gathered.samples.size(), 0u) << b.name;
    const uint64_t once = rasterizer->visited();
    EXPECT_GE(once, gathered.samples.size()) << b.name;
    rasterizer->draw(triangle({0, 0}, {9 * kPx, 0}, {0, 9 * kPx}), &gathered);
    EXPECT_EQ(rasterizer->visited(), 2 * once) << b.name;
  }
  EXPECT_EQ(names.size(), 13u);
}

TEST(Catalogue, FacingIsHonouredByAllButPoints) {
  const spec::Triangle clockwise = triangle({0, 0}, {9 * kPx, 0}, {0, 9 * kPx});
  const spec::Triangle counter = triangle({0, 0}, {0, 9 * kPx}, {9 * kPx, 0});
  for (const baseline::Baseline& b : baseline::baselines()) {
    const bool points = std::string(b.name) == "points";
    const auto drawn = [&](spec::Cull cull, const spec::Triangle& t) {
      const spec::FrameState frame{16, 16, cull, spec::DepthFunc::kLess};
      return !samples_of(b.name, frame, t).empty();
    };
    EXPECT_TRUE(drawn(spec::Cull::kNone, clockwise)) << b.name;
    EXPECT_TRUE(drawn(spec::Cull::kNone, counter)) << b.name;
    EXPECT_EQ(drawn(spec::Cull::kBack, clockwise), points) << b.name;
    EXPECT_TRUE(drawn(spec::Cull::kBack, counter)) << b.name;
    EXPECT_TRUE(drawn(spec::Cull::kFront, clockwise)) << b.name;
    EXPECT_EQ(drawn(spec::Cull::kFront, counter), points) << b.name;
  }
}

TEST(Catalogue, ZeroAreaDrawsNothing) {
  for (const std::string& name : exact_baselines()) {
    for (const spec::Triangle& t :
         {triangle({kHalfPx, kHalfPx}, {kHalfPx, kHalfPx}, {kHalfPx, kHalfPx}),
          triangle({0, 0}, {4 * kPx, 4 * kPx}, {8 * kPx, 8 * kPx}),
          triangle({0, kHalfPx}, {8 * kPx, kHalfPx}, {3 * kPx, kHalfPx}),
          triangle({kHalfPx, 0}, {kHalfPx, 8 * kPx}, {kHalfPx, 3 * kPx})}) {
      EXPECT_TRUE(samples_of(name, kWindow, t).empty()) << name;
    }
  }
}

constexpr spec::FrameState frame_of_size(int width, int height) {
  return {width, height, spec::Cull::kNone, spec::DepthFunc::kLess};
}

// Every triangle of the nine extreme points, values at their extremes: nothing leaves its range,
// and the exact ones still hit every sample.
TEST(HardInput, CornersOfTheGuardBandOnOddFrames) {
  const std::set<std::string> exact(exact_baselines().begin(), exact_baselines().end());
  const auto corner = [](int i) {
    const auto extreme = [](int k) { return k == 0 ? kGuardLow : k == 1 ? 0 : kGuardHigh; };
    return Point{extreme(i % 3), extreme(i / 3)};
  };
  for (const spec::FrameState& frame :
       {frame_of_size(1, 1), frame_of_size(13, 7), frame_of_size(2, 31)}) {
    for (const baseline::Baseline& b : baseline::baselines()) {
      Random random(71);
      Verdict verdict;
      for (int n = 0; n < 9 * 9 * 9; ++n) {
        spec::Triangle t = triangle(corner(n % 9), corner(n / 9 % 9), corner(n / 81));
        randomize_values(random, &t);
        auto samples = samples_of(b.name, frame, t);
        for (const baseline::Sample& s : samples) {
          ASSERT_TRUE(s.x >= 0 && s.x < frame.width && s.y >= 0 && s.y < frame.height) << b.name;
          ASSERT_TRUE(s.z >= 0 && s.z < 1 << 24) << b.name;
          for (const int c : s.rgba) ASSERT_TRUE(c >= 0 && c <= 255) << b.name;
        }
        judge_samples(frame, t, samples, &verdict);
      }
      if (exact.count(b.name) != 0) {
        EXPECT_EQ(verdict.faults(), 0) << b.name;
        EXPECT_GT(verdict.triangles, 50) << b.name;
      }
    }
  }
}

// Slivers make the steepest planes: single precision overshoots without bounds, and is clamped.
TEST(HardInput, SliversStayInRange) {
  for (const baseline::Baseline& b : baseline::baselines()) {
    Random random(72);
    const auto rasterizer = b.make(kContract, kHugeFrame);
    Gathered gathered;
    for (int n = 0; n < 1000; ++n) {
      spec::Triangle t = random_triangle(random, Shape::kSliver);
      randomize_values(random, &t);
      rasterizer->draw(t, &gathered);
    }
    for (const baseline::Sample& s : gathered.samples) {
      ASSERT_TRUE(s.z >= 0 && s.z < 1 << 24) << b.name;
      for (const int c : s.rgba) ASSERT_TRUE(c >= 0 && c <= 255) << b.name;
    }
  }
}

// A strip as long as the greatest frame: steps add up over 16384 px.
TEST(HardInput, StripAcrossTheGreatestFrame) {
  constexpr spec::FrameState kStrip = frame_of_size(16384, 12);
  spec::Triangle t = triangle({kGuardLow, -900}, {kGuardHigh, 6 * kPx + 3}, {kGuardLow + 7, 3001});
  t.v[1].z = kMaxDepthInput;
  t.v[2].attr = {255, 0, 255, 0};
  for (const std::string& name : exact_baselines()) {
    Verdict verdict;
    judge_samples(kStrip, t, samples_of(name, kStrip, t), &verdict);
    EXPECT_EQ(verdict.faults(), 0) << name;
    EXPECT_GT(verdict.wanted, 50000) << name;
    if (name != "edge_flat") {
      EXPECT_LT(verdict.depth_ulp, name == "edge_smooth" ? 2.6 : .51) << name;
    }
  }
}

// Other subpixel grids. At 12 bits an edge can need 55 bits, more than a double has.
TEST(HardInput, FourAndTwelveSubpixelBits) {
  for (const int bits : {4, 12}) {
    spec::Design design;
    design.subpixel_bits = bits;
    const spec::Contract contract = spec::contract(design);
    for (const std::string& name : exact_baselines()) {
      if (bits == 12 && (name == "fp64" || name == "painter")) continue;
      const auto rasterizer = find_baseline(name).make(contract, kWindow);
      Random random(73);
      Verdict verdict;
      for (int n = 0; n < 150; ++n) {
        const int64_t reach = n % 2 == 0 ? int64_t{40} << bits : int64_t{16383} << bits;
        const auto draw = [&] { return static_cast<int>(random.between(-reach, reach)); };
        std::array<Point, 3> p;
        for (Point& q : p) {
          q.x = draw();
          q.y = draw();
        }
        const spec::Triangle t = triangle(p[0], p[1], p[2]);
        Gathered gathered;
        rasterizer->draw(t, &gathered);
        judge_samples(kWindow, t, gathered.samples, &verdict, bits);
      }
      EXPECT_EQ(verdict.faults(), 0) << name << ' ' << bits;
      EXPECT_GT(verdict.wanted, 20000) << name;
    }
  }
}

}  // namespace
}  // namespace pineda::test
