// Timing of one DRAM channel: banks with an open row each, refresh, and a shared data bus.
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

  // One cache for depth and one for colour. A line holds one tile, since a triangle's stamps come
  // tile by tile. The set index is the low bits of the tile's column and row, so that neighbouring
  // tiles fall into different sets.
  int set_columns_log2 = 2;
  int set_rows_log2 = 2;
  int ways = 2;                // depth read and depth write may both wait for a fill in one set
  int hit_latency_cycles = 3;  // tags, data, a register
};

/// Empty if the parameters are valid, else the reason why not, in one line.
std::string invalid_reason(const DramParameters& parameters);

struct ChannelCounters {
  uint64_t row_hits = 0;
  uint64_t row_misses = 0;
  uint64_t row_conflicts = 0;
  Cycle refresh_wait = 0;  // cycles in which bursts waited for a refresh
  Cycle busy = 0;          // cycles with data on the bus
};

/// Serves bursts in the order of the requests.
///
/// The command of a burst is issued as soon as the data of the previous burst start on the bus, not
/// earlier, so that row hits follow one another without a gap. A bank opens another row only when
/// its last burst is over. A refresh starts at every multiple of the interval: it closes all rows,
/// and no command is issued for refresh_cycles. Bursts issued before it finish.
class DramChannel {
 public:
  explicit DramChannel(const DramParameters& parameters) : parameters_(parameters) { reset(); }

  void reset();
  /// Transfers a burst of `cycles` bus cycles from or to a row, requested in cycle `arrival`. Row r
  /// lies in bank r % banks. Returns the first cycle after the burst's last one on the bus.
  Cycle serve(Cycle arrival, int64_t row, int cycles);
  const ChannelCounters& counters() const { return counters_; }

 private:
  static constexpr int64_t kClosed = -1;
  struct Bank {
    int64_t row = kClosed;
    Cycle idle = 0;     // its last burst is over from this cycle on
    int64_t epoch = 0;  // number of refreshes before its last burst
  };
  Cycle after_refresh(Cycle cycle) const;
  int open(Bank* bank, int64_t row);

  DramParameters parameters_;
  std::vector<Bank> banks_;
  Cycle order_free_ = 0;  // the next command can be issued from this cycle on
  Cycle bus_free_ = 0;    // the bus is free from this cycle on
  ChannelCounters counters_;
};

}  // namespace pineda::memory
