// Back-pressure and gaps at the ports: a pure function of (seed, port, cycle), the same for the RTL
// and the model.
#pragma once

#include <cstdint>

#include "model/memory/port.h"
#include "model/spec/names.h"
#include "model/spec/random.h"

namespace pineda::memory {

/// Who stalls: nobody, the producers that feed the design, the consumers behind it, or both.
enum class StallMode { kNone, kSource, kSink, kBoth };

struct StallModeName {
  StallMode value;
  const char* word;       // of --stall
  const char* test_name;  // of tests over every mode
};
inline constexpr StallModeName kStallModeNames[] = {
    {StallMode::kNone, "none", "NoStalls"},
    {StallMode::kSource, "source", "SourceStalled"},
    {StallMode::kSink, "sink", "SinkStalled"},
    {StallMode::kBoth, "both", "BothStalled"},
};
constexpr const auto& names(StallMode) { return kStallModeNames; }
inline constexpr auto kStallModes = spec::values_of<StallMode>();

/// "NoStalls", "SourceStalled", "SinkStalled", "BothStalled".
constexpr const char* stall_mode_name(StallMode mode) { return spec::row_of(mode).test_name; }

/// Ports that can stall. The first ones feed the design, the others take from it.
enum class Port : uint8_t {
  kInput,  // of a unit on its own
  kTriangle,
  kEnd,
  kOutput,  // of a unit on its own
  kClear,
  kDepthRead,
  kDepthWrite,
  kColorWrite,
};

/// The same port among all that can stall.
constexpr Port stalling(MemoryPort port) {
  return static_cast<Port>(static_cast<int>(Port::kDepthRead) + static_cast<int>(port));
}

class Stalls {
 public:
  Stalls() = default;
  Stalls(StallMode mode, uint64_t seed) : mode_(mode), seed_(seed) {}

  /// Does anybody ever stall?
  bool any() const { return mode_ != StallMode::kNone; }
  /// Does this port stand still in this cycle? Every 32 cycles a port draws how busy it is: never,
  /// one cycle in four, in two, or seven in eight.
  bool operator()(Port port, Cycle cycle) const {
    const bool source = port < Port::kOutput;
    if (mode_ == StallMode::kNone || (mode_ == StallMode::kSource && !source) ||
        (mode_ == StallMode::kSink && source)) {
      return false;
    }
    const auto time = static_cast<uint64_t>(cycle);
    static constexpr uint64_t kEighths[] = {0, 2, 4, 7};
    const uint64_t busy = kEighths[hash(port, time / 32) >> 8 & 3];
    return (hash(port, ~time) >> 8 & 7) < busy;
  }

 private:
  // Random numbers that can be read in any order, of the port and the time.
  uint64_t hash(Port port, uint64_t time) const {
    return spec::SplitMix64::at(seed_, time + (static_cast<uint64_t>(port) << 56));
  }

  StallMode mode_ = StallMode::kNone;
  uint64_t seed_ = 0;
};

}  // namespace pineda::memory
