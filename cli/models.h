// The two models in time, with the same options: latency of the depth memory and stalls.
#pragma once

#include "cli/options.h"
#include "model/timing/raster_top.h"
#include "tb/frame_bench.h"
#include "tb/ready.h"

namespace pineda::cli {

inline tb::BenchOptions bench_options(const Options& options, const spec::Contract& contract) {
  tb::BenchOptions bench;
  bench.depth_latency_cycles = latency_of(options, contract);
  bench.memory = memory::make_timing(memory_kind_of(options), contract, bench.depth_latency_cycles);
  bench.stall_mode = stall_mode_of(options);
  bench.seed = options.seed;
  return bench;
}

/// Elaborates the SystemC model, which is possible once per process.
inline std::unique_ptr<timing::RasterTop> make_model(const spec::Contract& contract,
                                                     const tb::BenchOptions& bench) {
  auto top = std::make_unique<timing::RasterTop>("raster_top", contract);
  top->set_memory(bench.memory);
  top->set_ready(tb::ready_of({bench.stall_mode, bench.seed}));
  return top;
}

}  // namespace pineda::cli
