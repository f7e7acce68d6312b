#include "studies/score/prover.h"

#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <sstream>

#include "model/files/data_folder.h"
#include "studies/area/area_error.h"
#include "studies/area/rtlil.h"

namespace pineda::studies {
namespace {

namespace fs = std::filesystem;

/// A unit in AIGER's binary form, whose mutant is told by the first values of 16 latches that never
/// change. Their lines are text.
class Circuit {
 public:
  explicit Circuit(const fs::path& folder) : text_(text_of(folder / "legal.aig")) {
    std::istringstream map(text_of(folder / "legal.map"));
    for (std::string line; std::getline(map, line);) {
      std::istringstream words(line);
      std::string kind, name;
      size_t latch = 0, bit = 0;
      if (words >> kind >> latch >> bit >> name && kind == "latch" && name == "mutant_q") {
        bits_[latch] = bit;
      }
    }
    constexpr size_t kSelectBits = 16;
    if (bits_.size() != kSelectBits) throw AreaError("the prover's netlist has lost mutant_q");
  }

  std::string with_mutant(int mutant) const {
    std::istringstream header(text_.substr(0, text_.find('\n')));
    std::string word;
    size_t variables = 0, inputs = 0, latches = 0;
    header >> word >> variables >> inputs >> latches;
    size_t at = text_.find('\n') + 1;
    std::string result = text_.substr(0, at);
    for (size_t latch = 0; latch < latches; ++latch) {
      const size_t end = text_.find('\n', at);
      result.append(text_, at, end - at);
      const auto bit = bits_.find(latch);
      if (bit != bits_.end() && (mutant >> bit->second & 1) != 0) result += " 1";
      result += '\n';
      at = end + 1;
    }
    return result + text_.substr(at);
  }

 private:
  std::string text_;
  std::map<size_t, size_t> bits_;  // of mutant_q, by latch
};

std::string circuit_script(const std::string& unit, const MutantNetlist& netlist,
                           const ToolRuns& runs, bool cuts_multipliers) {
  const auto kept = [&](const std::string& name, const std::string& ending) {
    return runs.keep(text_of(files::data_folder() / "studies/score" / (name + ending)), ending);
  };
  const std::string cut =
      cuts_multipliers ? fmt::format(
                             "techmap -map {}\nselect -set factors w:*.factor_a w:*.factor_b\n"
                             "rename -enumerate -pattern factor_% @factors\n"
                             "expose w:factor_*\n",
                             kept("cut_multipliers", ".v"))
                       : "";
  return fmt::format(
      "read_rtlil {}\nread_verilog -sv -formal {} {}\nhierarchy -check -top {}_legal\n"
      "proc\nflatten\nopt_clean\n{}memory_map\nasync2sync\nopt_expr\nopt_clean\ndffunmap\n"
      "simplemap\ntechmap\nsetundef -zero -init\naigmap\nopt_clean\n"
      "write_aiger -symbols -map {}/legal.map {}/legal.aig\n",
      netlist.rtlil, netlist.package, kept(unit + "_legal", ".sv"), unit, cut, kOut, kOut);
}

/// Registers that are equal by induction become one; what is left is proven with free products.
std::string cut_script(const std::string& original, const std::string& mutant) {
  constexpr int kProofSeconds = 10, kMostSeconds = 60;
  return fmt::format(
      "! timeout -k 5 {3} yosys-abc -q \"miter {0} {1}; strash; scleanup; lcorr; strash; "
      "pdr -T {2}; print_status\" 2>&1 | sed '/ was asserted in frame /d' > {4}/log || true\n",
      original, mutant, kProofSeconds, kMostSeconds, kOut);
}

/// The same with products as they are, and a search for a difference before the proof.
std::string proof_script(const std::string& original, const std::string& mutant) {
  constexpr int kSearchSeconds = 5, kProofSeconds = 10, kMostSeconds = 60;
  return fmt::format(
      "! timeout -k 5 {4} yosys-abc -q \"miter {0} {1}; strash; scleanup; lcorr; strash; "
      "write_aiger {5}/left.aig; bmc3 -T {2}; print_status\" > {5}/log 2>&1 || true\n"
      "! grep -q 'was asserted' {5}/log || timeout -k 5 {4} yosys-abc -q "
      "\"read_aiger {5}/left.aig; strash; pdr -T {3}; print_status\" >> {5}/log 2>&1 || true\n",
      original, mutant, kSearchSeconds, kProofSeconds, kMostSeconds, kOut);
}

/// For what is left then: an older search for equal registers, slower, that leaves fewer where there are
/// multipliers; then a proof on as little of the rest as it takes, with free inputs in place of what is cut
/// off. So a difference that is found here is none.
std::string abstraction_script(const std::string& original, const std::string& mutant) {
  constexpr int kAbstractionSeconds = 15, kProofSeconds = 20, kMostSeconds = 180;
  return fmt::format(
      "! timeout -k 5 {4} yosys-abc -q \"miter {0} {1}; strash; scleanup; lcorr -n; strash; "
      "&get; &gla -T {2}; &gla_derive; &put; scleanup; strash; pdr -T {3}; print_status\" "
      "2>&1 | sed '/ was asserted in frame /d' > {5}/log || true\n",
      original, mutant, kAbstractionSeconds, kProofSeconds, kMostSeconds, kOut);
}

/// What ABC's log says. Throws AreaError where it did not run.
Decision decision_of(const std::string& log) {
  if (const size_t at = log.find("timeout: failed"); at != std::string::npos) {
    throw AreaError("expected yosys-abc, as Yosys brings it: " +
                    log.substr(at, log.find('\n', at) - at));
  }
  Decision decision;
  if (log.find("Property proved") != std::string::npos ||
      log.find("Status = 1") != std::string::npos) {
    decision.proof = Proof::kEquivalent;
  }
  const std::string asserted = " was asserted in frame ";
  if (const size_t at = log.find(asserted); at != std::string::npos) {
    decision.proof = Proof::kDiffers;
    decision.cycles = std::atoi(log.c_str() + at + asserted.size()) + 1;
  }
  return decision;
}

}  // namespace

std::vector<Decision> decided(const std::string& unit, const MutantNetlist& netlist,
                              const std::vector<int>& mutants, const ToolRuns& runs) {
  if (mutants.empty()) return {};
  std::map<bool, Circuit> circuits;  // by whether products are free
  for (const bool is_cut : {true, false}) {
    const ToolRun mapping{"yosys", circuit_script(unit, netlist, runs, is_cut),
                          "mapping " + unit + " for the prover"};
    circuits.emplace(is_cut, runs.run({mapping}).front());
  }
  std::vector<Decision> decisions(mutants.size());
  for (const auto script : {cut_script, proof_script, abstraction_script}) {
    const Circuit& circuit = circuits.at(script == cut_script);
    const std::string original = runs.keep(circuit.with_mutant(0), ".aig");
    std::vector<size_t> open;
    std::vector<ToolRun> proofs;
    for (size_t i = 0; i < mutants.size(); ++i) {
      if (decisions[i].proof != Proof::kUndecided) continue;
      const std::string file = runs.keep(circuit.with_mutant(mutants[i]), ".aig");
      open.push_back(i);
      proofs.push_back({"yosys", script(original, file),
                        fmt::format("proving mutant {} of {}", mutants[i], unit)});
    }
    const std::vector<fs::path> folders = runs.run(proofs);
    for (size_t k = 0; k < open.size(); ++k) {
      decisions[open[k]] = decision_of(text_of(folders[k] / "log"));
    }
  }
  return decisions;
}

}  // namespace pineda::studies
