// Snapping and the depth input: hand-worked values, and every float of a range against rationals.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstring>
#include <limits>

#include "model/exact/exact.h"
#include "model/spec/random.h"

namespace exact {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Integer = boost::multiprecision::cpp_int;

float from_bits(uint32_t bits) {
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

Integer floor_of(const Rational& r) {
  Integer quotient = numerator(r) / denominator(r);
  if (quotient * denominator(r) > numerator(r)) --quotient;
  return quotient;
}

struct SnapCase {
  float value;
  int64_t snapped;
  bool saturated;
};

TEST(Snap, HandWorkedValues) {
  const float inf = std::numeric_limits<float>::infinity();
  const SnapCase cases[] = {
      {0.0f, 0, false},
      {1.0f, 256, false},
      {0.5f / 256, 0, false},                   // a half goes to even: 0
      {1.5f / 256, 2, false},                   // 2
      {2.5f / 256, 2, false},                   // 2 again
      {-0.5f / 256, 0, false},                  // 0
      {-1.5f / 256, -2, false},                 // -2
      {0x1.000002p-9f, 1, false},               // just above half a unit
      {0x1.fffffep-10f, 0, false},              // just below
      {from_bits(1), 0, false},                 // the least denormal
      {from_bits(0x807fffff), 0, false},        // the greatest negative denormal
      {16383.99609375f, (1 << 22) - 1, false},  // the greatest coordinate
      {16383.998046875f, (1 << 22) - 1, true},  // half a unit more: to even, which is outside
      {16384.0f, (1 << 22) - 1, true},
      {-16384.0f, -(1 << 22), false},
      {-16384.001953125f, -(1 << 22), false},  // half a unit outside: to even, which is inside
      {-16384.00390625f, -(1 << 22), true},    // a whole unit
      {1e30f, (1 << 22) - 1, true},
      {inf, (1 << 22) - 1, true},
      {-inf, -(1 << 22), true},
  };
  for (const SnapCase& c : cases) {
    bool saturated = !c.saturated;
    EXPECT_EQ(snap(c.value, 8, 14, &saturated), c.snapped) << c.value;
    EXPECT_EQ(saturated, c.saturated) << c.value;
  }
}

TEST(Snap, RandomFloatsAreNearestAndTiesEven) {
  pineda::spec::Random random(2);
  int ties = 0;
  for (int n = 0; n < 20000; ++n) {
    // Any sign, exponents from 2^-14 to 2^13, and often a short mantissa, so that ties occur.
    const auto draw = static_cast<uint32_t>(random.bits());
    const uint32_t mantissa = n % 2 == 0 ? draw & 0x7fffff : draw & 0x700000;
    const auto exponent = static_cast<uint32_t>(113 + (random.bits() % 28));
    const float value = from_bits((draw & 0x80000000) | exponent << 23 | mantissa);
    const Rational scaled = Rational(static_cast<double>(value)) * 256;
    Integer wanted = floor_of(scaled);
    const Rational rest = scaled - wanted;
    if (rest == Rational(1, 2)) ++ties;
    if (rest > Rational(1, 2) || (rest == Rational(1, 2) && wanted % 2 != 0)) ++wanted;
    bool saturated = true;
    ASSERT_EQ(Integer(snap(value, 8, 14, &saturated)), wanted) << value;
    ASSERT_FALSE(saturated);
  }
  EXPECT_GT(ties, 100);
}

TEST(DepthInput, HandWorkedValues) {
  bool clamped = true;
  EXPECT_EQ(depth_input(0.0f, 24, &clamped), 0);
  EXPECT_FALSE(clamped);
  EXPECT_EQ(depth_input(1.0f, 24, &clamped), int64_t{0xffffff} << 8);
  EXPECT_FALSE(clamped);
  // .5 * (2^24-1) * 256 = 2^31 - 128, exactly.
  EXPECT_EQ(depth_input(0.5f, 24, &clamped), (int64_t{1} << 31) - 128);
  // 2^-33: (2^24-1) / 2^25 = .49999997 rounds down; 2^-32 is twice that and rounds up.
  EXPECT_EQ(depth_input(0x1p-33f, 24, &clamped), 0);
  EXPECT_EQ(depth_input(0x1p-32f, 24, &clamped), 1);
  // The float below 1: (1 - 2^-24)(2^24 - 1)*256 = (2^24 - 2 + 2^-24)*256.
  EXPECT_EQ(depth_input(0x1.fffffep-1f, 24, &clamped), int64_t{0xfffffe} << 8);
  EXPECT_EQ(depth_input(from_bits(1), 24, &clamped), 0);
  EXPECT_FALSE(clamped);
}

TEST(DepthInput, OutsideIsClampedAndSaid) {
  const float inf = std::numeric_limits<float>::infinity();
  for (const float z : {-0x1p-126f, -1.0f, -inf}) {
    bool clamped = false;
    EXPECT_EQ(depth_input(z, 24, &clamped), 0);
    EXPECT_TRUE(clamped);
  }
  for (const float z : {0x1.000002p0f, 2.0f, inf}) {
    bool clamped = false;
    EXPECT_EQ(depth_input(z, 24, &clamped), int64_t{0xffffff} << 8);
    EXPECT_TRUE(clamped);
  }
}

// The mutant, too: in single precision about half of these are wrong.
TEST(DepthInput, FloatsNearOneAreRoundedOnceAndSinglePrecisionIsNot) {
  pineda::spec::Random random(3);
  int single_differs = 0;
  constexpr int kTries = 20000;
  for (int n = 0; n < kTries; ++n) {
    const float z = from_bits(0x3f000000 + static_cast<uint32_t>(random.bits() % 0x800000));
    const Rational scaled = Rational(static_cast<double>(z)) * 0xffffff;
    bool clamped = true;
    ASSERT_EQ(Integer(depth_input(z, 24, &clamped)), floor_of(scaled * 256 + Rational(1, 2)));
    ASSERT_FALSE(clamped);
    const auto single = static_cast<int64_t>(z * 16777215.0f + .5f);
    single_differs += Integer(single) != floor_of(scaled + Rational(1, 2)) ? 1 : 0;
  }
  EXPECT_GT(single_differs, kTries / 3);
}

}  // namespace
}  // namespace exact
