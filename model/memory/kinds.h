// The memory models that a user can name. A new one needs a file like ideal_timing.h with a factory
// function, an enumerator of Kind, and a row in kKindNames.
#pragma once

#include <memory>
#include <string>

#include "model/memory/dram_timing.h"
#include "model/memory/ideal_timing.h"
#include "model/spec/names.h"

namespace pineda::memory {

enum class Kind { kIdeal, kDram, kDramMerged };

struct KindName {
  Kind value;
  const char* word;
  const char* meaning;  // explanation added to the word in messages, may be empty
  bool has_latency;     // the caller chooses its latency
  /// Makes the memory with its default parameters.
  std::shared_ptr<MemoryTiming> (*make)(const spec::Contract&, int latency_cycles);
};
inline constexpr KindName kKindNames[] = {
    {Kind::kIdeal, "ideal", "", true, make_ideal},
    {Kind::kDram, "dram", "behind caches", false, make_dram},
    {Kind::kDramMerged, "dram_merged", "depth and colour on one channel", false, make_dram_merged},
};
constexpr const auto& names(Kind) { return kKindNames; }
inline constexpr auto kKinds = spec::values_of<Kind>();

/// "ideal, dram (behind caches) or dram_merged (depth and colour on one channel)".
std::string kinds_text();

/// A memory with its default parameters. `latency_cycles` only matters for a kind that has_latency.
/// Errors   see IdealTiming.
inline std::shared_ptr<MemoryTiming> make_timing(Kind kind, const spec::Contract& contract,
                                                 int latency_cycles) {
  return spec::row_of(kind).make(contract, latency_cycles);
}

}  // namespace pineda::memory
