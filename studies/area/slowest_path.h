// How slow a netlist is.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "studies/area/synthesis.h"
#include "studies/area/technology.h"
#include "studies/area/tool_runs.h"

namespace pineda::studies {

/// Part of a path inside one module.
struct PathPart {
  std::string instance;  // below the top: "u_setup.u_style"
  std::string module;
  double ps = 0;
  int cells = 0;  // logic levels
};

/// A path between registers, inputs and outputs.
struct TimingPath {
  double ps = 0;        // all of it: the least period of a clock that it allows
  double fixed_ps = 0;  // of that the registers and the input's driver
  std::string from, to;
  std::vector<PathPart> parts;

  int levels() const;
};

/// How slow a netlist is.
struct NetlistTiming {
  std::vector<TimingPath>
      slow;            // slower than the clock asked for, the slowest first; at least one,
                       // at most a thousand, one for each end
  TimingPath through;  // from an input to an output, the slowest; 0 ps: there is none
};

/// The timing of each top's netlist under a clock.
///
/// In       the modules below the tops are mapped. No wires; inputs come at the edge of the clock,
///          from the technology's driving cell; reset is not timed.
/// Errors   AreaError: a netlist has no path.
std::vector<NetlistTiming> netlist_timings(const Synthesis& synthesis, const Technology& technology,
                                           const ToolRuns& runs,
                                           const std::vector<std::string>& tops, int period_ps);

}  // namespace pineda::studies
