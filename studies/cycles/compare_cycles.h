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

/// Where memories or ports stall, the model's cycles may be wrong by so much, as a share of the
/// RTL's, and 99 % of the retirements by so many cycles.
inline constexpr double kCycleErrorBound = .001;
inline constexpr int64_t kRetireP99Bound = 4;

struct CycleOptions {
  memory::Kind memory = memory::Kind::kIdeal;
  int depth_latency_cycles = 8;  // of an ideal memory
  memory::StallMode stall_mode = memory::StallMode::kNone;
  uint64_t seed = 0;                   // of the stalls
  int runs = 5;                        // the median of so many is the speed; 0: not measured
  std::vector<std::string> compilers;  // of the RTL that is measured, two at most
  std::function<void(const std::string&)> say;  // hears what takes its time
};

/// Cycles in which triangles retired, by the model less by the RTL. A triangle retires with its
/// last depth or colour write.
struct RetireErrors {
  uint64_t triangles = 0;  // that retired in the model or in the RTL
  uint64_t off = 0;        // of them: those that did not retire in the same cycle
  int64_t p99 = 0;         // of the sizes of all differences
  int64_t max = 0;
  uint32_t worst = 0;  // the first triangle of the greatest difference
};
/// By number; -1 where a triangle wrote nothing.
RetireErrors retire_errors(const std::vector<int64_t>& model, const std::vector<int64_t>& rtl);

struct RtlSpeed {
  std::array<char, 32> compiler{};  // and its version
  double seconds = 0;               // of CPU time a frame, as below
};

/// Comes through a pipe.
struct CyclePoint {
  int64_t model_cycles = 0;
  int64_t rtl_cycles = 0;
  bool same_frame = false;  // depth and colours of model and RTL
  RetireErrors retire;
  size_t counters = 0;                   // compared
  size_t counters_off = 0;               // of them: those that differ
  std::array<char, 32> first_counter{};  // the name of the first of these
  // Medians of CPU seconds a frame; 0: not measured. Nothing is loaded, packed or elaborated in
  // them.
  double time_seconds = 0;  // the model, only what time depends on
  double bits_seconds = 0;  // the model, every bit
  std::array<RtlSpeed, 2> rtl;
  size_t compilers = 0;

  /// |model - RTL| of the frame's cycles, as a share of the RTL's.
  double error() const;
  /// A cycle, a retirement, a counter or the frame differs.
  bool is_off() const;
  /// Where nothing stalls nothing is off; elsewhere all is within its bound, and counters and
  /// frame are not off.
  bool holds(bool stalls) const;
  /// The faster RTL; nullptr where none was measured.
  const RtlSpeed* fastest() const;
};

/// Cycles and counters with the ordinary plug-in under a listener. Speed, where nobody stalls and
/// the memory is ideal, with bench plug-ins (tb/bench_top.h); the runs of model and RTL take turns.
/// All of it in a process of its own.
///
/// Errors   tb::PluginError: the RTL cannot be had. tb::RtlError: the bare RTL takes other cycles
///          or draws another frame than the ordinary one, or one of them broke its own rules.
CyclePoint compare_cycles(const spec::Contract& contract, const spec::FrameState& frame,
                          const std::vector<spec::Triangle>& triangles,
                          const CycleOptions& options);

}  // namespace pineda::studies
