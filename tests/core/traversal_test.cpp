// Traversal: order, borders, tile corners, micro-triangles.
#include "model/core/traversal.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "model/core/frame.h"
#include "tests/core/support.h"

namespace pineda::test {
namespace {

// Remembers whether the stamps come by rows of tiles, the first row of a triangle from the left and
// those below all from the left or all from the right, and in each tile by rows; each address once.
struct OrderSink {
  bool is_first = true;   // of the triangle
  int last_tile[2] = {};  // column, row
  int last[2] = {};
  int first_row = 0;
  int direction = 0;  // of the rows below the first; 0: not known yet
  int stamps = 0;
  int leftward = 0;
  int out_of_order = 0;
  int outside = 0;
  spec::FrameState frame;

  bool is_next(int tile_x, int tile_y, const spec::Stamp& s) {
    if (tile_y != last_tile[1]) return tile_y > last_tile[1];
    if (tile_x == last_tile[0]) return std::pair(s.y, s.x) > std::pair(last[1], last[0]);
    const int now = tile_x > last_tile[0] ? 1 : -1;
    if (tile_y == first_row) return now == 1;
    leftward += now < 0 ? 1 : 0;
    if (direction == 0) direction = now;
    return now == direction;
  }
  void prim(const spec::SetupPrim& prim) {
    is_first = true;
    direction = 0;
    first_row = prim.y0 >> 3;
  }
  void stamp(const spec::Stamp& s) {
    const int tile_x = s.x >> 2, tile_y = s.y >> 2;
    ++stamps;
    out_of_order += is_first || is_next(tile_x, tile_y, s) ? 0 : 1;
    is_first = false;
    last_tile[0] = tile_x;
    last_tile[1] = tile_y;
    last[0] = s.x;
    last[1] = s.y;
    for_each_sample(s, [&](int x, int y, size_t) {
      outside += x < 0 || y < 0 || x >= frame.width || y >= frame.height ? 1 : 0;
    });
  }
  void fragment(const spec::Stamp&, const spec::Fragment&) {}
  void depth(const spec::DepthWrite&) {}
  void color(const spec::ColorWrite&) {}
};

class OddFrame : public testing::TestWithParam<std::pair<int, int>> {};
INSTANTIATE_TEST_SUITE_P(Sizes, OddFrame,
                         testing::Values(std::pair{641, 479}, std::pair{1, 1}, std::pair{9, 1},
                                         std::pair{1, 17}, std::pair{2, 2}, std::pair{67, 45}),
                         [](const auto& size) {
                           return std::to_string(size.param.first) + "x" +
                                  std::to_string(size.param.second);
                         });

TEST_P(OddFrame, NothingOutsideIsSentOrCountedAndStampsComeInOrder) {
  const auto [width, height] = GetParam();
  const spec::FrameState frame{width, height, spec::Cull::kNone, spec::DepthFunc::kLess};
  core::Renderer renderer(kContract, frame);
  OrderSink sink;
  sink.frame = frame;
  Random random(71);
  uint64_t samples = 0;
  for (int n = 0; n < 60; ++n) {
    const spec::Triangle t =
        random_triangle(random, n % 2 == 0 ? Shape::k256Px : Shape::kGuardBand);
    ASSERT_EQ(coverage_difference(frame, t), "") << n;
    renderer.draw(t, sink);
    samples += static_cast<uint64_t>(judge(frame, t).samples());
  }
  EXPECT_GT(sink.stamps, 5);
  EXPECT_EQ(sink.out_of_order, 0);
  EXPECT_GT(sink.leftward, width > 64 ? 100 : -1);
  EXPECT_EQ(sink.outside, 0);
  EXPECT_EQ(renderer.counters().stamps, static_cast<uint64_t>(sink.stamps));
  EXPECT_EQ(renderer.counters().fragments, samples);
  uint64_t hits = 0;
  for (const uint16_t h : renderer.buffer().hits) hits += h;
  EXPECT_EQ(hits, samples);
}

TEST(OddFrame, FullScreenTriangleFillsEverySampleOnce) {
  constexpr spec::FrameState kFrame{641, 479, spec::Cull::kNone, spec::DepthFunc::kLess};
  core::Renderer renderer(kContract, kFrame);
  renderer.draw(triangle({0, 0}, {2 * 641 * kPx, 0}, {0, 2 * 479 * kPx}));
  EXPECT_EQ(renderer.counters().fragments, 641u * 479u);
  for (const uint16_t h : renderer.buffer().hits) ASSERT_EQ(h, 1);
}

// The order check can fail: the same triangle drawn twice starts again at its first stamp.
TEST(OddFrame, MutantStreamOutOfOrderIsCaught) {
  OrderSink sink;
  sink.frame = kWindow;
  spec::Stamp stamp;
  stamp.mask = 1;
  stamp.x = 1;
  sink.stamp(stamp);
  sink.stamp(stamp);
  EXPECT_EQ(sink.out_of_order, 1);
}

// Corners in the corners of a tile and a subpixel beside them; edges along tile borders.
TEST(TileCorners, NoStampIsLostOrSentTwice) {
  constexpr spec::FrameState kFrame{40, 40, spec::Cull::kNone, spec::DepthFunc::kLess};
  constexpr std::array<int, 9> kNear{
      0, -1, 1, kHalfPx, kHalfPx - 1, kHalfPx + 1, -kHalfPx, -kHalfPx - 1, -kHalfPx + 1};
  Random random(72);
  int drawn = 0;
  for (int n = 0; n < 20000; ++n) {
    const auto corner = [&] {
      const auto near = [&] { return kNear[static_cast<size_t>(random.between(0, 8))]; };
      return Point{random.between(0, 4) * 8 * kPx + near(),
                   random.between(0, 4) * 8 * kPx + near()};
    };
    const spec::Triangle t = triangle(corner(), corner(), corner());
    ASSERT_EQ(coverage_difference(kFrame, t), "") << n;
    drawn += judge(kFrame, t).samples() > 0 ? 1 : 0;
  }
  EXPECT_GT(drawn, 10000);
}

TEST(TileCorners, QuadsAlongTileBordersAreHitOnce) {
  constexpr spec::FrameState kFrame{40, 40, spec::Cull::kNone, spec::DepthFunc::kLess};
  for (const int shift : {0, kHalfPx, -kHalfPx, 1, -1}) {
    HitMap hits(kFrame);
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) {
        const int x0 = (8 * i + 4) * kPx + shift;
        const int y0 = (8 * j + 4) * kPx + shift;
        const int side = 8 * kPx;
        hits.draw(triangle({x0, y0}, {x0 + side, y0}, {x0, y0 + side}));
        hits.draw(triangle({x0 + side, y0}, {x0 + side, y0 + side}, {x0, y0 + side}));
      }
    }
    EXPECT_EQ(hits.count(1), 32 * 32) << shift;
    EXPECT_EQ(hits.count(-1), 0) << shift;
  }
}

// An edge is flagged as accepted just where it is >= 0 at all samples of the tile; tiles are dropped
// or passed over just where one edge has no sample inside.
TEST(TileTest, FlagsAgreeWithEverySampleOfTheTile) {
  Random random(73);
  int accepted = 0;
  int dropped = 0;
  for (int n = 0; n < 400; ++n) {
    const spec::Triangle t = random_triangle(random, Shape::k256Px);
    spec::SetupPrim prim;
    if (core::setup(kContract, kWindow, t, &prim) != core::Drop::kNone) continue;
    std::map<std::pair<int, int>, uint32_t> kept;  // column and row of a tile: its flags
    core::TileWalk tiles(kContract, prim);
    core::Tile tile;
    for (core::TileWalk::Test test; (test = tiles.next(&tile)) != core::TileWalk::Test::kEnd;) {
      if (test == core::TileWalk::Test::kRejected) continue;
      ASSERT_TRUE(kept.emplace(std::pair(tile.x, tile.y), tile.accepted).second);
    }
    for (int row = prim.y0 >> 3; row <= prim.y1 >> 3; ++row) {
      for (int column = prim.x0 >> 3; column <= prim.x1 >> 3; ++column) {
        const auto found = kept.find({column, row});
        bool outside = false;
        for (size_t i = 0; i < 3; ++i) {
          int inside = 0;
          for (int s = 0; s < 64; ++s) {
            const int x = (column - (prim.x0 >> 3)) * 8 + s % 8;
            const int y = (row - (prim.y0 >> 3)) * 8 + s / 8;
            inside += prim.edge[i].e + x * prim.edge[i].a + y * prim.edge[i].b >= 0 ? 1 : 0;
          }
          outside |= inside == 0;
          if (found == kept.end()) continue;
          ASSERT_EQ((found->second >> i & 1) != 0, inside == 64);
          accepted += inside == 64 ? 1 : 0;
        }
        ASSERT_EQ(found == kept.end(), outside);
        dropped += outside ? 1 : 0;
      }
    }
  }
  EXPECT_GT(accepted, 1000);
  EXPECT_GT(dropped, 100);
}

int stamp_tests(const core::Tile& tile) {
  core::StampWalk walk(kContract, tile);
  uint32_t mask = 0;
  int x = 0, y = 0, calls = 0;
  while (walk.next(&mask, &x, &y)) ++calls;
  return calls;
}

TEST(StampWalk, TestsTheStampsInTheBox) {
  core::Tile tile;
  tile.x1 = tile.y1 = 7;
  EXPECT_EQ(stamp_tests(tile), 16);
  tile.x0 = 3;  // columns 1 to 3, rows 2 to 2 of stamps
  tile.y0 = 4;
  tile.y1 = 5;
  EXPECT_EQ(stamp_tests(tile), 3);
}

// Equilateral triangles of a given area (px^2) at random places and angles: the share whose box
// holds no sample, and the share that hold none themselves.
struct Shares {
  double empty_box = 0;
  double empty = 0;
};

Shares micro_shares(double area_px2) {
  constexpr int kTries = 20000;
  Random random(74);
  const double turn = 2 * std::acos(-1.0);
  const double radius = kPx * std::sqrt(area_px2 * 4 / (3 * std::sqrt(3.0)));
  int empty_box = 0;
  int empty = 0;
  for (int n = 0; n < kTries; ++n) {
    const double x = kPx * (100 + random.unit());
    const double y = kPx * (100 + random.unit());
    const double angle = turn * random.unit();
    const auto corner = [&](int i) {
      const double a = angle + turn * i / 3;
      return Point{static_cast<int>(std::lround(x + radius * std::cos(a))),
                   static_cast<int>(std::lround(y + radius * std::sin(a)))};
    };
    const spec::Triangle t = triangle(corner(0), corner(1), corner(2));
    EXPECT_EQ(coverage_difference(kHugeFrame, t), "");
    spec::SetupPrim prim;
    const core::Drop drop = core::setup(kContract, kHugeFrame, t, &prim);
    empty_box += drop == core::Drop::kNoSample ? 1 : 0;
    empty += judge(kHugeFrame, t).samples() == 0 ? 1 : 0;
  }
  return {1.0 * empty_box / kTries, 1.0 * empty / kTries};
}

TEST(MicroTriangles, ShareThatHitsNoSample) {
  EXPECT_NEAR(micro_shares(.01).empty, .99, .01);
  EXPECT_NEAR(micro_shares(.2).empty, .80, .015);
  EXPECT_NEAR(micro_shares(.5).empty, .51, .015);
  EXPECT_NEAR(micro_shares(1).empty, .16, .03);
  EXPECT_EQ(micro_shares(16).empty, 0);
}

TEST(MicroTriangles, BoxWithoutASampleCullsMostOfTheSmallest) {
  EXPECT_NEAR(micro_shares(.2).empty_box, .56, .03);
}

}  // namespace
}  // namespace pineda::test
