// The design without a reciprocal: each code is the nearest one to the exact value.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/core/frame.h"
#include "tests/core/support.h"

namespace pineda::test {
namespace {

const spec::Contract kExact = spec::contract(*spec::find_design("exact"));

struct Fragments {
  std::vector<judge::Drawn> seen;
  void prim(const spec::SetupPrim&) {}
  void stamp(const spec::Stamp&) {}
  void depth(const spec::DepthWrite&) {}
  void color(const spec::ColorWrite&) {}
  void fragment(const spec::Stamp& stamp, const spec::Fragment& f) {
    judge::for_each_sample(kContract.design, stamp, f,
                           [this](const judge::Drawn& drawn) { seen.push_back(drawn); });
  }
};

// Halves round up, so the error may be +1/2 but not -1/2.
void expect_nearest(double error) {
  EXPECT_GT(error, -.5);
  EXPECT_LE(error, .5);
}

TEST(ExactPlanes, EveryCodeIsTheNearest) {
  Random random(61);
  int64_t samples = 0;
  double worst = 0;
  for (int n = 0; n < 1500; ++n) {
    constexpr Shape kShapes[] = {Shape::k16Px,      Shape::k256Px,  Shape::k8192Px,
                                 Shape::kGuardBand, Shape::kNeedle, Shape::kSliver};
    // The huge frame is never allocated: those shapes are moved into the window.
    spec::Triangle t = random_triangle(random, kShapes[n % 6]);
    if (frame_of(kShapes[n % 6]).width != kWindow.width) {
      const int dx = (t.v[0].x >> 8 << 8) - 20 * kPx;
      const int dy = (t.v[0].y >> 8 << 8) - 20 * kPx;
      for (auto& v : t.v) {
        v.x = std::clamp(v.x - dx, kGuardLow, kGuardHigh);
        v.y = std::clamp(v.y - dy, kGuardLow, kGuardHigh);
      }
    }
    randomize_values(random, &t);
    const exact::Judge exact = judge(kWindow, t);
    core::Renderer renderer(kExact, kWindow);
    Fragments fragments;
    renderer.draw(t, fragments);
    ASSERT_EQ(static_cast<int64_t>(fragments.seen.size()), exact.culled() ? 0 : exact.samples());
    for (const auto& s : fragments.seen) {
      const double error = exact.depth_error(s.x, s.y, s.z);
      expect_nearest(error);
      worst = std::max(worst, std::abs(error));
      for (int a = 0; a < 4; ++a) {
        expect_nearest(exact.attribute_error(s.x, s.y, a, s.attr[static_cast<size_t>(a)]));
      }
      ++samples;
    }
  }
  EXPECT_GT(samples, 100000);
  EXPECT_GT(worst, .4999);  // errors up to a half occur, so the test saw the worst
}

// Halfway between 0 and 1 at every sample of the middle column: up.
TEST(ExactPlanes, HalvesRoundUpByHand) {
  spec::Triangle t =
      triangle({-kHalfPx, -kHalfPx}, {kPx + kHalfPx, -kHalfPx}, {-kHalfPx, 8 * kPx + kHalfPx});
  // z = (x + 1/2) / 2 codes: 1/2 at the centre of pixel 0.
  t.v[1].z = 256;
  core::Renderer renderer(kExact, kWindow);
  renderer.draw(t);
  EXPECT_EQ(renderer.buffer().hits[0], 1);
  EXPECT_EQ(renderer.buffer().depth[0], 1u);
}

// The comparison can fail: the default design has codes that are not the nearest.
TEST(ExactPlanes, DefaultDesignIsNotAlwaysTheNearest) {
  Random random(62);
  int wrong = 0;
  for (int n = 0; n < 100; ++n) {
    spec::Triangle t = random_triangle(random, Shape::k8192Px);
    randomize_values(random, &t);
    const exact::Judge exact = judge(kWindow, t);
    core::Renderer renderer(kContract, kWindow);
    Fragments fragments;
    renderer.draw(t, fragments);
    for (const auto& s : fragments.seen) {
      wrong += std::abs(exact.depth_error(s.x, s.y, s.z)) > .5 ? 1 : 0;
    }
  }
  EXPECT_GT(wrong, 100);
}

}  // namespace
}  // namespace pineda::test
