// The right answers of the coverage cases, each computed by a rule of its own.
#include <algorithm>
#include <cmath>

#include "tests/core/support.h"
#include "tests/hard/support.h"

namespace pineda::hard {
namespace {

using test::HitMap;
using test::kContract;
using test::kHalfPx;
using test::kPx;
using test::Rule;

HitMap hit_map(const Snapped& scene, Rule rule = Rule::kTopLeft) {
  HitMap hits(scene.frame);
  for (const auto& t : scene.triangles) hits.draw(t, rule);
  return hits;
}
int samples_of(const spec::FrameState& frame) { return frame.width * frame.height; }
int doubled(const HitMap& hits) { return hits.count(-1); }

TEST(SharedEdges, HitEverySampleOnce) {
  const Snapped scene = snapped("shared_edges");
  EXPECT_EQ(hit_map(scene).count(1), samples_of(scene.frame));
}

TEST(HalfPixelLattice, HitsEverySampleOnceByTheTopLeftRuleAlone) {
  const Snapped scene = snapped("half_pixel_lattice");
  EXPECT_EQ(hit_map(scene).count(1), samples_of(scene.frame));
  const HitMap inclusive = hit_map(scene, Rule::kInclusive);
  const HitMap strict = hit_map(scene, Rule::kStrict);
  EXPECT_GT(doubled(inclusive), 50);
  EXPECT_EQ(inclusive.count(0), 0);
  EXPECT_GT(strict.count(0), 50);
  EXPECT_EQ(doubled(strict), 0);
}

TEST(NearPlane, HitsEverySampleOnce) {
  const Snapped scene = snapped("near_plane");
  EXPECT_EQ(hit_map(scene).count(1), samples_of(scene.frame));
  EXPECT_EQ(scene.counters.z_clamped, 0u);
  // Pieces of a clipped triangle share its number; vertices made by clipping lie on the plane, z =
  // 0.
  int pieces = 0, cut = 0;
  for (size_t i = 1; i < scene.triangles.size(); ++i) {
    const auto& t = scene.triangles[i];
    pieces += t.id == scene.triangles[i - 1].id ? 1 : 0;
    const bool on_plane =
        std::any_of(t.v.begin(), t.v.end(), [](const auto& v) { return v.z == 0; });
    cut += on_plane && judge(kContract, scene.frame, t).samples() > 0 ? 1 : 0;
  }
  EXPECT_GT(pieces, 10);
  EXPECT_GT(cut, 10);
}

TEST(TJunction, HitsDifferByOneInsideTheSliversAlone) {
  const Snapped scene = snapped("t_junction");
  int holes = 0, doubles = 0;
  for (size_t i = 0; i < scene.triangles.size(); i += 3) {
    const spec::Vertex &p = scene.triangles[i].v[0], &q = scene.triangles[i].v[1];
    const spec::Vertex &middle = scene.triangles[i + 1].v[1], &far = scene.triangles[i + 1].v[2];
    const spec::Triangle whole{0, {p, q, far}}, sliver{0, {p, middle, q}};
    const auto side = [&](const spec::Vertex& v) {
      return test::judge(scene.frame, spec::Triangle{0, {p, q, v}}).doubled_area() > 0;
    };
    const int sign = side(middle) == side(far) ? -1 : 1;
    HitMap split(scene.frame), expected(scene.frame), crack(scene.frame);
    for (size_t k = i; k < i + 3; ++k) split.draw(scene.triangles[k]);
    expected.draw(scene.triangles[i]);
    expected.draw(whole);
    crack.draw(sliver);
    ASSERT_EQ(crack.count(1), 1) << "junction " << i / 3;
    for (int y = 0; y < scene.frame.height; ++y) {
      for (int x = 0; x < scene.frame.width; ++x) {
        ASSERT_EQ(split.at(x, y), expected.at(x, y) + sign * crack.at(x, y)) << x << "," << y;
      }
    }
    (sign < 0 ? holes : doubles) += 1;
  }
  EXPECT_GT(holes, 5);
  EXPECT_GT(doubles, 5);
}

TEST(Fan, HitsItsMiddleOnce) {
  const Snapped scene = snapped("fan");
  const HitMap hits = hit_map(scene);
  const HitMap inclusive = hit_map(scene, Rule::kInclusive);
  const HitMap strict = hit_map(scene, Rule::kStrict);
  int lost = 0;
  for (int y = 7; y < scene.frame.height; y += 16) {
    for (int x = 7; x < scene.frame.width; x += 16) {
      EXPECT_EQ(hits.at(x, y), 1) << x << "," << y;
      lost += strict.at(x, y) == 0 && inclusive.at(x, y) > 1 ? 1 : 0;
    }
  }
  EXPECT_EQ(doubled(hits), 0);
  EXPECT_GE(lost, 12);  // every other fan has its middle on the sample
}

TEST(Sliver, OfOneUnitDrawsTheSamplesItCovers) {
  const Snapped scene = snapped("sliver");
  int of_one_unit = 0;
  for (size_t i = 0; i < scene.triangles.size(); ++i) {
    const exact::Judge exact = judge(kContract, scene.frame, scene.triangles[i]);
    const int64_t units = std::abs(exact.doubled_area());
    ASSERT_TRUE(units >= 1 && units <= 4) << units;
    const auto samples = static_cast<uint64_t>(exact.samples());
    ASSERT_EQ(drawn(scene, i, 1).counters().fragments, samples);
    of_one_unit += units == 1 && samples > 0 ? 1 : 0;
  }
  EXPECT_GE(of_one_unit, 5);
}

TEST(ZeroArea, DrawsNothingAndIsCounted) {
  Snapped scene = snapped("zero_area");
  const core::Renderer all = drawn(scene);
  const auto is_line = [&](const spec::Triangle& t) {
    return judge(kContract, scene.frame, t).doubled_area() == 0;
  };
  const auto lines = std::remove_if(scene.triangles.begin(), scene.triangles.end(), is_line);
  EXPECT_EQ(scene.triangles.end() - lines, 40);
  EXPECT_EQ(all.counters().dropped[static_cast<size_t>(core::Drop::kZeroArea)], 40u);
  scene.triangles.erase(lines, scene.triangles.end());
  const core::Renderer rest = drawn(scene);
  EXPECT_GT(rest.counters().fragments, 100u);
  EXPECT_EQ(all.buffer().hits, rest.buffer().hits);
  EXPECT_EQ(all.buffer().color, rest.buffer().color);
}

// A fifth of the triangles without area have an area before snapping.
TEST(ZeroArea, SomeOfItComesFromSnapping) {
  int triangles = 0;
  for (const auto& t : hard_case("zero_area").make()) {
    const auto& v = t.v;
    const double area = (double{v[1].x} - v[0].x) * (double{v[2].y} - v[0].y) -
                        (double{v[2].x} - v[0].x) * (double{v[1].y} - v[0].y);
    triangles += area != 0 ? 1 : 0;
  }
  EXPECT_EQ(triangles, 8 + 8);
}

// Pairs of triangles make rectangles [left, right) x [top, bottom) of samples.
TEST(EdgesThroughCenters, BelongToTheLeftAndTheTop) {
  const Snapped scene = snapped("edges_through_centers");
  const HitMap hits = hit_map(scene);
  int samples = 0;
  for (size_t i = 0; i < scene.triangles.size(); i += 2) {
    int left = 1 << 30, top = 1 << 30, right = 0, bottom = 0;
    for (size_t k = 0; k < 6; ++k) {
      const auto& v = scene.triangles[i + k / 3].v[k % 3];
      ASSERT_EQ((v.x & (kPx - 1)) | (v.y & (kPx - 1)), kHalfPx);
      left = std::min(left, v.x / kPx);
      right = std::max(right, v.x / kPx);
      top = std::min(top, v.y / kPx);
      bottom = std::max(bottom, v.y / kPx);
    }
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        ASSERT_EQ(hits.at(x, y), x < right && y < bottom ? 1 : 0) << x << "," << y;
      }
    }
    samples += (right - left) * (bottom - top);
  }
  EXPECT_EQ(hits.count(1), samples);
  EXPECT_EQ(doubled(hits), 0);
}

TEST(BoxOnCenters, ExcludesItsRightmostColumnAndLowestRow) {
  const Snapped scene = snapped("box_on_centers");
  for (size_t i = 0; i < scene.triangles.size(); ++i) {
    const auto& t = scene.triangles[i];
    const int right = std::max({t.v[0].x, t.v[1].x, t.v[2].x});
    const int bottom = std::max({t.v[0].y, t.v[1].y, t.v[2].y});
    ASSERT_EQ((right & (kPx - 1)) | (bottom & (kPx - 1)), kHalfPx);
    HitMap hits(scene.frame);
    hits.draw(t);
    for (int y = 0; y < scene.frame.height; ++y) EXPECT_EQ(hits.at(right / kPx, y), 0) << i;
    for (int x = 0; x < scene.frame.width; ++x) EXPECT_EQ(hits.at(x, bottom / kPx), 0) << i;
  }
  // In every fourth the box holds no other sample.
  EXPECT_EQ(drawn(scene).counters().dropped[static_cast<size_t>(core::Drop::kNoSample)], 12u);
  // An inclusive rule draws on that column or row.
  EXPECT_GT(hit_map(scene, Rule::kInclusive).count(1), hit_map(scene).count(1) + 10);
}

TEST(MicroTriangles, HitNoSampleAsOftenAsTheirAreaSays) {
  const Snapped scene = snapped("micro_triangles");
  constexpr size_t kEach = 400;
  constexpr std::array<double, 5> kShare{.99, .80, .51, .16, 0};
  for (size_t area = 0; area < kShare.size(); ++area) {
    int empty = 0;
    for (size_t i = area * kEach; i < (area + 1) * kEach; ++i) {
      empty += drawn(scene, i, 1).counters().fragments == 0 ? 1 : 0;
    }
    // Three standard deviations of 400 draws.
    const double spread = 3 * std::sqrt(kShare[area] * (1 - kShare[area]) / kEach);
    EXPECT_NEAR(empty / double{kEach}, kShare[area], spread) << "area " << area;
  }
  // At .2 px^2 the box alone tells more than half of all triangles to be empty.
  const core::Renderer fifth = drawn(scene, kEach, kEach);
  const auto by_box = fifth.counters().dropped[static_cast<size_t>(core::Drop::kNoSample)];
  EXPECT_NEAR(static_cast<double>(by_box) / kEach, .56, .08);
}

}  // namespace
}  // namespace pineda::hard
