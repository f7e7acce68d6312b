// Whole frames through the Verilated top.
#pragma once

#include <functional>

#include "tb/memory.h"

namespace pineda::tb {

struct BenchOptions {
  int depth_latency_cycles = spec::kHighTile.depth_latency_cycles;
  StallMode stall_mode = StallMode::kNone;
  uint64_t seed = 0;
};

/// Gives the next triangle of a frame; false at its end.
using NextTriangle = std::function<bool(spec::Triangle*)>;

struct FrameResult {
  uint64_t cycles = 0;     // from the frame's first clock edge to the last write accepted
  uint64_t triangles = 0;  // accepted
};

/// Runs frames, one after the other, from one reset on.
///
/// Errors   RtlError: a failed assertion, an unstable payload, a deadlock, with the cycle.
class FrameBench {
 public:
  FrameBench(const RtlLibrary& library, const BenchOptions& options);

  /// One frame, from its first offer until the top is idle. With a listener, every token at every
  /// unit boundary; without one, the streams inside are not looked at.
  FrameResult run(const spec::FrameState& frame, const NextTriangle& next, Listener* listener);
  /// The same, but resets in the middle, `cycles` after the start, and leaves the pipeline idle.
  void run_into_reset(const spec::FrameState& frame, const NextTriangle& next, uint64_t cycles);

  /// Memories as the last frame left them. Hits are counted when a listener is there.
  const core::FrameBuffer& buffer() const { return memory_.buffer(); }
  bool trace(const std::string& file) { return unit_.trace(file); }

 private:
  struct Progress;
  bool step(Progress* progress, const NextTriangle& next, Listener* listener);
  void reset();

  RtlUnit unit_;
  Stalls stalls_;
  SourceEnd<spec::FrameState> frames_;
  SourceEnd<spec::Triangle> triangles_;
  PortData end_valid_, end_ready_, clear_valid_, clear_ready_, idle_;
  Tap<spec::SetupPrim> prims_;
  Tap<spec::Stamp> stamps_;
  MemoryEnd memory_;
};

}  // namespace pineda::tb
