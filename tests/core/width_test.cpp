// Every field of every struct fits the width that the contract declares, at the format's extremes.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "model/spec/fields.h"
#include "tests/core/support.h"

namespace pineda::test {
namespace {

bool fits(int64_t value, bool is_signed, int bits) {
  if (is_signed) return spec::wrap(value, bits) == value;
  return value >= 0 && (bits >= 63 || value < int64_t{1} << bits);
}

// Name and value of the first field that does not fit; empty when all do.
template <class T>
std::string misfit(const spec::Contract& c, const T& value) {
  for (const auto& field : spec::fields<T>(c)) {
    for (int i = 0; i < field.count; ++i) {
      const int64_t v = field.get(c, value, i);
      if (!fits(v, field.is_signed, field.bits)) {
        return std::string(field.name) + " = " + std::to_string(v);
      }
    }
  }
  return {};
}

// Calls visit(triangle) for all corner combinations: each vertex in a corner of the guard band, in
// the middle of a side or in the centre, each with depth and attributes at either extreme.
template <class Visitor>
void for_each_extreme(Visitor&& visit) {
  static constexpr std::array<int, 3> kAt{kGuardLow, 0, kGuardHigh};
  for (int corners = 0; corners < 9 * 9 * 9; ++corners) {
    for (int values = 0; values < 8; ++values) {
      const auto at = [](int place) {
        return Point{kAt[static_cast<size_t>(place % 3)], kAt[static_cast<size_t>(place / 3)]};
      };
      spec::Triangle t = triangle(at(corners % 9), at(corners / 9 % 9), at(corners / 81));
      t.id = 0xffffffff;
      for (size_t i = 0; i < 3; ++i) {
        const bool high = (values >> i & 1) != 0;
        t.v[i].z = high ? kMaxDepthInput : 0;
        t.v[i].attr.fill(high ? 255 : 0);
      }
      visit(t);
    }
  }
}

TEST(FormatExtremes, EverySetupFieldFitsAtAllCornerCombinations) {
  int drawn = 0;
  for_each_extreme([&](const spec::Triangle& t) {
    spec::SetupPrim prim;
    if (core::setup(kContract, kHugeFrame, t, &prim) != core::Drop::kNone) return;
    ASSERT_EQ(misfit(kContract, t), "");
    ASSERT_EQ(misfit(kContract, prim), "");
    ++drawn;
  });
  EXPECT_GT(drawn, 2000);
}

// E' at the four corner samples of the greatest frame, where a plane has its extremes.
TEST(FormatExtremes, EdgesFitAtEveryCornerOfTheFrame) {
  bool needs_all_bits = false;
  for_each_extreme([&](const spec::Triangle& t) {
    spec::SetupPrim prim;
    if (core::setup(kContract, kHugeFrame, t, &prim) != core::Drop::kNone) return;
    const int x0 = prim.x0 & ~7;
    const int y0 = prim.y0 & ~7;
    for (const auto& edge : prim.edge) {
      for (const int x : {0, 16383}) {
        for (const int y : {0, 16383}) {
          const int64_t e = edge.e + (x - x0) * edge.a + (y - y0) * edge.b;
          ASSERT_TRUE(fits(e, true, kContract.width.edge)) << e;
          needs_all_bits |= !fits(e, true, kContract.width.edge - 1);
        }
      }
    }
  });
  EXPECT_TRUE(needs_all_bits);  // one bit less would not do
}

TEST(FormatExtremes, TilesAndStampsFitInsideAWindow) {
  for_each_extreme([&](const spec::Triangle& t) {
    spec::SetupPrim prim;
    if (core::setup(kContract, kWindow, t, &prim) != core::Drop::kNone) return;
    core::TileWalk tiles(kContract, prim);
    core::Tile tile;
    for (auto test = tiles.next(&tile); test != core::TileWalk::Test::kEnd;
         test = tiles.next(&tile)) {
      if (test == core::TileWalk::Test::kRejected) continue;
      ASSERT_EQ(misfit(kContract, tile), "");
    }
    core::for_each_stamp(kContract, prim, [&](const spec::Stamp& stamp) {
      ASSERT_EQ(misfit(kContract, stamp), "");
    });
  });
}

// An edge that cuts a tile: E' fits TILE_EDGE_BITS at each corner sample of that tile.
TEST(FormatExtremes, EdgeThatCutsATileFitsItsNarrowWidth) {
  Random random(61);
  bool needs_all_bits = false;
  int cut = 0;
  const auto check = [&](const spec::Triangle& t) {
    spec::SetupPrim prim;
    if (core::setup(kContract, kWindow, t, &prim) != core::Drop::kNone) return;
    core::TileWalk tiles(kContract, prim);
    core::Tile tile;
    for (auto test = tiles.next(&tile); test != core::TileWalk::Test::kEnd;
         test = tiles.next(&tile)) {
      if (test == core::TileWalk::Test::kRejected) continue;
      for (size_t i = 0; i < 3; ++i) {
        if ((tile.accepted >> i & 1) != 0) continue;
        ++cut;
        const auto& edge = prim.edge[i];  // evaluated anew at full width
        for (int corner = 0; corner < 4; ++corner) {
          const int x = tile.x * 8 + (corner & 1) * 7 - (prim.x0 & ~7);
          const int y = tile.y * 8 + (corner >> 1) * 7 - (prim.y0 & ~7);
          const int64_t e = edge.e + x * edge.a + y * edge.b;
          ASSERT_TRUE(fits(e, true, kContract.width.tile_edge)) << e;
          needs_all_bits |= !fits(e, true, kContract.width.tile_edge - 1);
        }
      }
    }
  };
  for (int n = 0; n < 2000; ++n) check(random_triangle(random, Shape::kGuardBand));
  // Diagonals of the guard band, moved bit by bit across a tile.
  for (int step = 0; step < 400; ++step) {
    check(triangle({kGuardLow, kGuardLow}, {kGuardHigh, kGuardHigh - 10 * step},
                   {kGuardLow, kGuardHigh}));
    check(triangle({kGuardLow, kGuardHigh - 10 * step}, {kGuardHigh, kGuardLow},
                   {kGuardHigh, kGuardHigh}));
  }
  EXPECT_GT(cut, 10000);
  EXPECT_TRUE(needs_all_bits);
}

// Numerators as the planes' products form them: a 2x2 determinant of differences.
TEST(FormatExtremes, AreaAndNumeratorsFitAndNeedEveryBit) {
  bool area_needs_all = false;
  bool numerator_needs_all = false;
  for_each_extreme([&](const spec::Triangle& t) {
    const auto& v = t.v;
    const auto determinant = [](int64_t a, int64_t b, int64_t c, int64_t d) {
      return a * d - b * c;
    };
    const int64_t dy1 = int64_t{v[1].y} - v[0].y;
    const int64_t dy2 = int64_t{v[2].y} - v[0].y;
    const int64_t area2 = determinant(int64_t{v[1].x} - v[0].x, int64_t{v[2].x} - v[0].x, dy1, dy2);
    const int64_t z = determinant(v[1].z - v[0].z, v[2].z - v[0].z, dy1, dy2);
    const int64_t attr =
        determinant(v[1].attr[0] - v[0].attr[0], v[2].attr[0] - v[0].attr[0], dy1, dy2);
    ASSERT_TRUE(fits(area2, true, kContract.width.area2));
    ASSERT_TRUE(fits(z, true, kContract.width.depth_numerator));
    ASSERT_TRUE(fits(attr, true, kContract.width.attr_numerator));
    area_needs_all |= !fits(area2, true, kContract.width.area2 - 1);
    numerator_needs_all |= !fits(z, true, kContract.width.depth_numerator - 1);
  });
  EXPECT_TRUE(area_needs_all);
  EXPECT_TRUE(numerator_needs_all);
}

TEST(FormatExtremes, MutantWithOneEdgeBitLessIsCaught) {
  spec::Contract narrow = kContract;
  --narrow.width.edge_coeff;
  bool caught = false;
  for_each_extreme([&](const spec::Triangle& t) {
    spec::SetupPrim prim;
    if (core::setup(kContract, kHugeFrame, t, &prim) != core::Drop::kNone) return;
    caught |= !misfit(narrow, prim).empty();
  });
  EXPECT_TRUE(caught);
}

}  // namespace
}  // namespace pineda::test
