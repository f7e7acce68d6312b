// The reciprocal against 1/area2 in 128-bit integers.
#include "model/core/reciprocal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/spec/reciprocal/schemes.h"
#include "tests/core/support.h"

namespace pineda::test {
namespace {

using spec::int128_t;

constexpr int kMaxLength = kContract.width.area2 - 1;  // bits of the greatest doubled area
constexpr int kLutBits = spec::kHighTile.reciprocal_lut_bits;

// (computed - exact) / exact, from the exact integer area2 * mantissa - 2^(k + length - 1).
double relative_error(const core::Reciprocal& r, int64_t area2) {
  const int shift = spec::kHighTile.reciprocal_bits + r.length - 1;
  const int128_t difference = int128_t{area2} * r.mantissa - (int128_t{1} << shift);
  return std::ldexp(static_cast<double>(difference), -shift);
}

// The greatest error that any area2 has, found by trying every mantissa of 32 bits with the bits
// below it all 0 and all 1 (the error is monotonic in them): 2^-29.4184 here, above the exact
// value; below it no more than 2^-29.68.
constexpr int64_t kWorstArea2 = (int64_t{4280791349} << 14) | 0x3fff;
constexpr double kBoundBits = 29.41;

struct Worst {
  double error = 0;
  int64_t area2 = 0;
  void add(int64_t candidate) {
    if (candidate < 1 || spec::bit_length(static_cast<uint64_t>(candidate)) > kMaxLength) return;
    const double e = std::abs(relative_error(core::reciprocal(kContract, candidate), candidate));
    if (e > error) {
      error = e;
      area2 = candidate;
    }
  }
  double bits() const { return -std::log2(error); }
};

TEST(Reciprocal, ErrorStaysBelowTheBoundAndTheWorstKnown) {
  Worst worst;
  // Every area up to 2^16, both ends and the middle of every ROM cell at every length, and powers
  // of two with their neighbours.
  for (int64_t area2 = 1; area2 < 1 << 16; ++area2) worst.add(area2);
  for (int length = 1; length <= kMaxLength; ++length) {
    for (int64_t near = -3; near <= 3; ++near) worst.add((int64_t{1} << (length - 1)) + near);
    if (length <= kLutBits + 1) continue;
    const int below = length - 1 - kLutBits;  // bits under the ROM's index
    for (int64_t cell = 0; cell <= int64_t{1} << kLutBits; ++cell) {
      const int64_t low = ((int64_t{1} << kLutBits) + cell) << below;
      for (int64_t near = -3; near <= 3; ++near) {
        worst.add(low + near);
        worst.add(low + (int64_t{1} << below) / 2 + near);
      }
    }
  }
  // At random, half of them near the end of a cell, where the first guess is worst.
  Random random(41);
  for (int n = 0; n < 3000000; ++n) {
    const int length = random.between(17, kMaxLength);
    const int64_t low = int64_t{1} << (length - 1);
    int64_t area2 = low + random.between(0, low - 1);
    if (n % 2 == 0 && length > kLutBits + 12) {
      const int below = length - 1 - kLutBits;
      area2 = (area2 >> below << below) -
              random.between(-1, 1) * random.between(0, int64_t{1} << (below - 9));
    }
    worst.add(area2);
  }
  EXPECT_GT(worst.bits(), kBoundBits) << "area2 " << worst.area2;
  const double searched = worst.error;
  worst.add(kWorstArea2);
  EXPECT_LE(searched, worst.error) << "a worse one than the worst known: area2 " << worst.area2;
  EXPECT_NEAR(worst.bits(), 29.4185, .0001);
}

TEST(Reciprocal, PowerOfTwoSaturatesAtOneUnitBelowOne) {
  for (int length = 1; length <= kMaxLength; ++length) {
    const auto r = core::reciprocal(kContract, int64_t{1} << (length - 1));
    EXPECT_EQ(r.mantissa, (int64_t{1} << 30) - 1);
    EXPECT_EQ(r.length, length);
  }
}

TEST(Reciprocal, MantissaIsNormalizedAtTheEndsOfEveryLength) {
  for (int length = 1; length <= kMaxLength; ++length) {
    const int64_t greatest = (int64_t{1} << length) - 1;
    for (const int64_t area2 : {greatest, greatest / 2 + 1, greatest / 2 + 2}) {
      if (area2 > greatest) continue;
      const auto r = core::reciprocal(kContract, area2);
      EXPECT_GE(r.mantissa, int64_t{1} << 29) << area2;
      EXPECT_LT(r.mantissa, int64_t{1} << 30) << area2;
      EXPECT_EQ(r.length, spec::bit_length(static_cast<uint64_t>(area2)));
    }
  }
}

// 1/3 = .0101...: mantissa 2/3 rounded to 30 bits, exponent 1 - 30 - 2.
TEST(Reciprocal, ThirdByHand) {
  const auto r = core::reciprocal(kContract, 3);
  EXPECT_EQ(r.length, 2);
  EXPECT_NEAR(static_cast<double>(r.mantissa), 0x1p31 / 3, 1.0);
}

// Without Newton steps the mantissa is the ROM's entry with its leading 1, for every number of
// index bits.
TEST(Reciprocal, FirstGuessIsTheEntryOfEveryRom) {
  spec::Design design = spec::kHighTile;
  design.reciprocal_newton_steps = 0;
  for (int l = 4; l <= 12; ++l) {
    design.reciprocal_lut_bits = l;
    ASSERT_EQ(spec::invalid_reason(design), "");
    const spec::Contract contract = spec::contract(design);
    const int below = design.reciprocal_bits - spec::reciprocal_rom_bits(design) - 1;
    for (int i = 0; i < 1 << l; ++i) {
      const int64_t value =
          (int64_t{1} << spec::reciprocal_rom_bits(design)) + spec::reciprocal_rom(design, i);
      const int64_t top = (int64_t{1} << l) + i;
      for (const int64_t area2 : {top, top << 20, ((top + 1) << 30) - 1}) {
        ASSERT_EQ(core::reciprocal(contract, area2).mantissa, value << below) << l << " " << i;
      }
    }
  }
  design.reciprocal_lut_bits = 13;  // no ROM of that size is there
  EXPECT_NE(spec::invalid_reason(design), "");
}

TEST(Reciprocal, MutantWithOneNewtonStepBreaksTheBound) {
  spec::Design design = spec::kHighTile;
  design.reciprocal_newton_steps = 1;
  double worst = 0;
  for (int64_t area2 = 1; area2 < 1 << 12; ++area2) {
    worst = std::max(
        worst, std::abs(relative_error(core::reciprocal(spec::contract(design), area2), area2)));
  }
  EXPECT_GT(worst, 0x1p-18);
}

}  // namespace
}  // namespace pineda::test
