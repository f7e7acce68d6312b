#include "studies/cycles/model_cycles.h"

#include <stdexcept>
#include <string>

#include "model/timing/raster_top.h"
#include "studies/cycles/child.h"

namespace pineda::studies {
namespace {

int64_t run(const spec::Contract& contract, const spec::FrameState& frame,
            const std::vector<spec::Triangle>& triangles) {
  timing::RasterTop top("raster_top", contract);
  top.set_depth_latency_cycles(contract.design.depth_latency_cycles);
  return top.run(frame, triangles).cycles;
}

}  // namespace

int64_t model_cycles(const spec::Contract& contract, const spec::FrameState& frame,
                     const std::vector<spec::Triangle>& triangles) {
  const std::string reason = spec::no_cycles_reason(contract.design);
  if (!reason.empty()) throw std::invalid_argument(reason);
  return in_child([&] { return run(contract, frame, triangles); });
}

}  // namespace pineda::studies
