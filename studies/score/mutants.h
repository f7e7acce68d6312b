// Mutants of a unit's RTL: one netlist that holds all of them, chosen by an input.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/spec/widths.h"
#include "studies/area/tool_runs.h"

namespace pineda::studies {

/// The units that are mutated; the names of their vectors.
inline constexpr const char* kMutatedUnits[] = {"setup", "traversal", "interp_ztest"};

/// One change of one bit of one cell's port.
struct Mutant {
  int number = 0;    // from 1; 0 is the RTL as it is
  std::string mode;  // inv, const0, const1, cnot0 or cnot1, as Yosys' mutate has them
  std::string port;
  int bit = 0;
  std::string file;  // below rtl/
  int line = 0;
  std::string source;          // the line
  bool in_multiplier = false;  // the product itself, rtl/lib

  /// "inv Y[3]".
  std::string text() const;
};

/// The RTL of a unit with mutants, each of which runs where the input mutant_i has its number.
struct MutantNetlist {
  std::vector<Mutant> mutants;
  std::string verilog;  // the text
  std::string rtlil;    // its file in the cache
  std::string package;  // the file of the design's package in the cache
};

/// Elaborates a unit as `study area` does, flat, with a `*` for each product, and lets Yosys choose
/// mutants evenly over cells, wires and source lines. The FIFO behind a unit is part of it.
///
/// Errors   AreaError: Yosys fails, or finds fewer mutants than asked for.
MutantNetlist mutated(const spec::Contract& contract, const std::string& unit, int mutants,
                      uint64_t seed, const ToolRuns& runs);

}  // namespace pineda::studies
