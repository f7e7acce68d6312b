// Several Verilated rasterizers on one channel, clock edge by clock edge: what the timing of
// SharedMemory is compared with.
#pragma once

#include <memory>
#include <vector>

#include "tb/stream.h"
#include "tests/timing/support.h"

namespace pineda::test {

/// The channel and how triangles come.
struct Traffic {
  Cycle channel_cycles = 1;  // of the channel, a transaction
  Cycle latency_cycles = 0;  // behind them
  // A triangle can be offered in every so many cycles; that sets the load.
  Cycle triangle_interval = 1;

  bool triangle_ready(Cycle cycle) const { return cycle % triangle_interval == 0; }
};

/// One rasterizer and its part of the memory. Reads are accepted when they are offered and answered
/// when the channel has served them, in order, at least a cycle later; writes are accepted when the
/// channel has served them.
class ClockedRasterizer {
 public:
  ClockedRasterizer(const tb::RtlLibrary& library, const Scene& scene, const Traffic& traffic);

  /// The first half of a cycle: returns how many requests are new in it, reads first, then depth
  /// writes, then colour writes.
  int offer(Cycle cycle);
  /// Request `i` of those that are new is served in `done`.
  void served(int i, Cycle done);
  /// The second half.
  void clock(Cycle cycle);
  /// The cycle in which the frame has drained, -1 until then.
  Cycle drained() const { return drained_; }

 private:
  enum Port { kRead, kDepthWrite, kColorWrite };
  static constexpr Cycle kIdle = -1;
  struct Response {
    Cycle cycle;
    spec::DepthData data;
  };
  void drive_triangles(Cycle cycle);
  void drive_memory(Cycle cycle);
  std::vector<uint32_t>::iterator stamp(int x, int y);

  tb::RtlUnit unit_;
  const Scene& scene_;
  Traffic traffic_;
  int columns_;
  tb::SourceEnd<spec::FrameState> frames_;
  tb::SourceEnd<spec::Triangle> triangles_;
  tb::PortData end_valid_, end_ready_, clear_valid_, clear_ready_, clear_depth_;
  tb::SinkEnd<spec::DepthRead> reads_;
  tb::SinkEnd<spec::DepthWrite> depth_writes_;
  tb::SinkEnd<spec::ColorWrite> color_writes_;
  tb::PortData response_valid_, response_ready_;
  tb::PayloadPort<spec::DepthData> response_;

  size_t next_ = 0;
  std::vector<uint32_t> depths_;  // lane by lane
  std::vector<Response> due_;
  size_t answered_ = 0;
  Cycle depth_done_ = kIdle, color_done_ = kIdle;  // of the write that waits
  std::vector<Port> fresh_;
  Cycle last_response_ = -1;
  Cycle drained_ = -1;
};

/// What a clocked run took.
struct ClockedResult {
  std::vector<Cycle> drained;  // of each rasterizer
  Cycle busy = 0;              // of the channel
};

/// Draws the scenes together. Of requests of one cycle the first ones of all rasterizers, in their
/// order, come before second ones.
ClockedResult run_clocked(const tb::RtlLibrary& library, const std::vector<Scene>& scenes,
                          const Traffic& traffic);

}  // namespace pineda::test
