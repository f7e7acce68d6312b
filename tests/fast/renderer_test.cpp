// Whole tiles at a time: the same bits and counts as stamp by stamp.
#include "model/fast/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/fast/levels.h"
#include "tests/fast/random_frames.h"

namespace pineda::fast {
namespace {

using spec::Random;
using test::compare;
using test::for_each_level;
using test::random_frame;
using test::random_triangle;

class WholeTiles : public testing::TestWithParam<std::string> {};

TEST_P(WholeTiles, EqualStampByStamp) {
  const auto c = spec::contract(*spec::find_design(GetParam()));
  for_each_level([&] {
    uint64_t drawn = 0;
    for (uint64_t seed = 0; seed < 60; ++seed) {
      ASSERT_EQ(compare(c, c, seed, &drawn), "") << "seed " << seed;
    }
    EXPECT_GT(drawn, 10000u);
  });
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const spec::Design& d : spec::designs()) all.push_back(d.name);
  return all;
}
INSTANTIATE_TEST_SUITE_P(Designs, WholeTiles, testing::ValuesIn(names()),
                         [](const auto& p) { return p.param; });

// Formats at the ends of their ranges: codes of 32 bits, planes that need 64-bit lanes, stamps and
// tiles of every shape.
TEST(WholeTiles, EqualStampByStampInRandomDesigns) {
  for_each_level([] {
    Random random(5);
    uint64_t drawn = 0;
    int valid = 0;
    for (int i = 0; i < 400 && valid < 120; ++i) {
      spec::Design d;
      d.subpixel_bits = random.between(4, 12);
      d.guard_bits = random.between(7, 14);
      d.depth_test = random.between(0, 9) != 0;
      d.depth_bits = random.between(16, 32);
      d.attributes = random.between(0, 6);
      d.flat_attributes = random.between(0, 2);
      d.attribute_bits = random.between(1, 16);
      d.perspective = random.between(0, 4) == 0;
      d.gradient_fraction_bits = random.between(8, 20);
      d.tile_fraction_bits = random.between(1, d.gradient_fraction_bits);
      d.tile_log2 = random.between(2, 6);
      d.stamp_width_log2 = random.between(0, 2);
      d.stamp_height_log2 = random.between(0, 2);
      if (!spec::invalid_reason(d).empty()) continue;
      ++valid;
      const auto seed = static_cast<uint64_t>(i);
      ASSERT_EQ(compare(spec::contract(d), spec::contract(d), seed, &drawn), "")
          << "design " << i << ": " << d.subpixel_bits << " " << d.guard_bits << " depth "
          << d.depth_test << " " << d.depth_bits << " attr " << d.attributes << " "
          << d.flat_attributes << " " << d.attribute_bits << " persp " << d.perspective << " F "
          << d.gradient_fraction_bits << " " << d.tile_fraction_bits << " tile " << d.tile_log2
          << " " << d.stamp_width_log2 << " " << d.stamp_height_log2;
    }
    EXPECT_EQ(valid, 120);
    EXPECT_GT(drawn, 10000u);
  });
}

// Triangles over whole blocks, whose depths are equal or a code apart: what is hidden by what.
TEST(WholeTiles, EqualStampByStampWhereDepthsTie) {
  const spec::Contract c = spec::contract(spec::kHighTile);
  spec::FrameState frame;
  frame.width = 40;
  frame.height = 24;
  for_each_level([&] {
    Random random(11);
    for (const auto func : {spec::DepthFunc::kLess, spec::DepthFunc::kLequal}) {
      frame.depth = func;
      core::Renderer stamps(c, frame);
      fast::Renderer tiles(c, frame);
      for (int i = 0; i < 400; ++i) {
        spec::Triangle t;
        t.v[0].x = t.v[0].y = t.v[1].y = t.v[2].x = -4000;
        t.v[1].x = t.v[2].y = static_cast<int32_t>(random.between(4000, 40000));
        const int64_t z = (int64_t{4000 - i / 4} << 8) + random.between(-300, 300);
        const int64_t slope = random.between(-600, 600);
        t.v[0].z = z;
        t.v[1].z = z + slope;
        t.v[2].z = z - slope;
        for (auto& v : t.v) v.attr[0] = i % 256;
        stamps.draw(t);
        tiles.draw(t);
        ASSERT_EQ(stamps.counters().passed, tiles.counters().passed) << i;
      }
      EXPECT_EQ(stamps.buffer().depth, tiles.buffer().depth);
      EXPECT_EQ(stamps.buffer().color, tiles.buffer().color);
      EXPECT_LT(stamps.counters().passed, stamps.counters().fragments / 4 * 3);
    }
  });
}

// A scissor of a few pixels over the corner of four tiles makes small boxes of larger triangles: there the
// walk passes over tiles.
TEST(WholeTiles, SmallScissors) {
  const spec::Contract c = spec::contract(spec::kHighTile);
  for_each_level([&] {
    Random random(6);
    for (int i = 0; i < 300; ++i) {
      spec::FrameState frame;
      frame.width = frame.height = 24;
      frame.scissor_x0 = random.between(1, 15);
      frame.scissor_y0 = random.between(1, 15);
      frame.scissor_x1 = frame.scissor_x0 + random.between(1, 8);
      frame.scissor_y1 = frame.scissor_y0 + random.between(1, 8);
      core::Renderer stamps(c, frame);
      fast::Renderer tiles(c, frame);
      std::vector<spec::Triangle> triangles(100);
      for (spec::Triangle& t : triangles) stamps.draw(t = random_triangle(c, frame, &random));
      tiles.draw(triangles.data(), triangles.size());
      for (const core::FrameCounter& row : core::kFrameCounters) {
        ASSERT_EQ(row.of(stamps.counters()), row.of(tiles.counters())) << row.name << ' ' << i;
      }
      ASSERT_EQ(stamps.buffer().depth, tiles.buffer().depth) << i;
      ASSERT_EQ(stamps.buffer().color, tiles.buffer().color) << i;
    }
  });
}

// Lists are set up in batches: any length, with dropped triangles between others.
TEST(WholeTiles, ListsEqualTrianglesOneByOne) {
  const spec::Contract c = spec::contract(spec::kHighTile);
  Random random(3);
  const spec::FrameState frame = random_frame(&random);
  for (size_t count = 0; count < 60; ++count) {
    std::vector<spec::Triangle> triangles;
    for (size_t i = 0; i < count; ++i) triangles.push_back(random_triangle(c, frame, &random));
    if (count > 3) triangles[count / 2].v[1] = triangles[count / 2].v[0];
    fast::Renderer list(c, frame), each(c, frame);
    list.draw(triangles.data(), count);
    for (const auto& t : triangles) each.draw(t);
    EXPECT_EQ(list.buffer().depth, each.buffer().depth);
    EXPECT_EQ(list.buffer().color, each.buffer().color);
    EXPECT_EQ(list.buffer().hits, each.buffer().hits);
    EXPECT_EQ(list.counters().triangles, count);
    EXPECT_EQ(list.counters().passed, each.counters().passed);
  }
}

TEST(WholeTiles, UncountedHitsAreNone) {
  const spec::Contract c = spec::contract(spec::kHighTile);
  spec::FrameState frame;
  frame.width = frame.height = 20;
  fast::Renderer uncounted(c, frame, {}, fast::Renderer::Hits::kUncounted), counted(c, frame);
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    const spec::Triangle t = random_triangle(c, frame, &random);
    uncounted.draw(t);
    counted.draw(t);
  }
  EXPECT_EQ(uncounted.buffer().hits, std::vector<uint16_t>(400));
  EXPECT_NE(counted.buffer().hits, std::vector<uint16_t>(400));
  EXPECT_EQ(uncounted.buffer().depth, counted.buffer().depth);
  EXPECT_EQ(uncounted.buffer().color, counted.buffer().color);
}

// Which designs have codes as narrow as blocks need them: a list, so that none is lost in silence.
TEST(WholeTiles, DesignsWithBlocks) {
  std::string with;
  for (const spec::Design& d : spec::designs()) {
    if (has_blocks(spec::contract(d))) with += std::string(d.name) + " ";
  }
  EXPECT_EQ(with, "high_tile flat dense wide tiny ");
  spec::FrameState frame;
  EXPECT_TRUE(has_blocks(spec::contract(spec::kHighTile), frame));
  frame.bias_constant = 1;
  EXPECT_FALSE(has_blocks(spec::contract(spec::kHighTile), frame));
}

// Tiles whose planes keep a fraction bit less than those of the stamps.
TEST(WholeTiles, MutantThatCutsAFractionBitIsSeen) {
  spec::Design cut = spec::kHighTile;
  --cut.tile_fraction_bits;
  uint64_t drawn = 0;
  EXPECT_NE(compare(spec::contract(spec::kHighTile), spec::contract(cut), 1, &drawn), "");
}

}  // namespace
}  // namespace pineda::fast
