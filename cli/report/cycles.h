// What a frame's cycles were spent on, for a person and for a program: the same of model and RTL.
#pragma once

#include "cli/output.h"
#include "model/timing/cycles.h"

namespace pineda::cli {

/// Adds "drained", "units", "fifos", "port_stalls", "stamps_by_samples" and "depth_tests".
/// Without `depth_tests` their outcome is not known.
void add_cycles(const timing::CycleCounters& spent, bool depth_tests, Json* json);

/// Shares by unit and cause, levels of the FIFOs, stalls of the ports, stamps, depth tests.
void print_cycles(const Output& output, const spec::Contract& contract,
                  const timing::CycleCounters& spent, bool depth_tests);

}  // namespace pineda::cli
