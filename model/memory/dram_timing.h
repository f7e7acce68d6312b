// Timing of depth and colour memories in DRAM, behind small caches whose lines are tiles.
#pragma once

#include <algorithm>
#include <array>
#include <memory>

#include "model/memory/tile_cache.h"
#include "model/memory/timing.h"

namespace pineda::memory {

struct CacheCounters {
  uint64_t hits = 0;
  uint64_t misses = 0;
  uint64_t write_backs = 0;
};

/// Two write-back caches, one for depth and one for colour, each with its own DRAM channel or both
/// on one.
///
/// A hit is served in the cycle of its acceptance, a miss when its fill is done. The port accepts
/// its next request in the cycle after that; a read is answered hit_latency_cycles after it is
/// served. So a port takes one hit a cycle, and a miss blocks only its own port. A miss requests
/// its line in the cycle after its acceptance; a dirty victim is written back after the fill. The
/// clear at the start of a frame takes no time; lines still dirty at its end are not written back.
/// Errors   parameters with an invalid_reason(): std::invalid_argument.
class DramTiming final : public MemoryTiming {
 public:
  DramTiming(const spec::Contract& contract, const DramParameters& parameters);
  DramTiming(const DramTiming&) = delete;  // the caches point to the channels
  DramTiming& operator=(const DramTiming&) = delete;

  void begin_frame(const spec::FrameState& frame) override;
  Cycle ready_from(MemoryPort port, Cycle from) override {
    return std::max(from, free_[static_cast<size_t>(port)]);
  }
  Cycle accept(MemoryPort port, Cycle cycle, int x, int y) override;

  const CacheCounters& depth_cache() const { return depth_.counters; }
  const CacheCounters& color_cache() const { return color_.counters; }
  /// Both are the same channel when merged.
  const ChannelCounters& depth_channel() const { return depth_.channel->counters(); }
  const ChannelCounters& color_channel() const { return color_.channel->counters(); }

 private:
  /// A cache and where its tiles lie in DRAM: in raster order of the tiles, in consecutive DRAM
  /// rows.
  struct Group {
    TileCache cache;
    DramChannel* channel;
    int burst_cycles;   // bus cycles of one tile
    int tiles_in_row;   // tiles in one DRAM row
    int64_t first_row;  // DRAM row of the first tile
    CacheCounters counters;
  };
  Group group(const DramParameters& parameters, int sample_bytes, DramChannel* channel) const;
  TileCache::Line* fill(Group* group, Cycle cycle, int column, int row);
  int64_t dram_row(const Group& group, int column, int row) const;

  int tile_log2_, columns_log2_, rows_log2_;  // a tile's size in px; in stamps
  int banks_;
  int hit_latency_cycles_;
  int columns_ = 0;  // tiles in a row of the frame
  std::array<DramChannel, 2> channels_;
  Group depth_, color_;
  std::array<Cycle, kMemoryPorts> free_{};  // the port takes a request from this cycle on
};

/// One channel for depth and one for colour. `latency_cycles` is ignored: it is of the ideal
/// memory.
std::shared_ptr<MemoryTiming> make_dram(const spec::Contract& contract, int latency_cycles);
/// One channel for both.
std::shared_ptr<MemoryTiming> make_dram_merged(const spec::Contract& contract, int latency_cycles);

}  // namespace pineda::memory
