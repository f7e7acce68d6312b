// The memory ports: interfaces with time, and TLM-2.0 sockets behind them.
#pragma once

#include <functional>
#include <systemc>

#include "model/core/frame.h"
#include "model/memory/stalls.h"
#include "model/timing/counted/cycles.h"
#include "model/timing/ports/memory_port.h"
#include "model/timing/standard.h"

namespace pineda::timing {

/// The ports of the rasterizer that something outside of it can stall: kTriangle, kClear and the
/// memory ports.
using ExternalPort = memory::Port;

/// Whether the other side of a port moves in a cycle: takes a read, a write or the
/// clear, offers a triangle. A pure function, so that the same pattern can be applied to the RTL.
/// Empty = always.
using Ready = std::function<bool(ExternalPort, Cycle)>;

/// The first cycle from `from` on in which the port is ready.
/// Errors   none in 2^20 cycles: SC_REPORT_FATAL "pineda/port/stuck".
Cycle first_ready(const Ready& ready, ExternalPort port, Cycle from);

/// A memory's answer to a request that is offered in a cycle.
struct Reply {
  bool taken = false;
  // Taken: the cycle in which it was. Else: the first cycle in which it makes sense to offer it
  // again; by then the memory may have more to say.
  Cycle cycle = 0;
  Cycle response = 0;  // of a read, later than that of the read before
};

/// Depth memory. Requests come in the order of the cycles in which they are offered, those of the
/// colour memory among them; within a cycle reads come first. A write accepted in t is seen by a
/// read accepted from t + 1 on.
class DepthMemory : public virtual sc_core::sc_interface {
 public:
  virtual Reply read(const spec::DepthRead& request, Cycle offered, spec::DepthData* data) = 0;
  virtual Reply write(const spec::DepthWrite& write, Cycle offered) = 0;
};

/// Colour memory. The same holds for its writes.
class ColorMemory : public virtual sc_core::sc_interface {
 public:
  virtual Reply write(const spec::ColorWrite& write, Cycle offered) = 0;
};

/// Both over TLM-2.0 sockets.
class MemoryPorts final : public sc_core::sc_module, public DepthMemory, public ColorMemory {
 public:
  MemoryPorts(sc_core::sc_module_name name, const spec::Contract& contract)
      : sc_module(name),
        depth("depth_socket", contract, memory::kDepthBytes),
        color("color_socket", contract, memory::color_bytes(contract.design)) {}

  MemorySocket depth;
  MemorySocket color;

  void begin_frame(const spec::FrameState& frame) {
    depth.get_to_know(frame);
    color.get_to_know(frame);
    depth.begin_frame(frame);
    color.begin_frame(frame);
  }
  /// See MemorySocket.
  void stop() {
    depth.stop();
    color.stop();
  }

  Reply read(const spec::DepthRead& request, Cycle offered, spec::DepthData* data) override;
  Reply write(const spec::DepthWrite& write, Cycle offered) override;
  Reply write(const spec::ColorWrite& write, Cycle offered) override;
};

}  // namespace pineda::timing
