// Cases run through the Verilated RTL of their design.
#pragma once

#include <optional>
#include <string>

#include "tb/unit_bench.h"
#include "vectors/grammar/cases.h"

namespace pineda::vectors {

/// What a bench makes of a case's inputs: the same case with the outputs of the RTL. It does not tell
/// the cause of a drop, so the expected causes are kept.
///
/// Errors   tb::RtlError: a failed assertion, an unstable payload, a deadlock.
SetupCase run(tb::SetupBench* bench, const SetupCase& inputs);
TraversalCase run(tb::TraversalBench* bench, const TraversalCase& inputs);
InterpZtestCase run(tb::InterpZtestBench* bench, const InterpZtestCase& inputs);
FrameCase run(tb::FrameBench* bench, const FrameCase& inputs);

/// Triangles one by one; they must stay.
tb::NextTriangle each_of(const std::vector<spec::Triangle>& triangles);

/// A frame that is reset on the way is begun and reset; another is not touched.
void begin(tb::FrameBench* bench, const FrameCase& inputs);

/// The bench of a unit.
template <class Case>
struct BenchOf;
template <>
struct BenchOf<SetupCase> {
  using Type = tb::SetupBench;
};
template <>
struct BenchOf<TraversalCase> {
  using Type = tb::TraversalBench;
};
template <>
struct BenchOf<InterpZtestCase> {
  using Type = tb::InterpZtestBench;
};
template <>
struct BenchOf<FrameCase> {
  using Type = tb::FrameBench;
};

/// Runs cases on the RTL, one after the other, also after one that breaks it.
template <class Case>
class RtlRunner {
 public:
  RtlRunner(const tb::RtlLibrary& library, const tb::BenchOptions& options)
      : library_(library), options_(options) {}

  /// The first difference from what the case expects, or what the RTL failed at. Ports stall as the case
  /// says, or as `stalls` does.
  std::optional<std::string> difference(const Case& expected,
                                        const std::optional<memory::Stalls>& stalls = {}) {
    if (!bench_) bench_.emplace(library_, options_);
    bench_->set_stalls(stalls ? *stalls : expected.ports.stalls());
    try {
      auto what = vectors::difference(library_.contract(), expected, run(&*bench_, expected));
      if (what) bench_.reset();  // what is wrong in it must not meet the next case
      return what;
    } catch (const tb::RtlError& error) {
      bench_.reset();
      return std::string(spec::name_of(Case::kUnit)) + " case " + expected.name + ": " +
             error.what();
    }
  }

  /// Verilator's coverage of the cases so far; false where a case broke the RTL or it is not counted.
  bool write_coverage(const std::string& file) const {
    return bench_ && bench_->write_coverage(file);
  }

 private:
  const tb::RtlLibrary& library_;
  tb::BenchOptions options_;
  std::optional<typename BenchOf<Case>::Type> bench_;
};

/// What the last frame of a bench left: the samples that are not as that frame is cleared.
std::vector<Sample> samples_of(const tb::FrameBench& bench, const spec::FrameState& frame);

}  // namespace pineda::vectors
