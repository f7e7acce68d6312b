#include "studies/score/score.h"

#include <fmt/format.h>

#include "tb/plugin_cache.h"

namespace pineda::studies {
namespace {

std::vector<size_t> with_fate(const std::vector<ScoredMutant>& all,
                              const std::function<bool(const ScoredMutant&)>& is_asked) {
  std::vector<size_t> found;
  for (size_t i = 0; i < all.size(); ++i) {
    if (is_asked(all[i])) found.push_back(i);
  }
  return found;
}

std::vector<int> numbers_of(const std::vector<ScoredMutant>& all,
                            const std::vector<size_t>& which) {
  std::vector<int> numbers;
  for (const size_t i : which) numbers.push_back(all[i].mutant.number);
  return numbers;
}

void decide(const std::string& unit, const MutantNetlist& netlist, const ToolRuns& runs,
            std::vector<ScoredMutant>* all) {
  const auto alive =
      with_fate(*all, [](const ScoredMutant& m) { return m.fate == Fate::kUndecided; });
  const auto decisions = decided(unit, netlist, numbers_of(*all, alive), runs);
  for (size_t i = 0; i < alive.size(); ++i) {
    ScoredMutant& scored = (*all)[alive[i]];
    scored.decision = decisions[i];
    if (decisions[i].proof == Proof::kEquivalent) scored.fate = Fate::kEquivalent;
    if (decisions[i].proof == Proof::kDiffers) scored.fate = Fate::kSurvives;
  }
}

}  // namespace

template <class Case>
std::vector<ScoredMutant> scored(const spec::Contract& contract, const MutantNetlist& netlist,
                                 const std::vector<Stage<Case>>& stages, bool proves,
                                 const ToolRuns& runs,
                                 const std::function<void(const std::string&)>& say,
                                 const std::function<void(size_t)>& done) {
  const std::string unit = spec::name_of(Case::kUnit);
  std::vector<ScoredMutant> all;
  for (const Mutant& mutant : netlist.mutants) all.push_back({mutant, Fate::kUndecided, 0, {}, {}});
  const tb::RtlLibrary library(contract,
                               tb::cached_mutants_plugin(contract, unit, netlist.verilog, say));
  for (size_t stage = 0; stage < stages.size(); ++stage) {
    const auto alive =
        with_fate(all, [](const ScoredMutant& m) { return m.fate == Fate::kUndecided; });
    if (alive.empty()) break;
    const auto cases = stages[stage].cases();
    say(fmt::format("{}: {} cases of {} on {} mutants", unit, cases.size(), stages[stage].name,
                    alive.size()));
    const auto sights = sights_of(library, cases, numbers_of(all, alive), done);
    for (size_t i = 0; i < alive.size(); ++i) {
      ScoredMutant& scored = all[alive[i]];
      if (!sights[i].is_dead && !sights[i].is_late) continue;
      scored.fate = sights[i].is_dead ? Fate::kDead : Fate::kLate;
      scored.stage = stage;
      scored.sight = sights[i];
    }
  }
  if (proves) decide(unit, netlist, runs, &all);
  return all;
}

template std::vector<ScoredMutant> scored(const spec::Contract&, const MutantNetlist&,
                                          const std::vector<Stage<vectors::SetupCase>>&, bool,
                                          const ToolRuns&,
                                          const std::function<void(const std::string&)>&,
                                          const std::function<void(size_t)>&);
template std::vector<ScoredMutant> scored(const spec::Contract&, const MutantNetlist&,
                                          const std::vector<Stage<vectors::TraversalCase>>&, bool,
                                          const ToolRuns&,
                                          const std::function<void(const std::string&)>&,
                                          const std::function<void(size_t)>&);
template std::vector<ScoredMutant> scored(const spec::Contract&, const MutantNetlist&,
                                          const std::vector<Stage<vectors::InterpZtestCase>>&, bool,
                                          const ToolRuns&,
                                          const std::function<void(const std::string&)>&,
                                          const std::function<void(size_t)>&);

}  // namespace pineda::studies
