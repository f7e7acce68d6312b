#include "studies/cycles/compare_cycles.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "studies/cycles/child.h"

namespace pineda::studies {
namespace {

TEST(RetireErrors, NoneWhereEveryTriangleRetiresInItsCycle) {
  const std::vector<int64_t> cycles = {40, -1, 17, 90};
  const RetireErrors errors = retire_errors(cycles, cycles);
  EXPECT_EQ(errors.triangles, 3u);
  EXPECT_EQ(errors.off, 0u);
  EXPECT_EQ(errors.max, 0);
}

TEST(RetireErrors, EarlyAndLateCountAlikeAndTheWorstIsNamed) {
  std::vector<int64_t> rtl(200, 1000);
  std::vector<int64_t> model = rtl;
  model[7] = 996;
  model[150] = 1009;
  model[180] = 1002;
  const RetireErrors errors = retire_errors(model, rtl);
  EXPECT_EQ(errors.triangles, 200u);
  EXPECT_EQ(errors.off, 3u);
  EXPECT_EQ(errors.max, 9);
  EXPECT_EQ(errors.worst, 150u);
  EXPECT_EQ(errors.p99, 2);  // 198 of 200 are off by no more
}

// A triangle that only one side drew counts as off, also if it comes after the other side's last
// one.
TEST(RetireErrors, MissingTriangleIsOff) {
  EXPECT_EQ(retire_errors({5, -1}, {5, 8}).off, 1u);
  EXPECT_EQ(retire_errors({5}, {5, -1, 8}).worst, 2u);
  EXPECT_EQ(retire_errors({5, 6}, {5}).off, 1u);
}

CyclePoint equal_point() {
  CyclePoint point;
  point.model_cycles = point.rtl_cycles = 10000;
  point.same_frame = true;
  return point;
}

TEST(CyclePoint, MayBeOffWithinItsBoundsOnlyWhereSomethingStalls) {
  CyclePoint point = equal_point();
  EXPECT_FALSE(point.is_off());
  EXPECT_TRUE(point.holds(false));

  point.model_cycles = 10010;
  EXPECT_TRUE(point.is_off());
  EXPECT_FALSE(point.holds(false));
  EXPECT_TRUE(point.holds(true));
  point.model_cycles = 9989;
  EXPECT_FALSE(point.holds(true));

  point = equal_point();
  point.retire.off = 1;
  point.retire.max = 100;
  point.retire.p99 = 4;
  EXPECT_TRUE(point.is_off());
  EXPECT_FALSE(point.holds(false));
  EXPECT_TRUE(point.holds(true));
  point.retire.p99 = 5;
  EXPECT_FALSE(point.holds(true));
}

TEST(CyclePoint, CountersAndFrameMayNeverDiffer) {
  CyclePoint counters = equal_point();
  counters.counters_off = 1;
  CyclePoint frame = equal_point();
  frame.same_frame = false;
  for (const CyclePoint& point : {counters, frame}) {
    EXPECT_TRUE(point.is_off());
    EXPECT_FALSE(point.holds(false));
    EXPECT_FALSE(point.holds(true));
  }
}

TEST(Child, AnswersOrSaysWhy) {
  EXPECT_EQ(in_child([] { return 41 + 1; }), 42);
  try {
    in_child([]() -> int { throw std::runtime_error("no memory at hand"); });
    FAIL() << "nothing thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "no memory at hand");
  }
  EXPECT_THROW(in_child([]() -> int { _exit(0); }), std::runtime_error);
}

}  // namespace
}  // namespace pineda::studies
