// Bursts worked by hand: from command to data it takes 6 cycles in an open row, 11 in a closed
// bank, 17 with another row open; two banks (even and odd rows), a refresh of 50 cycles every 1000.
#include "model/memory/dram_channel.h"

#include <gtest/gtest.h>

namespace pineda::memory {
namespace {

DramParameters parameters() {
  DramParameters p;
  p.banks = 2;
  p.refresh_interval_cycles = 1000;
  p.refresh_cycles = 50;
  return p;
}

TEST(DramChannel, FirstBurstOpensARow) {
  DramChannel channel(parameters());
  EXPECT_EQ(channel.serve(10, 0, 16), 10 + 11 + 16);
  EXPECT_EQ(channel.counters().row_misses, 1u);
  EXPECT_EQ(channel.counters().busy, 16);
}

// The second burst's command is sent in 21, when the first data come; the bus is free in 37.
TEST(DramChannel, RowHitsFollowWithoutAGap) {
  DramChannel channel(parameters());
  channel.serve(10, 0, 16);
  EXPECT_EQ(channel.serve(10, 0, 16), 37 + 16);
  EXPECT_EQ(channel.serve(10, 0, 16), 53 + 16);
  EXPECT_EQ(channel.counters().row_hits, 2u);
}

// Bursts of 4 take less time than a command takes to its data: 21 + 6 + 4.
TEST(DramChannel, ShortBurstsWaitForTheCommand) {
  DramChannel channel(parameters());
  EXPECT_EQ(channel.serve(10, 0, 4), 25);
  EXPECT_EQ(channel.serve(10, 0, 4), 31);
}

TEST(DramChannel, AnotherRowOfABankOpensWhenItsBurstIsOver) {
  DramChannel channel(parameters());
  channel.serve(10, 0, 16);
  EXPECT_EQ(channel.serve(10, 2, 16), 37 + 17 + 16);
  EXPECT_EQ(channel.counters().row_conflicts, 1u);
}

// With a command in 21 the data could come in 32, but the bus is free only in 37.
TEST(DramChannel, AnotherBankOpensUnderTheDataOfTheFirst) {
  DramChannel channel(parameters());
  channel.serve(10, 0, 16);
  EXPECT_EQ(channel.serve(10, 1, 16), 37 + 16);
  EXPECT_EQ(channel.counters().row_misses, 2u);
}

TEST(DramChannel, RefreshDelaysAndClosesTheRows) {
  DramChannel channel(parameters());
  channel.serve(900, 0, 16);
  EXPECT_EQ(channel.serve(1010, 0, 16), 1050 + 11 + 16);
  EXPECT_EQ(channel.counters().refresh_wait, 40);
  EXPECT_EQ(channel.serve(1200, 0, 16), 1200 + 6 + 16);   // after the refresh
  EXPECT_EQ(channel.serve(2100, 0, 16), 2100 + 11 + 16);  // a refresh in between closed the row
  EXPECT_EQ(channel.counters().refresh_wait, 40);
}

TEST(DramChannel, BurstOrderedBeforeARefreshIsFinished) {
  DramChannel channel(parameters());
  EXPECT_EQ(channel.serve(999, 0, 16), 999 + 11 + 16);
  // The next command would be sent in 1010, in the refresh.
  EXPECT_EQ(channel.serve(1000, 0, 16), 1050 + 11 + 16);
}

TEST(DramChannel, NoRefreshIsDueInCycleZero) {
  DramChannel channel(parameters());
  EXPECT_EQ(channel.serve(0, 0, 16), 0 + 11 + 16);
}

TEST(DramParameters, SayWhyTheyCannotBe) {
  EXPECT_EQ(invalid_reason({}), "");
  const auto reason = [](auto member, int value) {
    DramParameters p;
    p.*member = value;
    return invalid_reason(p);
  };
  EXPECT_NE(reason(&DramParameters::banks, 0), "");
  EXPECT_NE(reason(&DramParameters::bus_bytes, 0), "");
  EXPECT_NE(reason(&DramParameters::row_hit_cycles, 12), "");
  EXPECT_NE(reason(&DramParameters::row_conflict_cycles, 10), "");
  EXPECT_NE(reason(&DramParameters::refresh_cycles, 3120), "");
  EXPECT_NE(reason(&DramParameters::set_rows_log2, -1), "");
  EXPECT_NE(reason(&DramParameters::ways, 1), "");
  EXPECT_NE(reason(&DramParameters::hit_latency_cycles, 0), "");
}

}  // namespace
}  // namespace pineda::memory
