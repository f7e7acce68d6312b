// Cycles of many designs in one program.
#pragma once

#include <vector>

#include "model/spec/structs.h"

namespace pineda::studies {

/// A frame in time.
struct ModelFrame {
  int64_t cycles = 0;
  uint64_t fragments = 0;  // covered samples of the stamps sent
};

/// A frame by the SystemC model, with the memories of its design. SystemC elaborates once a process,
/// so each call runs in a process of its own.
///
/// Errors   std::runtime_error when that process ends without an answer; std::invalid_argument for
///          a design without cycles.
ModelFrame model_frame(const spec::Contract& contract, const spec::FrameState& frame,
                       const std::vector<spec::Triangle>& triangles);
/// Its cycles alone.
int64_t model_cycles(const spec::Contract& contract, const spec::FrameState& frame,
                     const std::vector<spec::Triangle>& triangles);

}  // namespace pineda::studies
