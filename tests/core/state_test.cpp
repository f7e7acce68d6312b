// Raster state: depth functions, depth write, scissor, depth bias, flat shading.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "model/core/frame.h"
#include "tests/core/support.h"

namespace pineda::test {
namespace {

using spec::DepthFunc;

constexpr spec::FrameState kSmall{24, 20, spec::Cull::kNone, spec::DepthFunc::kLess};

// Covers the small frame, at one depth and in one colour.
spec::Triangle sheet(int64_t z_codes, int32_t red) {
  spec::Triangle t = triangle({-kPx, -kPx}, {60 * kPx, -kPx}, {-kPx, 60 * kPx});
  for (auto& v : t.v) {
    v.z = z_codes << 8;
    v.attr[0] = red;
  }
  return t;
}

size_t at(const spec::FrameState& frame, int x, int y) {
  return static_cast<size_t>(y) * static_cast<size_t>(frame.width) + static_cast<size_t>(x);
}

// What passes against a stored 1000: 999, 1000, 1001.
TEST(DepthFunction, EachOneByHand) {
  struct Row {
    DepthFunc func;
    bool less, equal, greater;
  };
  const Row rows[] = {
      {DepthFunc::kNever, false, false, false},  {DepthFunc::kLess, true, false, false},
      {DepthFunc::kEqual, false, true, false},   {DepthFunc::kLequal, true, true, false},
      {DepthFunc::kGreater, false, false, true}, {DepthFunc::kNotequal, true, false, true},
      {DepthFunc::kGequal, false, true, true},   {DepthFunc::kAlways, true, true, true},
      {DepthFunc::kOff, true, true, true}};
  std::array<uint32_t, spec::kMaxLanes> stored{};
  stored.fill(1000);
  const std::array<uint32_t, spec::kMaxLanes> z{999, 1000, 1001, 7};
  for (const Row& row : rows) {
    const uint32_t wanted = (row.less ? 1u : 0u) | (row.equal ? 2u : 0u) | (row.greater ? 4u : 0u);
    EXPECT_EQ(core::depth_test(kContract, row.func, 7, z, stored), wanted)
        << static_cast<int>(row.func);
  }
}

TEST(DepthFunction, AlwaysWritesDepthAndOffDoesNot) {
  spec::FrameState frame = kSmall;
  for (const DepthFunc func : {DepthFunc::kAlways, DepthFunc::kOff}) {
    frame.depth = func;
    core::Renderer renderer(kContract, frame);
    renderer.draw(sheet(500, 1));
    renderer.draw(sheet(900, 2));
    EXPECT_EQ(renderer.buffer().depth[0], func == DepthFunc::kOff ? 0xffffffu : 900u);
    EXPECT_EQ(renderer.buffer().color[0], 2);
  }
}

TEST(DepthWrite, OffTestsAndColorsButKeepsTheDepth) {
  spec::FrameState frame = kSmall;
  frame.depth_write = false;
  core::Renderer renderer(kContract, frame);
  renderer.draw(sheet(500, 1));
  renderer.draw(sheet(900, 2));  // depth is still cleared, so it passes, too
  EXPECT_EQ(renderer.buffer().depth[0], 0xffffffu);
  EXPECT_EQ(renderer.buffer().color[0], 2);
  EXPECT_EQ(renderer.counters().passed, 2u * 24 * 20);
}

// By hand: each function on depth cleared to the nearest, the middle and the farthest. Sheets at
// the ends, in the middle and beside it are drawn one by one. By stamps and by whole tiles.
TEST(ClearDepth, EachFunctionComparesWithIt) {
  const int64_t middle = 1 << 23;
  const int64_t top = (1 << 24) - 1;
  int seen = 0;
  for (const auto& [z, code] : {std::pair{0., int64_t{0}}, {.5, middle}, {1., top}}) {
    for (int f = 0; f < 9; ++f) {
      spec::FrameState frame = kSmall;
      frame.depth = static_cast<DepthFunc>(f);
      frame.clear_depth = z;
      for (const int64_t depth : {int64_t{0}, middle - 1, middle, middle + 1, top}) {
        const uint32_t passes =
            core::depth_test(kContract, frame.depth, 1, {static_cast<uint32_t>(depth)},
                             {static_cast<uint32_t>(code)});
        const bool writes = passes != 0 && frame.depth != DepthFunc::kOff;
        core::Renderer drawn(kContract, frame);
        drawn.draw(sheet(depth, 9));
        for (size_t i : {size_t{0}, drawn.buffer().depth.size() - 1}) {
          ASSERT_EQ(drawn.buffer().color[4 * i], passes * 9) << f << ' ' << z << ' ' << depth;
          ASSERT_EQ(drawn.buffer().depth[i], writes ? depth : code) << f << ' ' << z;
        }
        drawn.clear();
        ASSERT_EQ(drawn.buffer().depth[0], code);
        seen += static_cast<int>(passes);
      }
    }
  }
  // Of the 15 comparisons 6 are less, 3 equal, 6 greater; off and always pass all.
  EXPECT_EQ(seen, 6 + (6 + 3) + 15 + 0 + 3 + 6 + (6 + 6) + (3 + 6) + 15);
}

// Attributes are interpolated only for samples that pass the depth test.
TEST(EarlyDepth, HiddenStampsAreNotInterpolated) {
  core::Renderer renderer(kContract, kSmall);
  renderer.draw(sheet(500, 1));
  const uint64_t seen = renderer.counters().interpolated;
  EXPECT_EQ(seen, 12u * 10);
  for (int n = 0; n < 7; ++n) renderer.draw(sheet(600 + n, 2));
  EXPECT_EQ(renderer.counters().interpolated, seen);
  EXPECT_EQ(renderer.counters().stamps, 8 * seen);
}

// The scissor cuts samples away; the others keep their values.
TEST(Scissor, CutsAndChangesNothingElse) {
  Random random(31);
  uint64_t outside = 0;
  for (int n = 0; n < 300; ++n) {
    spec::Triangle t = random_triangle(random, Shape::k256Px);
    randomize_values(random, &t);
    spec::FrameState cut = kWindow;
    cut.scissor_x0 = random.between(0, 60);
    cut.scissor_y0 = random.between(0, 40);
    cut.scissor_x1 = random.between(cut.scissor_x0, 80);  // beyond the frame at times
    cut.scissor_y1 = random.between(cut.scissor_y0, 60);
    core::Renderer whole(kContract, kWindow);
    core::Renderer part(kContract, cut);
    whole.draw(t);
    part.draw(t);
    outside += part.counters().dropped[static_cast<size_t>(core::Drop::kOutside)];
    for (int y = 0; y < kWindow.height; ++y) {
      for (int x = 0; x < kWindow.width; ++x) {
        const size_t i = at(kWindow, x, y);
        const bool in =
            x >= cut.scissor_x0 && x < cut.scissor_x1 && y >= cut.scissor_y0 && y < cut.scissor_y1;
        ASSERT_EQ(part.buffer().hits[i], in ? whole.buffer().hits[i] : 0) << x << ',' << y;
        ASSERT_EQ(part.buffer().depth[i], in ? whole.buffer().depth[i] : 0xffffffu);
      }
    }
  }
  EXPECT_GT(outside, 10u);
}

TEST(Scissor, EmptyOneDrawsNothing) {
  spec::FrameState frame = kSmall;
  frame.scissor_x0 = frame.scissor_x1 = 5;
  core::Renderer renderer(kContract, frame);
  EXPECT_EQ(renderer.draw(sheet(1, 1)), core::Drop::kOutside);
}

TEST(FlatShading, FirstVertexGivesItsColorWhereverTheAnchorIs) {
  spec::FrameState frame = kSmall;
  frame.shade = spec::Shade::kFlat;
  for (size_t first = 0; first < 3; ++first) {
    spec::Triangle t = sheet(10, 0);
    for (size_t i = 0; i < 3; ++i) t.v[i].attr[0] = static_cast<int32_t>(10 * (i + 1));
    std::rotate(t.v.begin(), t.v.begin() + static_cast<std::ptrdiff_t>(first), t.v.end());
    for (const char* name : {"high_tile", "persp", "exact"}) {
      for (auto& v : t.v) v.inverse_w = 1 << 19;
      core::Renderer renderer(spec::contract(*spec::find_design(name)), frame);
      renderer.draw(t);
      for (size_t i = 0; i < renderer.buffer().hits.size(); ++i) {
        ASSERT_EQ(renderer.buffer().color[4 * i], 10 * (first + 1)) << name;
      }
    }
  }
}

TEST(FlatAttributes, AreTheFirstVertexsWhateverTheState) {
  const spec::Contract flat = spec::contract(*spec::find_design("flat"));
  spec::Triangle t = sheet(10, 0);
  for (size_t i = 0; i < 3; ++i) t.v[i].attr = {static_cast<int32_t>(i), 7, 8, 255};
  core::Renderer renderer(flat, kSmall);
  renderer.draw(t);
  EXPECT_EQ(renderer.buffer().color[0], 0);
  EXPECT_EQ(renderer.buffer().color[1], 7);
  EXPECT_EQ(renderer.buffer().color[3], 255);
  EXPECT_EQ(renderer.buffer().depth[0], 0xffffffu);
}

// z grows by 3 codes a px to the right and by -5 a px down.
spec::Triangle slope() {
  spec::Triangle t =
      triangle({-100 * kPx, -100 * kPx}, {200 * kPx, -100 * kPx}, {-100 * kPx, 200 * kPx});
  for (auto& v : t.v) v.z = (int64_t{100000} << 8) + 3 * int64_t{v.x} - 5 * int64_t{v.y};
  return t;
}

TEST(DepthBias, ConstantAndSlopeByHand) {
  for (const char* name : {"high_tile", "high", "exact"}) {
    spec::FrameState frame = kSmall;
    core::Renderer plain(spec::contract(*spec::find_design(name)), frame);
    plain.draw(slope());
    frame.bias_constant = -17;
    frame.bias_slope = 2 * 256 + 128;  // 2.5
    core::Renderer biased(spec::contract(*spec::find_design(name)), frame);
    biased.draw(slope());
    for (int x = 0; x < 24; ++x) {
      const size_t i = at(kSmall, x, 7);
      // 2.5 * 5 - 17 = -4.5 from a value of whole codes and 3/2 - 5/2 more: exactly one less half.
      const auto before = static_cast<int64_t>(plain.buffer().depth[i]);
      EXPECT_NEAR(static_cast<double>(biased.buffer().depth[i]), static_cast<double>(before) - 4.5,
                  .5 + 1e-9)
          << name << ' ' << x;
    }
  }
}

TEST(DepthBias, ClampsAtBothEndsOfTheRangeAndNeverWraps) {
  for (const char* name : {"high_tile", "low", "exact"}) {
    for (const auto& [constant, factor, wanted] :
         {std::tuple<int64_t, int, uint32_t>{(1 << 24) - 1, 0, 0xffffffu},
          {-((1 << 24) - 1), 0, 0u},
          {0, 32767, 0xffffffu},
          {0, -32768, 0u}}) {
      spec::FrameState frame = kSmall;
      frame.depth = DepthFunc::kAlways;
      frame.bias_constant = constant;
      frame.bias_slope = factor;
      // A triangle so steep that its gradient alone exceeds every range.
      spec::Triangle t = triangle({-kPx, -kPx}, {30 * kPx, -kPx}, {30 * kPx, 30 * kPx + 1});
      t.v[0].z = kMaxDepthInput;
      if (factor == 0) t = sheet(1 << 23, 0);
      core::Renderer renderer(spec::contract(*spec::find_design(name)), frame);
      renderer.draw(t);
      int covered = 0;
      for (size_t i = 0; i < renderer.buffer().hits.size(); ++i) {
        if (renderer.buffer().hits[i] == 0) continue;
        ++covered;
        ASSERT_EQ(renderer.buffer().depth[i], wanted) << name << ' ' << constant << ' ' << factor;
      }
      EXPECT_GT(covered, 100);
    }
  }
}

// Against the plane through the snapped vertices and its own gradients, in doubles.
TEST(DepthBias, IsTheSlopeTimesTheGreaterGradient) {
  Random random(41);
  double worst = 0;
  for (int n = 0; n < 400; ++n) {
    spec::Triangle t = random_triangle(random, Shape::k256Px);
    randomize_values(random, &t);
    spec::FrameState frame = kWindow;
    frame.bias_slope = random.between(-512, 512);
    spec::SetupPrim prim;
    if (core::setup(kContract, frame, t, &prim) != core::Drop::kNone) continue;
    const auto d = [&](size_t i, size_t j) {
      return std::array<double, 3>{double(t.v[i].x) - t.v[j].x, double(t.v[i].y) - t.v[j].y,
                                   static_cast<double>(t.v[i].z - t.v[j].z)};
    };
    const auto a = d(1, 0);
    const auto b = d(2, 0);
    const double area2 = a[0] * b[1] - b[0] * a[1];
    // Subpixels and 2^-8 codes cancel.
    const double gx = std::abs((a[2] * b[1] - b[2] * a[1]) / area2);
    const double gy = std::abs((b[2] * a[0] - a[2] * b[0]) / area2);
    const double greater = std::max(gx, gy);
    const double bias = std::ldexp(static_cast<double>(prim.planes.z_bias), -16);
    const double exact = frame.bias_slope / 256.0 * greater;
    if (std::abs(exact) > 0x1p24) continue;  // saturates
    const double allowed =
        std::abs(frame.bias_slope) / 256.0 * (0x1p-9 + greater * std::exp2(-29.4)) + 1e-6;
    EXPECT_LE(std::abs(bias - exact), allowed);
    worst = std::max(worst, std::abs(bias - exact));
  }
  EXPECT_GT(worst, 1e-4);
}

}  // namespace
}  // namespace pineda::test
