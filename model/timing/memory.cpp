#include "model/timing/memory.h"

#include <stdexcept>

namespace pineda::timing {

Cycle first_ready(const Ready& ready, ExternalPort port, Cycle from) {
  constexpr Cycle kPatience = Cycle{1} << 20;
  if (!ready) return from;
  for (Cycle cycle = from; cycle < from + kPatience; ++cycle) {
    if (ready(port, cycle)) return cycle;
  }
  SC_REPORT_FATAL("pineda/port/stuck", "a port is not ready for 2^20 cycles");
  return from;
}

IdealMemory::IdealMemory(const char* name, const spec::Contract& contract)
    : sc_object(name), contract_(contract) {
  set_latency_cycles(contract.design.depth_latency_cycles);
}

void IdealMemory::set_latency_cycles(int cycles) {
  const int longest = contract_.design.max_depth_latency_cycles;
  if (cycles < 1 || cycles > longest) {
    throw std::invalid_argument("depth latency: expected 1 to " + std::to_string(longest) +
                                " cycles, got " + std::to_string(cycles));
  }
  latency_cycles_ = cycles;
}

void IdealMemory::begin_frame(const spec::FrameState& frame) {
  buffer_ = core::FrameBuffer(contract_, frame);
}

DepthMemory::Read IdealMemory::read(const spec::DepthRead& request, Cycle earliest) {
  const Cycle accepted = first_ready(ready_, ExternalPort::kDepthRead, earliest);
  return {accepted, accepted + latency_cycles_,
          buffer_.read(contract_, request.x, request.y, request.mask)};
}

Cycle IdealMemory::write(const spec::DepthWrite& write, Cycle earliest) {
  buffer_.write(contract_, write);
  return first_ready(ready_, ExternalPort::kDepthWrite, earliest);
}

Cycle IdealMemory::write(const spec::ColorWrite& write, Cycle earliest) {
  buffer_.write(contract_, write);
  return first_ready(ready_, ExternalPort::kColorWrite, earliest);
}

}  // namespace pineda::timing
