// Netlists of units on their vectors, in Icarus Verilog.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "studies/area/synthesis.h"
#include "studies/netlist/unit_vectors.h"

namespace pineda::studies {

/// The mapped netlists of some of kUnits, each as `study area` has it at this one clock; from the
/// same cache.
///
/// Errors   AreaError.
std::vector<std::filesystem::path> unit_netlists(const spec::Contract& contract,
                                                 const Technology& technology, int clock_ps,
                                                 const std::vector<std::string>& units,
                                                 const ToolRuns& runs);

/// A netlist, of the module UNIT_unit, and what it is given.
struct NetlistTask {
  std::filesystem::path netlist;
  std::unique_ptr<UnitVectors> vectors;
};

/// Replays netlists at the same time, each in a simulator of its own.
///
/// In       cells: their Verilog models. seed: of the stalls. cache: where it works; nothing stays.
/// Errors   AreaError: Icarus is missing, or does not take a netlist.
std::vector<Replay> replay_netlists(const std::vector<NetlistTask>& tasks, const std::string& cells,
                                    uint64_t seed, const std::filesystem::path& cache);

/// "Icarus Verilog version 11.0 (stable) ()".
/// Errors   AreaError: it is missing.
std::string icarus_version();

}  // namespace pineda::studies
