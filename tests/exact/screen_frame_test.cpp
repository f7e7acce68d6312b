// A whole frame judged sample by sample: a sheet of jittered cells, each split into triangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "model/exact/exact.h"

namespace exact {
namespace {

constexpr int kWidth = 1920;
constexpr int kHeight = 1080;
constexpr int kCell = 12;  // px
constexpr int kColumns = kWidth / kCell;
constexpr int kRows = kHeight / kCell;

// A corner of the sheet, which reaches half a cell beyond the frame on every side.
ScreenVertex corner(int column, int row) {
  const auto index = static_cast<uint32_t>(row * (kColumns + 2) + column);
  const uint32_t mixed = (index + 1) * 2654435761U;
  const auto jitter = [mixed](int shift) {
    return static_cast<float>(mixed >> shift & 255) / 64 - 2;  // px, in [-2, 2)
  };
  ScreenVertex v;
  v.x = static_cast<float>((column * 2 - 1) * kCell) / 2 + jitter(24);
  v.y = static_cast<float>((row * 2 - 1) * kCell) / 2 + jitter(16);
  v.z = static_cast<float>(mixed >> 20) / 4096;
  v.w = 1 + static_cast<float>(mixed >> 8 & 1023);
  v.rgba = {static_cast<int>(mixed >> 24), 0, 255, static_cast<int>(mixed >> 16 & 255)};
  return v;
}

struct Counts {
  std::vector<int> hits = std::vector<int>(size_t{kWidth} * kHeight);
  int64_t samples = 0;  // as the snapped judge counts them
  int64_t outside = 0;  // values outside the range of the vertices'
};

bool within(const Value& v, int low, int high) {
  return v.whole >= low && (v.whole < high || (v.whole == high && v.fraction == 0));
}

void count(const ScreenTriangle& t, Counts* counts) {
  const ScreenJudge judge(t, {}, {kWidth, kHeight, Cull::kNone});
  counts->samples += judge.snapped().samples();
  const auto [low, high] = std::minmax({t[0].rgba[0], t[1].rgba[0], t[2].rgba[0]});
  std::vector<Sample> row;
  for (int y = judge.rows().first; y <= judge.rows().last; ++y) {
    row.clear();
    judge.row(y, true, &row);
    for (const Sample& s : row) {
      ++counts->hits[static_cast<size_t>(s.y) * kWidth + static_cast<size_t>(s.x)];
      const bool inside = within(s.affine[0], low, high) && within(s.perspective[0], low, high) &&
                          within(s.perspective[1], 0, 0) && within(s.perspective[2], 255, 255);
      counts->outside += inside ? 0 : 1;
    }
  }
}

TEST(ScreenFrame, SheetHitsEverySampleOnceAndKeepsItsColours) {
  Counts counts;
  for (int row = 0; row <= kRows; ++row) {
    for (int column = 0; column <= kColumns; ++column) {
      const ScreenVertex a = corner(column, row);
      const ScreenVertex b = corner(column + 1, row);
      const ScreenVertex c = corner(column, row + 1);
      const ScreenVertex d = corner(column + 1, row + 1);
      count({{a, b, c}}, &counts);
      count({{d, b, c}}, &counts);  // the other winding
    }
  }
  EXPECT_EQ(std::count(counts.hits.begin(), counts.hits.end(), 1), int64_t{kWidth} * kHeight);
  EXPECT_EQ(counts.samples, int64_t{kWidth} * kHeight);
  EXPECT_EQ(counts.outside, 0);
}

}  // namespace
}  // namespace exact
