// The comparisons must see every wrong bit, and say where it is.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "model/spec/difference.h"
#include "model/spec/pack.h"
#include "tests/vectors/samples.h"

namespace pineda::vectors {
namespace {

// Flips each bit of the last element of `outputs` in turn; the case's difference must name it.
template <class Case, class T>
void expect_every_bit_seen(const Case& expected, std::vector<T> Case::*outputs) {
  const spec::Packer<T> packer(kContract);
  ASSERT_FALSE((expected.*outputs).empty());
  int position = packer.bits();
  for (const auto& field : packer.table()) {
    for (int bit = 0; bit < field.bits * field.count; ++bit) {
      Case got = expected;
      auto words = packer.pack((got.*outputs).back());
      const int at = position - field.bits * field.count + bit;
      spec::set_bits(words.data(), at, 1, ~spec::get_bits(words.data(), at, 1));
      (got.*outputs).back() = packer.unpack(words.data());
      const auto text = difference(kContract, expected, got);
      ASSERT_TRUE(text) << field.name << " bit " << bit;
      EXPECT_NE(text->find(std::string(": ") + field.name), std::string::npos) << *text;
    }
    position -= field.bits * field.count;
  }
}

TEST(Mutant, EveryBitOfASetupPrimIsSeen) {
  expect_every_bit_seen(sample_case<SetupCase>(), &SetupCase::out);
}
TEST(Mutant, EveryBitOfAStampIsSeen) {
  expect_every_bit_seen(sample_case<TraversalCase>(), &TraversalCase::out);
}
TEST(Mutant, EveryBitOfADepthWriteIsSeen) {
  expect_every_bit_seen(sample_case<InterpZtestCase>(), &InterpZtestCase::depth);
}
TEST(Mutant, EveryBitOfAColorWriteIsSeen) {
  expect_every_bit_seen(sample_case<InterpZtestCase>(), &InterpZtestCase::color);
}

TEST(Mutant, MessageNamesUnitCaseFieldHexAndRealValue) {
  SetupCase expected = sample_case<SetupCase>();
  ASSERT_EQ(expected.out.size(), 2u);
  expected.out[1].edge[2].e = -1;
  SetupCase got = expected;
  got.out[1].edge[2].e = 1 << 9;
  EXPECT_EQ(difference(kContract, expected, got).value_or("none"),
            "setup case sample.0: setup_prim 1: e[2]: expected 0x7fffffffff (-0.00390625 px^2), "
            "got 0x0000000200 (2 px^2)");
}

TEST(Mutant, SwappedLostAndExtraStampsAreSeen) {
  const auto expected = sample_case<TraversalCase>();
  ASSERT_GT(expected.out.size(), 3u);
  TraversalCase swapped = expected;
  std::swap(swapped.out[0], swapped.out[1]);
  EXPECT_NE(difference(kContract, expected, swapped).value_or("").find("stamp 0: x: expected"),
            std::string::npos);
  TraversalCase lost = expected;
  lost.out.pop_back();
  const std::string last = std::to_string(lost.out.size());
  EXPECT_EQ(difference(kContract, expected, lost).value_or("none"),
            "traversal case sample.0: stamp " + last + ": expected one more, got the end");
  EXPECT_EQ(difference(kContract, lost, expected).value_or("none"),
            "traversal case sample.0: stamp " + last + ": expected the end, got one more");
}

TEST(Mutant, WrongMissingAndExtraDropsAreSeen) {
  const auto expected = sample_case<SetupCase>();
  SetupCase got = expected;
  got.drops[1] = core::Drop::kFacing;
  EXPECT_EQ(difference(kContract, expected, got).value_or("none"),
            "setup case sample.0: triangle 1: expected zero area, got facing");
  got.drops = {core::Drop::kNone};
  EXPECT_TRUE(difference(kContract, expected, got));
  got.drops = expected.drops;
  got.drops.push_back(core::Drop::kNone);
  EXPECT_TRUE(difference(kContract, expected, got));
}

TEST(Mutant, EveryMemoryAndCounterOfAFrameIsSeen) {
  const auto expected = sample_case<FrameCase>();
  const auto text = [&](const FrameCase& got) {
    return difference(kContract, expected, got).value_or("none");
  };
  EXPECT_EQ(text(expected), "none");
  FrameCase got = expected;
  const Sample first = expected.samples.front(), last = expected.samples.back();
  got.samples.front().depth ^= 1;
  EXPECT_EQ(text(got).find(fmt::format("frame case sample.0: sample ({}, {}): depth: expected 0x",
                                       first.x, first.y)),
            0u)
      << text(got);
  got = expected;
  got.samples.back().color[3] ^= 0x80;
  EXPECT_EQ(text(got).find(fmt::format("frame case sample.0: sample ({}, {}): color[3]: expected",
                                       last.x, last.y)),
            0u)
      << text(got);
  got = expected;
  ++got.samples[8].hits;
  EXPECT_NE(text(got).find("): hits: expected 0x"), std::string::npos) << text(got);
  got = expected;
  got.samples.pop_back();
  EXPECT_EQ(text(got), fmt::format("frame case sample.0: sample ({}, {}): expected to be drawn, "
                                   "got as cleared",
                                   last.x, last.y));
  got = expected;
  got.samples.insert(got.samples.begin(), Sample{first.x - 1, first.y, 0, {}, 1});
  EXPECT_EQ(text(got), fmt::format("frame case sample.0: sample ({}, {}): expected as cleared, "
                                   "got drawn",
                                   first.x - 1, first.y));
  for (const Counter& counter : counters()) {
    got = expected;
    ++counter.row->of(got.counters);
    EXPECT_NE(text(got).find("counter " + counter.name), std::string::npos);
  }
}

TEST(ValueText, FillsTheFieldsDigitsAndDividesByItsFraction) {
  EXPECT_EQ(spec::value_text(1, 0, "", 1), "0x1 (1)");
  EXPECT_EQ(spec::value_text(44, 18, "code/px", -(int64_t{1} << 43)),
            "0x80000000000 (-33554432 code/px)");
  EXPECT_EQ(spec::value_text(64, 0, "", -1), "0xffffffffffffffff (-1)");
}

TEST(Comparer, FirstFieldInTheTablesOrderIsNamed) {
  spec::SetupPrim expected;
  spec::SetupPrim got;
  EXPECT_EQ(spec::difference(kContract, expected, got), std::nullopt);
  got.planes.z.dx = 1;
  got.edge[1].b = 128;
  EXPECT_EQ(spec::difference(kContract, expected, got).value_or("none"),
            "b[1]: expected 0x000000 (0 px), got 0x000080 (0.5 px)");
}

}  // namespace
}  // namespace pineda::vectors
