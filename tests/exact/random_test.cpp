// The judge against plain rationals: edge functions, weights and planes written down literally.
#include "model/spec/random.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <string>
#include <utility>

#include "model/exact/exact.h"

namespace exact {
namespace {

using Rational = boost::multiprecision::cpp_rational;

using pineda::spec::Random;

// A position in px.
struct Position {
  Rational x;
  Rational y;
};

Position position(const Vertex& v, int subpixel_bits) {
  const Rational unit(1, int64_t{1} << subpixel_bits);
  return {v.x * unit, v.y * unit};
}

Position sample(int x, int y) { return {Rational(2 * x + 1, 2), Rational(2 * y + 1, 2)}; }

Rational edge(const Position& u, const Position& w, const Position& p) {
  return (w.x - u.x) * (p.y - u.y) - (w.y - u.y) * (p.x - u.x);
}

// Does the sample belong to the triangle, by the textbook rule? `inclusive`, the mutant, counts
// samples on every edge.
bool inside(std::array<Position, 3> v, const Position& p, bool inclusive = false) {
  const Rational area = edge(v[0], v[1], v[2]);
  if (area == 0) return false;
  if (area < 0) std::swap(v[1], v[2]);
  for (size_t i = 0; i < 3; ++i) {
    const Position& u = v[i];
    const Position& w = v[(i + 1) % 3];
    const Rational e = edge(u, w, p);
    const bool top_left = w.y < u.y || (w.y == u.y && w.x > u.x);
    if (e < 0 || (e == 0 && !top_left && !inclusive)) return false;
  }
  return true;
}

Rational interpolated(const std::array<Position, 3>& v, const std::array<Rational, 3>& value,
                      const Position& p) {
  const Rational area = edge(v[0], v[1], v[2]);
  const Rational dx =
      ((value[1] - value[0]) * (v[2].y - v[0].y) - (value[2] - value[0]) * (v[1].y - v[0].y)) /
      area;
  const Rational dy =
      ((value[2] - value[0]) * (v[1].x - v[0].x) - (value[1] - value[0]) * (v[2].x - v[0].x)) /
      area;
  return value[0] + dx * (p.x - v[0].x) + dy * (p.y - v[0].y);
}

// Corners on a lattice of `step` subpixels: a step of half a pixel puts many samples on edges.
Triangle random_triangle(Random& random, int64_t reach, int64_t step) {
  Triangle t;
  for (Vertex& v : t) {
    v.x = random.between(-reach, reach) * step;
    v.y = random.between(-reach, reach) * step;
    v.z = random.between(0, int64_t{0xffffff00});
    v.attr = {random.between(0, 255)};
  }
  return t;
}

struct Case {
  const char* name;
  int subpixel_bits;
  int64_t reach;
  int64_t step;
};
constexpr Case kCases[] = {
    {"HalfPixelLattice", 8, 12, 128},
    {"Small", 8, 2048, 1},
    {"GuardBand", 8, 1 << 22, 1},
    {"GuardBand4SubpixelBits", 4, 1 << 18, 1},
    {"GuardBand12SubpixelBits", 12, 1 << 26, 1},
    {"Small12SubpixelBits", 12, 40000, 1},
    {"HalfPixels", 1, 8, 1},
};

class JudgeRandom : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Classes, JudgeRandom, testing::ValuesIn(kCases),
                         [](const auto& c) { return std::string(c.param.name); });

TEST_P(JudgeRandom, CoverageAndErrorsEqualRationals) {
  const Case c = GetParam();
  constexpr int kSize = 9;
  Random random(static_cast<uint64_t>(c.reach + c.subpixel_bits));
  int hits = 0;
  for (int n = 0; n < 250; ++n) {
    const Triangle t = random_triangle(random, c.reach, c.step);
    const Judge judge(t, c.subpixel_bits, kSize, kSize, Cull::kNone);
    const std::array<Position, 3> v{position(t[0], c.subpixel_bits),
                                    position(t[1], c.subpixel_bits),
                                    position(t[2], c.subpixel_bits)};
    int64_t samples = 0;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const Position p = sample(x, y);
        ASSERT_EQ(judge.covers(x, y), inside(v, p))
            << "triangle " << n << " pixel " << x << ',' << y;
        if (!judge.covers(x, y)) continue;
        ++samples;
        const Rational z = interpolated(
            v, {Rational(t[0].z, 256), Rational(t[1].z, 256), Rational(t[2].z, 256)}, p);
        const Rational a = interpolated(
            v, {Rational(t[0].attr[0]), Rational(t[1].attr[0]), Rational(t[2].attr[0])}, p);
        const int64_t code = random.between(0, 0xffffff);
        const int64_t value = random.between(0, 255);
        ASSERT_DOUBLE_EQ(judge.depth_error(x, y, code), Rational(code - z).convert_to<double>());
        ASSERT_DOUBLE_EQ(judge.attribute_error(x, y, 0, value),
                         Rational(value - a).convert_to<double>());
      }
    }
    ASSERT_EQ(judge.samples(), samples);
    hits += static_cast<int>(samples);
  }
  EXPECT_GT(hits, 50);  // the class reaches the frame
}

// The comparison above can fail: it tells the top-left rule from the inclusive one.
TEST(JudgeRandomMutant, InclusiveRuleIsToldApart) {
  Random random(1);
  int differences = 0;
  for (int n = 0; n < 100; ++n) {
    const Triangle t = random_triangle(random, 12, 128);
    const Judge judge(t, 8, 9, 9, Cull::kNone);
    const std::array<Position, 3> v{position(t[0], 8), position(t[1], 8), position(t[2], 8)};
    for (int y = 0; y < 9; ++y) {
      for (int x = 0; x < 9; ++x) {
        differences += judge.covers(x, y) != inside(v, sample(x, y), true) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(differences, 10);
}

}  // namespace
}  // namespace exact
