#include "tb/counters.h"

namespace pineda::tb {

using timing::Counter;

Counters::Events::Events(PortData port) : port_(port), first_(port.bytes / sizeof(uint64_t)) {
  start();
}

void Counters::Events::start() { std::memcpy(first_.data(), port_.data, port_.bytes); }

uint64_t Counters::Events::counted(const core::RtlKinds& kinds) const {
  const auto* const now = static_cast<const uint64_t*>(port_.data);
  uint64_t sum = 0;
  for (size_t kind = 0; kind < first_.size(); ++kind) {
    sum += kinds.times(kind) * (now[kind] - first_[kind]);
  }
  return sum;
}

Counters::Counters(const RtlUnit& top) : contract_(top.contract()) {
  const timing::FrameResult none = timing::empty_result(contract_);
  timing::for_each_counter(contract_, none, [&](const Counter& row, auto) {
    if (!row.rtl.empty()) events_.try_emplace(row.rtl, top.port(row.rtl));
  });
}

void Counters::start() {
  for (auto& [name, events] : events_) events.start();
}

timing::FrameResult Counters::read(timing::Cycle drained) const {
  timing::FrameResult result = timing::empty_result(contract_);
  timing::for_each_counter(contract_, result, [&](const Counter& row, auto& count) {
    if (row.rtl.empty()) return;
    const uint64_t events = events_.at(row.rtl).counted(row.kinds);
    count = static_cast<std::decay_t<decltype(count)>>(events);
  });
  result.spent.drained = drained;
  return result;
}

}  // namespace pineda::tb
