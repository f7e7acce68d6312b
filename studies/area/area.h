// Area, clock and storage of a design's RTL in a process.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/spec/widths.h"
#include "studies/area/slowest_path.h"
#include "studies/area/synthesis.h"
#include "studies/area/technology.h"
#include "studies/area/tool_runs.h"

namespace pineda::studies {

/// A module at one place of the hierarchy, what it holds not included.
struct AreaPart {
  std::string path;  // of its instance: "u_setup.u_style"; of the top ""
  std::string module;
  std::string unit;  // setup, traversal, interp_ztest or top; a FIFO is its producer's
  double area_um2 = 0;
  int flip_flops = 0;
  long memory_bits =
      0;  // if it is a memory; its area is then that of flip-flops and their selection
  int memory_words = 0;
};

struct UnitArea {
  double area_um2 = 0;
  int flip_flops = 0;
  TimingPath slowest;  // of the unit alone, from its inputs to its outputs
  TimingPath through;  // from an input to an output without a register; 0 ps: there is none

  double fmax_mhz() const { return 1e6 / slowest.ps; }
};

struct AreaStudy {
  std::vector<AreaPart> parts;
  std::map<std::string, UnitArea> units;  // "top": what belongs to no unit, without a path
  TimingPath slowest;                     // of raster_top
  std::vector<int> asked_ps;              // the clocks asked for
  double area_um2 = 0;                    // every stored bit as a flip-flop
  double area_without_memory_um2 = 0;
  double macro_area_um2 =
      -1;  // of the memories, macros where they are smaller; -1: no macros known
  int flip_flops = 0;
  long memory_bits = 0;

  double fmax_mhz() const { return 1e6 / slowest.ps; }
};

inline constexpr int kMostClockPs = 1'000'000'000;

struct AreaOptions {
  long least_memory_bits = 1024;  // smaller memories count as logic
  int clock_ps = 0;               // the one clock asked for; 0: the fastest is searched
};

/// Maps a design and finds its fastest clock: it asks for faster ones until one fails, to 3 %, in at
/// most four clocks; from clock to clock only modules on paths that are too slow are mapped again.
///
/// In       a design that has RTL.
/// Errors   AreaError.
AreaStudy study_area(const spec::Contract& contract, const Technology& technology,
                     const AreaOptions& options, const ToolRuns& runs);

}  // namespace pineda::studies
