// The multiplier as it is synthesized, of Booth digits, against the processor's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <type_traits>

#include "Vmultiplier_24x17.h"
#include "Vmultiplier_33x24.h"
#include "Vmultiplier_33x31_1.h"
#include "Vmultiplier_33x31_2.h"
#include "Vmultiplier_6x5.h"
#include "Vmultiplier_6x5_1.h"
#include "Vmultiplier_6x5_2.h"
#include "Vmultiplier_7x4.h"
#include "Vmultiplier_unsigned.h"
#include "model/spec/random.h"
#include "tests/rtl/lone.h"

namespace pineda::tb {
namespace {

using spec::Random;

/// A Verilated multiplier for numbers of `a_bits` and `b_bits` bits; its product is taken modulo 2^64
/// if it is longer. `Stages`: cycles of one that is pipelined, 0 for one that has no clock.
template <class Model, int Stages = 0>
class Multiplier {
 public:
  Multiplier(int a_bits, int b_bits) : a_bits_(a_bits), b_bits_(b_bits) {
    if constexpr (Stages > 0) clock(&model_);
  }

  bool is_right(int64_t a, int64_t b, int64_t addend) {
    const int bits = std::min(a_bits_ + b_bits_, 64);
    model_.a_i = low<decltype(model_.a_i)>(a, a_bits_);
    model_.b_i = low<decltype(model_.b_i)>(b, b_bits_);
    model_.addend_i = low<decltype(model_.addend_i)>(addend, bits);
    const uint64_t product =
        static_cast<uint64_t>(a) * static_cast<uint64_t>(b) + static_cast<uint64_t>(addend);
    expected_.push_back(product & (~uint64_t{0} >> (64 - bits)));
    if constexpr (Stages > 0) {
      model_.enable_i = 1;
      model_.valid_i = (1 << Stages) - 1;
      clock(&model_);
    }
    model_.eval();
    if (expected_.size() < static_cast<size_t>(std::max(Stages, 1))) return true;
    const uint64_t next = expected_.front();
    expected_.pop_front();
    return static_cast<uint64_t>(model_.product_o) == next;
  }

  /// Wrong products of all numbers.
  int wrong_of_all() {
    Random random(3);
    int wrong = 0;
    for (int64_t a = -(int64_t{1} << (a_bits_ - 1)); a < int64_t{1} << (a_bits_ - 1); ++a) {
      for (int64_t b = -(int64_t{1} << (b_bits_ - 1)); b < int64_t{1} << (b_bits_ - 1); ++b) {
        wrong += is_right(a, b, 0) && is_right(a, b, random.between(-1000, 1000)) ? 0 : 1;
      }
    }
    return wrong;
  }

  /// Wrong products of `count` random numbers, of all lengths, and of the ends of the ranges.
  int wrong_of(int count) {
    Random random(4);
    const auto number = [&](int bits) {
      const int length = static_cast<int>(random.between(1, bits));
      const int64_t end = int64_t{1} << (length - 1);
      return random.between(0, 7) == 0 ? (random.coin() ? -end : end - 1)
                                       : random.between(-end, end - 1);
    };
    int wrong = 0;
    for (int i = 0; i < count; ++i) {
      wrong += is_right(number(a_bits_), number(b_bits_), number(a_bits_)) ? 0 : 1;
    }
    return wrong;
  }

 private:
  template <class Port>
  static std::decay_t<Port> low(int64_t value, int bits) {
    return static_cast<std::decay_t<Port>>(static_cast<uint64_t>(value) &
                                           (~uint64_t{0} >> (64 - bits)));
  }

  int a_bits_, b_bits_;
  std::deque<uint64_t> expected_;  // the newest last
  Model model_;
};

TEST(MultiplierRtl, EveryProductOfFewBitsIsRight) {
  EXPECT_EQ(Multiplier<Vmultiplier_6x5>(6, 5).wrong_of_all(), 0);
  EXPECT_EQ(Multiplier<Vmultiplier_7x4>(7, 4).wrong_of_all(), 0);
}

TEST(MultiplierRtl, ProductsOfSetupAreRight) {
  EXPECT_EQ(Multiplier<Vmultiplier_24x17>(24, 17).wrong_of(200'000), 0);
  EXPECT_EQ(Multiplier<Vmultiplier_33x24>(33, 24).wrong_of(200'000), 0);
}

TEST(MultiplierRtl, OneACycleIsRight) {
  EXPECT_EQ((Multiplier<Vmultiplier_6x5_1, 1>(6, 5).wrong_of_all()), 0);
  EXPECT_EQ((Multiplier<Vmultiplier_6x5_2, 2>(6, 5).wrong_of_all()), 0);
  EXPECT_EQ((Multiplier<Vmultiplier_33x31_1, 1>(33, 31).wrong_of(200'000)), 0);
  EXPECT_EQ((Multiplier<Vmultiplier_33x31_2, 2>(33, 31).wrong_of(200'000)), 0);
}

// The mutant: the last digit of the second factor is taken for one without a sign.
TEST(MultiplierRtlMutant, WithoutASignIsCaught) {
  EXPECT_GT(Multiplier<Vmultiplier_unsigned>(6, 5).wrong_of_all(), 500);
}

}  // namespace
}  // namespace pineda::tb
