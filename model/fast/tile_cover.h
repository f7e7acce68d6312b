// Traversal by whole tiles: what core::TileWalk and core::StampWalk define, quickly.
#pragma once

#include <vector>

#include "model/fast/tile_steps.h"

namespace pineda::fast {

inline constexpr int kBlockPx = 8;  // side of the blocks of samples that are computed together

/// Blocks along a tile's side; 1 if the tile is smaller than a block.
constexpr int blocks_across(const spec::Design& d) {
  return d.tile_log2 <= 3 ? 1 : 1 << (d.tile_log2 - 3);
}

/// The block of the sample in column x, row y of a tile.
constexpr size_t block_of(const spec::Design& d, int x, int y) {
  return static_cast<size_t>(y / kBlockPx) * static_cast<size_t>(blocks_across(d)) +
         static_cast<size_t>(x / kBlockPx);
}

/// How many stamps a tile has, as a power of two.
constexpr int stamps_log2(const spec::Design& d) {
  return 2 * d.tile_log2 - d.stamp_width_log2 - d.stamp_height_log2;
}

/// Calls visit(number) for each bit that is set.
template <class Visitor>
void for_each_bit(const uint64_t* words, size_t count, Visitor&& visit) {
  for (size_t word = 0; word < count; ++word) {
    for (uint64_t bits = words[word]; bits != 0; bits &= bits - 1) {
      visit(static_cast<int>(word * 64) + __builtin_ctzll(bits));
    }
  }
}

/// Bits that are set. (Where the compiler may not count on an instruction, it calls a function.)
inline int count_bits(uint64_t bits) {
  bits -= bits >> 1 & 0x5555555555555555;
  bits = (bits & 0x3333333333333333) + (bits >> 2 & 0x3333333333333333);
  bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0f;
  return static_cast<int>(bits * 0x0101010101010101 >> 56);
}

/// Some samples of a tile, and the stamps that have one of them. A stamp's place is its number in
/// the whole tile, row by row.
struct TileSamples {
  std::vector<uint64_t> blocks;  // row by row; bit 8*y + x is the block's sample in column x, row y
  std::vector<uint64_t> stamps;  // one bit for each: it has one of the samples

  int count = 0;         // stamps that have a sample
  int sample_count = 0;  // samples of all stamps
  int first = 0;         // places of the first and the last stamp that has one
  int last = 0;

  explicit TileSamples(const spec::Design& design);

  bool has(int place) const {
    return (stamps[static_cast<size_t>(place) / 64] >> (place % 64) & 1) != 0;
  }
  /// How many stamps before this place have a sample.
  int before(int place) const {
    int n = 0;
    for (int word = 0; word < place / 64; ++word)
      n += count_bits(stamps[static_cast<size_t>(word)]);
    const uint64_t below = (uint64_t{1} << (place % 64)) - 1;
    return n + count_bits(stamps[static_cast<size_t>(place) / 64] & below);
  }
  /// Calls visit(place) for each stamp that has a sample.
  template <class Visitor>
  void for_each_stamp(Visitor&& visit) const {
    for_each_bit(stamps.data(), stamps.size(), visit);
  }
};

/// The samples of a stamp, a bit a lane.
uint32_t lanes_of(const spec::Design& design, const TileSamples& samples, int place);

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

/// The groups of a tile's stamps that are tested together for coverage, those inside the triangle's
/// box: row by row, so tests and places come in the same order.
struct GroupBox {
  int column0 = 0, columns = 0;  // of groups, from the tile's corner
  int row0 = 0, rows = 0;
  int columns_log2 = 0;  // of stamps, in the whole tile
  int group_log2 = 0;    // stamps of a group

  int tests() const { return columns * rows; }
  /// Number of the test of the stamp at a place in the box.
  int test_of(int place) const {
    const int row = (place >> columns_log2) - row0;
    const int column = ((place & ((1 << columns_log2) - 1)) >> group_log2) - column0;
    return row * columns + column;
  }
};

/// The groups that have a stamp with a sample; no meaning where there is none.
struct CoveredGroups {
  int first = 0, last = 0;  // numbers of their tests
  int count = 0;
  int before_last = 0;  // stamps with a sample before the last group
};

/// A tile that no edge rejects, with the coverage of its stamps.
struct TileCover {
  int x = 0, y = 0;                    // column and row, in tiles
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // box clipped to the tile, px from the tile's corner
  bool accepted = false;               // every edge accepts every sample of the tile
  bool full = false;                   // every sample of the tile is covered
  GroupBox box;
  TileSamples covered;
  CoveredGroups groups;

  explicit TileCover(const spec::Contract& contract) : covered(contract.design) {
    box.columns_log2 = contract.design.tile_log2 - contract.design.stamp_width_log2;
    box.group_log2 = contract.width.tested_stamps_log2;
  }
};

/// Finds the stamps from the blocks in the box.
void find_stamps(const spec::Design& design, const TileCover& box, TileSamples* samples);

/// Samples of a stamp, up to 16. (Inline, since a call would cost more than the count.)
inline int count_lanes(uint32_t mask) {
  mask -= mask >> 1 & 0x5555;
  mask = (mask & 0x3333) + (mask >> 2 & 0x3333);
  mask = (mask + (mask >> 4)) & 0x0f0f;
  return static_cast<int>((mask + (mask >> 8)) & 0x1f);
}

/// Walks the tiles of a triangle's box as core::TileWalk does, and finds the coverage of all stamps
/// of a tile at once.
///
/// Bits     those of core::TileWalk and core::StampWalk.
/// In       begin(): a SetupPrim, which must outlive the walk; its planes are not looked at; the rows
///          of tiles that are wanted.
/// Out      next(): one tile test a call; *cover is written when the tile is kept, except for its
///          samples and groups, which cover_stamps() finds.
class TileCoverWalk {
 public:
  explicit TileCoverWalk(const spec::Contract& contract) : contract_(contract) {}

  void begin(const spec::SetupPrim& prim, core::TileRows rows = {});
  core::TileWalk::Test next(TileCover* cover);
  /// Calls next() until a tile is kept; false if there is none left. *rejected: tiles before it.
  bool next_kept(TileCover* cover, int* rejected);
  /// Finds the samples of the tile kept last; adds its stamps to *by_samples unless that is null.
  void cover_stamps(TileCover* cover, StampsBySamples* by_samples) const;

 private:
  void keep(TileCover* cover);

  spec::Contract contract_;
  const spec::SetupPrim* prim_ = nullptr;
  TileSteps steps_;
  EdgeValues kept_{};  // TileSteps::lowered() of the tile kept last
};

}  // namespace pineda::fast
