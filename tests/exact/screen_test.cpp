// The judge from floats on, against cases worked by hand.
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <vector>

#include "model/exact/exact.h"

namespace exact {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr Frame kFrame{8, 8, Cull::kNone};

// Corners on the centres of pixels (0,0), (4,0) and (0,4): the sample of pixel (1,1) has the
// barycentric weights 1/2, 1/4, 1/4.
ScreenTriangle corner() {
  return {{{0.5f, 0.5f, 0, 1, {}}, {4.5f, 0.5f, 0, 1, {}}, {0.5f, 4.5f, 0, 1, {}}}};
}

ScreenTriangle with_red(ScreenTriangle t, const std::array<int, 3>& red) {
  for (size_t i = 0; i < 3; ++i) t[i].rgba[0] = red[i];
  return t;
}

ScreenTriangle with_w(ScreenTriangle t, const std::array<float, 3>& w) {
  for (size_t i = 0; i < 3; ++i) t[i].w = w[i];
  return t;
}

ScreenTriangle with_z(ScreenTriangle t, const std::array<float, 3>& z) {
  for (size_t i = 0; i < 3; ++i) t[i].z = z[i];
  return t;
}

Sample sample(const ScreenTriangle& t, int x, int y, const Format& format = {}) {
  std::vector<Sample> row;
  ScreenJudge(t, format, kFrame).row(y, true, &row);
  for (const Sample& s : row) {
    if (s.x == x && s.y == y) return s;
  }
  ADD_FAILURE() << "not covered: " << x << ',' << y;
  return {};
}

void expect_value(const Value& v, int64_t whole, double fraction, int64_t nearest) {
  EXPECT_EQ(v.whole, whole);
  EXPECT_DOUBLE_EQ(v.fraction, fraction);
  EXPECT_EQ(v.nearest, nearest);
}

std::vector<int> counts(const ScreenJudge& judge) {
  std::vector<int> result;
  std::vector<Sample> row;
  for (int y = judge.rows().first; y <= judge.rows().last; ++y) {
    row.clear();
    judge.row(y, false, &row);
    result.push_back(static_cast<int>(row.size()));
  }
  return result;
}

TEST(ScreenValues, AffineByHand) {
  // Red 0, 1, 0 and 0 to 255: 1/4, 1/2 and 3/4 of a code along the top row; a half rounds up.
  const ScreenTriangle t = with_red(corner(), {0, 1, 0});
  expect_value(sample(t, 0, 0).affine[0], 0, 0, 0);
  expect_value(sample(t, 1, 0).affine[0], 0, .25, 0);
  expect_value(sample(t, 2, 0).affine[0], 0, .5, 1);
  expect_value(sample(t, 3, 0).affine[0], 0, .75, 1);
  // z 1, 0, 0 at 24 bits: half of 2^24 - 1 at (1,1).
  expect_value(sample(with_z(t, {1, 0, 0}), 1, 1).z, 0x7fffff, .5, 0x800000);
  // Falling: from 7 by 1.5 a row and by .5 a column.
  const ScreenTriangle falling = with_red(corner(), {7, 5, 1});
  expect_value(sample(falling, 0, 1).affine[0], 5, .5, 6);
  expect_value(sample(falling, 0, 2).affine[0], 4, 0, 4);
  expect_value(sample(falling, 3, 0).affine[0], 5, .5, 6);
}

TEST(ScreenValues, PerspectiveByHand) {
  // (80/4/2 + 160/4/4) / (1/2 + 1/8 + 1/16) = 20 / (11/16) = 29 + 1/11; affinely 20 + 40.
  const ScreenTriangle t = with_w(with_red(corner(), {0, 80, 160}), {1, 2, 4});
  EXPECT_FALSE(ScreenJudge(t, {}, kFrame).affine());
  expect_value(sample(t, 1, 1).affine[0], 60, 0, 60);
  expect_value(sample(t, 1, 1).perspective[0], 29, 1.0 / 11, 29);
  // At (0,0) the first vertex alone; at (2,0) (40/2) / (1/2 + 1/4) = 26 + 2/3.
  expect_value(sample(t, 0, 0).perspective[0], 0, 0, 0);
  expect_value(sample(t, 2, 0).perspective[0], 26, 2.0 / 3, 27);
}

TEST(ScreenValues, EqualWsAreAffine) {
  const ScreenTriangle t = with_w(with_red(corner(), {0, 1, 0}), {3, 3, 3});
  EXPECT_TRUE(ScreenJudge(t, {}, kFrame).affine());
  expect_value(sample(t, 3, 0).perspective[0], 0, .75, 1);
}

// The w's differ by 2^253. Red at (1,1) would be the mean of the last two vertices; the first one
// changes it by less than 2^-240, which is enough to leave a whole number or a half.
TEST(ScreenValues, WsFarthestApartDecideWholeAndNearest) {
  const std::array<float, 3> w{0x1p127f, 0x1p-126f, 0x1p-126f};
  const auto red = [&](const std::array<int, 3>& r) {
    return sample(with_w(with_red(corner(), r), w), 1, 1).perspective[0];
  };
  expect_value(red({15, 10, 20}), 15, 0, 15);
  expect_value(red({0, 10, 20}), 14, 1 - 0x1p-53, 15);
  EXPECT_LT(red({0, 10, 20}).fraction, 1);
  expect_value(red({0, 10, 21}), 15, .5, 15);
  expect_value(red({255, 10, 21}), 15, .5, 16);
  const Value above = red({255, 10, 20});
  EXPECT_EQ(above.whole, 15);
  EXPECT_NEAR(above.fraction / 0x1p-253, 240, 1e-9);
}

TEST(ScreenValues, DepthOf16And32Bits) {
  Format format;
  format.depth_bits = 32;
  expect_value(sample(with_z(corner(), {1, 1, 1}), 1, 1, format).z, 0xffffffff, 0, 0xffffffff);
  expect_value(sample(with_z(corner(), {1, 0, 0}), 1, 1, format).z, 0x7fffffff, .5, 0x80000000);
  format.depth_bits = 16;
  // 3/512 of 65535 is 98302.5 units of 2^-8: half up, not to even.
  expect_value(sample(with_z(corner(), {0x3p-9f, 0x3p-9f, 0x3p-9f}), 1, 1, format).z, 383,
               255 / 256.0, 384);
}

TEST(ScreenValues, ColoursAtOtherWidths) {
  const auto red = [](int c, int bits) {
    Format format;
    format.attribute_bits = bits;
    return sample(with_red(corner(), {c, c, c}), 1, 1, format).affine[0].whole;
  };
  EXPECT_EQ(red(127, 1), 0);
  EXPECT_EQ(red(128, 1), 1);
  EXPECT_EQ(red(128, 10), 514);  // 513.506
  EXPECT_EQ(red(127, 10), 509);  // 509.494
  EXPECT_EQ(red(200, 16), 200 * 257);
}

TEST(ScreenValues, AttributesOfTheFormatOnly) {
  ScreenTriangle t = corner();
  for (ScreenVertex& v : t) v.rgba = {1, 2, 3, 4};
  Format format;
  format.attributes = 3;
  const Sample three = sample(t, 1, 1, format);
  EXPECT_EQ(three.affine[2].whole, 3);
  EXPECT_EQ(three.affine[3].whole, 0);
  format.attributes = 16;
  EXPECT_EQ(sample(t, 1, 1, format).perspective[3].whole, 4);
  EXPECT_EQ(ScreenJudge(t, format, kFrame).snapped().attribute_error(1, 1, 15, 0), 0);
}

TEST(ScreenSnapping, TiesGoToEvenBeforeTheTopLeftRule) {
  // A left edge half a subpixel to either side of the centres of column 0 snaps onto them. One and
  // a half subpixels to their right it snaps beyond them, and the slanted edge beyond the centres
  // on it.
  for (const float x : {0.5f - 0x1p-9f, 0.5f + 0x1p-9f}) {
    ScreenTriangle t = corner();
    t[0].x = t[2].x = x;
    EXPECT_EQ(counts(ScreenJudge(t, {}, kFrame)), (std::vector<int>{4, 3, 2, 1}));
  }
  ScreenTriangle t = corner();
  t[0].x = t[2].x = 0.5f + 0x3p-9f;
  EXPECT_EQ(counts(ScreenJudge(t, {}, kFrame)), (std::vector<int>{3, 3, 2, 1}));
}

TEST(ScreenSnapping, InfinitiesSaturateAndDenormalsAreZero) {
  const ScreenTriangle huge{
      {{kInf, kInf, 0, 1, {}}, {-kInf, kInf, kInf, 1, {}}, {kInf, -kInf, -kInf, 1, {}}}};
  const ScreenJudge judge(huge, {}, kFrame);
  EXPECT_EQ(counts(judge), std::vector<int>(8, 8));
  EXPECT_EQ(judge.snapped().vertices()[2].y, -(1 << 22));
  EXPECT_EQ(judge.snapped().vertices()[0].x, (1 << 22) - 1);
  EXPECT_EQ(judge.snapped().vertices()[1].z, int64_t{0xffffff} << 8);
  EXPECT_EQ(judge.snapped().vertices()[2].z, 0);
  const ScreenTriangle tiny{
      {{0x1p-149f, -0x1p-127f, 0x1p-130f, 1, {}}, {8, 0, 0, 1, {}}, {0, 8, 0, 1, {}}}};
  EXPECT_EQ(counts(ScreenJudge(tiny, {}, kFrame)), (std::vector<int>{7, 6, 5, 4, 3, 2, 1, 0}));
  EXPECT_EQ(ScreenJudge(tiny, {}, kFrame).snapped().vertices()[0].z, 0);
}

TEST(ScreenSnapping, NanInAnyComponentDropsTheTriangle) {
  for (size_t vertex = 0; vertex < 3; ++vertex) {
    for (float ScreenVertex::*const component :
         {&ScreenVertex::x, &ScreenVertex::y, &ScreenVertex::z, &ScreenVertex::w}) {
      ScreenTriangle t = corner();
      EXPECT_FALSE(ScreenJudge(t, {}, kFrame).dropped());
      t[vertex].*component = kNan;
      const ScreenJudge judge(t, {}, kFrame);
      EXPECT_TRUE(judge.dropped());
      EXPECT_TRUE(judge.culled());
      EXPECT_TRUE(counts(judge).empty());
    }
  }
}

TEST(ScreenCoverage, CullingLooksAtSnappedPositions) {
  const ScreenTriangle clockwise = corner();
  const ScreenTriangle counter{{clockwise[0], clockwise[2], clockwise[1]}};
  EXPECT_TRUE(ScreenJudge(clockwise, {}, {8, 8, Cull::kBack}).culled());
  EXPECT_FALSE(ScreenJudge(clockwise, {}, {8, 8, Cull::kFront}).culled());
  EXPECT_TRUE(ScreenJudge(counter, {}, {8, 8, Cull::kFront}).culled());
  EXPECT_EQ(counts(ScreenJudge(counter, {}, {8, 8, Cull::kBack})),
            counts(ScreenJudge(clockwise, {}, kFrame)));
  ScreenTriangle thin = clockwise;  // has area as floats, none once snapped
  thin[2] = {2.5f, 0.5f + 0x1p-10f, 0, 1, {}};
  EXPECT_TRUE(ScreenJudge(thin, {}, kFrame).culled());
  EXPECT_FALSE(ScreenJudge(thin, {}, kFrame).dropped());
}

TEST(ScreenValues, StayWithTheirVerticesWhateverTheWinding) {
  const ScreenTriangle t = with_w(with_red(corner(), {0, 80, 160}), {1, 2, 4});
  expect_value(sample({{t[2], t[1], t[0]}}, 1, 1).perspective[0], 29, 1.0 / 11, 29);
  expect_value(sample({{t[1], t[2], t[0]}}, 1, 1).perspective[0], 29, 1.0 / 11, 29);
}

TEST(ScreenValue, ErrorsOfCodesAndOfFractions) {
  const Value v{21, .25, 21};
  EXPECT_EQ(v.error_of(21), -.25);
  EXPECT_EQ(v.error_of(22), .75);
  EXPECT_EQ(v.error_of(-1), -22.25);
  EXPECT_EQ(v.error_of(21 * 256 + 128, 8), .25);
  EXPECT_EQ(v.error_of(-64, 8), -21.5);
  EXPECT_EQ(v.error_of(5, 0), -16.25);
  // Codes and fractions that do not fit into one double together.
  const Value deep{0xffffffff, 0x1p-30, 0xffffffff};
  EXPECT_EQ(deep.error_of((int64_t{0xffffffff} << 30) + 3, 30), 0x1p-29);
}

TEST(ScreenState, AScissorLeavesItsColumnsAndRows) {
  Frame frame{8, 8};
  frame.x0 = 1;
  frame.y0 = 2;
  frame.x1 = 100;
  frame.y1 = 3;
  const ScreenJudge judge(corner(), {}, frame);
  EXPECT_EQ(judge.rows().first, 2);
  EXPECT_EQ(counts(judge), (std::vector<int>{1}));
  EXPECT_EQ(judge.snapped().samples(), 1);
  EXPECT_TRUE(judge.snapped().covers(1, 2));
  EXPECT_FALSE(judge.snapped().covers(0, 2));
  EXPECT_FALSE(judge.snapped().covers(1, 1));
  frame.x1 = 1;
  EXPECT_EQ(ScreenJudge(corner(), {}, frame).snapped().samples(), 0);
}

TEST(ScreenState, FlatShadingTakesTheFirstVertexWhereverItLies) {
  const ScreenTriangle t = with_w(with_red(corner(), {0, 80, 160}), {1, 2, 4});
  Frame frame{8, 8};
  frame.flat = true;
  for (size_t i = 0; i < 3; ++i) {
    const ScreenTriangle turned{{t[i], t[(i + 1) % 3], t[(i + 2) % 3]}};
    const ScreenJudge judge(turned, {}, frame);
    EXPECT_TRUE(judge.affine());
    std::vector<Sample> row;
    judge.row(1, true, &row);
    for (const Sample& s : row) {
      expect_value(s.affine[0], 80 * static_cast<int64_t>(i), 0, 80 * static_cast<int64_t>(i));
      expect_value(s.perspective[0], 80 * static_cast<int64_t>(i), 0, 80 * static_cast<int64_t>(i));
    }
  }
}

// z falls from 2^24 - 1 to 0 over 4 px, both ways: a quarter of all codes a px.
TEST(ScreenState, DepthBiasByHand) {
  const ScreenTriangle t = with_z(corner(), {1, 0, 0});
  EXPECT_EQ(ScreenJudge(t, {}, kFrame).depth_slope(), 16777215 / 4.);
  const auto z = [&](int64_t constant, int slope, int x) {
    Frame frame{8, 8};
    frame.bias_constant = constant;
    frame.bias_slope = slope;
    std::vector<Sample> row;
    ScreenJudge(t, {}, frame).row(1, false, &row);
    return row.at(static_cast<size_t>(x)).z;
  };
  expect_value(z(0, 0, 1), 0x7fffff, .5, 0x800000);
  expect_value(z(-5, 0, 1), 0x7ffffa, .5, 0x7ffffb);
  // 1/256 of 4194303.75 is 16383.9990234375.
  expect_value(z(0, 1, 1), 8388607 + 16384, .4990234375, 8388607 + 16384);
  expect_value(z(0, -256, 1), 8388607 - 4194304, .75, 8388607 - 4194303);
  // Both ends.
  expect_value(z(0, 512, 1), 0xffffff, 0, 0xffffff);
  expect_value(z(0, -512, 1), 0, 0, 0);
  expect_value(z(16777215, 32767, 0), 0xffffff, 0, 0xffffff);
  expect_value(z(-16777215, -32768, 0), 0, 0, 0);
}

TEST(ScreenErrors, WhatCannotBeJudgedIsRefused) {
  for (const float w : {0.0f, -1.0f, kInf, 0x1p-127f}) {
    EXPECT_THROW(ScreenJudge(with_w(corner(), {1, w, 1}), {}, kFrame), std::out_of_range);
  }
  EXPECT_THROW(ScreenJudge(with_red(corner(), {0, 256, 0}), {}, kFrame), std::out_of_range);
  Frame steep{8, 8};
  steep.bias_slope = 32769;
  EXPECT_THROW(ScreenJudge(corner(), {}, steep), std::out_of_range);
  Frame far{8, 8};
  far.bias_constant = -(int64_t{1} << 32) - 1;
  EXPECT_THROW(ScreenJudge(corner(), {}, far), std::out_of_range);
  for (int Format::*const member :
       {&Format::subpixel_bits, &Format::guard_bits, &Format::depth_bits, &Format::attributes,
        &Format::attribute_bits}) {
    for (const int bits : {-1, 33}) {
      Format format;
      format.*member = bits;
      EXPECT_THROW(ScreenJudge(corner(), format, kFrame), std::out_of_range);
    }
  }
}

}  // namespace
}  // namespace exact
