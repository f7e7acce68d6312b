// "6.837 Lecture 6", slides 23 to 29: planes, the clamp of colours, the way into the raster.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "tests/baseline/printed.h"
#include "tests/baseline/support.h"

namespace pineda::test {
namespace {

// Planes of red over random triangles in size x size px, as printed: int32 with 12 fraction bits by
// (int), from the origin, half a code added. What does not fit an int saturates.
struct Red {
  int triangles = 0;
  int overflown = 0;  // a coefficient that saturated
  double worst = 0;   // LSB, of triangles that did not saturate
  double worst_overflown = 0;
};

Red printed_red(int size_px, int count, int stride) {
  Random random(21);
  Red red;
  for (int n = 0; n < count; ++n) {
    const spec::Triangle t = triangle_in(random, size_px);
    const exact::Judge exact = judge(square(size_px), t);
    if (exact.doubled_area() == 0) continue;
    const auto plane =
        printed::plane(printed::corners(t), {t.v[0].attr[0], t.v[1].attr[0], t.v[2].attr[0]});
    ++red.triangles;
    const bool overflows = std::any_of(plane.begin(), plane.end(), [](int64_t c) {
      return c == std::numeric_limits<int32_t>::max() || c == std::numeric_limits<int32_t>::min();
    });
    red.overflown += overflows ? 1 : 0;
    double& worst = overflows ? red.worst_overflown : red.worst;
    const int step = overflows ? 1 : stride;
    const exact::Span rows = exact.rows();
    for (int y = rows.first; y <= rows.last; y += step) {
      const exact::Span span = exact.span(y);
      for (int x = span.first; x <= span.last; x += step) {
        const int64_t sum = int64_t{plane[0]} * x + int64_t{plane[1]} * y + plane[2] + 2048;
        const int32_t accumulator = static_cast<int32_t>(static_cast<uint32_t>(sum)) >> 12;
        worst = std::max(worst,
                         std::abs(exact.attribute_error(x, y, 0, std::clamp(accumulator, 0, 255))));
      }
    }
  }
  return red;
}

double mended_red(int size_px, int count) {
  Random random(22);
  Verdict verdict;
  const auto mended = find_baseline("edge_smooth").make(kContract, square(size_px));
  for (int n = 0; n < count; ++n) {
    const spec::Triangle t = triangle_in(random, size_px);
    Gathered gathered;
    mended->draw(t, &gathered);
    judge_samples(square(size_px), t, gathered.samples, &verdict);
  }
  return verdict.color_lsb;
}

// The planes of narrow triangles exceed 2^19 LSB at the origin. This is rare, and as frequent at
// any size, since a triangle twice as far is half as steep. A single random sample may suggest that
// 512 px are safe.
TEST(PlaneEquation, TwelveBitsFromTheOriginFadeWithDistanceAndOverflowIn32Bits) {
  const Red at_512 = printed_red(512, 20000, 32);
  const Red at_1024 = printed_red(1024, 20000, 64);
  record("at_512", at_512.worst);
  record("at_1024", at_1024.worst);
  record("overflown_at_512", at_512.overflown);
  record("overflown_at_1024", at_1024.overflown);
  record("worst_overflown", std::max(at_512.worst_overflown, at_1024.worst_overflown));
  // Each coefficient is short of less than 2^-12: (x + y + 1) * 2^-12 + 1/2.
  EXPECT_LT(at_512.worst, .76);
  EXPECT_GT(at_512.worst, .58);
  EXPECT_LT(at_1024.worst, 1.01);
  EXPECT_GT(at_1024.worst, at_512.worst);
  EXPECT_GT(at_512.overflown, 0);
  EXPECT_GT(at_1024.overflown, 0);
  EXPECT_LT(at_512.overflown + at_1024.overflown, 100);
  EXPECT_GT(std::max(at_512.worst_overflown, at_1024.worst_overflown), 100);
}

TEST(PlaneEquation, MendedFadesHalfAsFastAndNeverOverflows) {
  const double at_512 = mended_red(512, 40);
  const double at_1024 = mended_red(1024, 20);
  record("at_512", at_512);
  record("at_1024", at_1024);
  EXPECT_LT(at_512, .63);  // (x + y + 1) * 2^-13 + 1/2
  EXPECT_LT(at_1024, .76);
  EXPECT_GT(at_1024, .51);
}

uint32_t printed_blue(int value) { return printed::smooth_color(0, 0, 0, value * 4096) & 255; }

TEST(ColorClamp, PrintedMaskSpoils127Of256ValuesAndTheMendedOneNone) {
  int spoiled = 0;
  for (int value = 0; value < 256; ++value) {
    spoiled += printed_blue(value) != static_cast<uint32_t>(value) ? 1 : 0;
    spec::Triangle t = triangle({0, 0}, {4 * kPx, 0}, {0, 4 * kPx});
    for (auto& v : t.v) v.attr = {value, 0, 255 - value, value};
    for (const char* name : {"edge_flat", "edge_smooth"}) {
      const auto samples = samples_of(name, square(4), t);
      ASSERT_EQ(samples.size(), 6u);
      for (const auto& s : samples) {
        ASSERT_EQ(s.rgba, (std::array<int, 4>{value, 0, 255 - value, value})) << name;
      }
    }
  }
  EXPECT_EQ(spoiled, 127);  // the odd ones but 255, which the saturated value equals
}

TEST(ColorClamp, PrintedAlphaSaturatesIntoRed) {
  EXPECT_EQ(printed::smooth_color(256 * 4096, 0, 0, 0), 0xffff0000u);
  EXPECT_EQ(printed::smooth_color(0, 256 * 4096, 0, 0), 0x00ff0000u);
  EXPECT_EQ(printed::smooth_color(-1, -1, -1, -1), 0u);
}

// A gradient rounded to 12 fraction bits overshoots white far from the origin: only the clamp keeps
// codes in range, and alpha in its own channel.
TEST(ColorClamp, MendedAlphaStaysInItsChannel) {
  const int far = 16300 * kPx;
  spec::Triangle t = triangle({far, far}, {far + 3000, far + 50}, {far + 40, far + 3500});
  t.v[0].attr = {0, 255, 0, 255};
  t.v[1].attr = {0, 255, 0, 254};
  t.v[2].attr = {0, 255, 0, 255};
  const auto samples = samples_of("edge_smooth", kHugeFrame, t);
  ASSERT_GT(samples.size(), 50u);
  for (const auto& s : samples) {
    ASSERT_EQ(s.rgba[0], 0);
    ASSERT_EQ(s.rgba[1], 255);
    ASSERT_EQ(s.rgba[2], 0);
    ASSERT_LE(s.rgba[3], 255);
    ASSERT_GE(s.rgba[3], 250);
  }
}

TEST(PixelIndex, PrintedProductMeetsItselfAndLeavesTheRaster) {
  constexpr int kWidth = 16;
  std::set<int> printed_places;
  std::set<int> places;
  int outside = 0;
  for (int y = 0; y < kWidth; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const int index = printed::smooth_index(x, y, kWidth);
      printed_places.insert(index);
      outside += index >= kWidth * kWidth ? 1 : 0;
      places.insert(y * kWidth + x);
    }
  }
  EXPECT_LT(printed_places.size(), 110u);  // 256 pixels, products of two numbers below 16
  EXPECT_GT(outside, 100);
  EXPECT_EQ(places.size(), 256u);
}

}  // namespace
}  // namespace pineda::test
