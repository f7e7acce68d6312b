// Random stalls at the ports: a pure function of (seed, port, cycle), so that the RTL and the model
// see the same ones.
#pragma once

#include <array>
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
  /// Does this port stall in this cycle? Every kBlock cycles each port draws a new stall
  /// probability: 0, 1/4, 1/2 or 7/8.
  bool operator()(Port port, Cycle cycle) const {
    const auto time = static_cast<uint64_t>(cycle);
    const uint64_t busy = busy_eighths(port, time / kBlock);
    return stalls(port, time, busy);
  }

  static constexpr unsigned kBlock = 32;
  /// Bit i: this port stalls in cycle kBlock * block + i.
  uint32_t in_block(Port port, uint64_t block) const {
    const uint64_t busy = busy_eighths(port, block);
    uint32_t all = 0;
    if (busy == 0) return all;
    for (unsigned i = 0; i < kBlock; ++i) {
      all |= static_cast<uint32_t>(stalls(port, block * kBlock + i, busy)) << i;
    }
    return all;
  }

 private:
  // Of eight cycles of a block so many stall.
  uint64_t busy_eighths(Port port, uint64_t block) const {
    const bool source = port < Port::kOutput;
    if (mode_ == StallMode::kNone || (mode_ == StallMode::kSource && !source) ||
        (mode_ == StallMode::kSink && source)) {
      return 0;
    }
    static constexpr uint64_t kEighths[] = {0, 2, 4, 7};
    return kEighths[hash(port, block) >> 8 & 3];
  }
  bool stalls(Port port, uint64_t time, uint64_t busy) const {
    return (hash(port, ~time) >> 8 & 7) < busy;
  }

  // A random number of (seed, port, time): no state, so it can be asked for in any order.
  uint64_t hash(Port port, uint64_t time) const {
    return spec::SplitMix64::at(seed_, time + (static_cast<uint64_t>(port) << 56));
  }

  StallMode mode_ = StallMode::kNone;
  uint64_t seed_ = 0;
};

/// Whether ports move, quickly where each port is asked about cycles close together: a block of them
/// is drawn at once.
class Moving {
 public:
  explicit Moving(const Stalls& stalls) : stalls_(stalls) {}

  bool operator()(Port port, Cycle cycle) const {
    const auto time = static_cast<uint64_t>(cycle);
    return (in_block(port, time / kBlock) >> time % kBlock & 1) != 0;
  }
  /// The first cycle from `from` on in which the port moves.
  Cycle first(Port port, Cycle from) const {
    const auto time = static_cast<uint64_t>(from);
    uint64_t block = time / kBlock;
    uint32_t moving = in_block(port, block) >> time % kBlock << time % kBlock;
    while (moving == 0) moving = in_block(port, ++block);
    return static_cast<Cycle>(block * kBlock) + __builtin_ctz(moving);
  }

 private:
  static constexpr unsigned kBlock = Stalls::kBlock;
  struct Block {
    uint64_t number = ~uint64_t{0};
    uint32_t moving = 0;
  };
  uint32_t in_block(Port port, uint64_t number) const {
    Block& block = blocks_[static_cast<size_t>(port)];
    if (block.number != number) block = {number, ~stalls_.in_block(port, number)};
    return block.moving;
  }

  Stalls stalls_;
  mutable std::array<Block, static_cast<size_t>(Port::kColorWrite) + 1> blocks_;  // drawn last
};

}  // namespace pineda::memory
