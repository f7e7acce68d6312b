// The right answers of the cases at the limits.
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "tests/core/support.h"
#include "tests/hard/support.h"

namespace pineda::hard {
namespace {

using test::kContract;
using test::kGuardHigh;
using test::kGuardLow;

// Opposite halves of the guard band's square share a diagonal; each half is drawn both ways round.
TEST(GuardBandFan, HitsEverySampleExactlyOnce) {
  const Snapped scene = snapped("guard_band_fan");
  EXPECT_EQ(scene.counters.saturated, 0u);
  const auto hits = drawn(scene).buffer().hits;
  EXPECT_EQ(std::count(hits.begin(), hits.end(), 1), 320 * 240);
}

TEST(FarMesh, HitsEverySampleOfItsCornerExactlyOnce) {
  const Snapped scene = snapped("far_mesh");
  const auto hits = drawn(scene).buffer().hits;
  // 240 px wide up to the last subpixel before the border, all 64 rows.
  EXPECT_EQ(std::count(hits.begin(), hits.end(), 1), 240 * 64);
  EXPECT_EQ(std::count(hits.begin(), hits.end(), 0), (16384 - 240) * 64);
}

TEST(Huge, IsExactAndSaturatesNothing) {
  const Snapped scene = snapped("huge");
  EXPECT_EQ(scene.counters.saturated, 0u);
  for (size_t i = 0; i < 8; ++i) {
    EXPECT_GE(std::abs(judge(kContract, scene.frame, scene.triangles[i]).doubled_area()),
              (int64_t{1} << 46) - (int64_t{1} << 24));
  }
  const auto hits = drawn(scene, 0, 8).buffer().hits;
  EXPECT_EQ(std::count(hits.begin(), hits.end(), 4), scene.frame.width * scene.frame.height);
}

TEST(BeyondGuardBand, IsSaturatedAndCounted) {
  const auto floats = hard_case("beyond_guard_band").make();
  const Snapped scene = snapped("beyond_guard_band");
  uint64_t saturated = 0;
  for (size_t i = 0; i < floats.size(); ++i) {
    for (size_t k = 0; k < 3; ++k) {
      const auto check = [&](float px, int subpx) {
        if (px >= 16384 || px < -16384) {
          EXPECT_EQ(subpx, px > 0 ? kGuardHigh : kGuardLow);
          ++saturated;
        } else {
          EXPECT_EQ(subpx, static_cast<int>(std::nearbyint(px * 256)));
        }
      };
      check(floats[i].v[k].x, scene.triangles[i].v[k].x);
      check(floats[i].v[k].y, scene.triangles[i].v[k].y);
    }
  }
  EXPECT_EQ(saturated, 28u);
  EXPECT_EQ(scene.counters.saturated, saturated);
  EXPECT_GT(drawn(scene).counters().fragments, 1000u);
}

/// Sees whether a triangle's stamps are inside the frame, and each sent once.
struct StampSink {
  const spec::FrameState& frame;
  std::set<std::pair<int, int>> sent;

  void prim(const spec::SetupPrim&) { sent.clear(); }
  void fragment(const spec::Stamp&, const spec::Fragment&) {}
  void depth(const spec::DepthWrite& w) { inside(w.x, w.y, w.mask); }
  void color(const spec::ColorWrite& w) { inside(w.x, w.y, w.mask); }
  void stamp(const spec::Stamp& s) {
    EXPECT_NE(s.mask, 0u);
    EXPECT_TRUE(sent.emplace(s.x, s.y).second) << s.x << "," << s.y << " twice";
    inside(s.x, s.y, s.mask);
  }
  void inside(int x, int y, uint32_t mask) const {
    spec::Stamp stamp;
    stamp.x = x;
    stamp.y = y;
    stamp.mask = mask;
    test::for_each_sample(stamp, [&](int px, int py, size_t) {
      EXPECT_TRUE(px >= 0 && px < frame.width && py >= 0 && py < frame.height) << px << "," << py;
    });
  }
};

void expect_each_stamp_once_inside(const std::string& name) {
  const Snapped scene = snapped(name);
  core::Renderer renderer(kContract, scene.frame);
  StampSink sink{scene.frame, {}};
  uint64_t samples = 0;
  for (const auto& t : scene.triangles) {
    renderer.draw(t, sink);
    samples += static_cast<uint64_t>(judge(kContract, scene.frame, t).samples());
  }
  EXPECT_EQ(renderer.counters().fragments, samples);
  uint64_t hits = 0;
  for (const uint16_t n : renderer.buffer().hits) hits += n;
  EXPECT_EQ(hits, samples);
  EXPECT_GT(samples, 5u);
}

TEST(OddFrame, NothingOutsideIsReadWrittenOrCounted) {
  for (const char* name : {"odd_frame_641x479", "odd_frame_13x7", "odd_frame_1x1"}) {
    SCOPED_TRACE(name);
    expect_each_stamp_once_inside(name);
    // All four corners of the frame are hit, and triangles reach over each side.
    const Snapped scene = snapped(name);
    const auto hits = drawn(scene).buffer().hits;
    const auto width = static_cast<size_t>(scene.frame.width);
    for (const size_t corner : {size_t{0}, width - 1, hits.size() - width, hits.size() - 1}) {
      EXPECT_GT(hits[corner], 0) << corner;
    }
  }
}

TEST(TileCorners, NoStampIsLostOrSentTwice) { expect_each_stamp_once_inside("tile_corners"); }

TEST(FormatExtremes, ReachesEveryExtremeAndDrawsThere) {
  const Snapped scene = snapped("format_extremes");
  std::set<int> coordinates;
  std::set<int64_t> depths;
  std::set<int32_t> colors;
  int64_t samples = 0;
  for (const auto& t : scene.triangles) {
    const int64_t covered = judge(kContract, scene.frame, t).samples();
    samples += covered;
    if (covered == 0) continue;
    for (const auto& v : t.v) {
      coordinates.insert({v.x, v.y});
      depths.insert(v.z);
      colors.insert(v.attr[0]);
    }
  }
  for (const int x : {kGuardLow, kGuardLow + 1, -1, 0, 1, kGuardHigh - 1, kGuardHigh}) {
    EXPECT_EQ(coordinates.count(x), 1u) << x;
  }
  EXPECT_EQ(depths, (std::set<int64_t>{0, test::kMaxDepthInput}));
  EXPECT_EQ(colors, (std::set<int32_t>{0, 255}));
  EXPECT_EQ(scene.counters.saturated, 0u);
  EXPECT_EQ(drawn(scene).counters().fragments, static_cast<uint64_t>(samples));
}

TEST(NotNumbers, AreDroppedSaturatedOrZeroAndCounted) {
  const auto floats = hard_case("not_numbers").make();
  const Snapped scene = snapped("not_numbers");
  EXPECT_EQ(scene.counters.triangles, floats.size());
  EXPECT_EQ(scene.counters.nan_dropped, 3 * 4u);  // X, Y, Z, W of three vertices
  EXPECT_EQ(scene.counters.saturated, 2 * 3 * 2u);
  EXPECT_EQ(scene.counters.z_clamped, 2 * 3u);
  EXPECT_EQ(scene.counters.denormals, 3 * 3 * 3u);
  ASSERT_EQ(scene.triangles.size() + 12, floats.size());
  const spec::Triangle& plain = scene.triangles.back();
  for (const auto& t : scene.triangles) {
    // t.id is the triangle's number as read, so the odd component can be found.
    for (size_t k = 0; k < 3; ++k) {
      const scene::ScreenVertex& from = floats[t.id].v[k];
      const auto expected = [](float value, int64_t ordinary, int64_t low, int64_t high) {
        if (std::isinf(value)) return value > 0 ? high : low;
        return std::fpclassify(value) == FP_SUBNORMAL ? 0 : ordinary;
      };
      EXPECT_EQ(t.v[k].x, expected(from.x, plain.v[k].x, kGuardLow, kGuardHigh)) << t.id;
      EXPECT_EQ(t.v[k].y, expected(from.y, plain.v[k].y, kGuardLow, kGuardHigh)) << t.id;
      const int64_t z = t.v[k].z;
      EXPECT_EQ(z, expected(from.z, z, 0, test::kMaxDepthInput)) << t.id;
    }
  }
}

}  // namespace
}  // namespace pineda::hard
