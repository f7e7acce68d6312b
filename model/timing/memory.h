// The memory ports: interfaces with time, and an ideal memory of fixed latency behind them.
#pragma once

#include <functional>
#include <string>
#include <systemc>

#include "model/core/frame.h"
#include "model/timing/local_time.h"

namespace pineda::timing {

/// The ports of the rasterizer that something outside of it can stall.
enum class ExternalPort { kTriangle, kClear, kDepthRead, kDepthWrite, kColorWrite };

/// Whether the other side of a port moves in a cycle: takes a read, a write or the
/// clear, offers a triangle. A pure function, so that the same pattern can be applied to the RTL.
/// Empty = always.
using Ready = std::function<bool(ExternalPort, Cycle)>;

/// The first cycle from `from` on in which the port is ready.
/// Errors   none in 2^20 cycles: SC_REPORT_FATAL "pineda/port/stuck".
Cycle first_ready(const Ready& ready, ExternalPort port, Cycle from);

/// Depth memory. Calls come in the order of the stamps, so the cycles of reads and of writes each
/// grow, but a call may lie before an earlier one of the other kind. At one address calls come in
/// the order of their cycles, and a write accepted in t is seen by a read accepted from t + 1 on.
class DepthMemory : public virtual sc_core::sc_interface {
 public:
  struct Read {
    Cycle accepted;
    Cycle response;  // later than that of the read before
    spec::DepthData data;
  };

  /// A read offered from `earliest` on.
  virtual Read read(const spec::DepthRead& request, Cycle earliest) = 0;

  /// A write offered from `earliest` on; returns the cycle in which it is accepted.
  virtual Cycle write(const spec::DepthWrite& write, Cycle earliest) = 0;
};

/// Colour memory: as DepthMemory's writes.
class ColorMemory : public virtual sc_core::sc_interface {
 public:
  virtual Cycle write(const spec::ColorWrite& write, Cycle earliest) = 0;
};

/// Depth and colour of a frame. A read accepted in t answers in t + latency.
///
/// Bits     core::FrameBuffer. Its hits stay 0: covered samples that fail the test never come here.
/// Errors   a latency outside 1 .. design.max_depth_latency_cycles: std::invalid_argument.
class IdealMemory final : public sc_core::sc_object, public DepthMemory, public ColorMemory {
 public:
  IdealMemory(const char* name, const spec::Contract& contract);

  void set_latency_cycles(int cycles);
  void set_ready(Ready ready) { ready_ = std::move(ready); }

  /// Clears both for a frame of this size.
  void begin_frame(const spec::FrameState& frame);
  const core::FrameBuffer& buffer() const { return buffer_; }

  Read read(const spec::DepthRead& request, Cycle earliest) override;
  Cycle write(const spec::DepthWrite& write, Cycle earliest) override;
  Cycle write(const spec::ColorWrite& write, Cycle earliest) override;

 private:
  spec::Contract contract_;
  int latency_cycles_;
  Ready ready_;
  core::FrameBuffer buffer_;
};

}  // namespace pineda::timing
