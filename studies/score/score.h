// The score of vectors: how many mutants of a unit's RTL they kill.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/spec/names.h"
#include "studies/score/kills.h"
#include "studies/score/mutants.h"
#include "studies/score/prover.h"

namespace pineda::studies {

/// What became of a mutant.
enum class Fate {
  kDead,        // vectors saw a wrong bit
  kLate,        // all bits right, a handshake in another cycle
  kEquivalent,  // proven
  kSurvives,    // it differs, by a proof; no vector shows it
  kUndecided,   // no vector shows it, and no proof was found
};
inline constexpr spec::Name<Fate> kFateNames[] = {{Fate::kDead, "dead"},
                                                  {Fate::kLate, "late"},
                                                  {Fate::kEquivalent, "equivalent"},
                                                  {Fate::kSurvives, "survives"},
                                                  {Fate::kUndecided, "undecided"}};
constexpr const auto& names(Fate) { return kFateNames; }

struct ScoredMutant {
  Mutant mutant;
  Fate fate = Fate::kUndecided;
  size_t stage = 0;   // of the dead and the late: the first that shows it
  Sight sight;        // of the same
  Decision decision;  // of the others
};

/// Vectors that are tried together, made when they are needed.
template <class Case>
struct Stage {
  std::string name;  // "level 1"
  std::function<std::vector<Case>()> cases;
};

/// Runs the mutants of a unit on one stage after the other, until one kills them; those that no stage
/// kills go to the prover, with `proves`. `say` hears what takes its time, `done` of mutants that are
/// through a stage, from any thread.
///
/// Errors   AreaError: a tool fails, or the RTL is not as the vectors expect. tb::PluginError: the
///          plug-in of the mutants cannot be had.
template <class Case>
std::vector<ScoredMutant> scored(const spec::Contract& contract, const MutantNetlist& netlist,
                                 const std::vector<Stage<Case>>& stages, bool proves,
                                 const ToolRuns& runs,
                                 const std::function<void(const std::string&)>& say,
                                 const std::function<void(size_t)>& done);

}  // namespace pineda::studies
