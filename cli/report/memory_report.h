// Reports the memory that a frame was drawn into, and its counters.
#pragma once

#include "cli/options.h"
#include "cli/output.h"
#include "tb/frame_bench.h"

namespace pineda::cli {

/// Adds "memory", "depth_latency_cycles" and, of DRAM, "dram": its counters over the last frame. A
/// channel that both caches use counts for both.
void add_memory(Json* json, const Options& options, const tb::BenchOptions& bench);
/// Prints the same; nothing for an ideal memory.
void print_memory(const Output& output, const tb::BenchOptions& bench);

}  // namespace pineda::cli
