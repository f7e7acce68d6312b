#include "model/timing/ports/memory.h"

namespace pineda::timing {

Cycle first_ready(const Ready& ready, ExternalPort port, Cycle from) {
  constexpr Cycle kPatience = Cycle{1} << 20;
  if (!ready) return from;
  // The stalls of the benches, which are not asked about every cycle.
  if (const auto* const moving = ready.target<memory::Moving>()) return moving->first(port, from);
  for (Cycle cycle = from; cycle < from + kPatience; ++cycle) {
    if (ready(port, cycle)) return cycle;
  }
  SC_REPORT_FATAL("pineda/port/stuck", "a port is not ready for 2^20 cycles");
  return from;
}

namespace {

Reply reply(const MemorySocket::Taken& taken) {
  if (taken.retry_from >= 0) return {false, taken.retry_from, 0};
  return {true, taken.accepted, taken.response};
}

}  // namespace

Reply MemoryPorts::read(const spec::DepthRead& request, Cycle offered, spec::DepthData* data) {
  return reply(depth.read(request.x, request.y, request.mask, offered, data));
}

Reply MemoryPorts::write(const spec::DepthWrite& write, Cycle offered) {
  return reply(depth.write(write, offered));
}

Reply MemoryPorts::write(const spec::ColorWrite& write, Cycle offered) {
  return reply(color.write(write, offered));
}

}  // namespace pineda::timing
