// What a study measures: scenes x designs x memories, and designs in technologies.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/memory/kinds.h"
#include "model/scene/scene.h"
#include "model/spec/widths.h"

namespace pineda::studies {

/// What a row of results tells.
enum class Measure { kCycles, kStalls, kBandwidth, kError, kHostSpeed, kArea, kTiming };

/// What a measure depends on beside the design: scene and memory, on the machine with nothing else
/// running, a scene, or a technology.
enum class DependsOn { kFrame, kMachine, kScene, kTechnology };

struct MeasureName {
  Measure value;
  const char* word;
  const char* meaning;
  DependsOn on;
  /// Raised when the same inputs give other figures although neither RTL nor package has changed.
  int revision;
};
inline constexpr MeasureName kMeasureNames[] = {
    {Measure::kCycles, "cycles", "of a frame, with its triangles and samples", DependsOn::kFrame,
     1},
    {Measure::kStalls, "stalls", "what each unit did in each cycle, FIFOs, ports",
     DependsOn::kFrame, 1},
    {Measure::kBandwidth, "bandwidth", "bytes read and written, caches", DependsOn::kFrame, 1},
    {Measure::kError, "error", "coverage, depth and colour against exact arithmetic",
     DependsOn::kScene, 1},
    {Measure::kHostSpeed, "host_speed", "of the cycle model on this machine", DependsOn::kMachine,
     1},
    {Measure::kArea, "area", "of cells, by unit", DependsOn::kTechnology, 1},
    {Measure::kTiming, "timing", "slowest paths, by unit", DependsOn::kTechnology, 1},
};
constexpr const auto& names(Measure) { return kMeasureNames; }
inline constexpr auto kMeasures = spec::values_of<Measure>();

struct StudyScene {
  std::string name;
  std::string content;  // a text that changes with what is drawn
  /// With `multi_pass` it can be rewound. Throws scene::InputError.
  std::function<scene::Scene(const spec::Contract&, bool multi_pass)> open;
};

struct StudyMemory {
  std::string name;
  memory::Kind kind = memory::Kind::kIdeal;
  std::optional<int> latency_cycles;  // of an ideal one; none: the design's own
  memory::DramParameters dram;
};

struct StudyTechnology {
  std::string name;     // as read_technology() takes it, or FILE.toml
  std::string liberty;  // the cells' file; empty: where the technology says
  std::string content;  // a text that changes with the technology
};

struct Study {
  std::string name;
  std::vector<StudyScene> scenes;
  std::vector<spec::Design> designs;
  std::vector<StudyMemory> memories;
  std::vector<StudyTechnology> technologies;
  std::vector<Measure> measures;
  int clock_ps = 0;  // the one clock asked of synthesis; 0: the fastest is searched
};

/// A number of a row.
struct Figure {
  std::string name;
  double value = 0;
};

inline bool operator==(const Figure& a, const Figure& b) {
  return a.name == b.name && a.value == b.value;
}

}  // namespace pineda::studies
