// The depth and colour memories behind a Verilated unit: fixed read latency, masked writes.
#pragma once

#include <cstdint>
#include <vector>

#include "model/core/frame.h"
#include "tb/stalls.h"
#include "tb/stream.h"

namespace pineda::tb {

/// Sees each token that leaves a unit, with the cycle of its handshake.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual void prim(uint64_t /*cycle*/, const spec::SetupPrim&) {}
  virtual void stamp(uint64_t /*cycle*/, const spec::Stamp&) {}
  virtual void depth(uint64_t /*cycle*/, const spec::DepthWrite&) {}
  virtual void color(uint64_t /*cycle*/, const spec::ColorWrite&) {}
};

/// Serves the memory ports of a unit, cycle by cycle. A read accepted in cycle t is answered in
/// t + latency and sees the writes accepted before t; nothing outside the frame exists.
class MemoryEnd {
 public:
  MemoryEnd(const RtlUnit& unit, int latency_cycles);

  void start(const spec::FrameState& frame);
  /// Before settle: ready signals and a due response.
  void drive(const Stalls& stalls, uint64_t cycle);
  /// After settle: takes reads and writes. True when a write was accepted.
  bool sample(uint64_t cycle, Listener* listener);
  /// Forgets everything under way, as after a reset.
  void forget();

  void count_hits(const spec::Stamp& stamp) { buffer_.count_hits(contract_, stamp); }
  const core::FrameBuffer& buffer() const { return buffer_; }

 private:
  struct Response {
    bool valid = false;
    spec::DepthData data;
  };

  const spec::Contract& contract_;
  SinkEnd<spec::DepthRead> reads_;
  SinkEnd<spec::DepthWrite> depth_writes_;
  SinkEnd<spec::ColorWrite> color_writes_;
  PortData response_valid_;
  PayloadPort<spec::DepthData> response_;
  std::vector<Response> due_;  // by cycle modulo its size
  core::FrameBuffer buffer_;
};

}  // namespace pineda::tb
