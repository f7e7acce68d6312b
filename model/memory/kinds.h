// The memories that can be named.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "model/memory/timing.h"

namespace pineda::memory {

enum class Kind {
  kIdeal,       // fixed latency, always ready
  kDram,        // DRAM behind caches, a channel for depth, one for colour
  kDramMerged,  // one channel for both
};
inline constexpr Kind kKinds[] = {Kind::kIdeal, Kind::kDram, Kind::kDramMerged};

/// "ideal", "dram", "dram_merged".
const char* kind_name(Kind kind);
std::optional<Kind> kind_named(const std::string& name);

/// A memory with its default parameters; the latency is that of an ideal one.
/// Errors   see IdealTiming.
std::shared_ptr<MemoryTiming> make_timing(Kind kind, const spec::Contract& contract,
                                          int latency_cycles);

}  // namespace pineda::memory
