// The fixed-point primitives against tables worked by hand.
#include "model/spec/fixed.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace pineda::spec {
namespace {

struct WrapCase {
  int64_t value;
  int bits;
  int64_t wrapped;
};

TEST(Wrap, HandWorkedTable) {
  const WrapCase cases[] = {
      {0, 4, 0},
      {7, 4, 7},
      {8, 4, -8},   // 1000
      {9, 4, -7},   // 1001
      {15, 4, -1},  // 1111
      {16, 4, 0},
      {-8, 4, -8},
      {-9, 4, 7},    // ...0111
      {-17, 4, -1},  // ...1111
      {0, 1, 0},
      {1, 1, -1},  // one bit is the sign
      {2, 1, 0},
      {int64_t{1} << 43, 44, -(int64_t{1} << 43)},
      {(int64_t{1} << 43) - 1, 44, (int64_t{1} << 43) - 1},
      {INT64_MIN, 44, 0},
      {INT64_MAX, 44, -1},
      {INT64_MIN, 63, 0},
      {INT64_MIN, 64, INT64_MIN},
      {INT64_MAX, 64, INT64_MAX},
      {-1, 64, -1},
  };
  for (const WrapCase& c : cases) {
    EXPECT_EQ(wrap(c.value, c.bits), c.wrapped) << c.value << " to " << c.bits;
    EXPECT_EQ(wrap(int128_t{c.value}, c.bits), c.wrapped);
  }
  // Bits above 64 of a wide intermediate do not count.
  EXPECT_EQ(wrap((int128_t{1} << 100) + 5, 44), 5);
  EXPECT_EQ(wrap(-(int128_t{1} << 100) - 5, 44), -5);
}

struct RoundCase {
  int64_t value;
  int shift;
  int64_t rounded;
};

// Each case is a quotient: 5/2 = 2.5 and so on.
TEST(RoundHalfUp, HandWorkedTable) {
  const RoundCase cases[] = {
      {5, 0, 5},   {-5, 0, -5},               // nothing to round
      {4, 1, 2},   {5, 1, 3},   {-4, 1, -2},  // 2.5 goes up
      {-5, 1, -2}, {-1, 1, 0},  {1, 1, 1},    // -2.5 goes up too, to -2
      {5, 2, 1},   {6, 2, 2},   {7, 2, 2},    // 1.25, 1.5, 1.75
      {-5, 2, -1}, {-6, 2, -1}, {-7, 2, -2},  // -1.25, -1.5, -1.75
      {127, 8, 0}, {128, 8, 1}, {-128, 8, 0}, {-129, 8, -1}, {0, 40, 0}, {int64_t{1} << 39, 40, 1},
  };
  for (const RoundCase& c : cases) {
    EXPECT_EQ(round_half_up(c.value, c.shift), c.rounded) << c.value << " >> " << c.shift;
    EXPECT_EQ(round_half_up(int128_t{c.value}, c.shift), c.rounded);
  }
  EXPECT_EQ(round_half_up((int128_t{1} << 90) + (int128_t{1} << 29), 30), (int128_t{1} << 60) + 1);
}

// The table above can fail: rounding away from zero, to even and truncation all differ from it.
TEST(RoundHalfUp, MutantsDiffer) {
  const auto away = [](int64_t v, int s) {
    return v < 0 ? -round_half_up(-v, s) : round_half_up(v, s);
  };
  EXPECT_NE(away(-5, 1), round_half_up(int64_t{-5}, 1));
  EXPECT_NE(-5 / 2 * 1 - 1, round_half_up(int64_t{-5}, 1));  // to even, downwards
  EXPECT_NE(7 >> 2, round_half_up(int64_t{7}, 2));           // truncation
}

TEST(BitLength, HandWorkedTable) {
  EXPECT_EQ(bit_length(0), 0);
  EXPECT_EQ(bit_length(1), 1);
  EXPECT_EQ(bit_length(2), 2);
  EXPECT_EQ(bit_length(255), 8);
  EXPECT_EQ(bit_length(256), 9);
  EXPECT_EQ(bit_length(UINT64_MAX), 64);
}

TEST(CeilLog2, HandWorkedTable) {
  EXPECT_EQ(ceil_log2(1), 0);
  EXPECT_EQ(ceil_log2(2), 1);
  EXPECT_EQ(ceil_log2(3), 2);
  EXPECT_EQ(ceil_log2(4), 2);
  EXPECT_EQ(ceil_log2(5), 3);
  EXPECT_EQ(ceil_log2(uint64_t{1} << 63), 63);
}

}  // namespace
}  // namespace pineda::spec
