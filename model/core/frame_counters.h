// The counters of a frame's triangles, tiles, stamps and samples, and the table of them.
#pragma once

#include <array>
#include <cstdint>
#include <iterator>
#include <string>

#include "model/core/setup.h"

namespace pineda::core {

/// What happened to the triangles and samples of a frame. kFrameCounters describes each counter.
struct FrameCounters {
  uint64_t triangles = 0;
  std::array<uint64_t, kDropCauses> dropped{};  // by Drop
  uint64_t tiles_tested = 0;
  uint64_t tiles_rejected = 0;
  uint64_t tiles_accepted = 0;
  uint64_t tiles_hidden = 0;
  uint64_t stamps = 0;
  uint64_t fragments = 0;
  uint64_t interpolated = 0;
  uint64_t passed = 0;
};

/// Which RTL events a counter sums. The RTL counts events in arrays by kind: tile tests by their
/// outcome, stamps by their number of samples.
struct RtlKinds {
  enum class Which : uint8_t { kOne, kAll, kAllButFirst, kByNumber };
  Which which = Which::kOne;
  int kind = 0;  // for kOne

  /// How many times an event of kind `of` counts. kByNumber: a stamp of k samples counts k times.
  constexpr uint64_t times(size_t of) const {
    if (which == Which::kByNumber) return of;
    if (which == Which::kOne) return of == static_cast<size_t>(kind) ? 1 : 0;
    return which == Which::kAll || of > 0 ? 1 : 0;
  }
};

/// Which models and frames know a counter's value.
enum class Known : uint8_t {
  kAlways,
  kIfTested,  // only where depth tests are made, since it counts their results
  kInTime,    // only models with time; the functional model leaves it at 0
};

/// A row of the table: all that lists, files and comparisons need to know of a counter.
struct FrameCounter {
  const char* name;
  const char* place;  // path in the JSON output; nullptr for drops: json() makes it
  const char* unit;
  const char* meaning;
  const char* rtl;  // the RTL's array of events, by its name in tb/plugin.cpp
  RtlKinds kinds;
  uint64_t FrameCounters::*member;  // nullptr: the counter is dropped[drop]
  Known known = Known::kAlways;
  Drop drop = Drop::kNone;

  uint64_t& of(FrameCounters& counters) const {
    return member != nullptr ? counters.*member : counters.dropped[static_cast<size_t>(drop)];
  }
  uint64_t of(const FrameCounters& counters) const {
    return member != nullptr ? counters.*member : counters.dropped[static_cast<size_t>(drop)];
  }
  constexpr bool is_drop() const { return member == nullptr; }
  /// "tiles_tested", "dropped.zero_area".
  std::string full_name() const {
    return is_drop() && drop != Drop::kNone ? std::string("dropped.") + name : name;
  }
  /// "/tiles/tested", "/dropped/zero_area"; empty where the JSON leaves it out.
  std::string json() const {
    if (!is_drop()) return place;
    return drop != Drop::kNone ? std::string("/dropped/") + name : std::string();
  }
};

namespace counter_rows {

constexpr RtlKinds one(int kind) { return {RtlKinds::Which::kOne, kind}; }
inline constexpr RtlKinds kAll{RtlKinds::Which::kAll};
inline constexpr RtlKinds kAllButFirst{RtlKinds::Which::kAllButFirst};
inline constexpr RtlKinds kByNumber{RtlKinds::Which::kByNumber};

constexpr FrameCounter drop(Drop drop, const char* meaning) {
  return {spec::name_of(drop),         nullptr, "triangles",    meaning, "setup_drops",
          one(static_cast<int>(drop)), nullptr, Known::kAlways, drop};
}

// Every counter once, in the order of the pipeline.
// clang-format off
inline constexpr FrameCounter kRows[] = {
    {"triangles", "/triangles", "triangles", "taken by setup",
     "setup_drops", kAll, &FrameCounters::triangles},
    drop(Drop::kNone, "set up and sent on"),
    drop(Drop::kZeroArea, "without area after snapping"),
    drop(Drop::kFacing, "culled by their facing"),
    drop(Drop::kNoSample, "in whose box no pixel centre lies"),
    drop(Drop::kOutside, "whose box lies outside the frame or the scissor"),
    {"tiles_tested", "/tiles/tested", "tiles", "tested against a triangle's edges",
     "tiles_tests", kAll, &FrameCounters::tiles_tested},
    {"tiles_rejected", "/tiles/rejected", "tiles", "rejected by an edge",
     "tiles_tests", one(2), &FrameCounters::tiles_rejected},
    {"tiles_accepted", "/tiles/accepted", "tiles", "accepted whole by all three edges",
     "tiles_tests", one(1), &FrameCounters::tiles_accepted},
    {"tiles_hidden", "/tiles/hidden", "tiles",
     "not rejected, but left out by hierarchical z: behind what is stored there",
     "tiles_tests", one(3), &FrameCounters::tiles_hidden, Known::kInTime},
    {"stamps", "/stamps", "stamps", "sent by traversal, so not empty",
     "stamps_sent", kAll, &FrameCounters::stamps},
    {"fragments", "/fragments", "samples", "covered, in stamps that were sent",
     "stamps_sent", kByNumber, &FrameCounters::fragments},
    {"interpolated", "/interpolated", "stamps",
     "with a sample that passed the depth test, so that attributes are needed",
     "samples_passed", kAllButFirst, &FrameCounters::interpolated, Known::kIfTested},
    {"passed", "/passed", "samples", "that passed the depth test, so that they are written",
     "samples_passed", kByNumber, &FrameCounters::passed, Known::kIfTested},
};
// clang-format on

}  // namespace counter_rows

/// The table. A new counter needs a member of FrameCounters, a row here, and an array in the RTL.
inline constexpr auto& kFrameCounters = counter_rows::kRows;
static_assert(sizeof(FrameCounters) == sizeof(uint64_t) * std::size(kFrameCounters),
              "each counter has a row");

}  // namespace pineda::core
