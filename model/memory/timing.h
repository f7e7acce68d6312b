// When a memory accepts requests and when it answers reads. The same object serves the Verilated
// RTL and the SystemC model.
#pragma once

#include "model/memory/port.h"
#include "model/spec/structs.h"

namespace pineda::memory {

/// Timing of a frame's depth and colour memories; the data are stored elsewhere.
///
/// Calls come in the order of their cycles; within a cycle depth read first, then depth write, then
/// colour write. A port accepts at most one request a cycle, and only where ready_from() allows it.
/// A write accepted in cycle t is seen by reads accepted from t + 1 on. Read responses come in
/// order, at most one a cycle.
class MemoryTiming {
 public:
  virtual ~MemoryTiming() = default;

  /// Resets the timing for a frame of this size with cleared memories. Cycles start at 0.
  virtual void begin_frame(const spec::FrameState& frame) = 0;

  /// The first cycle >= `from` in which the port accepts a request, given all requests accepted
  /// before `from`. It does not depend on the address of the request.
  virtual Cycle ready_from(MemoryPort port, Cycle from) = 0;

  /// Accepts in `cycle` a request on the stamp in column x, row y. Returns the cycle of a read's
  /// response, later than `cycle`; for a write, the cycle in which a read would be answered.
  virtual Cycle accept(MemoryPort port, Cycle cycle, int x, int y) = 0;

  /// The latency of reads if it is constant and all ports are always ready, so that the order of
  /// requests at different ports does not matter; else 0.
  virtual Cycle fixed_latency() const { return 0; }
};

}  // namespace pineda::memory
