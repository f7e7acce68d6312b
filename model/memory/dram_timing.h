// Depth and colour in DRAM behind small caches of tiles.
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

/// A cache for depth and one for colour, write-back, each on a channel of its own or both on one.
///
/// An access is served in the cycle in which its line is there: that of its acceptance, or that in
/// which a fill is done. Its port takes the next one in the cycle after; a read is answered
/// hit_latency_cycles after it is served. So hits go one a cycle, and a miss blocks its own port
/// alone. A miss asks for its line in the cycle after its acceptance; what it evicts, if dirty, is
/// written back behind the fill. The clear at the start of a frame takes no time; lines still dirty
/// at its end are not written back.
/// Errors   parameters with an invalid_reason(): std::invalid_argument.
class DramTiming final : public MemoryTiming {
 public:
  DramTiming(const spec::Contract& contract, const DramParameters& parameters);
  DramTiming(const DramTiming&) = delete;  // the caches know their channels
  DramTiming& operator=(const DramTiming&) = delete;

  void begin_frame(const spec::FrameState& frame) override;
  Cycle ready_from(MemoryPort port, Cycle from) override {
    return std::max(from, free_[static_cast<size_t>(port)]);
  }
  Cycle accept(MemoryPort port, Cycle cycle, int x, int y) override;

  const CacheCounters& depth_cache() const { return depth_.counters; }
  const CacheCounters& color_cache() const { return color_.counters; }
  /// The same one when merged.
  const ChannelCounters& depth_channel() const { return depth_.channel->counters(); }
  const ChannelCounters& color_channel() const { return color_.channel->counters(); }

 private:
  /// A cache and where its tiles lie in DRAM: row by row of the frame, a DRAM row after the other.
  struct Group {
    TileCache cache;
    DramChannel* channel;
    int burst_cycles;   // of a tile
    int tiles_in_row;   // of the DRAM
    int64_t first_row;  // of the DRAM
    CacheCounters counters;
  };
  Group group(const DramParameters& parameters, int sample_bytes, DramChannel* channel) const;
  TileCache::Line* fill(Group* group, Cycle cycle, int column, int row);
  int64_t dram_row(const Group& group, int column, int row) const;

  int tile_log2_, columns_log2_, rows_log2_;  // px of a tile; its stamps
  int banks_;
  int hit_latency_cycles_;
  int columns_ = 0;  // tiles in a row of the frame
  std::array<DramChannel, 2> channels_;
  Group depth_, color_;
  std::array<Cycle, kMemoryPorts> free_{};  // the port takes a request from this cycle on
};

/// A channel for depth, one for colour; an ideal memory's latency is not theirs.
std::shared_ptr<MemoryTiming> make_dram(const spec::Contract& contract, int latency_cycles);
/// One channel for both.
std::shared_ptr<MemoryTiming> make_dram_merged(const spec::Contract& contract, int latency_cycles);

}  // namespace pineda::memory
