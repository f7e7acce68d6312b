#include "studies/cycles/model_cycles.h"

#include <stdexcept>
#include <string>

#include "model/timing/raster_top.h"
#include "studies/cycles/child.h"

namespace pineda::studies {
namespace {

ModelFrame run(const spec::Contract& contract, const spec::FrameState& frame,
               const std::vector<spec::Triangle>& triangles) {
  timing::RasterTop top("raster_top", contract);
  top.set_depth_latency_cycles(contract.design.depth_latency_cycles);
  top.set_bits(false);
  const timing::FrameResult result = top.run(frame, triangles);
  return {result.cycles, result.counters.fragments};
}

}  // namespace

ModelFrame model_frame(const spec::Contract& contract, const spec::FrameState& frame,
                       const std::vector<spec::Triangle>& triangles) {
  const std::string reason = spec::no_cycles_reason(contract.design);
  if (!reason.empty()) throw std::invalid_argument(reason);
  return in_child([&] { return run(contract, frame, triangles); });
}

int64_t model_cycles(const spec::Contract& contract, const spec::FrameState& frame,
                     const std::vector<spec::Triangle>& triangles) {
  return model_frame(contract, frame, triangles).cycles;
}

}  // namespace pineda::studies
