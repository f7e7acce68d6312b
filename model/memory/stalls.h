// Random stalls at the ports: a pure function of (seed, port, cycle), so that the RTL and the model
// see the same ones.
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

/// Ports that can stall. Those before kOutput feed the design, the others take from it.
enum class Port : uint8_t {
  kInput,  // input of a unit tested on its own
  kTriangle,
  kEnd,
  kOutput,  // output of a unit tested on its own
  kClear,
  kDepthRead,
  kDepthWrite,
  kColorWrite,
};

/// The Port of a memory port.
constexpr Port stalling(MemoryPort port) {
  return static_cast<Port>(static_cast<int>(Port::kDepthRead) + static_cast<int>(port));
}

class Stalls {
 public:
  Stalls() = default;
  Stalls(StallMode mode, uint64_t seed) : mode_(mode), seed_(seed) {}

  /// Does any port ever stall?
  bool any() const { return mode_ != StallMode::kNone; }
  /// Does this port stall in this cycle? Every 32 cycles each port draws a new stall probability:
  /// 0, 1/4, 1/2 or 7/8.
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
  // A random number of (seed, port, time): no state, so it can be asked for in any order.
  uint64_t hash(Port port, uint64_t time) const {
    return spec::SplitMix64::at(seed_, time + (static_cast<uint64_t>(port) << 56));
  }

  StallMode mode_ = StallMode::kNone;
  uint64_t seed_ = 0;
};

}  // namespace pineda::memory
