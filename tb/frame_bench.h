// Whole frames through the Verilated top.
#pragma once

#include <functional>

#include "tb/counters.h"
#include "tb/memory.h"

namespace pineda::tb {

struct BenchOptions {
  int depth_latency_cycles = spec::kHighTile.depth_latency_cycles;  // of an ideal memory
  std::shared_ptr<MemoryTiming> memory;  // in its place; serves one bench at a time
  StallMode stall_mode = StallMode::kNone;
  uint64_t seed = 0;
};

/// The memory of a bench. Throws RtlError if its latency is out of range.
std::shared_ptr<MemoryTiming> memory_of(const BenchOptions& options);

/// Gives the next triangle of a frame; false at its end.
using NextTriangle = std::function<bool(spec::Triangle*)>;

using timing::FrameResult;

/// Some cycles of a frame, looked at closely.
struct CloseUp {
  Cycle from = 0;     // the first cycle that the waveform shows
  Cycle at = 0;       // what the units do in this one is counted; from <= at < until
  Cycle until = 0;    // the first cycle that is not run any more
  std::string trace;  // file of the waveform; empty: none
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
  /// The same, but resets in the middle, `cycles` after the start. Throws RtlError if the pipeline is not
  /// idle then.
  void run_into_reset(const spec::FrameState& frame, const NextTriangle& next, Cycle cycles);
  /// Cycles without a frame, after one or after a reset. Throws RtlError if something is written.
  void wait(Cycle cycles);

  /// The first frame since the reset up to the end of the close-up, where the bench is left as it is: good
  /// for nothing more. The waveform is whole once the bench is gone. Returns each unit's cause in
  /// cycle `at`. Throws RtlError if the waveform cannot be written.
  std::array<timing::Cause, timing::kUnits> run_close_up(const spec::FrameState& frame,
                                                         const NextTriangle& next,
                                                         Listener* listener,
                                                         const CloseUp& close_up);

  /// Memories as the last frame left them. Hits are counted when a listener is there.
  core::FrameBuffer buffer() const { return memory_.memories().whole(); }
  const PagedBuffer& memories() const { return memory_.memories(); }
  const spec::Contract& contract() const { return unit_.contract(); }
  /// Of the frames that follow, in cycles of each.
  void set_stalls(const Stalls& stalls) { stalls_ = stalls; }
  /// The cycle of the last handshake: where to look once a frame has ended in an RtlError.
  Cycle last_moved() const { return last_moved_; }
  bool trace(const std::string& file) { return unit_.trace(file); }
  bool write_coverage(const std::string& file) const { return unit_.write_coverage(file); }

 private:
  struct Progress;
  Progress offered(const spec::FrameState& frame);
  bool step(Progress* progress, const NextTriangle& next, Listener* listener);
  void reset();

  RtlUnit unit_;
  Stalls stalls_;
  SourceEnd<spec::FrameState> frames_;
  SourceEnd<spec::Triangle> triangles_;
  PortData end_valid_, end_ready_, clear_valid_, clear_ready_, idle_;
  std::optional<PortData> clear_depth_;  // of a design with depth
  Tap<spec::SetupPrim> prims_;
  Tap<spec::Stamp> stamps_;
  Counters counters_;
  MemoryEnd memory_;
  Cycle last_moved_ = 0;
};

}  // namespace pineda::tb
