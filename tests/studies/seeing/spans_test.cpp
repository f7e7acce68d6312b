// Joining what units and FIFOs report.
#include "studies/seeing/spans.h"

#include <gtest/gtest.h>

#include <vector>

#include "model/spec/random.h"

namespace pineda::test {
namespace {

using studies::FifoLevel;
using studies::Span;
using studies::SpanJoiner;
using studies::Window;
using timing::Cause;
using timing::Cycle;

class SpanJoining : public testing::Test {
 protected:
  void add(Cause cause, Cycle from, Cycle until, uint32_t id) {
    joiner_.add({cause, from, until, id}, window_, [this](const Span& s) { take(s); });
  }
  // "busy 2-5 of 7; ..."
  std::string joined() {
    joiner_.finish([this](const Span& s) { take(s); });
    return text_;
  }

  Window window_;

 private:
  void take(const Span& s) {
    text_ += timing::cause_name(s.cause) + (" " + std::to_string(s.from)) + "-" +
             std::to_string(s.until) + " of " + std::to_string(s.id) + "; ";
  }

  SpanJoiner joiner_;
  std::string text_;
};

TEST_F(SpanJoining, SingleCyclesBecomeOneSpan) {
  for (Cycle cycle = 2; cycle < 5; ++cycle) add(Cause::kBusy, cycle, cycle + 1, 7);
  EXPECT_EQ(joined(), "busy 2-5 of 7; ");
}

TEST_F(SpanJoining, FirstCycleOfTheFirstTriangleIsNotLost) {
  add(Cause::kBusy, 0, 1, 0);
  add(Cause::kBusy, 1, 2, 0);
  EXPECT_EQ(joined(), "busy 0-2 of 0; ");
}

TEST_F(SpanJoining, AnotherCauseTriangleOrAGapEndsASpan) {
  add(Cause::kBusy, 2, 3, 7);
  add(Cause::kBlocked, 3, 4, 7);
  add(Cause::kBlocked, 4, 5, 8);
  add(Cause::kBlocked, 6, 7, 8);
  EXPECT_EQ(joined(), "busy 2-3 of 7; blocked 3-4 of 7; blocked 4-5 of 8; blocked 6-7 of 8; ");
}

TEST_F(SpanJoining, WindowCutsOffWhatLiesOutside) {
  window_ = {10, 20};
  add(Cause::kBusy, 0, 10, 1);
  add(Cause::kBlocked, 8, 12, 2);
  add(Cause::kBusy, 19, 25, 3);
  add(Cause::kBusy, 25, 30, 3);
  EXPECT_EQ(joined(), "blocked 10-12 of 2; busy 19-20 of 3; ");
}

struct Level {
  Cycle cycle;
  int level;
};
bool operator==(const Level& a, const Level& b) { return a.cycle == b.cycle && a.level == b.level; }
std::ostream& operator<<(std::ostream& to, const Level& l) {
  return to << l.cycle << ":" << l.level;
}

struct Slot {
  Cycle inserted;
  Cycle freed;
};

std::vector<Level> levels_of(const std::vector<Slot>& slots) {
  std::vector<Level> levels;
  const auto changed = [&](Cycle cycle, int level) { levels.push_back({cycle, level}); };
  FifoLevel fifo;
  for (const Slot& slot : slots) fifo.slot(slot.inserted, slot.freed, changed);
  fifo.finish(changed);
  return levels;
}

TEST(FifoLevels, CountFromTheCycleAfterTheInsertion) {
  EXPECT_EQ(levels_of({{3, 5}}), (std::vector<Level>{{4, 1}, {6, 0}}));
}

TEST(FifoLevels, InsertionAndReleaseInOneCycleChangeNothing) {
  EXPECT_EQ(levels_of({{3, 5}, {5, 7}}), (std::vector<Level>{{4, 1}, {8, 0}}));
}

// Random slots of a FIFO of four: the level at each cycle as one counts it slot by slot.
TEST(FifoLevels, AreThoseOfACountCycleByCycle) {
  constexpr size_t kDepth = 4;
  spec::Random random(1);
  std::vector<Slot> slots;
  for (size_t i = 0; i < 500; ++i) {
    const Cycle room = i < kDepth ? 0 : slots[i - kDepth].freed + 1;
    const Cycle after = i == 0 ? 0 : slots[i - 1].inserted + 1;
    const Cycle inserted = std::max(room, after) + random.between(0, 3);
    const Cycle free = i == 0 ? 0 : slots[i - 1].freed + 1;
    slots.push_back({inserted, std::max(inserted + 1, free) + random.between(0, 3)});
  }
  std::vector<Level> counted;
  int last = 0;
  for (Cycle cycle = 0; cycle <= slots.back().freed + 1; ++cycle) {
    int level = 0;
    for (const Slot& slot : slots) level += slot.inserted < cycle && cycle <= slot.freed ? 1 : 0;
    if (level != last) counted.push_back({cycle, level});
    last = level;
  }
  EXPECT_EQ(levels_of(slots), counted);
  EXPECT_GT(counted.size(), 300);
}

}  // namespace
}  // namespace pineda::test
