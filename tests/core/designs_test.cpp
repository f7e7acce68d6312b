// Other designs than the default one: the same rules hold for every parameter.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "model/core/frame.h"
#include "tests/core/support.h"

namespace pineda::test {
namespace {

constexpr spec::Design coarse_subpixels() {
  spec::Design d;
  d.name = "coarse_subpixels";
  d.subpixel_bits = 4;
  d.guard_bits = 11;
  d.tile_log2 = 4;
  d.stamp_width_log2 = 2;
  d.stamp_height_log2 = 2;
  return d;
}

constexpr spec::Design fine_subpixels() {
  spec::Design d;
  d.name = "fine_subpixels";
  d.subpixel_bits = 12;
  d.tile_log2 = 2;
  d.stamp_width_log2 = 0;
  d.stamp_height_log2 = 1;
  return d;
}

constexpr spec::Design low_precision() {
  spec::Design d;
  d.name = "low_precision";
  d.depth_bits = 16;
  d.attributes = 2;
  d.reciprocal_lut_bits = 8;
  d.reciprocal_newton_steps = 1;
  d.reciprocal_bits = 19;
  d.gradient_fraction_bits = 10;
  d.tile_fraction_bits = 6;
  return d;
}

std::vector<spec::Design> all_designs() {
  std::vector<spec::Design> all = spec::designs();
  all.insert(all.end(), {coarse_subpixels(), fine_subpixels(), low_precision()});
  return all;
}

// Bound of the depth error in codes: errors of the reciprocal, of gradients across the guard band's
// square, of steps in a tile, of the input's fraction, and the final rounding.
double depth_bound_codes(const spec::Design& d) {
  const double first_guess = .625 * std::ldexp(1.0, -d.reciprocal_lut_bits);
  // Up to one unit by rounding or saturation, and half a unit by truncation in between.
  const double reciprocal =
      std::pow(first_guess, 1 << d.reciprocal_newton_steps) + std::ldexp(1.5, -d.reciprocal_bits);
  const int tile = 1 << d.tile_log2;
  const double in_tile = d.tile_fraction_bits == d.gradient_fraction_bits ? 0 : 2 * tile - 1;
  return std::ldexp(reciprocal, d.depth_bits) +
         std::ldexp(std::ldexp(4.0, d.guard_bits) + 2, -d.gradient_fraction_bits - 1) +
         std::ldexp(in_tile, -d.tile_fraction_bits - 1) + 0x1p-9 + .5;
}

// A random triangle, its coordinates and depths brought to the design's formats.
spec::Triangle triangle_for(Random& random, const spec::Design& d) {
  constexpr Shape kShapes[] = {Shape::k256Px, Shape::k8192Px, Shape::kGuardBand, Shape::kNeedle};
  spec::Triangle t = random_triangle(random, kShapes[random.between(0, 3)]);
  randomize_values(random, &t);
  const int64_t limit = int64_t{1} << (d.guard_bits + d.subpixel_bits);
  for (auto& v : t.v) {
    const auto scaled = [&](int64_t c) {
      return static_cast<int32_t>(
          std::clamp(c * (int64_t{1} << d.subpixel_bits) >> 8, -limit, limit - 1));
    };
    v.x = scaled(v.x);
    v.y = scaled(v.y);
    v.z = std::min(v.z >> (24 - d.depth_bits), ((int64_t{1} << d.depth_bits) - 1) << 8);
  }
  return t;
}

class EveryDesign : public testing::TestWithParam<spec::Design> {};
INSTANTIATE_TEST_SUITE_P(Designs, EveryDesign, testing::ValuesIn(all_designs()),
                         [](const auto& d) { return std::string(d.param.name); });

TEST_P(EveryDesign, CoverageIsExactAndDepthKeepsItsBound) {
  const spec::Design& d = GetParam();
  ASSERT_EQ(spec::invalid_reason(d), "");
  spec::FrameState frame = kWindow;
  frame.depth = spec::DepthFunc::kLequal;
  core::Renderer renderer(spec::contract(d), frame);
  Random random(101);
  double error = 0;
  int64_t samples = 0;
  for (int n = 0; n < 600; ++n) {
    const spec::Triangle t = triangle_for(random, d);
    const exact::Judge exact = judge::exact_judge(d, frame, t);
    renderer.clear();
    renderer.draw(t);
    for (int y = 0; y < frame.height; ++y) {
      const exact::Span span = exact.span(y);
      for (int x = 0; x < frame.width; ++x) {
        const bool wanted = span.first <= x && x <= span.last;
        const auto at = static_cast<size_t>(y * frame.width + x);
        ASSERT_EQ(renderer.buffer().hits[at], wanted ? 1 : 0) << n << ": " << x << ',' << y;
        samples += wanted ? 1 : 0;
        if (!wanted || !d.depth_test) continue;
        error = std::max(error, std::abs(exact.depth_error(x, y, renderer.buffer().depth[at])));
      }
    }
  }
  EXPECT_GT(samples, 50000);
  EXPECT_LE(error, d.depth_test ? depth_bound_codes(d) : 0);
  EXPECT_GE(error, d.depth_test ? .45 : 0);
}

// The bound is not too generous: the default design's is the documented one.
TEST(EveryDesignBound, OfTheDefaultIsTheDocumentedOne) {
  EXPECT_NEAR(depth_bound_codes(spec::kHighTile), .68, .01);
}

}  // namespace
}  // namespace pineda::test
