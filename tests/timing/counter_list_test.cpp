// Counters by name, and what makes pineda check say no.
#include "model/timing/counter_list.h"

#include <gtest/gtest.h>

#include <set>

#include "cli/report/report.h"

namespace pineda::test {
namespace {

const spec::Contract kWide = spec::contract(*spec::find_design("wide"));  // stamps of 16 samples

// Every counter of a frame holds another value.
timing::CycleCounters distinct_cycles(int64_t from) {
  timing::CycleCounters spent;
  spent.drained = from++;
  for (auto& unit : spent.units) {
    for (auto& cycles : unit.spent) cycles = from++;
  }
  for (auto& levels : spent.levels) levels = {from++, from++, from++};
  for (auto& cycles : spent.port_stalls) cycles = from++;
  for (auto& stamps : spent.stamps_by_samples) stamps = static_cast<uint64_t>(from++);
  spent.samples_passed = static_cast<uint64_t>(from++);
  spent.samples_failed = static_cast<uint64_t>(from);
  return spent;
}

core::FrameCounters distinct_counters() {
  core::FrameCounters n;
  n.triangles = 1001;
  n.dropped = {1002, 1003, 1004, 1005, 1006};
  n.tiles_tested = 1007;
  n.tiles_rejected = 1008;
  n.tiles_accepted = 1009;
  n.tiles_hidden = 1010;
  n.stamps = 1011;
  n.fragments = 1012;
  n.interpolated = 1013;
  n.passed = 1014;
  return n;
}

TEST(CounterList, HoldsEveryCounterOnceUnderANameOfItsOwn) {
  const auto list = timing::counter_list(kWide, distinct_cycles(1), distinct_counters());
  std::set<std::string> names;
  std::set<int64_t> counts;
  for (const auto& [name, count] : list) {
    names.insert(name);
    counts.insert(count);
  }
  EXPECT_EQ(names.size(), list.size());
  EXPECT_EQ(counts.size(), list.size());
  // 1 + 4 units * 5 causes + 3 FIFOs * 3 levels + 3 ports + 17 stamps + 2, and 14 of the frame.
  EXPECT_EQ(list.size(), 52u + 14u);
  EXPECT_EQ(*counts.begin(), 1);
  EXPECT_EQ(*counts.rbegin(), 1014);
}

TEST(CounterList, TheOneThatDiffersIsNamedWithBothCounts) {
  auto rtl = distinct_cycles(1);
  rtl.units[0][timing::Cause::kBlocked] = -7;
  const auto model = timing::counter_list(kWide, distinct_cycles(1), distinct_counters());
  const auto differences =
      timing::counter_differences(model, timing::counter_list(kWide, rtl, distinct_counters()));
  ASSERT_EQ(differences.size(), 1u);
  EXPECT_EQ(differences[0].name, "setup.blocked");
  EXPECT_EQ(differences[0].model, 4);
  EXPECT_EQ(differences[0].rtl, -7);
  EXPECT_TRUE(timing::counter_differences(model, model).empty());
}

TEST(CounterList, OfAnotherDesignIsRefused) {
  auto deeper = distinct_cycles(1);
  deeper.levels[0].push_back(0);
  const auto list = timing::counter_list(kWide, distinct_cycles(1), {});
  EXPECT_THROW(timing::counter_differences(list, timing::counter_list(kWide, deeper, {})),
               std::invalid_argument);
}

TEST(CheckVerdict, CyclesMoreThanATenthOfAPercentApartDoNotHold) {
  cli::CheckResult result;
  result.rtl.cycles = 100'000;
  for (const uint64_t apart : {0u, 1u, 100u}) {
    result.model.cycles = 100'000 + apart;
    EXPECT_TRUE(result.holds()) << apart;
    result.model.cycles = 100'000 - apart;
    EXPECT_TRUE(result.holds()) << apart;
  }
  for (const uint64_t cycles : {100'101u, 99'899u, 0u}) {
    result.model.cycles = cycles;
    EXPECT_FALSE(result.holds()) << cycles;
  }
}

TEST(CheckVerdict, OneCounterThatDiffersDoesNotHold) {
  cli::CheckResult result;
  EXPECT_TRUE(result.holds());
  result.counters_differ.push_back({"stamps.busy", 1, 2});
  EXPECT_FALSE(result.holds());
}

}  // namespace
}  // namespace pineda::test
