// "6.837 Lecture 6", slides 14 to 17: the draw loop and the flat triangle. Each printed
// fault is shown, and the mended form beside it.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "tests/baseline/printed.h"
#include "tests/baseline/support.h"

namespace pineda::test {
namespace {

using printed::Pixel;

// The pixels of a mesh that the printed edges cover, by the given sign test.
template <class Test>
Hits mesh_hits(const std::vector<spec::Triangle>& mesh, int size_px, Test&& test) {
  Hits hits(size_px);
  for (const spec::Triangle& t : mesh) {
    const printed::Setup s = printed::with_right_box(printed::corners(t), size_px);
    printed::for_each_pixel(s, 1, [&](int x, int y) {
      if (test(s.edge[0].evaluate(x, y), s.edge[1].evaluate(x, y), s.edge[2].evaluate(x, y))) {
        hits.add(x, y);
      }
    });
  }
  return hits;
}

TEST(SignByOr, NotNegativeHitsSharedEdgesTwiceAndAllPositiveLeavesHoles) {
  constexpr int kSize = 200;
  Random random(7);
  const auto mesh = lattice_mesh(random, kSize);
  const Hits by_or = mesh_hits(mesh, kSize, [](int a, int b, int c) { return (a | b | c) >= 0; });
  const Hits positive =
      mesh_hits(mesh, kSize, [](int a, int b, int c) { return a > 0 && b > 0 && c > 0; });
  record("doubles", by_or.doubles());
  record("holes", positive.holes());
  EXPECT_GT(by_or.doubles(), 500);
  EXPECT_EQ(by_or.holes(), 0);
  EXPECT_GT(positive.holes(), 500);
  EXPECT_EQ(positive.doubles(), 0);
  for (const std::string& name : exact_baselines()) {
    const Hits mended = hits_of(name, mesh, kSize);
    EXPECT_EQ(mended.doubles(), 0) << name;
    EXPECT_EQ(mended.holes(), 0) << name;
  }
}

// Nearly equilateral, 128 to 512 px a side.
spec::Triangle well_shaped(Random& random, int size_px) {
  const double turn = 7 * random.unit();
  const double radius = (75 + 180 * random.unit()) * kPx;
  std::array<Point, 3> p;
  for (size_t i = 0; i < 3; ++i) {
    const double angle = turn + 2.0944 * static_cast<double>(i) + .7 * (random.unit() - .5);
    p[i].x = size_px * kHalfPx + static_cast<int>(radius * std::cos(angle));
    p[i].y = size_px * kHalfPx + static_cast<int>(radius * std::sin(angle));
  }
  return triangle(p[0], p[1], p[2]);
}

// Both find the same samples, which the judge checks: only the number of tests differs.
TEST(EarlyExit, TestsFewerSamplesForTheSameTriangles) {
  Random random(8);
  const auto early = find_baseline("edge_smooth").make(kContract, square(512));
  const auto whole = find_baseline("barycentric_incremental").make(kContract, square(512));
  Gathered with_exit;
  Gathered without;
  for (int n = 0; n < 30; ++n) {
    const spec::Triangle t = well_shaped(random, 512);
    early->draw(t, &with_exit);
    whole->draw(t, &without);
  }
  ASSERT_EQ(with_exit.samples.size(), without.samples.size());
  ASSERT_GT(with_exit.samples.size(), 100000u);
  const auto covered = static_cast<double>(with_exit.samples.size());
  const double early_ratio = static_cast<double>(early->visited()) / covered;
  const double whole_ratio = static_cast<double>(whole->visited()) / covered;
  record("whole", whole_ratio);
  record("early", early_ratio);
  EXPECT_NEAR(whole_ratio, 2.2, .2);
  EXPECT_NEAR(early_ratio, 1.6, .2);
}

// Its top edge lies on a row of samples, which the printed test counts as inside.
spec::Triangle pointing_down() {
  constexpr int kTop = 4 * kPx + kHalfPx;
  return triangle({4 * kPx, kTop}, {60 * kPx, kTop}, {32 * kPx, 60 * kPx});
}

TEST(DrawLoop, PrintedRowsAllRepeatTheFirst) {
  constexpr int kSize = 64;
  const spec::Triangle t = pointing_down();
  const printed::Setup s = printed::with_right_box(printed::corners(t), kSize);
  std::vector<std::set<int>> columns(kSize);
  for (const Pixel& p : printed::draw(s, kSize)) {
    columns[static_cast<size_t>(p.row / kSize)].insert(p.column);  // the scale taken off again
  }
  const auto first = static_cast<size_t>(s.y_min);
  EXPECT_EQ(columns[first].size(), 56u);
  for (size_t y = first; y <= static_cast<size_t>(s.y_max); ++y) {
    EXPECT_EQ(columns[y], columns[first]) << y;
  }
  Verdict mended;
  judge_samples(square(kSize), t, samples_of("edge_smooth", square(kSize), t), &mended);
  EXPECT_EQ(mended.faults(), 0);
  EXPECT_GT(mended.wanted, 1000);
}

TEST(DrawLoop, RowTimesWidthAsAnIndexOfRowsLeavesTheRaster) {
  constexpr int kSize = 64;
  const auto pixels =
      printed::draw(printed::with_right_box(printed::corners(pointing_down()), kSize), kSize);
  ASSERT_GT(pixels.size(), 1000u);
  for (const Pixel& p : pixels) ASSERT_GE(p.row, kSize);
  for (const auto& s : samples_of("edge_flat", square(kSize), pointing_down())) {
    ASSERT_LT(s.y, kSize);
    ASSERT_LT(s.x, kSize);
  }
}

TEST(FlatTriangle, PrintedColorIsOneChannelOffAndWithoutAlpha) {
  spec::Triangle t = triangle({4 * kPx, 4 * kPx}, {60 * kPx, 4 * kPx}, {32 * kPx, 60 * kPx});
  t.v[0].attr = {10, 100, 0, 255};  // red, green, blue, alpha
  t.v[1].attr = {20, 100, 0, 255};
  t.v[2].attr = {32, 100, 1, 255};
  t.v[0].z = 2 * 256;                                                // codes
  EXPECT_EQ(printed::flat_color(printed::corners(t)), 0x00ff1564u);  // alpha for red, red for green
  const auto samples = samples_of("edge_flat", square(64), t);
  ASSERT_FALSE(samples.empty());
  for (const auto& s : samples) {
    ASSERT_EQ(s.rgba, (std::array<int, 4>{21, 100, 0, 255}));  // 62/3 and 1/3, to the nearest
    ASSERT_EQ(s.z, 1);                                         // 2/3
  }
}

}  // namespace
}  // namespace pineda::test
