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

TEST_F(SetupTiming, TriangleEveryIntervalDroppedOnesToo) {
  Source source({good_, good_, bad_, bad_, good_}, {2, 0, 0, 0, 50});
  Sink sink({0, 0, 0});
  run(&source, &sink);
  EXPECT_EQ(source.taken, (Cycles{2, 8, 14, 20, 50}));
  EXPECT_EQ(sink.offered, (Cycles{29, 35, 77}));
  EXPECT_EQ(setup_.idle_from(), 78);
  const auto cycles = setup_.cycles(78);
  EXPECT_EQ(cycles[Cause::kBusy], 5 * 6);
  EXPECT_EQ(cycles[Cause::kBlocked], 0);
  EXPECT_EQ(cycles[Cause::kStarved], 2 + 24 + 22);
}

// While a triangle is inside, the next one is taken a multiple of 6 cycles later.
TEST_F(SetupTiming, TriangleWaitsForItsTurn) {
  Source source({good_, good_, good_, good_}, {2, 9, 15, 49});
  Sink sink({0, 0, 0, 0});
  run(&source, &sink);
  EXPECT_EQ(source.taken, (Cycles{2, 14, 20, 49}));  // the third one has left in 47
  EXPECT_EQ(setup_.cycles(77)[Cause::kBusy], 4 * 6);
}

// The first output waits from 29 to 38: 9 cycles. Four triangles were accepted before; the sixth is
// accepted 9 cycles later, and all other outputs are also 9 cycles later.
TEST_F(SetupTiming, OutputNotTakenFreezesTheWholeUnit) {
  Source source({good_, good_, good_, good_, good_, good_}, {2, 0, 0, 0, 0, 0});
  Sink sink({38, 0, 0, 0, 0, 0});
  run(&source, &sink);
  EXPECT_EQ(source.taken, (Cycles{2, 8, 14, 20, 26, 41}));
  EXPECT_EQ(sink.offered, (Cycles{29, 44, 50, 56, 62, 68}));
  EXPECT_EQ(setup_.cycles(69)[Cause::kBlocked], 9);
}

// It is empty in the cycle after.
TEST_F(SetupTiming, TriangleThatComesDuringAFreezeIsTakenAfterIt) {
  Source source({good_, good_}, {2, 33});
  Sink sink({38, 0});
  run(&source, &sink);
  EXPECT_EQ(source.taken, (Cycles{2, 39}));
  EXPECT_EQ(sink.offered, (Cycles{29, 66}));
}

TEST_F(SetupTiming, TriangleThatComesInTheFirstCycleOfAFreezeIsTakenAfterIt) {
  Source source({good_, good_}, {2, 29});
  Sink sink({38, 0});
  run(&source, &sink);
  EXPECT_EQ(source.taken, (Cycles{2, 39}));
}

TEST_F(SetupTiming, TriangleThatComesInTheLastTurnBeforeAFreezeIsTaken) {
  Source source({good_, good_}, {2, 26});
  Sink sink({38, 0});
  run(&source, &sink);
  EXPECT_EQ(source.taken, (Cycles{2, 26}));
  EXPECT_EQ(sink.offered, (Cycles{29, 62}));
}

// Two freezes end before the third triangle comes.
TEST_F(SetupTiming, FreezesAddUp) {
  Source source({good_, good_, good_, good_}, {2, 0, 100, 0});
  Sink sink({38, 60, 0, 0});
  run(&source, &sink);
  EXPECT_EQ(source.taken, (Cycles{2, 8, 100, 106}));
  EXPECT_EQ(sink.offered, (Cycles{29, 44, 127, 133}));
  EXPECT_EQ(setup_.cycles(134)[Cause::kBlocked], 9 + 16);
  EXPECT_EQ(setup_.cycles(134)[Cause::kBusy], 24);
}

}  // namespace
}  // namespace pineda::test
