// The cycle model against the RTL on one frame: cycles, the retirement of each triangle, speed.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "model/memory/kinds.h"
#include "model/memory/stalls.h"
#include "model/spec/structs.h"

namespace pineda::studies {

/// With stalls at memories or ports, the model's cycles may differ from the RTL's by this share,
/// and 99 % of the retirements by this many cycles.
inline constexpr double kCycleErrorBound = .001;
inline constexpr int64_t kRetireP99Bound = 4;

struct CycleOptions {
  memory::Kind memory = memory::Kind::kIdeal;
  int depth_latency_cycles = 8;  // of an ideal memory
  memory::StallMode stall_mode = memory::StallMode::kNone;
  uint64_t seed = 0;                   // of the stalls
  int runs = 5;                        // the speed is the median of this many runs; 0: not measured
  std::vector<std::string> compilers;  // that compile the measured RTL; two at most
  std::function<void(const std::string&)> say;  // is told what takes long, such as a build
};

/// Differences between the cycles in which the model and the RTL retire triangles (model - RTL). A
/// triangle retires with its last depth or colour write.
struct RetireErrors {
  uint64_t triangles = 0;  // that retired in the model or in the RTL
  uint64_t off = 0;        // of them: those that did not retire in the same cycle
  int64_t p99 = 0;         // 99th percentile of the absolute differences
  int64_t max = 0;
  uint32_t worst = 0;  // the first triangle with the greatest difference
};
/// Both lists: the retire cycle by triangle number, -1 where a triangle wrote nothing.
RetireErrors retire_errors(const std::vector<int64_t>& model, const std::vector<int64_t>& rtl);

struct RtlSpeed {
  std::array<char, 32> compiler{};  // name and version
  double seconds = 0;               // CPU seconds per frame, measured as below
};

/// The result of one frame; sent through a pipe, so it holds no pointers.
struct CyclePoint {
  int64_t model_cycles = 0;
  int64_t rtl_cycles = 0;
  bool same_frame = false;  // model and RTL left the same depth and colours
  RetireErrors retire;
  size_t counters = 0;                   // compared
  size_t counters_off = 0;               // of them: those that differ
  std::array<char, 32> first_counter{};  // the name of the first of these
  // Medians of CPU seconds per frame; 0: not measured. Loading, packing and elaboration are not
  // included.
  double time_seconds = 0;  // the model, computing only what timing depends on
  double bits_seconds = 0;  // the model, computing every bit
  std::array<RtlSpeed, 2> rtl;
  size_t compilers = 0;

  /// |model - RTL| of the frame's cycles, as a share of the RTL's.
  double error() const;
  /// A cycle, a retirement, a counter or the frame differs.
  bool is_off() const;
  /// Without stalls nothing may differ. With stalls cycles and retirements must be within their
  /// bounds; counters and frame must still be equal.
  bool holds(bool stalls) const;
  /// The faster RTL; nullptr where none was measured.
  const RtlSpeed* fastest() const;
};

/// Compares cycles and counters; the RTL runs as the ordinary plug-in with a listener. Speed is
/// measured on bench plug-ins (tb/bench_top.h) with the same memory and stalls, with model and RTL
/// taking turns. The frames are drawn in a child process.
///
/// Errors   tb::PluginError: the RTL cannot be found or built. tb::RtlError: the bare RTL's cycles
///          or frame differ from the ordinary RTL's, or one of the two broke its own rules.
CyclePoint compare_cycles(const spec::Contract& contract, const spec::FrameState& frame,
                          const std::vector<spec::Triangle>& triangles,
                          const CycleOptions& options);

}  // namespace pineda::studies
