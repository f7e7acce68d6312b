// The caches worked by hand, with the default parameters: tiles of 8x8 px are 4x4 stamps and 256
// bytes, so 16 cycles on the bus and 16 tiles in a DRAM row; 4x4 sets of two; hits answered in 3.
#include "model/memory/dram_timing.h"

#include <gtest/gtest.h>

#include <memory>

namespace pineda::memory {
namespace {

constexpr spec::Contract kContract = spec::contract(spec::kHighTile);
constexpr auto kRead = MemoryPort::kDepthRead;
constexpr auto kWrite = MemoryPort::kDepthWrite;
constexpr auto kColor = MemoryPort::kColorWrite;
constexpr int kTile = 4;  // stamps along a tile's side

class DramTimingTest : public testing::Test {
 protected:
  DramTimingTest() { begin(DramParameters()); }

  void begin(const DramParameters& parameters) {
    timing_ = std::make_unique<DramTiming>(kContract, parameters);
    spec::FrameState frame;
    frame.width = 640;
    frame.height = 480;
    timing_->begin_frame(frame);
  }

  std::unique_ptr<DramTiming> timing_;
};

// Requested in 101 from a closed bank: data in 112 .. 127, served in 128.
TEST_F(DramTimingTest, MissWaitsForItsFillAndBlocksItsPortAlone) {
  EXPECT_EQ(timing_->ready_from(kRead, 100), 100);
  EXPECT_EQ(timing_->accept(kRead, 100, 0, 0), 128 + 3);
  EXPECT_EQ(timing_->ready_from(kRead, 101), 129);
  EXPECT_EQ(timing_->ready_from(kWrite, 101), 101);
  EXPECT_EQ(timing_->ready_from(kColor, 101), 101);
  EXPECT_EQ(timing_->depth_cache().misses, 1u);
}

TEST_F(DramTimingTest, HitsAreAnsweredOneACycle) {
  timing_->accept(kRead, 100, 0, 0);
  for (Cycle t = 129; t < 133; ++t) {
    EXPECT_EQ(timing_->ready_from(kRead, t), t);
    EXPECT_EQ(timing_->accept(kRead, t, 3, static_cast<int>(t - 129)), t + 3);
  }
  EXPECT_EQ(timing_->depth_cache().hits, 4u);
}

TEST_F(DramTimingTest, WriteToATileUnderWayWaitsForTheSameFill) {
  timing_->accept(kRead, 100, 0, 0);
  timing_->accept(kWrite, 105, 1, 1);
  EXPECT_EQ(timing_->ready_from(kWrite, 106), 129);
  EXPECT_EQ(timing_->depth_cache().misses, 1u);
}

// The next tile lies in the same DRAM row: behind the first one's data, 128 .. 143.
TEST_F(DramTimingTest, SecondMissQueuesBehindTheFirst) {
  timing_->accept(kRead, 100, 0, 0);
  timing_->accept(kWrite, 105, kTile, 0);
  EXPECT_EQ(timing_->ready_from(kWrite, 106), 145);
  EXPECT_EQ(timing_->depth_channel().row_hits, 1u);
}

// Columns 0, 4 and 8 share a set of two. The third fill's data come in 307 .. 322, the write-back
// follows until 338; a read in 324 finds the bus taken until then: 339 .. 354.
TEST_F(DramTimingTest, DirtyTileIsWrittenBackBehindTheFill) {
  timing_->accept(kWrite, 100, 0, 0);
  timing_->accept(kRead, 200, 4 * kTile, 0);
  EXPECT_EQ(timing_->depth_cache().write_backs, 0u);
  EXPECT_EQ(timing_->accept(kRead, 300, 8 * kTile, 0), 323 + 3);
  EXPECT_EQ(timing_->depth_cache().write_backs, 1u);
  EXPECT_EQ(timing_->accept(kRead, 324, kTile, 0), 355 + 3);
}

TEST_F(DramTimingTest, LeastRecentlyUsedTileIsEvicted) {
  timing_->accept(kRead, 100, 0, 0);
  timing_->accept(kRead, 200, 4 * kTile, 0);
  timing_->accept(kRead, 300, 0, 0);
  timing_->accept(kRead, 400, 8 * kTile, 0);
  EXPECT_EQ(timing_->accept(kRead, 500, 0, 0), 503);
  EXPECT_GT(timing_->accept(kRead, 600, 4 * kTile, 0), 603);
}

// The read's tile is filled until 128 and is the least recently used one of its set in 110.
TEST_F(DramTimingTest, TileThatIsBeingFilledIsNotEvicted) {
  timing_->accept(kWrite, 10, 4 * kTile, 0);
  timing_->accept(kRead, 100, 0, 0);
  timing_->accept(kWrite, 101, 4 * kTile, 0);
  timing_->accept(kWrite, 110, 8 * kTile, 0);
  EXPECT_EQ(timing_->accept(kRead, 200, 0, 0), 203);
}

// Each row of tiles has cache sets of its own, so a square of 4x4 tiles stays in the cache.
TEST_F(DramTimingTest, NeighboursDoNotEvictOneAnother) {
  Cycle t = 0;
  for (int pass = 0; pass < 2; ++pass) {
    for (int tile = 0; tile < 16; ++tile) {
      t = timing_->ready_from(kRead, t + 1);
      timing_->accept(kRead, t, (tile & 3) * kTile, (tile >> 2) * kTile);
    }
  }
  EXPECT_EQ(timing_->depth_cache().misses, 16u);
  EXPECT_EQ(timing_->depth_cache().hits, 16u);
}

TEST_F(DramTimingTest, ColorHasAChannelOfItsOwn) {
  timing_->accept(kRead, 100, 0, 0);
  timing_->accept(kColor, 100, 0, 0);
  EXPECT_EQ(timing_->ready_from(kColor, 101), 129);
}

// The colour's burst follows the depth's data, 128 .. 143; its bank is another one and opens
// meanwhile.
TEST_F(DramTimingTest, MergedColorQueuesBehindDepth) {
  DramParameters merged;
  merged.merged = true;
  begin(merged);
  timing_->accept(kRead, 100, 0, 0);
  timing_->accept(kColor, 100, 0, 0);
  EXPECT_EQ(timing_->ready_from(kColor, 101), 145);
  EXPECT_EQ(timing_->color_channel().row_misses, 2u);
}

TEST_F(DramTimingTest, FramesDoNotDependOnTheOnesBefore) {
  timing_->accept(kRead, 100, 0, 0);
  timing_->begin_frame({640, 480});
  EXPECT_EQ(timing_->ready_from(kRead, 5), 5);
  EXPECT_EQ(timing_->accept(kRead, 100, 0, 0), 131);
  EXPECT_EQ(timing_->depth_cache().misses, 1u);
}

TEST_F(DramTimingTest, WrongParametersAreRefused) {
  DramParameters p;
  p.ways = 1;
  EXPECT_THROW(DramTiming(kContract, p), std::invalid_argument);
}

}  // namespace
}  // namespace pineda::memory
