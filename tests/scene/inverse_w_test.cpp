// 1/w of a vertex against rationals: every float that may come, however far apart the three are.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "model/scene/snap.h"
#include "model/spec/random.h"

namespace pineda::scene {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Integer = boost::multiprecision::cpp_int;

Rational power_of_two(int exponent) {
  const Rational power(Integer(1) << std::abs(exponent));
  return exponent < 0 ? Rational(1 / power) : power;
}

/// The nearest number of `bits` bits, halves up: mantissa * 2^exponent, the mantissa's top bit set.
struct Rounded {
  Integer mantissa;
  int exponent;
};

Rounded inverse(float w, int bits) {
  const Rational exact = 1 / Rational(static_cast<double>(w));
  int exponent = -std::ilogb(w) - bits;  // a guess that is at most one off
  const Rational least = power_of_two(bits - 1);
  while (exact / power_of_two(exponent) < least) --exponent;
  while (exact / power_of_two(exponent) >= 2 * least) ++exponent;
  const Rational scaled = exact / power_of_two(exponent) + Rational(1, 2);
  Integer mantissa = numerator(scaled) / denominator(scaled);
  if (mantissa == Integer(1) << bits) {
    mantissa >>= 1;
    ++exponent;
  }
  return {mantissa, exponent};
}

/// How many components differ from the rationals'.
int wrong(const spec::Contract& c, const std::array<float, 3>& w) {
  std::array<spec::Vertex, 3> v;
  set_inverse_w(c, w, &v);
  std::array<Rounded, 3> exact;
  for (size_t i = 0; i < 3; ++i) exact[i] = inverse(w[i], c.design.inverse_w_bits);
  const int top = std::max({exact[0].exponent, exact[1].exponent, exact[2].exponent});
  int count = 0;
  for (size_t i = 0; i < 3; ++i) {
    count += exact[i].mantissa != v[i].inverse_w ? 1 : 0;
    count += top - exact[i].exponent != v[i].inverse_w_shift ? 1 : 0;
    count += v[i].inverse_w_shift >> spec::kInverseWShiftBits != 0 ? 1 : 0;
  }
  return count;
}

spec::Contract with_bits(int bits) {
  spec::Design d = *spec::find_design("persp");
  d.inverse_w_bits = bits;
  return spec::contract(d);
}

// Powers of two, where 1/w is one, too; and the floats beside them, whose 1/w may round up to one.
std::vector<float> hard_ws() {
  std::vector<float> all{3, 5, 7, .1f, 1e6f, 1e-6f, 0x1.555556p0f, 0x1.fffffep0f};
  for (const float power :
       {std::numeric_limits<float>::min(), 0x1p-64f, .25f, 1.f, 2.f, 0x1p20f, 0x1p64f, 0x1p127f}) {
    all.push_back(power);
    all.push_back(std::nextafter(power, std::numeric_limits<float>::max()));
    const float below = std::nextafter(power, 0.f);
    if (std::isnormal(below)) all.push_back(below);
  }
  all.push_back(std::numeric_limits<float>::max());
  return all;
}

TEST(InverseW, EveryHardWBesideEveryOtherIsTheNearestMantissa) {
  const std::vector<float> ws = hard_ws();
  for (const int bits : {8, 20, 24}) {
    const spec::Contract c = with_bits(bits);
    for (const float a : ws) {
      for (const float b : ws) ASSERT_EQ(wrong(c, {a, 1.5f, b}), 0) << bits << " " << a << " " << b;
    }
  }
}

TEST(InverseW, AnyNormalFloatsAreTheNearestMantissas) {
  spec::Random random(1);
  const auto any = [&] {
    const int mantissa = random.between(1 << 23, (1 << 24) - 1);
    return std::ldexp(static_cast<float>(mantissa), random.between(-126, 127) - 23);
  };
  for (int i = 0; i < 3000; ++i) {
    const float a = any();
    const float b = any();
    ASSERT_EQ(wrong(with_bits(8 + i % 17), {a, b, any()}), 0) << i;
  }
}

// The mutant: a quotient in doubles that is cut off is off by one for about half of all.
TEST(InverseW, CuttingOffIsSeen) {
  spec::Random random(2);
  int differ = 0;
  for (int i = 0; i < 1000; ++i) {
    const float w = random.uniform(1, 2);
    const auto cut = static_cast<int64_t>(std::ldexp(1 / static_cast<double>(w), 20));
    differ += inverse(w, 20).mantissa != cut ? 1 : 0;
  }
  EXPECT_NEAR(differ, 500, 80);
}

}  // namespace
}  // namespace pineda::scene
