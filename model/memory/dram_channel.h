// One channel of DRAM: banks with a row open, refresh, a bus.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/memory/port.h"

namespace pineda::memory {

/// DRAM and the caches in front of it, in cycles of the rasterizer.
///
/// The defaults are those of a rasterizer at 400 MHz (2.5 ns) with two x16 parts of 2 Gb DDR3L-1600
/// on each channel: 32 bits * 1600 MT/s = 16 bytes a cycle. Times: Alliance AS4C128M16D3LB-12
/// datasheet, speed bin 11-11-11 (tAA = tRCD = tRP = 13.75 ns, tRFC = 160 ns, tREFI = 7.8 us);
/// banks and the row's 2 KB a part: JEDEC JESD79-3. Controller and PHY come on top in a real
/// system: add them to the three row times.
struct DramParameters {
  // DRAM
  int banks = 8;
  int row_bytes = 4096;                // of a channel: 2 KB in each of two parts
  int bus_bytes = 16;                  // a cycle
  int row_hit_cycles = 6;              // command to first data: tAA
  int row_miss_cycles = 11;            // tRCD + tAA: no row is open
  int row_conflict_cycles = 17;        // tRP + tRCD + tAA: another row is open
  int refresh_interval_cycles = 3120;  // tREFI
  int refresh_cycles = 64;             // tRFC
  bool merged = false;                 // depth and colour share a channel

  // A cache for depth, one for colour. A line is a tile: the stamps of a triangle come tile by
  // tile. Sets lie in a rectangle of tiles, so that neighbours do not evict one another.
  int set_columns_log2 = 2;
  int set_rows_log2 = 2;
  int ways = 2;                // both ports of depth may wait for a fill in one set
  int hit_latency_cycles = 3;  // tags, data, a register
};

/// Empty if a memory can be so, else why not, in one line.
std::string invalid_reason(const DramParameters& parameters);

struct ChannelCounters {
  uint64_t row_hits = 0;
  uint64_t row_misses = 0;
  uint64_t row_conflicts = 0;
  Cycle refresh_wait = 0;  // cycles in which bursts waited for a refresh
  Cycle busy = 0;          // cycles with data on the bus
};

/// Serves bursts in the order in which they are asked for.
///
/// A burst is ordered while the data of the one before are on the bus, not earlier, so that row
/// hits follow one another without a gap. Another row of a bank opens when the bank's last burst is
/// over. Refresh is due every interval, a pure function of time: nothing is ordered for
/// refresh_cycles then, and all rows are closed; what was ordered before is finished.
class DramChannel {
 public:
  explicit DramChannel(const DramParameters& parameters) : parameters_(parameters) { reset(); }

  void reset();
  /// A burst of `cycles` on the bus from or to a row, asked for in `arrival`; rows are numbered
  /// bank by bank. Returns the first cycle in which all of it is there.
  Cycle serve(Cycle arrival, int64_t row, int cycles);
  const ChannelCounters& counters() const { return counters_; }

 private:
  static constexpr int64_t kClosed = -1;
  struct Bank {
    int64_t row = kClosed;
    Cycle idle = 0;     // its last burst is over
    int64_t epoch = 0;  // refreshes before the row was opened
  };
  Cycle after_refresh(Cycle cycle) const;
  int open(Bank* bank, int64_t row);

  DramParameters parameters_;
  std::vector<Bank> banks_;
  Cycle order_free_ = 0;  // the next burst can be ordered
  Cycle bus_free_ = 0;
  ChannelCounters counters_;
};

}  // namespace pineda::memory
