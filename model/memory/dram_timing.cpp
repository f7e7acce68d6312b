#include "model/memory/dram_timing.h"

#include "model/memory/layout.h"

namespace pineda::memory {
namespace {

const DramParameters& checked(const DramParameters& parameters) {
  const std::string why = invalid_reason(parameters);
  if (!why.empty()) throw std::invalid_argument("DRAM: " + why);
  return parameters;
}

int divide_up(int a, int b) { return (a + b - 1) / b; }

}  // namespace

DramTiming::DramTiming(const spec::Contract& c, const DramParameters& p)
    : tile_log2_(c.design.tile_log2),
      columns_log2_(c.design.tile_log2 - c.design.stamp_width_log2),
      rows_log2_(c.design.tile_log2 - c.design.stamp_height_log2),
      banks_(p.banks),
      hit_latency_cycles_(p.hit_latency_cycles),
      channels_{DramChannel(checked(p)), DramChannel(p)},
      depth_(group(p, kDepthBytes, &channels_[0])),
      color_(group(p, color_bytes(c.design), &channels_[p.merged ? 0 : 1])) {}

DramTiming::Group DramTiming::group(const DramParameters& p, int sample_bytes,
                                    DramChannel* channel) const {
  const int bytes = sample_bytes << (2 * tile_log2_);
  return {TileCache(p),
          channel,
          divide_up(bytes, p.bus_bytes),
          std::max(p.row_bytes / bytes, 1),
          0,
          {}};
}

void DramTiming::begin_frame(const spec::FrameState& frame) {
  columns_ = ((frame.width - 1) >> tile_log2_) + 1;
  const int rows = ((frame.height - 1) >> tile_log2_) + 1;
  for (DramChannel& channel : channels_) channel.reset();
  for (Group* g : {&depth_, &color_}) {
    g->cache.reset();
    g->counters = {};
  }
  free_ = {};
  // Colour lies behind depth in memory, shifted by half the banks: depth and colour of a tile are
  // used together and should not share a bank.
  const int used = divide_up(columns_ * rows, depth_.tiles_in_row);
  color_.first_row = divide_up(used, banks_) * banks_ + banks_ / 2;
}

int64_t DramTiming::dram_row(const Group& g, int column, int row) const {
  const int64_t tile = static_cast<int64_t>(row) * columns_ + column;
  return g.first_row + tile / g.tiles_in_row;
}

TileCache::Line* DramTiming::fill(Group* g, Cycle cycle, int column, int row) {
  TileCache::Line* line = g->cache.victim(cycle, column, row);
  const TileCache::Line old = *line;
  line->column = column;
  line->row = row;
  line->dirty = false;
  line->filled = g->channel->serve(cycle + 1, dram_row(*g, column, row), g->burst_cycles);
  if (old.dirty) {
    ++g->counters.write_backs;
    g->channel->serve(cycle + 1, dram_row(*g, old.column, old.row), g->burst_cycles);
  }
  return line;
}

Cycle DramTiming::accept(MemoryPort port, Cycle cycle, int x, int y) {
  Group& g = port == MemoryPort::kColorWrite ? color_ : depth_;
  const int column = x >> columns_log2_;
  const int row = y >> rows_log2_;
  TileCache::Line* line = g.cache.find(column, row);
  ++(line != nullptr ? g.counters.hits : g.counters.misses);
  if (line == nullptr) line = fill(&g, cycle, column, row);
  line->dirty |= port != MemoryPort::kDepthRead;
  const Cycle served = std::max(cycle, line->filled);
  free_[static_cast<size_t>(port)] = served + 1;
  return served + hit_latency_cycles_;
}

std::shared_ptr<MemoryTiming> make_dram(const spec::Contract& contract, int) {
  return std::make_shared<DramTiming>(contract, DramParameters());
}

std::shared_ptr<MemoryTiming> make_dram_merged(const spec::Contract& contract, int) {
  DramParameters parameters;
  parameters.merged = true;
  return std::make_shared<DramTiming>(contract, parameters);
}

}  // namespace pineda::memory
