// The code that depth is cleared to: rounded once, in every format of depth.
#include "model/spec/clear_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "model/spec/random.h"

namespace pineda::spec {
namespace {

// A binary32 times 32 bits has 56 bits, a half 57: a long double of 64 holds both exactly, so that
// floor() is the only rounding.
uint32_t expected_code(float z, int depth_bits) {
  static_assert(std::numeric_limits<long double>::digits >= 64);
  const long double greatest = std::exp2(static_cast<long double>(depth_bits)) - 1;
  return static_cast<uint32_t>(std::floor(static_cast<long double>(z) * greatest + .5L));
}

TEST(ClearDepth, EveryBinary32NearTheEndsIsRoundedOnce) {
  for (const int bits : {16, 17, 23, 24, 25, 31, 32}) {
    const auto top = static_cast<uint32_t>((uint64_t{1} << bits) - 1);
    EXPECT_EQ(depth_code(0, bits), 0u);
    EXPECT_EQ(depth_code(1, bits), top);
    float up = 0;
    float down = 1;
    for (int i = 0; i < 5000; ++i) {
      for (const float z : {up, down, .5f + up, std::ldexp(down, -bits)}) {
        ASSERT_EQ(depth_code(z, bits), expected_code(z, bits)) << bits << ": " << z;
      }
      up = std::nextafter(up, 1.0f);
      down = std::nextafter(down, 0.0f);
    }
  }
}

TEST(ClearDepth, RandomBinary32OfEveryExponentAreRoundedOnce) {
  Random random(31);
  for (int i = 0; i < 200000; ++i) {
    const auto mantissa = static_cast<float>(random.bits() >> 40);
    const float z = std::ldexp(mantissa, -24 - static_cast<int>(random.bits() % 40));
    const int bits = 16 + static_cast<int>(random.bits() % 17);
    ASSERT_EQ(depth_code(z, bits), expected_code(z, bits)) << bits << ": " << z;
  }
}

// Halves up, by hand: of 2^16 - 1 codes the half is 32767.5, of the least float below it less.
TEST(ClearDepth, HalvesGoUpAndWhatIsBelowDown) {
  EXPECT_EQ(depth_code(.5, 16), 32768u);
  EXPECT_EQ(depth_code(std::nextafter(.5f, 0.0f), 16), 32767u);
  EXPECT_EQ(depth_code(.5, 24), 8388608u);
  EXPECT_EQ(depth_code(.5, 32), 0x80000000u);
  EXPECT_EQ(depth_code(std::numeric_limits<float>::denorm_min(), 32), 0u);
  EXPECT_EQ(depth_code(std::numeric_limits<double>::denorm_min(), 32), 0u);
}

// The mutant: the same in binary32 is wrong for many.
TEST(ClearDepth, BinaryArithmeticOfTheSameFormIsWrong) {
  Random random(32);
  int wrong = 0;
  for (int i = 0; i < 1000; ++i) {
    const float z = .5f + static_cast<float>(random.bits() >> 40) * 0x1p-25f;
    wrong += depth_code(z, 24) != static_cast<uint32_t>(z * 16777215.0f + .5f) ? 1 : 0;
  }
  EXPECT_GT(wrong, 300);
}

TEST(ClearDepth, EveryCodeIsThatOfItsDepth) {
  Random random(33);
  for (int bits = 16; bits <= 32; ++bits) {
    const auto top = static_cast<uint32_t>((uint64_t{1} << bits) - 1);
    const auto back = [bits](uint32_t code) { return depth_code(depth_of_code(code, bits), bits); };
    for (int i = 0; i < 20000; ++i) {
      const auto any = static_cast<uint32_t>(random.bits()) & top;
      const auto near = static_cast<uint32_t>(i);
      for (const uint32_t code : {any, near, top - near}) ASSERT_EQ(back(code), code) << bits;
    }
    for (int bit = 0; bit < bits; ++bit) ASSERT_EQ(back(1u << bit), 1u << bit) << bits;
    EXPECT_EQ(depth_of_code(top, bits), 1);
  }
}

TEST(ClearDepth, WhatIsNoDepthIsRefused) {
  for (const double z : {-1e-30, 1 + 1e-15, std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    EXPECT_THROW(depth_code(z, 24), std::invalid_argument) << z;
  }
  EXPECT_EQ(depth_code(-0.0, 24), 0u);
}

// The frame state holds a depth, so each design gets a code in its own format.
TEST(ClearDepth, OfADesignIsInItsCodes) {
  FrameState frame;
  EXPECT_EQ(cleared_depth(kHighTile, frame), 0xffffffu);
  frame.clear_depth = .5;
  Design d = kHighTile;
  EXPECT_EQ(cleared_depth(d, frame), 0x800000u);
  d.depth_bits = 16;
  EXPECT_EQ(cleared_depth(d, frame), 0x8000u);
  d.depth_test = false;
  EXPECT_EQ(cleared_depth(d, frame), 0xffffffu);
}

}  // namespace
}  // namespace pineda::spec
