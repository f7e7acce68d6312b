// One scene through two sides of a design, each in a child process: SystemC elaborates once per
// process.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "tests/random/draw.h"

namespace pineda::test {

/// What a comparison found.
struct Found {
  uint64_t compared = 0;         // tokens or samples
  std::array<char, 240> text{};  // the first difference; empty if none

  std::string difference() const { return text.data(); }
  void set(const std::string& difference);
};

/// The cycle model against the Verilated RTL: every token's bits and its cycle, at every boundary;
/// the cycles of the frame; every counter; the frame. `plugin`: a file, or empty for the design's
/// own, built where there is none; `late` cycles are added to the model's latency.
Found model_against_rtl(const spec::Contract& contract, const Trial& trial,
                        const std::string& plugin = {}, int late = 0);

/// The cycle model in three modes: stamp by stamp with a listener, by whole tiles, and computing
/// only what time depends on. Cycles and counters must be the same; the first two must have core's
/// frame and, except for what hierarchical z leaves out, its counters. The first two are compared
/// under the stalls of the trial, the last one without stalls.
Found model_against_itself(const spec::Contract& contract, const Trial& trial, int late = 0);

}  // namespace pineda::test
