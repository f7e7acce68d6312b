// Perspective-correct attributes against exact rationals, whatever the ratio of the w's.
#include "model/core/perspective.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/judge/drawing.h"
#include "model/scene/snap.h"
#include "model/spec/bounds.h"
#include "tests/core/support.h"

namespace pineda::test {
namespace {

spec::Design persp(int attribute_bits) {
  spec::Design d = *spec::find_design("persp");
  d.attribute_bits = attribute_bits;
  return d;
}

/// A random triangle with w's up to `ratio` apart and colours at extremes or anywhere: as floats
/// for the judge, snapped for the core.
struct Pair {
  exact::ScreenTriangle screen;
  spec::Triangle snapped;
};

Pair random_pair(const spec::Contract& c, Random& random, Shape shape, double ratio) {
  Pair pair;
  spec::Triangle& t = pair.snapped;
  t = random_triangle(random, shape);
  randomize_values(random, &t);
  std::array<float, 3> w{};
  // Away from 1, so that exponents differ from those of the coordinates.
  const double scale = std::exp2(static_cast<double>(random.between(-100, 20)));
  for (auto& value : w) value = static_cast<float>(scale * std::pow(ratio, random.unit()));
  const int32_t top = (1 << c.design.attribute_bits) - 1;
  for (size_t i = 0; i < 3; ++i) {
    auto& v = t.v[i];
    auto& s = pair.screen[i];
    s.x = std::ldexp(static_cast<float>(v.x), -8);
    s.y = std::ldexp(static_cast<float>(v.y), -8);
    s.w = w[i];
    for (size_t a = 0; a < 4; ++a) {
      s.rgba[a] = v.attr[a];
      v.attr[a] = (2 * v.attr[a] * top + 255) / 510;
    }
  }
  scene::set_inverse_w(c, w, &t.v);
  return pair;
}

/// Largest error over all shapes; `affine`: from affine values instead.
double worst(const spec::Design& design, double ratio, int triangles, bool affine = false) {
  const spec::Contract c = spec::contract(design);
  Random random(91);
  judge::ScreenTruth truth;
  judge::Values values = judge::values_of(design);
  values.perspective = !affine;
  double error = 0;
  int64_t samples = 0;
  for (int n = 0; n < triangles; ++n) {
    const Shape shape = studies::kShapes[static_cast<size_t>(n) % studies::kShapes.size()];
    const spec::FrameState frame = frame_of(shape);
    const Pair pair = random_pair(c, random, shape, ratio);
    truth.judge(
        exact::ScreenJudge(pair.screen, judge::format_of(design), judge::exact_frame(frame)));
    judge::for_each_sample(c, frame, pair.snapped, [&](const judge::Drawn& drawn) {
      ASSERT_NE(truth.find(drawn.x, drawn.y), nullptr);
      ++samples;
      for (const judge::Error& e : truth.errors(values, drawn).attr) {
        error = std::max(error, std::abs(e.units));
      }
    });
  }
  EXPECT_GT(samples, 20000);
  return error;
}

class Ratio : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Perspective, Ratio, testing::Values(1, 4, 64, 1e3, 1e6, 1e30),
                         [](const auto& r) {
                           return "TwoTo" + std::to_string(std::lround(std::log2(r.param)));
                         });

TEST_P(Ratio, ColorsAreWithinTheBoundWhateverIt) {
  const double error = worst(persp(8), GetParam(), 300);
  EXPECT_LE(error, spec::error_bounds(persp(8)).attribute_lsb);
  EXPECT_LE(error, .66);
  EXPECT_GT(error, .49);
}

// With 16 bits the error before rounding shows: it is no greater at a ratio of 1e6 than at 4.
TEST_P(Ratio, SixteenBitsAreWithinTheBoundWhateverIt) {
  const double error = worst(persp(16), GetParam(), 300);
  EXPECT_LE(error, spec::error_bounds(persp(16)).attribute_lsb);
  EXPECT_GT(error, .49);
}

// The bound is not too generous: with eight bits of 1/w errors exceed the bound of twenty, not
// their own.
TEST(Perspective, CoarseInverseWBreaksTheBound) {
  spec::Design coarse = persp(16);
  coarse.inverse_w_bits = 8;
  const double error = worst(coarse, 64, 60);
  EXPECT_GT(error, 10 * spec::error_bounds(persp(16)).attribute_lsb);
  EXPECT_LE(error, spec::error_bounds(coarse).attribute_lsb);
  EXPECT_GT(error, .4 * spec::error_bounds(coarse).attribute_lsb);
}

// The judge can fail, too: affine values are far from perspective-correct ones.
TEST(Perspective, AffineValuesAreFarOff) { EXPECT_GT(worst(persp(8), 1e3, 60, true), 100); }

// Low designs keep their own bounds: k = 19 bits, one Newton step.
TEST(Perspective, OtherReciprocalsKeepTheirBounds) {
  for (const char* name : {"low", "med"}) {
    spec::Design d = *spec::find_design(name);
    d.perspective = true;
    d.attribute_bits = 16;
    ASSERT_EQ(spec::invalid_reason(d), "");
    const double error = worst(d, 1e3, 120);
    EXPECT_LE(error, spec::error_bounds(d).attribute_lsb) << name;
    EXPECT_GT(error, .3 * spec::error_bounds(d).attribute_lsb) << name;
  }
  spec::Design quadratic = persp(16);
  quadratic.reciprocal_scheme = spec::ReciprocalScheme::kQuadratic;
  quadratic.reciprocal_bits = 28;
  EXPECT_LE(worst(quadratic, 1e3, 120), spec::error_bounds(quadratic).attribute_lsb);
}

// By hand: w of 1 and 3 along a row. Halfway across the screen the near vertex has three quarters.
TEST(Perspective, WeightsByHand) {
  const spec::Contract c = spec::contract(persp(8));
  spec::Triangle t =
      triangle({kHalfPx, kHalfPx}, {8 * kPx + kHalfPx, kHalfPx}, {kHalfPx, 8 * kPx + kHalfPx});
  scene::set_inverse_w(c, {1.0f, 3.0f, 1.0f}, &t.v);
  EXPECT_EQ(t.v[0].inverse_w, 1 << 19);
  EXPECT_EQ(t.v[1].inverse_w, 699051);  // 2/3 of 2^20, rounded
  EXPECT_EQ(t.v[1].inverse_w_shift, 2);
  t.v[1].attr[0] = 200;
  core::Renderer renderer(c, kWindow);
  renderer.draw(t);
  EXPECT_EQ(renderer.buffer().color[4 * 4], 50);  // pixel (4, 0), channel 0: 200 / (1 + 3)
  EXPECT_EQ(renderer.buffer().color[0], 0);
}

// A vertex far behind the others: it gives the value at its own corner only.
TEST(Perspective, GreatestRatioOfAllFloats) {
  const spec::Contract c = spec::contract(persp(8));
  spec::Triangle t = triangle({0, 0}, {40 * kPx, 0}, {0, 40 * kPx});
  scene::set_inverse_w(c, {0x1p-126f, 0x1.fffffep127f, 0x1p-126f}, &t.v);
  EXPECT_LT(t.v[1].inverse_w_shift, 1 << spec::kInverseWShiftBits);
  t.v[1].attr[0] = 255;
  core::Renderer renderer(c, kWindow);
  renderer.draw(t);
  for (int x = 0; x < 39; ++x) {
    EXPECT_EQ(renderer.buffer().color[static_cast<size_t>(4 * x)], 0) << x;
  }
}

}  // namespace
}  // namespace pineda::test
