// Which mutants are equivalent: on all legal inputs they do in each cycle what the original does.
#pragma once

#include <string>
#include <vector>

#include "studies/score/mutants.h"

namespace pineda::studies {

enum class Proof {
  kEquivalent,  // proven, by induction over registers or by property-directed reachability
  kDiffers,     // an input sequence tells it from the original
  kUndecided,   // neither within the time
};

struct Decision {
  Proof proof = Proof::kUndecided;
  int cycles = 0;  // of the shortest sequence found that tells them apart
};

/// Decides mutants of a unit by ABC: the unit inside of studies/score/UNIT_legal.sv, which makes
/// every legal input and shows what can be seen of the outputs, against the same with the mutant.
/// Registers start as zero and are reset in the first cycle.
///
/// Errors   AreaError: Yosys fails.
std::vector<Decision> decided(const std::string& unit, const MutantNetlist& netlist,
                              const std::vector<int>& mutants, const ToolRuns& runs);

}  // namespace pineda::studies
