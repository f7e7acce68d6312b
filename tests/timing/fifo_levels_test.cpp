// FifoLevels against a count of every cycle.
#include "model/timing/counted/fifo_levels.h"

#include <gtest/gtest.h>

#include "model/spec/random.h"

namespace pineda::test {
namespace {

using timing::Cycle;
using timing::FifoLevels;

struct Slot {
  Cycle inserted;
  Cycle freed;
};

// A FIFO under random offers and takers.
std::vector<Slot> random_slots(int depth, uint32_t seed) {
  spec::Random random(seed);
  std::vector<Slot> slots;
  for (size_t n = 0; n < 150; ++n) {
    const Cycle gap = random.between(0, random.between(0, 3) == 0 ? 19 : 1);
    Cycle inserted = n == 0 ? gap : slots.back().inserted + 1 + gap;
    if (n >= static_cast<size_t>(depth)) {
      inserted = std::max(inserted, slots[n - static_cast<size_t>(depth)].freed + 1);
    }
    const Cycle wait = random.between(0, 2) == 0 ? random.between(0, 14) : 0;
    const Cycle first = n == 0 ? inserted + 1 : std::max(inserted, slots.back().freed) + 1;
    slots.push_back({inserted, first + wait});
  }
  return slots;
}

// A slot taken in t counts from t + 1 to the cycle in which it is freed.
std::vector<Cycle> counted(const std::vector<Slot>& slots, int depth, Cycle drained) {
  std::vector<Cycle> cycles(static_cast<size_t>(depth) + 1);
  for (Cycle cycle = 0; cycle < drained; ++cycle) {
    size_t level = 0;
    for (const Slot& slot : slots) level += slot.inserted < cycle && cycle <= slot.freed ? 1 : 0;
    ++cycles[level];
  }
  return cycles;
}

std::vector<Cycle> levels_of(const std::vector<Slot>& slots, int depth, Cycle drained) {
  FifoLevels levels(depth);
  levels.slot(3, 9);  // left over from an earlier frame
  levels.begin_frame();
  for (const Slot& slot : slots) levels.slot(slot.inserted, slot.freed);
  return levels.cycles(drained);
}

TEST(FifoLevels, CountEachCycleAtTheLevelItBeginsWith) {
  bool full = false;
  for (uint32_t seed = 0; seed < 200; ++seed) {
    const int depth = 1 + static_cast<int>(seed % 5);
    const auto slots = random_slots(depth, seed);
    const Cycle drained = slots.back().freed + 1 + seed % 3;
    const auto expected = counted(slots, depth, drained);
    ASSERT_EQ(levels_of(slots, depth, drained), expected) << "seed " << seed;
    full = full || expected.back() > 0;
  }
  EXPECT_TRUE(full);
}

TEST(FifoLevels, WithoutATokenEveryCycleIsEmpty) {
  EXPECT_EQ(FifoLevels(3).cycles(7), (std::vector<Cycle>{7, 0, 0, 0}));
}

// A slot taken in the cycle in which the one before is freed: never two.
TEST(FifoLevels, ExchangeInOneCycleKeepsTheLevel) {
  EXPECT_EQ(levels_of({{0, 4}, {4, 6}}, 2, 8), (std::vector<Cycle>{2, 6, 0}));
}

// Some tokens that wait, then a run of tokens each freed in the cycle after it came, with gaps. The
// last waiting token is freed no later than the run's first token comes.
TEST(FifoLevels, RunThatFlowsFreelyCountsAsItsTokens) {
  for (uint32_t seed = 0; seed < 50; ++seed) {
    spec::Random random(seed);
    auto slots = random_slots(3, seed);
    FifoLevels at_once(3);
    at_once.begin_frame();
    for (const Slot& slot : slots) at_once.slot(slot.inserted, slot.freed);
    Cycle inserted = slots.back().freed + random.between(0, 2);
    for (int i = 0; i < 8; ++i, inserted += 1 + random.between(0, 2)) {
      slots.push_back({inserted, inserted + 1});
    }
    at_once.flow(8);
    const Cycle drained = slots.back().freed + 4;
    EXPECT_EQ(at_once.cycles(drained), counted(slots, 3, drained)) << "seed " << seed;
  }
}

TEST(FifoLevelsMutant, ReleaseACycleLaterIsNoticed) {
  const auto slots = random_slots(3, 1);
  auto later = slots;
  ++later.back().freed;
  const Cycle drained = slots.back().freed + 3;
  EXPECT_NE(levels_of(later, 3, drained), counted(slots, 3, drained));
}

}  // namespace
}  // namespace pineda::test
