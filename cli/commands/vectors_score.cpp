// pineda vectors score: how many mutants of the RTL the vectors kill.
#include <algorithm>
#include <mutex>

#include "cli/commands/vectors.h"
#include "studies/area/area_error.h"
#include "studies/score/score.h"
#include "tb/plugin_cache.h"
#include "vectors/generator/generate.h"

namespace pineda::cli {
namespace {

using studies::Fate;
using studies::ScoredMutant;
using vectors::Unit;

/// The mutants of a unit, counted.
struct Tally {
  size_t mutants = 0, in_multipliers = 0;
  size_t killed[vectors::kMaxLevel] = {};  // by stage
  size_t late = 0;                         // of them: all bits right
  size_t equivalent = 0, survive = 0, undecided = 0;
  size_t undecided_in_multipliers = 0;

  void add(const ScoredMutant& m) {
    ++mutants;
    in_multipliers += m.mutant.in_multiplier ? 1 : 0;
    late += m.fate == Fate::kLate ? 1 : 0;
    equivalent += m.fate == Fate::kEquivalent ? 1 : 0;
    survive += m.fate == Fate::kSurvives ? 1 : 0;
    undecided += m.fate == Fate::kUndecided ? 1 : 0;
    undecided_in_multipliers += m.fate == Fate::kUndecided && m.mutant.in_multiplier ? 1 : 0;
    if (m.fate == Fate::kDead || m.fate == Fate::kLate) ++killed[m.stage];
  }
  /// Of the mutants that are not equivalent, what the stages up to this one kill.
  double percent(size_t stage) const {
    size_t dead = 0;
    for (size_t i = 0; i <= stage; ++i) dead += killed[i];
    const size_t all = mutants - equivalent;
    return all == 0 ? 100. : 100. * static_cast<double>(dead) / static_cast<double>(all);
  }
};

/// A result of one unit.
struct UnitScore {
  Unit unit = Unit::kSetup;
  std::vector<ScoredMutant> mutants;
};

/// What is to be scored: units of a design, each with its vectors.
struct Plan {
  spec::Contract contract;
  std::vector<Unit> units;
  std::map<Unit, std::string> files;  // in place of levels
  int level = 1;
};

Plan plan_of(const VectorOptions& options) {
  constexpr Unit kUnits[] = {Unit::kSetup, Unit::kTraversal, Unit::kInterpZtest};
  Plan plan{contract_of(options), {}, {}, options.files.empty() ? options.level : 1};
  for (const std::string& file : options.files) {
    const vectors::Header header = vectors::read_header(file);
    if (header.unit == Unit::kFrame) {
      throw UsageError(fmt::format("{}: expected vectors of a unit, got those of frames", file));
    }
    if (!plan.files.empty() &&
        spec::package_hash(header.contract) != spec::package_hash(plan.contract)) {
      throw UsageError(fmt::format("{}: expected vectors of design {}, got those of {}", file,
                                   plan.contract.design.name, header.contract.design.name));
    }
    plan.contract = header.contract;
    if (!plan.files.emplace(header.unit, file).second) {
      throw UsageError(fmt::format("{}: expected one file a unit, got a second of {}", file,
                                   spec::name_of(header.unit)));
    }
  }
  for (const Unit unit : kUnits) {
    const bool is_asked = options.unit == "all" || options.unit == spec::name_of(unit);
    if (is_asked && (plan.files.empty() || plan.files.count(unit) != 0)) plan.units.push_back(unit);
  }
  if (plan.units.empty()) {
    throw UsageError(fmt::format("--unit: expected a file of {}, got none", options.unit));
  }
  require_of(options, plan.contract.design, spec::no_rtl_reason);
  return plan;
}

template <class Case>
std::vector<studies::Stage<Case>> stages_of(const Plan& plan) {
  const auto file = plan.files.find(Case::kUnit);
  if (file != plan.files.end()) {
    return {{file->second, [path = file->second] { return vectors::read<Case>(path).cases; }}};
  }
  std::vector<studies::Stage<Case>> stages;
  for (int level = 1; level <= plan.level; ++level) {
    const vectors::Request request{level, 1, {}};
    stages.push_back({fmt::format("level {}", level), [&plan, request] {
                        return vectors::generate<Case>(plan.contract, request,
                                                       spec::error_bounds(plan.contract.design))
                            .cases;
                      }});
  }
  return stages;
}

UnitScore scored(Unit unit, const Plan& plan, const VectorOptions& options,
                 const studies::ToolRuns& runs, const Output& output, Progress* progress) {
  const auto units = static_cast<int>(plan.units.size());
  const int mutants = (options.mutants + units - 1) / units;
  const auto netlist =
      studies::mutated(plan.contract, spec::name_of(unit), mutants, options.seed, runs);
  std::mutex mutex;
  const auto done = [&](size_t count) {
    const std::lock_guard<std::mutex> lock(mutex);
    progress->update("mutants", count);
  };
  const auto say = [&](const std::string& text) { output.say(text); };
  return with_case(unit, [&](auto kind) -> UnitScore {
    using Case = decltype(kind);
    if constexpr (Case::kUnit == Unit::kFrame) {
      return {};
    } else {
      return {unit, studies::scored(plan.contract, netlist, stages_of<Case>(plan),
                                    !options.no_proofs, runs, say, done)};
    }
  });
}

std::string place_of(const ScoredMutant& m) {
  return fmt::format("rtl/{}:{}", m.mutant.file, m.mutant.line);
}

std::string fate_of(const ScoredMutant& m) {
  switch (m.fate) {
    case Fate::kDead:
    case Fate::kLate:
      return fmt::format("{}, cycle {}: {}", m.sight.vector, m.sight.cycle, m.sight.what);
    case Fate::kSurvives:
      return fmt::format("differs after {} cycles", m.decision.cycles);
    case Fate::kEquivalent:
    case Fate::kUndecided:
      break;
  }
  return spec::name_of(m.fate);
}

Json json_of(const ScoredMutant& m) {
  Json json{{"number", m.mutant.number},      {"change", m.mutant.text()},
            {"file", "rtl/" + m.mutant.file}, {"line", m.mutant.line},
            {"source", m.mutant.source},      {"in_multiplier", m.mutant.in_multiplier},
            {"fate", spec::name_of(m.fate)}};
  if (m.fate == Fate::kDead || m.fate == Fate::kLate) {
    json["stage"] = m.stage + 1;
    json["case"] = m.sight.vector;
    json["cycle"] = m.sight.cycle;
    json["what"] = m.sight.what;
  }
  if (m.fate == Fate::kSurvives) json["differs_after_cycles"] = m.decision.cycles;
  return json;
}

Json json_of(const Tally& t, int stages) {
  Json json{{"mutants", t.mutants}, {"in_multipliers", t.in_multipliers}};
  for (int i = 0; i < stages; ++i) json[fmt::format("killed_level{}", i + 1)] = t.killed[i];
  json["late"] = t.late;
  json["equivalent"] = t.equivalent;
  json["survive"] = t.survive;
  json["undecided"] = t.undecided;
  json["undecided_in_multipliers"] = t.undecided_in_multipliers;
  for (int i = 0; i < stages; ++i) {
    json[fmt::format("percent_level{}", i + 1)] = t.percent(static_cast<size_t>(i));
  }
  return json;
}

void print_row(const Output& output, const std::string& name, const Tally& t, int stages) {
  std::string row = fmt::format("{:<14}{:>8}", name, t.mutants);
  for (int i = 0; i < stages; ++i) row += fmt::format("{:>9}", t.killed[i]);
  row += fmt::format("{:>6}{:>12}{:>10}{:>11}", t.late, t.equivalent, t.survive, t.undecided);
  for (int i = 0; i < stages; ++i) {
    row += fmt::format("{:>8.1f} %", t.percent(static_cast<size_t>(i)));
  }
  output.line("{}", row);
}

void print_lives(const Output& output, const std::vector<UnitScore>& scores, bool all) {
  for (const UnitScore& score : scores) {
    for (const ScoredMutant& m : score.mutants) {
      const bool lives = m.fate == Fate::kSurvives || m.fate == Fate::kUndecided;
      if (!lives && !all) continue;
      output.line("\n{} {}, {}, {}{}", spec::name_of(score.unit), m.mutant.number, m.mutant.text(),
                  place_of(m), m.mutant.in_multiplier ? ", in a multiplier" : "");
      output.line("  {}\n  {}", m.mutant.source, fate_of(m));
    }
  }
}

/// The bounds: what a level must kill of the mutants that are not equivalent, and what may stay undecided
/// outside of multipliers.
bool holds(const Tally& t, int stages) {
  constexpr double kLeast = 95, kMostUndecided = 2;
  const size_t undecided = t.undecided - t.undecided_in_multipliers;
  const bool is_decided = static_cast<double>(undecided) * 100 <=
                          kMostUndecided * static_cast<double>(t.mutants - t.in_multipliers);
  return t.percent(0) >= kLeast && is_decided && (stages == 1 || t.survive == 0);
}

}  // namespace

int score_vectors(const VectorOptions& options) {
  const Output output(options);
  Progress progress(options);
  const Plan plan = plan_of(options);
  const studies::ToolRuns runs(std::filesystem::absolute(tb::plugin_cache_folder()) / "score",
                               {"yosys"}, [&](const std::string& text) { output.say(text); });
  std::vector<UnitScore> scores;
  for (const Unit unit : plan.units) {
    scores.push_back(scored(unit, plan, options, runs, output, &progress));
    progress.clear();
  }
  const int stages = plan.level;
  const std::string& design = plan.contract.design.name;
  Json json{{"design", design}, {"seed", options.seed}, {"level", stages}};
  Tally sum;
  std::string head = fmt::format("{:<14}{:>8}", "unit", "mutants");
  for (int i = 1; i <= stages; ++i)
    head += plan.files.empty() ? fmt::format("  level {}", i) : "    files";
  head += "  late  equivalent  survive  undecided";
  for (int i = 1; i <= stages; ++i)
    head += plan.files.empty() ? fmt::format("{:>10}", fmt::format("to {}", i)) : "     score";
  output.line("{}\n{}", design, head);
  for (const UnitScore& score : scores) {
    Tally tally;
    Json mutants = Json::array();
    for (const ScoredMutant& m : score.mutants) {
      tally.add(m);
      sum.add(m);
      mutants.push_back(json_of(m));
    }
    print_row(output, spec::name_of(score.unit), tally, stages);
    json["units"][spec::name_of(score.unit)] = json_of(tally, stages);
    json["units"][spec::name_of(score.unit)]["list"] = mutants;
  }
  if (scores.size() > 1) print_row(output, "all", sum, stages);
  print_lives(output, scores, options.all);
  const bool is_well = holds(sum, stages);
  output.line("\n{}", is_well ? "It holds." : "IT DOES NOT HOLD.");
  json["all"] = json_of(sum, stages);
  json["holds"] = is_well;
  output.json(json);
  return is_well ? kHolds : kMismatch;
}

}  // namespace pineda::cli
