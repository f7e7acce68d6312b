#include "model/memory/dram_channel.h"

#include <algorithm>

namespace pineda::memory {

std::string invalid_reason(const DramParameters& p) {
  if (std::min({p.banks, p.row_bytes, p.bus_bytes, p.refresh_cycles}) < 1) {
    return "banks, bytes of a row and of the bus, cycles of a refresh: expected 1 or more";
  }
  if (p.row_hit_cycles < 1 || p.row_miss_cycles < p.row_hit_cycles ||
      p.row_conflict_cycles < p.row_miss_cycles) {
    return "cycles of a row: expected 1 <= hit <= miss <= conflict";
  }
  if (p.refresh_interval_cycles <= p.refresh_cycles) {
    return "a refresh must be over before the next is due";
  }
  if (std::min(p.set_columns_log2, p.set_rows_log2) < 0 ||
      std::max(p.set_columns_log2, p.set_rows_log2) > 8) {
    return "sets of a cache: expected 2^0 to 2^8 in each direction";
  }
  if (p.ways < 2) return "ways of a cache: expected 2 or more, one for each port of depth";
  if (p.hit_latency_cycles < 1) return "hit latency: expected 1 cycle or more";
  return {};
}

void DramChannel::reset() {
  banks_.assign(static_cast<size_t>(parameters_.banks), Bank{});
  order_free_ = bus_free_ = 0;
  counters_ = {};
}

Cycle DramChannel::after_refresh(Cycle cycle) const {
  const Cycle interval = parameters_.refresh_interval_cycles;
  const Cycle phase = cycle % interval;
  const bool refreshing = cycle >= interval && phase < parameters_.refresh_cycles;
  return refreshing ? cycle - phase + parameters_.refresh_cycles : cycle;
}

int DramChannel::open(Bank* bank, int64_t row) {
  if (bank->row == row) {
    ++counters_.row_hits;
    return parameters_.row_hit_cycles;
  }
  const bool closed = bank->row == kClosed;
  ++(closed ? counters_.row_misses : counters_.row_conflicts);
  bank->row = row;
  return closed ? parameters_.row_miss_cycles : parameters_.row_conflict_cycles;
}

Cycle DramChannel::serve(Cycle arrival, int64_t row, int cycles) {
  Bank& bank = banks_[static_cast<size_t>(row % parameters_.banks)];
  const Cycle wanted = std::max({arrival, order_free_, bank.row == row ? 0 : bank.idle});
  const Cycle ordered = after_refresh(wanted);
  counters_.refresh_wait += ordered - wanted;
  const int64_t epoch = ordered / parameters_.refresh_interval_cycles;
  if (bank.epoch != epoch) bank.row = kClosed;
  bank.epoch = epoch;
  const Cycle data = std::max(ordered + open(&bank, row), bus_free_);
  order_free_ = data;
  bus_free_ = bank.idle = data + cycles;
  counters_.busy += cycles;
  return bus_free_;
}

}  // namespace pineda::memory
