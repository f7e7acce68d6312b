// Bands of tile rows: a triangle in parts has the bits of the whole.
#include <gtest/gtest.h>

#include "model/spec/difference.h"
#include "tests/core/support.h"

namespace pineda::test {
namespace {

std::vector<spec::Stamp> stamps_of(const spec::SetupPrim& prim) {
  std::vector<spec::Stamp> stamps;
  core::for_each_stamp(kContract, prim, [&](const spec::Stamp& stamp) { stamps.push_back(stamp); });
  return stamps;
}

// Stamps of the bands of `rows` tile rows, one band after the other.
std::vector<spec::Stamp> banded_stamps_of(const spec::SetupPrim& prim, int rows) {
  std::vector<spec::Stamp> all;
  const int last_row = (kWindow.height - 1) >> kContract.design.tile_log2;
  for (int first = 0; first <= last_row; first += rows) {
    spec::SetupPrim part = prim;
    if (!core::clip_rows(kContract, first, first + rows - 1, &part)) continue;
    const auto stamps = stamps_of(part);
    all.insert(all.end(), stamps.begin(), stamps.end());
  }
  return all;
}

TEST(ClipRows, BandsTogetherSendTheStampsOfTheWhole) {
  Random random(61);
  int compared = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto shape = static_cast<Shape>(random.between(1, 4));
    const spec::Triangle t = random_triangle(random, shape);
    spec::SetupPrim prim;
    if (core::setup(kContract, kWindow, t, &prim) != core::Drop::kNone) continue;
    const auto whole = stamps_of(prim);
    for (const int rows : {1, 2, 4}) {
      const auto text = spec::difference(kContract, whole, banded_stamps_of(prim, rows));
      ASSERT_FALSE(text) << "triangle " << i << ", bands of " << rows << ": " << *text;
    }
    compared += whole.empty() ? 0 : 1;
  }
  EXPECT_GT(compared, 500);
}

TEST(ClipRows, NothingIsLeftOutsideTheBox) {
  spec::SetupPrim prim;
  const auto t = triangle({0, 20 * kPx}, {30 * kPx, 20 * kPx}, {0, 30 * kPx});
  ASSERT_EQ(core::setup(kContract, kWindow, t, &prim), core::Drop::kNone);
  EXPECT_FALSE(core::clip_rows(kContract, 0, 1, &prim));
  EXPECT_FALSE(core::clip_rows(kContract, 4, 5, &prim));
  EXPECT_TRUE(core::clip_rows(kContract, 0, 1 << 16, &prim));
}

// The mutant: edges that are not moved from the triangle's first tile to the band's are noticed.
TEST(ClipRows, EdgesLeftWhereTheyWereAreCaught) {
  spec::SetupPrim prim;
  const auto t = triangle({0, 0}, {60 * kPx, 0}, {0, 40 * kPx});
  ASSERT_EQ(core::setup(kContract, kWindow, t, &prim), core::Drop::kNone);
  spec::SetupPrim part = prim;
  ASSERT_TRUE(core::clip_rows(kContract, 2, 3, &part));
  const auto right = stamps_of(part);
  part.edge = prim.edge;
  EXPECT_TRUE(spec::difference(kContract, right, stamps_of(part)));
}

}  // namespace
}  // namespace pineda::test
