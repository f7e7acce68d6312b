// A memory that is always ready and answers after a fixed time.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "model/memory/timing.h"

namespace pineda::memory {

/// Always ready; a read accepted in cycle t is answered in cycle t + latency.
/// Errors   a latency outside 1 .. spec::kMaxDepthLatencyCycles: std::invalid_argument.
class IdealTiming final : public MemoryTiming {
 public:
  explicit IdealTiming(int latency_cycles) : latency_cycles_(latency_cycles) {
    constexpr int kLongest = spec::kMaxDepthLatencyCycles;
    if (latency_cycles < 1 || latency_cycles > kLongest) {
      throw std::invalid_argument("depth latency: expected 1 to " + std::to_string(kLongest) +
                                  " cycles, got " + std::to_string(latency_cycles));
    }
  }

  void begin_frame(const spec::FrameState&) override {}
  Cycle ready_from(MemoryPort, Cycle from) override { return from; }
  Cycle accept(MemoryPort, Cycle cycle, int, int) override { return cycle + latency_cycles_; }
  Cycle fixed_latency() const override { return latency_cycles_; }

 private:
  int latency_cycles_;
};

inline std::shared_ptr<MemoryTiming> make_ideal(const spec::Contract&, int latency_cycles) {
  return std::make_shared<IdealTiming>(latency_cycles);
}

}  // namespace pineda::memory
