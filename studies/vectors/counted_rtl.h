// Cases run on RTL that counts its lines and bits.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "studies/vectors/benches.h"
#include "studies/vectors/code_points.h"
#include "tb/plugin_cache.h"

namespace pineda::vectors {

/// The SystemVerilog module of a unit.
const char* module_of(Unit unit);

/// Adds the counts of one unit: write(FILE) writes them to a file that is read and removed.
void add_counts(const std::function<bool(const std::string&)>& write, CodeCounts* counts);

/// One unit of a design, built with counters the first time.
///
/// Errors   tb::PluginError: it cannot be had.
template <class Case>
class CountedRtl {
 public:
  CountedRtl(const spec::Contract& contract, const tb::BenchOptions& options,
             const std::function<void(const std::string&)>& say)
      : library_(contract, tb::cached_coverage_plugin(contract, module_of(Case::kUnit), say)),
        runner_(library_, options) {}

  /// The first difference from what the case expects.
  std::optional<std::string> difference(const Case& value) { return runner_.difference(value); }
  /// Of the cases so far, none of which broke the RTL.
  void add_to(CodeCounts* counts) const {
    add_counts([&](const std::string& file) { return runner_.write_coverage(file); }, counts);
  }

 private:
  tb::RtlLibrary library_;
  RtlRunner<Case> runner_;
};

}  // namespace pineda::vectors
