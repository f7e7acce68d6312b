// Vectors run on RTL that counts its lines and bits.
#pragma once

#include "cli/commands/vectors.h"
#include "cli/models.h"
#include "cli/report/code_coverage.h"
#include "studies/vectors/counted_rtl.h"
#include "vectors/generator/generate.h"

namespace pineda::cli {

struct CoverageOptions : VectorOptions {
  std::vector<std::string> units;  // none: all
  std::vector<std::string> files;  // none: the cases of the level
  std::string folder;
  std::string waivers = default_code_waivers();
};

/// Runs cases unit by unit: those of the files, or of the level.
class CoverageRun {
 public:
  /// Errors   UsageError: files of several designs; vectors::Refused.
  CoverageRun(const CoverageOptions& options, const Output& output);

  const spec::Contract& contract() const { return contract_; }
  const std::vector<vectors::Unit>& units() const { return units_; }
  const vectors::CodeCounts& counts() const { return counts_; }
  uint64_t cases() const { return cases_; }

  /// Calls see(case) for each case of each unit, which holds on the RTL.
  ///
  /// Errors   tb::RtlError: a case that does not hold.
  template <class See>
  void run(See&& see) {
    for (const vectors::Unit unit : units_) {
      with_case(unit, [&](auto kind) { run_unit<decltype(kind)>(see); });
    }
    progress_.clear();
  }

 private:
  template <class Case, class See>
  void run_unit(See& see) {
    vectors::CountedRtl<Case> rtl(contract_, bench_options(options_, contract_),
                                  [&](const std::string& text) { output_.say(text); });
    const auto visit = [&](const Case& value) {
      if (const auto difference = rtl.difference(value)) throw tb::RtlError(*difference);
      see(value);
      progress_.update(spec::name_of(Case::kUnit), ++cases_);
    };
    if (options_.files.empty()) {
      vectors::for_each_case<Case>(contract_, {options_.level, options_.seed, std::nullopt},
                                   spec::error_bounds(contract_.design), visit);
    }
    for (const std::string& file : options_.files) {
      if (vectors::read_header(file).unit != Case::kUnit) continue;
      vectors::Reader<Case> reader(file);
      for (Case c; reader.next(&c);) visit(c);
    }
    rtl.add_to(&counts_);
  }

  const CoverageOptions& options_;
  const Output& output_;
  Progress progress_;
  spec::Contract contract_;
  std::vector<vectors::Unit> units_;
  vectors::CodeCounts counts_;
  uint64_t cases_ = 0;
};

/// "setup, traversal".
std::string unit_names(const std::vector<vectors::Unit>& units);

/// --design, --unit, --level, --seed, --waivers.
void add_coverage_options(CLI::App* command, CoverageOptions* options);

}  // namespace pineda::cli
