// What a frame's cycles were spent on, for a person and for a program: the same of model and RTL.
#pragma once

#include "cli/output.h"
#include "model/timing/counted/counters.h"

namespace pineda::cli {

/// Adds "drained", "units", "fifos", "port_stalls", "stamps_by_samples" and, if their results are
/// known, "depth_tests".
void add_cycles(const spec::Contract& contract, const timing::FrameResult& result, Json* json);

/// Shares by unit and cause, levels of the FIFOs, stalls of the ports, stamps, depth tests.
void print_cycles(const Output& output, const spec::Contract& contract,
                  const timing::FrameResult& result);

}  // namespace pineda::cli
