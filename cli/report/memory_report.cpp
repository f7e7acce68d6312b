#include "cli/report/memory_report.h"

#include "model/memory/dram_timing.h"

namespace pineda::cli {
namespace {

const memory::DramTiming* dram_of(const tb::BenchOptions& bench) {
  return dynamic_cast<const memory::DramTiming*>(bench.memory.get());
}

Json dram_json(const memory::CacheCounters& cache, const memory::ChannelCounters& channel) {
  return {{"hits", cache.hits},
          {"misses", cache.misses},
          {"write_backs", cache.write_backs},
          {"row_hits", channel.row_hits},
          {"row_misses", channel.row_misses},
          {"row_conflicts", channel.row_conflicts},
          {"refresh_wait", channel.refresh_wait},
          {"busy", channel.busy}};
}

std::string cache_text(const memory::CacheCounters& cache) {
  return fmt::format("{} accesses, {} misses, {} tiles written back",
                     grouped(cache.hits + cache.misses), grouped(cache.misses),
                     grouped(cache.write_backs));
}

}  // namespace

void add_memory(Json* json, const Options& options, const tb::BenchOptions& bench) {
  (*json)["memory"] = options.memory;
  (*json)["depth_latency_cycles"] = bench.depth_latency_cycles;
  if (const auto* dram = dram_of(bench)) {
    (*json)["dram"] = {{"depth", dram_json(dram->depth_cache(), dram->depth_channel())},
                       {"color", dram_json(dram->color_cache(), dram->color_channel())}};
  }
}

void print_memory(const Output& output, const tb::BenchOptions& bench) {
  const auto* dram = dram_of(bench);
  if (dram == nullptr) return;
  output.row("depth cache", cache_text(dram->depth_cache()));
  output.row("colour cache", cache_text(dram->color_cache()));
}

}  // namespace pineda::cli
