// The pipelined reciprocal's RTL against core: a number a cycle, with gaps and stalls.
#include <gtest/gtest.h>

#include <deque>
#include <string>
#include <type_traits>

#include "Vpipelined28_high_tile.h"
#include "Vpipelined28_newton_small.h"
#include "Vpipelined28_quadratic.h"
#include "Vpipelined28_rom.h"
#include "Vpipelined28_slow_affine.h"
#include "Vpipelined28_slow_persp.h"
#include "Vpipelined_high_tile.h"
#include "Vpipelined_newton_small.h"
#include "Vpipelined_quadratic.h"
#include "Vpipelined_rom.h"
#include "Vpipelined_slow_affine.h"
#include "Vpipelined_slow_persp.h"
#include "Vpipelined_unit_more.h"
#include "model/core/reciprocal.h"
#include "tests/rtl/lone.h"

namespace pineda::tb {
namespace {

using core::Reciprocal;
using spec::Random;

/// A Verilated reciprocal_pipelined for numbers of `bits` bits; 0: as wide as a doubled area.
template <class Model>
class Pipeline {
 public:
  explicit Pipeline(const std::string& design, int bits = 0) : contract_(contract_of(design)) {
    bits_ = bits == 0 ? contract_.width.area2 - 1 : bits;
    model_.rst_ni = 0;
    clock(&model_);
    model_.rst_ni = 1;
    cycles_ = spec::pipelined_reciprocal_cycles(contract_.design);
  }

  /// Feeds `count` numbers, a gap `gaps` times in eight, a stall `stalls` times in eight, and
  /// returns how many results differ from core's.
  int wrong(int count, int gaps, int stalls) {
    Random random(7);
    std::deque<int64_t> inside;  // the newest last, 0: a gap
    int wrong = 0;
    for (int fed = 0; fed < count;) {
      model_.enable_i = random.between(0, 7) >= stalls;
      const int64_t value = random.between(0, 7) < gaps ? 0 : number(&random, fed);
      model_.valid_i = value != 0;
      model_.value_i = static_cast<std::decay_t<decltype(model_.value_i)>>(value);
      clock(&model_);
      if (!model_.enable_i) continue;
      fed += value != 0 ? 1 : 0;
      inside.push_back(value);
      if (inside.size() < static_cast<size_t>(cycles_)) continue;
      if (inside.front() != 0) wrong += agrees(inside.front()) ? 0 : 1;
      inside.pop_front();
    }
    return wrong;
  }

 private:
  // All small numbers and powers of two with their neighbours, then random ones of every length.
  int64_t number(Random* random, int fed) const {
    if (fed < 1 << 10) return fed + 1;
    const auto length = random->between(2, bits_);
    const int64_t low = int64_t{1} << (length - 1);
    return random->coin() ? random->between(low, 2 * low - 1) : low - 1 + random->between(0, 2);
  }
  bool agrees(int64_t value) const {
    const Reciprocal expected = core::reciprocal(contract_, value);
    return static_cast<int64_t>(model_.mantissa_o) == expected.mantissa &&
           static_cast<int>(model_.length_o) == expected.length;
  }

  spec::Contract contract_;
  int bits_ = 0;
  int cycles_ = 0;
  Model model_;
};

template <class Model>
void expect_agreement(const char* design, int bits) {
  EXPECT_EQ(Pipeline<Model>(design, bits).wrong(100'000, 0, 0), 0) << design;
  EXPECT_EQ(Pipeline<Model>(design, bits).wrong(20'000, 4, 0), 0) << design << ", gaps";
  EXPECT_EQ(Pipeline<Model>(design, bits).wrong(20'000, 4, 4), 0) << design << ", gaps and stalls";
}

TEST(ReciprocalPipelinedRtl, MatchesModelOfDoubledAreas) {
  expect_agreement<Vpipelined_rom>("rom", 0);
  expect_agreement<Vpipelined_high_tile>("high_tile", 0);
  expect_agreement<Vpipelined_newton_small>("newton_small", 0);
  expect_agreement<Vpipelined_quadratic>("quadratic", 0);
  expect_agreement<Vpipelined_slow_persp>("slow_persp", 0);
  expect_agreement<Vpipelined_slow_affine>("slow_affine", 0);
}

TEST(ReciprocalPipelinedRtl, MatchesModelOf28Bits) {
  expect_agreement<Vpipelined28_rom>("rom", 28);
  expect_agreement<Vpipelined28_high_tile>("high_tile", 28);
  expect_agreement<Vpipelined28_newton_small>("newton_small", 28);
  expect_agreement<Vpipelined28_quadratic>("quadratic", 28);
  expect_agreement<Vpipelined28_slow_persp>("slow_persp", 28);
  expect_agreement<Vpipelined28_slow_affine>("slow_affine", 28);
}

TEST(ReciprocalPipelinedRtlMutant, UnitTooMuchAtTheStartOfACellIsCaught) {
  EXPECT_GT(Pipeline<Vpipelined_unit_more>("quadratic").wrong(5000, 0, 0), 0);
}

}  // namespace
}  // namespace pineda::tb
