// The two models in time, with the same options: latency of the depth memory and stalls.
#pragma once

#include "cli/options.h"
#include "model/timing/raster_top.h"
#include "tb/frame_bench.h"

namespace pineda::cli {

inline tb::BenchOptions bench_options(const Options& options, const spec::Contract& contract) {
  tb::BenchOptions bench;
  bench.depth_latency_cycles = latency_of(options, contract);
  bench.stall_mode = stall_mode_of(options);
  bench.seed = options.seed;
  return bench;
}

/// The stalls of the benches, as the SystemC model takes them.
inline timing::Ready ready_of(const tb::BenchOptions& bench) {
  if (bench.stall_mode == tb::StallMode::kNone) return {};
  const tb::Stalls stalls(bench.stall_mode, bench.seed);
  return [stalls](timing::ExternalPort port, timing::Cycle cycle) {
    static constexpr tb::Port kPorts[] = {tb::Port::kTriangle, tb::Port::kClear,
                                          tb::Port::kDepthRead, tb::Port::kDepthWrite,
                                          tb::Port::kColorWrite};
    return !stalls(kPorts[static_cast<int>(port)], static_cast<uint64_t>(cycle));
  };
}

/// Elaborates the SystemC model; once a process.
inline std::unique_ptr<timing::RasterTop> make_model(const spec::Contract& contract,
                                                     const tb::BenchOptions& bench) {
  auto top = std::make_unique<timing::RasterTop>("raster_top", contract);
  top->set_depth_latency_cycles(bench.depth_latency_cycles);
  top->set_ready(ready_of(bench));
  return top;
}

}  // namespace pineda::cli
