// The line that a mismatch prints.
#include "model/spec/difference.h"

#include <gtest/gtest.h>

#include <vector>

namespace pineda::spec {
namespace {

constexpr Contract kContract = contract(kHighTile);

TEST(Difference, ValueIsHexOfItsWidthAndTheRealNumber) {
  EXPECT_EQ(value_text(39, 8, "px^2", -1), "0x7fffffffff (-0.00390625 px^2)");
  EXPECT_EQ(value_text(39, 8, "px^2", 256), "0x0000000100 (1 px^2)");
}

TEST(Difference, EqualStructsHaveNone) {
  SetupPrim prim;
  prim.edge[1].e = -77;
  EXPECT_FALSE(Comparer<SetupPrim>(kContract).difference(prim, prim).has_value());
}

TEST(Difference, NamesFieldAndElement) {
  SetupPrim expected;
  SetupPrim got;
  expected.edge[1].e = -1;
  const auto text = Comparer<SetupPrim>(kContract).difference(expected, got);
  ASSERT_TRUE(text.has_value());
  EXPECT_EQ(*text, "e[1]: expected 0x7fffffffff (-0.00390625 px^2), got 0x0000000000 (0 px^2)");
}

// Every element of every field is looked at: a change of any one of them is found.
TEST(Difference, NoFieldIsOverlooked) {
  const Comparer<Stamp> comparer(kContract);
  for (const auto& field : fields<Stamp>(kContract)) {
    for (int i = 0; i < field.count; ++i) {
      Stamp changed;
      field.set(kContract, changed, i, 1 - field.get(kContract, changed, i));
      const auto text = comparer.difference(Stamp{}, changed);
      ASSERT_TRUE(text.has_value()) << field.name;
      EXPECT_EQ(text->rfind(field.name, 0), 0u) << *text;
    }
  }
}

TEST(Difference, SequencesAreComparedInOrderAndToTheEnd) {
  const Comparer<DepthRead> comparer(kContract);
  DepthRead a;
  DepthRead b;
  b.x = 3;
  using Reads = std::vector<DepthRead>;
  EXPECT_FALSE(comparer.difference(Reads{a, b}, Reads{a, b}).has_value());
  const auto swapped = comparer.difference(Reads{a, b}, Reads{b, a});  // the same set
  ASSERT_TRUE(swapped.has_value());
  EXPECT_EQ(swapped->rfind("depth_read 0: x: ", 0), 0u) << *swapped;
  EXPECT_EQ(comparer.difference(Reads{a}, Reads{a, b}).value_or(""),
            "depth_read 1: expected the end, got one more");
  EXPECT_EQ(comparer.difference(Reads{a, b}, Reads{a}).value_or(""),
            "depth_read 1: expected one more, got the end");
}

}  // namespace
}  // namespace pineda::spec
