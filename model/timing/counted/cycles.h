// Cycles, and what they are spent on: the same words for the model and the RTL. Knows no SystemC.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/memory/port.h"
#include "model/spec/widths.h"

namespace pineda::timing {

using memory::Cycle;
using memory::kMemoryPorts;
using memory::MemoryPort;
using memory::port_name;

/// From this cycle on the memories are asked to clear; once they have, triangles are taken.
inline constexpr Cycle kClearOffered = 1;

/// What has a time of its own: setup, the three stages of traversal, interpolation and depth test.
enum class Unit : uint8_t { kSetup, kTiles, kCoverage, kStamps, kInterpZtest };
inline constexpr size_t kUnits = 5;

/// What a unit does in a cycle. Where several hold, the first one counts, in the order: starved,
/// hazard, blocked, memory. Setup works on several triangles at a time, so for it: blocked while an
/// output waits, which freezes it; else busy from a triangle taken until the next one could be.
enum class Cause : uint8_t {
  kBusy,
  kStarved,  // nothing to work on
  kBlocked,  // the next unit, or a full table, does not take it
  kHazard,   // the stamp's address is in flight (interpolation only)
  kMemory,   // a memory port does not take it
};
inline constexpr size_t kCauses = 5;

const char* unit_name(Unit unit);     // "setup", "tiles", "coverage", "stamps", ...
const char* unit_title(Unit unit);    // for a person: "traversal, tiles"
const char* cause_name(Cause cause);  // "busy", "starved", "blocked", "hazard", "memory"
const char* cause_meaning(Cause cause);

/// The cycles of a unit, from cycle 0 until the frame has drained, by cause.
struct UnitCycles {
  std::array<Cycle, kCauses> spent{};

  Cycle& operator[](Cause cause) { return spent[static_cast<size_t>(cause)]; }
  Cycle operator[](Cause cause) const { return spent[static_cast<size_t>(cause)]; }
  Cycle total() const {
    Cycle sum = 0;
    for (const Cycle cycles : spent) sum += cycles;
    return sum;
  }
};

/// The FIFOs: triangles set up, tiles inside traversal, stamps.
enum class Fifo : uint8_t { kPrims, kTiles, kStamps };
inline constexpr size_t kFifos = 3;
const char* fifo_name(Fifo fifo);  // "prims", "tiles", "stamps"
/// How many slots it has.
int fifo_depth(const spec::Design& design, Fifo fifo);

/// What a frame's cycles were spent on. Model and RTL count the same; counters.h has the names.
struct CycleCounters {
  Cycle drained = 0;                     // from cycle 0 until the whole pipeline is empty
  std::array<UnitCycles, kUnits> units;  // each adds up to `drained`
  // By FIFO, by level 0 .. depth: the cycles that began at that level. Each adds up to `drained`.
  std::array<std::vector<Cycle>, kFifos> levels;
  std::array<Cycle, kMemoryPorts> port_stalls{};  // cycles in which a port's offer was not taken
  // Stamps sent to interpolation, by covered samples: [0] stays 0.
  std::array<uint64_t, spec::kMaxLanes + 1> stamps_by_samples{};
  uint64_t samples_passed = 0;  // covered samples by the outcome of their depth test
  uint64_t samples_failed = 0;
};

}  // namespace pineda::timing
