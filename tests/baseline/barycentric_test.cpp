// "Triangles", barycentric coordinates: what the loop can do without, and who owns samples on an
// edge.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "tests/baseline/printed.h"
#include "tests/baseline/support.h"

namespace pineda::test {
namespace {

using printed::Condition;
using printed::Vertex2D;

constexpr int kSize = 200;
constexpr spec::FrameState kFrame{kSize, kSize, spec::Cull::kNone, spec::DepthFunc::kLess};
constexpr printed::Range kAll{0, kSize - 1, 0, kSize - 1};

// A point far to the right of everything and a little below: no edge's line, unless horizontal,
// passes to its right at that height. Exact in doubles for the triangles of a small frame.
constexpr Vertex2D kFarPoint{0x1p30f, 0x1p12f, 0};

// The samples that a triangle can cover.
printed::Range range_of(const printed::Corners& v) {
  const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
  return {std::max(static_cast<int>(left), 0), std::min(static_cast<int>(right) + 1, kSize - 1),
          std::max(static_cast<int>(top), 0), std::min(static_cast<int>(bottom) + 1, kSize - 1)};
}

Hits printed_hits(const std::vector<spec::Triangle>& mesh, const Vertex2D& r) {
  Hits hits(kSize);
  for (const spec::Triangle& t : mesh) {
    const printed::Corners v = printed::corners(t);
    for (const auto& p : printed::barycentric(v, range_of(v), Condition::kOffScreenPoint, r)) {
      hits.add(p.column, p.row);
    }
  }
  return hits;
}

TEST(BarycentricLoop, DroppingTheUpperBoundChangesNothing) {
  Random random(31);
  size_t samples = 0;
  for (int n = 0; n < 60; ++n) {
    const printed::Corners v = printed::corners(triangle_in(random, kSize));
    const auto bounded = printed::barycentric(v, kAll, Condition::kUnitInterval);
    ASSERT_EQ(printed::barycentric(v, kAll, Condition::kNotNegative), bounded);
    samples += bounded.size();
  }
  EXPECT_GT(samples, 50000u);
}

// The plain form has divisions and goes by columns, which only costs time: it finds the samples and
// looks at the pixels of the incremental form.
TEST(BarycentricLoop, PlainAndIncrementalSeeTheSame) {
  Random random(32);
  const auto plain = find_baseline("barycentric").make(kContract, kFrame);
  const auto stepped = find_baseline("barycentric_incremental").make(kContract, kFrame);
  const auto place = [](const baseline::Sample& s) { return std::pair(s.y, s.x); };
  for (int n = 0; n < 20; ++n) {
    const spec::Triangle t = triangle_in(random, kSize);
    Gathered columns;
    Gathered rows;
    plain->draw(t, &columns);
    stepped->draw(t, &rows);
    std::sort(columns.samples.begin(), columns.samples.end(),
              [&](const auto& a, const auto& b) { return place(a) < place(b); });
    ASSERT_EQ(columns.samples.size(), rows.samples.size());
    for (size_t i = 0; i < rows.samples.size(); ++i) {
      ASSERT_EQ(place(columns.samples[i]), place(rows.samples[i]));
      ASSERT_EQ(columns.samples[i].z, rows.samples[i].z);
      ASSERT_EQ(columns.samples[i].rgba, rows.samples[i].rgba);
    }
  }
  EXPECT_EQ(plain->visited(), stepped->visited());
}

// The diagonal of a square at the origin runs through the printed point (-1, -1).
TEST(OffScreenPoint, PrintedPointOnTheLineOfAnEdgeDropsItsSamples) {
  const Point corner{kHalfPx, kHalfPx};
  const int far = 100 * kPx + kHalfPx;
  const std::vector<spec::Triangle> square{triangle(corner, {far, kHalfPx}, {far, far}),
                                           triangle(corner, {far, far}, {kHalfPx, far})};
  const Hits printed = printed_hits(square, {-1, -1, 0});
  const Hits mended = hits_of("barycentric", square, kSize);
  for (int i = 2; i < 100; ++i) {
    EXPECT_EQ(printed.at(i, i), 0) << i;
    EXPECT_EQ(mended.at(i, i), 1) << i;
    EXPECT_EQ(printed.at(i, i - 1), 1) << i;
  }
  EXPECT_EQ(printed.doubles(), 0);
}

TEST(OffScreenPoint, DropsSamplesOfAMeshUnlessItIsOutOfEveryLine) {
  Random random(33);
  int dropped = 0;
  int far_dropped = 0;
  int doubles = 0;
  for (int n = 0; n < 6; ++n) {
    const auto mesh = lattice_mesh(random, kSize);
    const Hits near = printed_hits(mesh, {-1, -1, 0});
    const Hits far = printed_hits(mesh, kFarPoint);
    dropped += near.holes();
    far_dropped += far.holes();
    doubles += near.doubles() + far.doubles();
  }
  record("dropped", dropped);
  EXPECT_GT(dropped, 20);  // of 6 * 198^2 = 235,000
  EXPECT_EQ(far_dropped, 0);
  EXPECT_EQ(doubles, 0);
}

// Left edges and top edges have the far point on the side of their triangle.
TEST(OffScreenPoint, AtInfinityItIsTheTopLeftRule) {
  Random random(34);
  size_t samples = 0;
  for (const spec::Triangle& t : lattice_mesh(random, kSize)) {
    const printed::Corners v = printed::corners(t);
    const auto by_point =
        printed::barycentric(v, range_of(v), Condition::kOffScreenPoint, kFarPoint);
    const exact::Judge exact = judge(kFrame, t);
    for (const auto& p : by_point) ASSERT_TRUE(exact.covers(p.column, p.row));
    ASSERT_EQ(static_cast<int64_t>(by_point.size()), exact.samples());
    samples += by_point.size();
  }
  EXPECT_GT(samples, 30000u);
}

}  // namespace
}  // namespace pineda::test
