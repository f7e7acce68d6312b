// The tags of a set-associative cache whose lines are tiles of the frame.
#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

#include "model/memory/dram_channel.h"

namespace pineda::memory {

class TileCache {
 public:
  struct Line {
    int column = -1, row = -1;  // of the tile; -1: the line is empty
    bool dirty = false;
    Cycle filled = 0;   // its data are in the cache from this cycle on
    uint64_t used = 0;  // time stamp of the last use, for LRU
  };

  explicit TileCache(const DramParameters& p)
      : columns_log2_(p.set_columns_log2), rows_log2_(p.set_rows_log2), ways_(p.ways) {
    reset();
  }

  void reset() {
    lines_.assign(static_cast<size_t>(ways_) << (columns_log2_ + rows_log2_), Line{});
    uses_ = 0;
  }

  /// The line that holds a tile, marked as most recently used; nullptr on a miss.
  Line* find(int column, int row) {
    Line* const first = set(column, row);
    Line* const line = std::find_if(
        first, first + ways_, [&](const Line& l) { return l.column == column && l.row == row; });
    if (line == first + ways_) return nullptr;
    line->used = ++uses_;
    return line;
  }

  /// The line to evict for a tile: the least recently used one of its set, lines still being filled
  /// last. Marked as most recently used.
  Line* victim(Cycle cycle, int column, int row) {
    Line* const first = set(column, row);
    Line* const line = std::min_element(first, first + ways_, [&](const Line& a, const Line& b) {
      return std::tuple(a.filled > cycle, a.used) < std::tuple(b.filled > cycle, b.used);
    });
    line->used = ++uses_;
    return line;
  }

 private:
  Line* set(int column, int row) {
    const int x = column & ((1 << columns_log2_) - 1);
    const int y = row & ((1 << rows_log2_) - 1);
    return &lines_[static_cast<size_t>(y << columns_log2_ | x) * static_cast<size_t>(ways_)];
  }

  int columns_log2_, rows_log2_, ways_;
  std::vector<Line> lines_;  // set by set
  uint64_t uses_ = 0;
};

}  // namespace pineda::memory
