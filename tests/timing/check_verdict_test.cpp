// What makes pineda check report a failure.
#include <gtest/gtest.h>

#include "cli/report/report.h"

namespace pineda::test {
namespace {

TEST(CheckVerdict, CyclesMoreThanATenthOfAPercentApartDoNotHold) {
  cli::CheckResult result;
  result.rtl.frame.cycles = 100'000;
  for (const timing::Cycle apart : {0, 1, 100}) {
    result.model.frame.cycles = 100'000 + apart;
    EXPECT_TRUE(result.holds()) << apart;
    result.model.frame.cycles = 100'000 - apart;
    EXPECT_TRUE(result.holds()) << apart;
  }
  for (const timing::Cycle cycles : {100'101, 99'899, 0}) {
    result.model.frame.cycles = cycles;
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
