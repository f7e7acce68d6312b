// When a memory takes requests, and when it answers reads: the same object serves the Verilated RTL
// and the SystemC model.
#pragma once

#include "model/memory/port.h"
#include "model/spec/structs.h"

namespace pineda::memory {

/// The time of the depth and colour memories of a frame; what they hold is not its business.
///
/// Calls come in the order of their cycles; in one cycle depth read, depth write, colour write. A
/// request is accepted in a cycle in which ready_from() says so, at most one a port in a cycle.
/// A write accepted in t is seen by a read accepted from t + 1 on. Responses of reads come in
/// order, in strictly growing cycles.
class MemoryTiming {
 public:
  virtual ~MemoryTiming() = default;

  /// As after a reset, for a frame of this size whose memories are cleared. Cycles start at 0.
  virtual void begin_frame(const spec::FrameState& frame) = 0;

  /// The first cycle >= `from` in which the port takes a request, given all that was accepted
  /// before `from`; whether a port is ready does not depend on what it is asked.
  virtual Cycle ready_from(MemoryPort port, Cycle from) = 0;

  /// A request on the stamp in column x, row y is accepted in `cycle`. For a read, the cycle of its
  /// response, later than `cycle`; for a write the cycle in which it would be answered.
  virtual Cycle accept(MemoryPort port, Cycle cycle, int x, int y) = 0;

  /// Cycles from a read's acceptance to its response if they are always the same and every port is
  /// always ready, so that the order of requests at different ports does not matter; else 0.
  virtual Cycle fixed_latency() const { return 0; }
};

}  // namespace pineda::memory
