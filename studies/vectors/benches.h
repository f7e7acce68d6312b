// Cases run through the Verilated RTL of their design.
#pragma once

#include "tb/unit_bench.h"
#include "vectors/grammar/cases.h"

namespace pineda::vectors {

/// What a bench makes of a case's inputs: the same case with the outputs of the RTL. It does not tell
/// the cause of a drop, so the expected causes are kept.
///
/// Errors   tb::RtlError: a failed assertion, an unstable payload, a deadlock.
SetupCase run(tb::SetupBench* bench, const SetupCase& inputs);
TraversalCase run(tb::TraversalBench* bench, const TraversalCase& inputs);
InterpZtestCase run(tb::InterpZtestBench* bench, const InterpZtestCase& inputs);
FrameCase run(tb::FrameBench* bench, const FrameCase& inputs);

}  // namespace pineda::vectors
