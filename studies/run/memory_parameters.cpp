#include "studies/run/memory_parameters.h"

#include <fmt/format.h>

namespace pineda::studies {

std::string parameters_of(const StudyMemory& m) {
  std::string text = spec::name_of(m.kind);
  if (spec::row_of(m.kind).has_latency) {
    return text + (m.latency_cycles ? fmt::format(" latency {}", *m.latency_cycles) : "");
  }
  for (const DramParameter& p : kDramParameters)
    text += fmt::format(" {} {}", p.key, m.dram.*p.member);
  return text;
}

std::shared_ptr<memory::MemoryTiming> make_memory(const StudyMemory& m,
                                                  const spec::Contract& contract) {
  if (spec::row_of(m.kind).has_latency) {
    return memory::make_timing(m.kind, contract,
                               m.latency_cycles.value_or(contract.design.depth_latency_cycles));
  }
  memory::DramParameters parameters = m.dram;
  parameters.merged = m.kind == memory::Kind::kDramMerged;
  return std::make_shared<memory::DramTiming>(contract, parameters);
}

}  // namespace pineda::studies
