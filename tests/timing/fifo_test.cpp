// TimedFifo between a producer and a consumer with scripted times, cycles worked by hand.
#include <gtest/gtest.h>

#include "model/timing/units/stream.h"

namespace pineda::test {
namespace {

using timing::Cycle;

// Offers token i from offers[i] on, but never two in a cycle; takes token i from takes[i] on.
class Bench final : public sc_core::sc_module, public timing::StreamIn<size_t> {
 public:
  Bench(sc_core::sc_module_name name, int depth, std::vector<Cycle> offered,
        std::vector<Cycle> wanted)
      : sc_module(name),
        offers(std::move(offered)),
        takes(std::move(wanted)),
        fifo_("fifo", timing::Fifo::kPrims, depth) {
    fifo_.out_o(*this);
  }

  void run() {
    sc_core::sc_start(sc_core::SC_ZERO_TIME);
    fifo_.begin_frame(nullptr);
    Cycle earliest = 0;
    for (size_t i = 0; i < offers.size(); ++i) {
      pushed.push_back(fifo_.push(i, std::max(earliest, offers[i])));
      earliest = pushed.back() + 1;
    }
  }
  Cycle take(const size_t& token, Cycle visible) override {
    tokens.push_back(token);
    const Cycle earliest = popped.empty() ? 0 : popped.back() + 1;
    popped.push_back(std::max({earliest, visible, takes[popped.size()]}));
    return popped.back();
  }

  std::vector<Cycle> offers, takes, pushed, popped;
  std::vector<size_t> tokens;

 private:
  timing::TimedFifo<size_t> fifo_;
};

using Cycles = std::vector<Cycle>;

TEST(TimedFifo, PushedInOneCycleIsSeenInTheNext) {
  Bench bench("bench", 4, {0, 1, 7}, {0, 0, 0});
  bench.run();
  EXPECT_EQ(bench.pushed, (Cycles{0, 1, 7}));
  EXPECT_EQ(bench.popped, (Cycles{1, 2, 8}));
  EXPECT_EQ(bench.tokens, (std::vector<size_t>{0, 1, 2}));
}

TEST(TimedFifo, SlotFreedInOneCycleIsUsableInTheNext) {
  Bench bench("bench", 2, {0, 0, 0, 0}, {10, 10, 10, 10});
  bench.run();
  EXPECT_EQ(bench.pushed, (Cycles{0, 1, 11, 12}));
  EXPECT_EQ(bench.popped, (Cycles{10, 11, 12, 13}));
}

TEST(TimedFifo, OneSlotHalvesTheRate) {
  Bench bench("bench", 1, {0, 0, 0}, {0, 0, 0});
  bench.run();
  EXPECT_EQ(bench.pushed, (Cycles{0, 2, 4}));
  EXPECT_EQ(bench.popped, (Cycles{1, 3, 5}));
}

TEST(TimedFifo, TwoSlotsKeepTheRate) {
  Bench bench("bench", 2, {5, 0, 0, 0}, {0, 0, 0, 0});
  bench.run();
  EXPECT_EQ(bench.pushed, (Cycles{5, 6, 7, 8}));
  EXPECT_EQ(bench.popped, (Cycles{6, 7, 8, 9}));
}

// The consumer is simulated much later, yet the producer learns the exact cycle of each release.
TEST(TimedFifo, LateConsumerPushesBackToTheCycle) {
  Bench bench("bench", 2, {0, 0, 0, 500}, {100, 0, 300, 0});
  bench.run();
  EXPECT_EQ(bench.pushed, (Cycles{0, 1, 101, 500}));
  EXPECT_EQ(bench.popped, (Cycles{100, 101, 300, 501}));
}

}  // namespace
}  // namespace pineda::test
