#include "model/memory/kinds.h"

#include "model/memory/dram_timing.h"

namespace pineda::memory {

const char* kind_name(Kind kind) {
  static constexpr const char* kNames[] = {"ideal", "dram", "dram_merged"};
  return kNames[static_cast<int>(kind)];
}

std::optional<Kind> kind_named(const std::string& name) {
  for (const Kind kind : kKinds) {
    if (name == kind_name(kind)) return kind;
  }
  return std::nullopt;
}

std::shared_ptr<MemoryTiming> make_timing(Kind kind, const spec::Contract& contract,
                                          int latency_cycles) {
  if (kind == Kind::kIdeal) {
    return std::make_shared<IdealTiming>(latency_cycles, contract.design.max_depth_latency_cycles);
  }
  DramParameters parameters;
  parameters.merged = kind == Kind::kDramMerged;
  return std::make_shared<DramTiming>(contract, parameters);
}

}  // namespace pineda::memory
