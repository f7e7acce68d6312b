// The multiplier as it is synthesized, of Booth digits, against the processor's.
#include <gtest/gtest.h>

#include "Vmultiplier_24x17.h"
#include "Vmultiplier_33x24.h"
#include "Vmultiplier_6x5.h"
#include "Vmultiplier_7x4.h"
#include "Vmultiplier_unsigned.h"
#include "model/spec/random.h"

namespace pineda::tb {
namespace {

using spec::Random;

/// A Verilated multiplier for numbers of `a_bits` and `b_bits` bits, at most 64 together.
template <class Model>
class Multiplier {
 public:
  Multiplier(int a_bits, int b_bits) : a_bits_(a_bits), b_bits_(b_bits) {}

  bool is_right(int64_t a, int64_t b, int64_t addend) {
    model_.a_i = low<decltype(model_.a_i)>(a, a_bits_);
    model_.b_i = low<decltype(model_.b_i)>(b, b_bits_);
    model_.addend_i = low<decltype(model_.addend_i)>(addend, a_bits_ + b_bits_);
    model_.eval();
    using Product = decltype(model_.product_o);
    return model_.product_o == low<Product>(a * b + addend, a_bits_ + b_bits_);
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

// The mutant: the last digit of the second factor is taken for one without a sign.
TEST(MultiplierRtlMutant, WithoutASignIsCaught) {
  EXPECT_GT(Multiplier<Vmultiplier_unsigned>(6, 5).wrong_of_all(), 500);
}

}  // namespace
}  // namespace pineda::tb
