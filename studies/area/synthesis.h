// A design's RTL as a netlist of cells, module by module.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "model/spec/widths.h"
#include "studies/area/rtlil.h"
#include "studies/area/technology.h"
#include "studies/area/tool_runs.h"

namespace pineda::studies {

/// The module at the top of the RTL, and its units.
inline constexpr const char* kTop = "raster_top";
inline constexpr const char* kUnits[] = {"setup_unit", "traversal_unit", "interp_ztest_unit"};

/// "setup" of setup_unit.
std::string unit_name(const std::string& module);

/// The RTL of a design in one text: its own package, then what rtl/files.f lists.
/// Errors   AreaError: a file cannot be read.
std::string sources_of(const spec::Contract& contract);

/// A module with state, a unit or the top. Modules without state, or with nothing but registers, are
/// part of those that hold them.
/// A memory is a module of its own.
struct SynthesizedModule {
  std::string name;
  std::string rtlil;                         // its file in the cache, before mapping
  std::string around;                        // the black boxes of the modules that it holds
  std::string netlist;                       // its file in the cache, mapped
  std::map<std::string, std::string> parts;  // module by instance
  std::map<std::string, int> cells;          // how many of each cell of the library
  long memory_bits = 0;                      // of a memory
  int memory_words = 0;
};

/// Maps the RTL of a design to the cells of a technology.
///
/// Source   the flow of docs/hardware.md: Yosys' synth without ABC, dfflibmap, then ABC told the
///          clock and the load; no wires.
class Synthesis {
 public:
  /// Elaborates. A memory with one write port and at most two read ports of at least
  /// `least_memory_bits` becomes a module.
  Synthesis(const spec::Contract& contract, const Technology& technology, long least_memory_bits,
            const ToolRuns& runs);

  /// Maps modules, each for a delay from its inputs and registers to its outputs and registers, ps;
  /// what was mapped for the same delay before is found again. Modules that are not named stay.
  void map(const std::map<std::string, int>& delay_ps);

  const std::map<std::string, SynthesizedModule>& modules() const { return modules_; }
  /// The module of each instance below `top`, by its path: "u_setup.u_style"; of `top` "".
  std::map<std::string, std::string> instances(const std::string& top) const;
  /// For each top the mapped netlist of it and all that it holds as one flat module; the files in the
  /// cache. Cells are named after their instances, a port is there for each bit: \tri_i[0] .
  std::vector<std::string> flat_netlists(const std::vector<std::string>& tops) const;
  const std::string& liberty() const { return liberty_; }

 private:
  void try_cells() const;
  std::string mapping_of(const std::string& module, int delay_ps) const;
  std::string elaborated(const spec::Contract& contract) const;
  std::string split(const std::string& design, long least_memory_bits,
                    std::map<std::string, RtlilCell>* memory) const;
  void elaborate(const spec::Contract& contract, long least_memory_bits);

  const Technology& technology_;
  const ToolRuns& runs_;
  std::string liberty_;      // its file in the cache, with the cells allowed
  std::string constraints_;  // for ABC
  std::map<std::string, SynthesizedModule> modules_;
};

/// What the modules of `top` are mapped for before any path has been seen, ps.
std::map<std::string, int> first_delays(const Synthesis& synthesis, const std::string& top,
                                        int clock_ps);

}  // namespace pineda::studies
