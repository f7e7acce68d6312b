// The reciprocal's RTL alone, scheme by scheme, against core: corner areas, random ones, stalls.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <type_traits>

#include "Vreciprocal_newton_small.h"
#include "Vreciprocal_quadratic.h"
#include "Vreciprocal_quadratic_large.h"
#include "Vreciprocal_quadratic_small.h"
#include "Vreciprocal_restoring2_small.h"
#include "Vreciprocal_restoring4.h"
#include "Vreciprocal_restoring4_odd.h"
#include "Vreciprocal_rom.h"
#include "Vreciprocal_unit_more.h"
#include "Vreciprocal_unsaturated.h"
#include "model/core/reciprocal.h"
#include "tests/rtl/lone.h"

namespace pineda::tb {
namespace {

using core::Reciprocal;
using spec::Random;

/// A Verilated reciprocal, stalled at random `stalls` times in eight.
template <class Model>
class Lone {
 public:
  explicit Lone(const std::string& design, int stalls = 0)
      : contract_(contract_of(design)), stalls_(stalls) {
    model_.rst_ni = 0;
    clock(&model_);
    model_.rst_ni = 1;
  }

  const spec::Contract& contract() const { return contract_; }

  /// The outputs, `cycles` enabled cycles after the start. The area is at the input in the first
  /// one only.
  Reciprocal after(int cycles, int64_t area2) {
    model_.start_i = 1;
    model_.area2_i = static_cast<std::decay_t<decltype(model_.area2_i)>>(area2);
    enabled_clock();
    model_.start_i = 0;
    model_.area2_i = 1;
    for (int i = 1; i < cycles; ++i) enabled_clock();
    return {static_cast<int64_t>(model_.mantissa_o), static_cast<int>(model_.length_o)};
  }

  bool agrees(int64_t area2) {
    const Reciprocal got = after(spec::reciprocal_cycles(contract_.design), area2);
    const Reciprocal expected = core::reciprocal(contract_, area2);
    return got.mantissa == expected.mantissa && got.length == expected.length;
  }

 private:
  void enabled_clock() {
    model_.enable_i = 0;
    while (random_.between(0, 7) < stalls_) clock(&model_);
    model_.enable_i = 1;
    clock(&model_);
  }

  spec::Contract contract_;
  int stalls_;
  Random random_{1};
  Model model_;
};

// Calls take(area2) for small areas, powers of two and the ends of ROM cells with their neighbours:
// for every area, when there are few.
template <class Take>
void for_each_corner(const spec::Contract& c, Take take) {
  const int area_bits = c.width.area2 - 1;
  const int64_t limit = int64_t{1} << area_bits;
  for (int64_t area2 = 1; area2 < std::min<int64_t>(limit, 1 << 18); ++area2) {
    if (area_bits <= 18 || area2 < 1 << 12) take(area2);
  }
  const auto take_near = [&](int64_t area2) {
    for (int64_t a = area2 - 2; a <= area2 + 2; ++a) {
      if (a > 0 && a < limit) take(a);
    }
  };
  const int cell_bits = std::max(c.design.reciprocal_lut_bits, 6);
  for (int length = 1; length <= area_bits; ++length) {
    take_near(int64_t{1} << length);
    if (length < area_bits - 2 || length <= cell_bits) continue;
    const int below = length - 1 - cell_bits;
    for (int64_t cell = int64_t{1} << cell_bits; cell < int64_t{2} << cell_bits; ++cell) {
      take_near(cell << below);
    }
  }
}

int64_t random_area(Random* random, const spec::Contract& c) {
  const auto length = random->between(1, c.width.area2 - 1);
  const int64_t low = int64_t{1} << (length - 1);
  return random->between(low, 2 * low - 1);
}

// A module and its design.
template <class M>
struct Scheme;
#define SCHEME(name)                              \
  template <>                                     \
  struct Scheme<Vreciprocal_##name> {             \
    static constexpr const char* kDesign = #name; \
  };
SCHEME(rom)
SCHEME(newton_small)
SCHEME(quadratic)
SCHEME(quadratic_large)
SCHEME(quadratic_small)
SCHEME(restoring4)
SCHEME(restoring4_odd)
SCHEME(restoring2_small)
#undef SCHEME

template <class Model>
class ReciprocalRtl : public testing::Test {};
using Models =
    testing::Types<Vreciprocal_rom, Vreciprocal_newton_small, Vreciprocal_quadratic,
                   Vreciprocal_quadratic_large, Vreciprocal_quadratic_small, Vreciprocal_restoring4,
                   Vreciprocal_restoring4_odd, Vreciprocal_restoring2_small>;
struct DesignName {
  template <class Model>
  static std::string GetName(int) {
    return Scheme<Model>::kDesign;
  }
};
TYPED_TEST_SUITE(ReciprocalRtl, Models, DesignName);

TYPED_TEST(ReciprocalRtl, CornersMatchModel) {
  Lone<TypeParam> lone(Scheme<TypeParam>::kDesign);
  int tried = 0;
  for_each_corner(lone.contract(), [&](int64_t area2) {
    ++tried;
    EXPECT_TRUE(lone.agrees(area2)) << "area2 " << area2;
  });
  EXPECT_GT(tried, 4000);
}

TYPED_TEST(ReciprocalRtl, RandomAreasMatchModel) {
  Lone<TypeParam> lone(Scheme<TypeParam>::kDesign);
  Random random(2);
  for (int i = 0; i < 200'000; ++i) {
    const int64_t area2 = random_area(&random, lone.contract());
    ASSERT_TRUE(lone.agrees(area2)) << "area2 " << area2;
  }
}

TYPED_TEST(ReciprocalRtl, StallsFreezeIt) {
  Lone<TypeParam> lone(Scheme<TypeParam>::kDesign, 4);
  Random random(3);
  for (int i = 0; i < 10'000; ++i) {
    const int64_t area2 = random_area(&random, lone.contract());
    ASSERT_TRUE(lone.agrees(area2)) << "area2 " << area2;
  }
}

// The result is not there a cycle early: the derived number of cycles is really needed.
TYPED_TEST(ReciprocalRtl, NeedsEveryCycleAndHoldsTheResult) {
  Lone<TypeParam> lone(Scheme<TypeParam>::kDesign);
  const int cycles = spec::reciprocal_cycles(lone.contract().design);
  Random random(4);
  int early = 0;
  for (int i = 0; i < 100; ++i) {
    const int64_t area2 = random_area(&random, lone.contract());
    const int64_t mantissa = core::reciprocal(lone.contract(), area2).mantissa;
    early += lone.after(cycles - 1, area2).mantissa == mantissa ? 1 : 0;
    EXPECT_EQ(lone.after(cycles + 50, area2).mantissa, mantissa);
  }
  EXPECT_LT(early, 50);
}

template <class Mutant>
int caught(const char* design) {
  Lone<Mutant> mutant(design);
  int wrong = 0;
  for_each_corner(mutant.contract(), [&](int64_t area2) { wrong += mutant.agrees(area2) ? 0 : 1; });
  return wrong;
}

TEST(ReciprocalRtlMutant, UnitTooMuchAtTheStartOfACellIsCaught) {
  const int wrong = caught<Vreciprocal_unit_more>("quadratic");
  EXPECT_GT(wrong, 0);
}

TEST(ReciprocalRtlMutant, PowersOfTwoThatDoNotSaturateAreCaught) {
  const int wrong = caught<Vreciprocal_unsaturated>("restoring4");
  EXPECT_GT(wrong, 0);
}

}  // namespace
}  // namespace pineda::tb
