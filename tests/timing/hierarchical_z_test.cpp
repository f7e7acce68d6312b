// Hierarchical z in time: the frame is the same, but tiles that are hidden are not walked.
#include <gtest/gtest.h>

#include "tests/timing/support.h"

namespace pineda::timing {
namespace {

spec::Contract hierarchical(int delay_cycles) {
  spec::Design d = spec::kHighTile;
  d.hierarchical_z = true;
  d.hierarchical_z_delay_cycles = delay_cycles;
  return spec::contract(d);
}

// Worked by hand: a frame of one tile of 16 stamps.
class OneTile : public testing::Test {
 protected:
  OneTile() { z_.begin_frame({8, 8, spec::Cull::kNone, spec::DepthFunc::kLess}); }
  void fill(Cycle from, uint32_t depth) {
    for (int i = 0; i < 16; ++i) z_.update(from + i, {i % 4, i / 4, depth});
  }

  static constexpr int kDelay = 3;
  HierarchicalZ z_{hierarchical(kDelay)};
};

TEST_F(OneTile, NothingIsHiddenBeforeEveryStampIsWritten) {
  fill(10, 100);
  EXPECT_FALSE(z_.hides(24, 0, 0, 4095));  // the cleared depth is not less
  EXPECT_FALSE(z_.hides(27, 0, 0, 101));   // the last write, of cycle 25, is seen from 28 on
  EXPECT_TRUE(z_.hides(28, 0, 0, 101));
}

TEST_F(OneTile, EqualDepthsMayPassSoTheyAreNotHidden) {
  fill(0, 100);
  EXPECT_FALSE(z_.hides(40, 0, 0, 100));
  EXPECT_TRUE(z_.hides(40, 0, 0, 101));
}

TEST_F(OneTile, TheGreatestOfItsStampsCounts) {
  fill(0, 100);
  z_.update(30, {2, 1, 500});
  EXPECT_FALSE(z_.hides(40, 0, 0, 500));
  EXPECT_TRUE(z_.hides(40, 0, 0, 501));
}

TEST_F(OneTile, AFrameStartsClear) {
  fill(0, 0);
  z_.begin_frame({8, 8, spec::Cull::kNone, spec::DepthFunc::kLess});
  EXPECT_FALSE(z_.hides(100, 0, 0, 4095));
}

// Cleared to .5, of which the top twelve of 24 bits are kept: what lies behind is hidden before
// anything is drawn; later writes count as usual.
TEST_F(OneTile, AFrameHidesWhatLiesBehindItsClearedDepth) {
  spec::FrameState frame{8, 8, spec::Cull::kNone, spec::DepthFunc::kLess};
  frame.clear_depth = .5;
  z_.begin_frame(frame);
  EXPECT_FALSE(z_.hides(0, 0, 0, 2048));
  EXPECT_TRUE(z_.hides(0, 0, 0, 2049));
  z_.update(1, {0, 0, 100});  // fifteen stamps are still clear
  EXPECT_FALSE(z_.hides(10, 0, 0, 2048));
  EXPECT_TRUE(z_.hides(10, 0, 0, 2049));
  fill(11, 100);
  EXPECT_TRUE(z_.hides(40, 0, 0, 101));
  frame.clear_depth = 0;
  z_.begin_frame(frame);
  EXPECT_FALSE(z_.hides(0, 0, 0, 0));
  EXPECT_TRUE(z_.hides(0, 0, 0, 1));
}

TEST_F(OneTile, StampsOutsideTheFrameHideNothing) {
  z_.begin_frame({3, 1, spec::Cull::kNone, spec::DepthFunc::kLess});
  z_.update(0, {0, 0, 7});
  z_.update(1, {1, 0, 9});
  EXPECT_FALSE(z_.hides(10, 0, 0, 9));
  EXPECT_TRUE(z_.hides(10, 0, 0, 10));
}

TEST(HierarchicalZ, OnlyLessAndLequalHide) {
  for (int func = 0; func < 9; ++func) {
    HierarchicalZ z(hierarchical(1));
    z.begin_frame({8, 8, spec::Cull::kNone, static_cast<spec::DepthFunc>(func)});
    EXPECT_EQ(z.is_active(), func < 2) << func;
  }
}

TEST(HierarchicalZ, TilesBeyondThoseKeptAreNeverHidden) {
  spec::Design d = spec::kHighTile;
  d.hierarchical_z = true;
  d.hierarchical_z_tiles = 1;
  HierarchicalZ z(spec::contract(d));
  z.begin_frame({16, 8, spec::Cull::kNone, spec::DepthFunc::kLess});
  for (int i = 0; i < 32; ++i) z.update(i, {i % 8, i / 8, 0});
  EXPECT_TRUE(z.hides(100, 0, 0, 1));
  EXPECT_FALSE(z.hides(100, 1, 0, 4095));
}

}  // namespace
}  // namespace pineda::timing
