// What memory a frame was drawn into, and what it did.
#pragma once

#include "cli/options.h"
#include "cli/output.h"
#include "tb/frame_bench.h"

namespace pineda::cli {

/// Adds "memory", "depth_latency_cycles" and, of DRAM, "dram": its counters over the last frame. A
/// channel that both caches are on counts for both.
void add_memory(Json* json, const Options& options, const tb::BenchOptions& bench);
/// The same for readers; nothing of an ideal memory.
void print_memory(const Output& output, const tb::BenchOptions& bench);

}  // namespace pineda::cli
