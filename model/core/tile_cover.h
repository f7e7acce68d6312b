// Traversal by whole tiles: the fast path to what TileWalk and StampWalk define.
#pragma once

#include <vector>

#include "model/core/traversal.h"

namespace pineda::core {

inline constexpr int kBlockPx = 8;  // side of the blocks of samples that are computed together

/// Blocks side by side in a tile; one that is larger than the tile counts.
constexpr int blocks_across(const spec::Design& d) {
  return d.tile_log2 <= 3 ? 1 : 1 << (d.tile_log2 - 3);
}

/// The block of the sample in column x, row y of a tile.
constexpr size_t block_of(const spec::Design& d, int x, int y) {
  return static_cast<size_t>(y / kBlockPx) * static_cast<size_t>(blocks_across(d)) +
         static_cast<size_t>(x / kBlockPx);
}

/// Some samples of a tile, and the stamps that have one.
struct TileSamples {
  std::vector<uint64_t> blocks;  // row by row; bit 8*y + x is the block's sample in column x, row y

  // By stamp test in the order of the walk, see TileCover.
  std::vector<uint64_t> stamps;  // a bit each: it has one of the samples
  std::vector<uint16_t> mask;    // if asked for: a bit a lane

  int count = 0;         // stamps that have one
  int sample_count = 0;  // of all of them
  int first = 0;         // stamp tests of the first and the last of them
  int last = 0;

  explicit TileSamples(const spec::Design& design);

  /// Calls visit(test) for each stamp that has a sample.
  template <class Visitor>
  void for_each_stamp(Visitor&& visit) const {
    if (count == 0) return;
    for (size_t word = 0; word <= static_cast<size_t>(last) / 64; ++word) {
      for (uint64_t bits = stamps[word]; bits != 0; bits &= bits - 1) {
        visit(static_cast<int>(word * 64) + __builtin_ctzll(bits));
      }
    }
  }
};

/// Stamps and samples, of many tiles.
struct StampCounts {
  uint64_t stamps = 0;
  uint64_t samples = 0;

  void add(const TileSamples& tile) {
    stamps += static_cast<uint64_t>(tile.count);
    samples += static_cast<uint64_t>(tile.sample_count);
  }
};

/// Stamps by the number of their samples; [0] stays 0.
using StampsBySamples = std::array<uint64_t, spec::kMaxLanes + 1>;

/// A tile that no edge rejects, with the coverage of its stamps.
struct TileCover {
  int x = 0, y = 0;                    // column and row, in tiles
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // box clipped to the tile, px from the tile's corner
  uint32_t accepted = 0;               // bit i: edge i accepts every sample of the tile
  // The stamps of that box, from the tile's corner. Stamp tests are counted row by row.
  int column0 = 0, columns = 0;
  int row0 = 0, rows = 0;
  bool full = false;  // every sample of the tile is covered: then there are masks, asked for or not
  TileSamples covered;

  explicit TileCover(const spec::Contract& contract) : covered(contract.design) {}
  int tests() const { return columns * rows; }
  /// Calls visit(test, place) for each stamp that has a sample; place: its number in the whole
  /// tile, row by row, which is 2^columns_log2 stamps wide.
  template <class Visitor>
  void for_each_stamp(const TileSamples& samples, int columns_log2, Visitor&& visit) const {
    int row_end = columns;  // the first test of the next row
    int place = (row0 << columns_log2) + column0;
    samples.for_each_stamp([&](int test) {
      for (; test >= row_end; row_end += columns) place += (1 << columns_log2) - columns;
      visit(test, place + test);
    });
  }
};

/// Finds the stamps in the box from the blocks, and adds them to *by_samples, if that is there.
void find_stamps(const spec::Design& design, const TileCover& box, bool with_masks,
                 TileSamples* samples, StampsBySamples* by_samples);

/// Samples of a stamp, up to 16. (A call of its own would cost more than it counts.)
inline int count_lanes(uint32_t mask) {
  mask -= mask >> 1 & 0x5555;
  mask = (mask & 0x3333) + (mask >> 2 & 0x3333);
  mask = (mask + (mask >> 4)) & 0x0f0f;
  return static_cast<int>((mask + (mask >> 8)) & 0x1f);
}

/// Walks the tiles of a triangle's box as TileWalk does, and finds the coverage of all stamps of a
/// tile at once.
///
/// Bits     those of TileWalk and StampWalk.
/// In       begin(): a SetupPrim, which must outlive the walk; its planes are not looked at.
/// Out      next(): one tile test a call; *cover is written when the tile is kept, but for its
///          samples, which cover_stamps() then finds.
class TileCoverWalk {
 public:
  explicit TileCoverWalk(const spec::Contract& contract) : contract_(contract) {}

  void begin(const spec::SetupPrim& prim);
  TileWalk::Test next(TileCover* cover);
  /// Of the tile that next() kept last; adds its stamps to *by_samples, if that is there.
  void cover_stamps(bool with_masks, TileCover* cover, StampsBySamples* by_samples) const;

 private:
  spec::Contract contract_;
  const spec::SetupPrim* prim_ = nullptr;
  int x_ = 0, y_ = 0;  // the tile that next() tests
  int first_x_ = 0, last_x_ = 0, last_y_ = 0;
  std::array<int64_t, 3> best_{}, worst_{};     // from a tile's first sample to those corners
  std::array<int64_t, 3> edge_{}, row_edge_{};  // E' at the first sample of the tile, of its row
  std::array<int64_t, 3> kept_{};               // the same of the tile kept last
};

}  // namespace pineda::core
