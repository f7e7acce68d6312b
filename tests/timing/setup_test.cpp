// SetupUnit between a scripted source and a scripted sink, cycles worked by hand. A triangle takes
// 12 cycles and its output comes 19 after it.
#include <gtest/gtest.h>

#include "tests/timing/support.h"

namespace pineda::test {
namespace {

using Cycles = std::vector<Cycle>;

// Offers triangle i from cycles[i] on.
struct Source {
  Source(std::vector<spec::Triangle> tokens, Cycles cycles)
      : triangles(std::move(tokens)), offers(std::move(cycles)) {}

  std::vector<spec::Triangle> triangles;
  Cycles offers, taken;
};

// Takes token i from takes[i] on.
class Sink final : public timing::StreamOut<spec::SetupPrim> {
 public:
  explicit Sink(Cycles cycles) : takes(std::move(cycles)) {}
  Cycle push(const spec::SetupPrim&, Cycle earliest) override {
    offered.push_back(earliest);
    return std::max(earliest, takes[offered.size() - 1]);
  }

  Cycles takes, offered;
};

class SetupTiming : public testing::Test {
 protected:
  void run(Source* source, Sink* sink) {
    frame_.state.width = frame_.state.height = 16;
    setup_.prim_o(*sink);
    sc_core::sc_start(sc_core::SC_ZERO_TIME);
    setup_.begin_frame(&frame_);
    for (size_t i = 0; i < source->triangles.size(); ++i) {
      source->taken.push_back(setup_.take(source->triangles[i], source->offers[i]));
    }
  }

  const spec::Triangle good_ = flat_triangle(0, 0, 8, 0, 0, 8);
  const spec::Triangle bad_ = flat_triangle(0, 0, 4, 4, 8, 8);  // zero area
  timing::Frame frame_;
  timing::SetupUnit setup_{"setup", kContract};
};

TEST_F(SetupTiming, TriangleEveryIntervalAndDroppedOnesEveryFive) {
  Source source({good_, good_, bad_, bad_, good_}, {2, 0, 0, 0, 50});
  Sink sink({0, 0, 0});
  run(&source, &sink);
  EXPECT_EQ(source.taken, (Cycles{2, 14, 26, 31, 50}));
  EXPECT_EQ(sink.offered, (Cycles{21, 33, 69}));
  EXPECT_EQ(setup_.idle_from(), 70);
  const auto cycles = setup_.cycles(70);
  EXPECT_EQ(cycles[Cause::kBusy], 3 * 12 + 2 * 5);
  EXPECT_EQ(cycles[Cause::kBlocked], 0);
  EXPECT_EQ(cycles[Cause::kStarved], 2 + 14 + 8);
}

// The first output waits from 21 to 30: 9 cycles. The second triangle was accepted before; the
// third is accepted 9 cycles later, and the second output is also 9 cycles later.
TEST_F(SetupTiming, OutputNotTakenFreezesTheWholeUnit) {
  Source source({good_, good_, good_}, {2, 0, 0});
  Sink sink({30, 0, 0});
  run(&source, &sink);
  EXPECT_EQ(source.taken, (Cycles{2, 14, 35}));
  EXPECT_EQ(sink.offered, (Cycles{21, 42, 54}));
  EXPECT_EQ(setup_.cycles(55)[Cause::kBlocked], 9);
}

TEST_F(SetupTiming, TriangleThatComesDuringAFreezeIsTakenAsItEnds) {
  Source source({good_, good_}, {2, 25});
  Sink sink({30, 0});
  run(&source, &sink);
  EXPECT_EQ(source.taken, (Cycles{2, 30}));
  EXPECT_EQ(sink.offered, (Cycles{21, 49}));
}

TEST_F(SetupTiming, TriangleThatComesInTheFirstCycleOfAFreezeIsTakenAsItEnds) {
  Source source({good_, good_}, {2, 21});
  Sink sink({30, 0});
  run(&source, &sink);
  EXPECT_EQ(source.taken, (Cycles{2, 30}));
}

TEST_F(SetupTiming, TriangleThatComesInTheLastCycleBeforeAFreezeIsTaken) {
  Source source({good_, good_}, {2, 20});
  Sink sink({30, 0});
  run(&source, &sink);
  EXPECT_EQ(source.taken, (Cycles{2, 20}));
  EXPECT_EQ(sink.offered, (Cycles{21, 48}));
}

// Two freezes end before the third triangle comes.
TEST_F(SetupTiming, FreezesAddUp) {
  Source source({good_, good_, good_, good_}, {2, 0, 100, 0});
  Sink sink({30, 50, 0, 0});
  run(&source, &sink);
  EXPECT_EQ(source.taken, (Cycles{2, 14, 100, 112}));
  EXPECT_EQ(sink.offered, (Cycles{21, 42, 119, 131}));
  EXPECT_EQ(setup_.cycles(132)[Cause::kBlocked], 9 + 8);
  EXPECT_EQ(setup_.cycles(132)[Cause::kBusy], 48);
}

}  // namespace
}  // namespace pineda::test
