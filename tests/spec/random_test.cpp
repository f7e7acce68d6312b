// Random numbers: published sequences first, then each kind of draw by the 64 bits that it takes.
#include "model/spec/random.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <type_traits>

namespace pineda::spec {
namespace {

// An engine that returns given bits.
class Stated {
 public:
  explicit Stated(uint64_t bits) : bits_(bits) {}
  uint64_t operator()() { return bits_; }

 private:
  uint64_t bits_;
};
using StatedDraw = RandomFrom<Stated>;

TEST(SplitMix64, FirstNumbersAreThoseOfTheReference) {
  Random random(1234567);  // the reference program's published sequence
  EXPECT_EQ(random.bits(), 6457827717110365317u);
  EXPECT_EQ(random.bits(), 3203168211198807973u);
  EXPECT_EQ(random.bits(), 9817491932198370423u);
}

TEST(SplitMix64, AnyNumberIsThereWithoutThoseBefore) {
  for (const uint64_t seed : {uint64_t{0}, uint64_t{31}, UINT64_MAX}) {
    SplitMix64 engine(seed);
    for (uint64_t n = 1; n < 1000; ++n) ASSERT_EQ(SplitMix64::at(seed, n), engine()) << n;
  }
  // The mutant: counted from 0 it is another number.
  EXPECT_NE(SplitMix64::at(5, 0), SplitMix64(5)());
}

TEST(RandomDraw, BetweenTakesTheRemainderAndReachesBothEnds) {
  EXPECT_EQ(StatedDraw(0).between(-3, 4), -3);
  EXPECT_EQ(StatedDraw(7).between(-3, 4), 4);
  EXPECT_EQ(StatedDraw(8).between(-3, 4), -3);
  EXPECT_EQ(StatedDraw(UINT64_MAX).between(5, 5), 5);
  EXPECT_EQ(StatedDraw(1).between(INT32_MAX - 1, INT32_MAX), INT32_MAX);
  EXPECT_EQ(StatedDraw(UINT64_MAX - 1).between(INT64_MIN, INT64_MAX - 1), INT64_MAX - 1);
  std::array<int, 8> drawn{};
  Random random(1);
  for (int i = 0; i < 8000; ++i) ++drawn.at(static_cast<size_t>(random.between(-3, 4) + 3));
  for (const int count : drawn) EXPECT_NEAR(count, 1000, 150);
}

TEST(RandomDraw, BetweenGivesTheWiderOfItsTypes) {
  static_assert(std::is_same_v<decltype(Random(0).between(0, 1)), int>);
  static_assert(std::is_same_v<decltype(Random(0).between(0, int64_t{1})), int64_t>);
  EXPECT_EQ(StatedDraw(uint64_t{1} << 40).between(0, int64_t{1} << 40), int64_t{1} << 40);
}

TEST(RandomDraw, CoinIsTheTopBit) {
  EXPECT_FALSE(StatedDraw(UINT64_MAX >> 1).coin());
  EXPECT_TRUE(StatedDraw(uint64_t{1} << 63).coin());
}

TEST(RandomDraw, UniformTakesTheTop24BitsAndLeavesOutTheHighEnd) {
  EXPECT_EQ(StatedDraw(0).uniform(-2, 6), -2.f);
  EXPECT_EQ(StatedDraw((uint64_t{1} << 40) - 1).uniform(-2, 6), -2.f);
  EXPECT_EQ(StatedDraw(uint64_t{1} << 63).uniform(-2, 6), 2.f);
  EXPECT_EQ(StatedDraw(UINT64_MAX).uniform(0, 1), 1 - 0x1p-24f);
}

TEST(RandomDraw, UnitTakesTheTop53BitsAndLeavesOut1) {
  EXPECT_EQ(StatedDraw((uint64_t{1} << 11) - 1).unit(), 0);
  EXPECT_EQ(StatedDraw(uint64_t{1} << 11).unit(), 0x1p-53);
  EXPECT_EQ(StatedDraw(UINT64_MAX).unit(), 1 - 0x1p-53);
}

// The standard states the 10000th number of this engine.
TEST(RandomDraw, AnotherEngineGivesItsOwnNumbers) {
  RandomFrom<std::mt19937_64> random(std::mt19937_64::default_seed);
  for (int i = 1; i < 10000; ++i) random.bits();
  EXPECT_EQ(random.bits(), 9981545732273789042u);
}

}  // namespace
}  // namespace pineda::spec
