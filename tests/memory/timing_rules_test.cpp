// What every MemoryTiming promises, under random requests; and stalls.
#include <gtest/gtest.h>

#include <map>

#include "model/memory/kinds.h"
#include "model/memory/stalls.h"
#include "model/spec/random.h"
#include "tests/spec/names.h"

namespace pineda::memory {
namespace {

constexpr spec::Contract kContract = spec::contract(spec::kHighTile);

// The first rule that is broken in 20000 cycles of requests near one another; empty if none.
std::string broken_rule(MemoryTiming* timing, uint64_t seed) {
  timing->begin_frame({320, 200});
  spec::Random random(seed);
  Cycle last_response = -1;
  int x = 80;
  for (Cycle t = 0; t < 20000; ++t) {
    bool ready[kMemoryPorts];
    for (size_t p = 0; p < kMemoryPorts; ++p) {
      const Cycle from = timing->ready_from(static_cast<MemoryPort>(p), t);
      if (from < t) return "ready in the past";
      ready[p] = from == t;
    }
    for (size_t p = 0; p < kMemoryPorts; ++p) {
      if (!ready[p] || random.between(0, 3) == 0) continue;
      // What other ports request in this cycle has no effect yet.
      const auto port = static_cast<MemoryPort>(p);
      if (timing->ready_from(port, t) != t) return "not ready any more in the same cycle";
      x = (x + random.between(0, 8) + 156) % 160;
      const Cycle response = timing->accept(port, t, x, random.between(0, 99));
      if (port != MemoryPort::kDepthRead) continue;
      if (response <= t) return "a response before its time";
      if (response <= last_response) return "responses out of order";
      last_response = response;
    }
  }
  return last_response > 0 ? "" : "nothing was read";
}

TEST(MemoryTiming, KeepsItsRules) {
  for (const Kind kind : kKinds) {
    for (uint64_t seed = 0; seed < 8; ++seed) {
      EXPECT_EQ(broken_rule(make_timing(kind, kContract, 8).get(), seed), "")
          << spec::name_of(kind);
    }
  }
}

TEST(MemoryTiming, SameRequestsTakeTheSameTimeAgain) {
  for (const Kind kind : kKinds) {
    const auto timing = make_timing(kind, kContract, 8);
    const auto times = [&] {
      std::vector<Cycle> responses;
      timing->begin_frame({320, 200});
      spec::Random random(3);
      for (Cycle t = 0; responses.size() < 1000;) {
        t = timing->ready_from(MemoryPort::kDepthRead, t + 1);
        const int x = random.between(0, 159);
        responses.push_back(timing->accept(MemoryPort::kDepthRead, t, x, random.between(0, 99)));
      }
      return responses;
    };
    EXPECT_EQ(times(), times()) << spec::name_of(kind);
  }
}

// The mutant: a hit overtakes the miss before it.
class Overtaking final : public MemoryTiming {
 public:
  void begin_frame(const spec::FrameState&) override {}
  Cycle ready_from(MemoryPort, Cycle from) override { return from; }
  Cycle accept(MemoryPort, Cycle cycle, int x, int) override {
    return cycle + (x % 8 == 0 ? 20 : 3);
  }
};

TEST(MemoryTimingMutant, IsCaught) {
  Overtaking mutant;
  EXPECT_EQ(broken_rule(&mutant, 1), "responses out of order");
}

TEST(IdealTiming, LatencyOutsideItsRangeIsRefused) {
  EXPECT_THROW(make_timing(Kind::kIdeal, kContract, 0), std::invalid_argument);
  EXPECT_THROW(make_timing(Kind::kIdeal, kContract, 1025), std::invalid_argument);
  const auto longest = make_timing(Kind::kIdeal, kContract, 1024);
  EXPECT_EQ(longest->accept(MemoryPort::kDepthRead, 5, 0, 0), 1029);
}

TEST(Kinds, AreFoundByTheirNames) {
  for (const Kind kind : kKinds) EXPECT_EQ(spec::named<Kind>(spec::name_of(kind)), kind);
  EXPECT_FALSE(spec::named<Kind>("sram"));
}

TEST(Kinds, TablesOfNamesAreWholeAndInOrder) {
  EXPECT_EQ(spec::fault(kKindNames, Kind::kDramMerged), "");
  EXPECT_EQ(spec::fault(kStallModeNames, StallMode::kBoth), "");
  EXPECT_EQ(spec::fault(kMemoryPortNames, MemoryPort::kColorWrite), "");
  for (const StallMode mode : kStallModes) EXPECT_STRNE(stall_mode_name(mode), "");
}

TEST(Kinds, AreExplainedInOneLine) {
  EXPECT_EQ(kinds_text(),
            "ideal, dram (behind caches) or dram_merged (depth and colour on one channel)");
}

TEST(Stalls, OfAModeAreThoseOfItsSide) {
  const Port sources[] = {Port::kInput, Port::kTriangle, Port::kEnd};
  const Port sinks[] = {Port::kOutput, Port::kClear, stalling(MemoryPort::kDepthRead),
                        stalling(MemoryPort::kDepthWrite), stalling(MemoryPort::kColorWrite)};
  std::map<Port, int> stalled;
  for (Cycle cycle = 0; cycle < 4096; ++cycle) {
    for (const Port port : sources) {
      EXPECT_FALSE(Stalls(StallMode::kSink, 7)(port, cycle));
      stalled[port] += Stalls(StallMode::kSource, 7)(port, cycle) ? 1 : 0;
    }
    for (const Port port : sinks) {
      EXPECT_FALSE(Stalls(StallMode::kSource, 7)(port, cycle));
      stalled[port] += Stalls(StallMode::kSink, 7)(port, cycle) ? 1 : 0;
    }
  }
  ASSERT_EQ(stalled.size(), 8u);
  // 13 eighths of four draws.
  for (const auto& [port, cycles] : stalled) EXPECT_NEAR(cycles, 4096 * 13 / 32, 300);
}

}  // namespace
}  // namespace pineda::memory
