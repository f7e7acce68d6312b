#include "studies/score/kills.h"

#include <fmt/format.h>

#include <atomic>
#include <exception>
#include <future>
#include <thread>

#include "model/spec/difference.h"
#include "studies/area/area_error.h"
#include "studies/vectors/benches.h"

namespace pineda::studies {
namespace {

using Cycles = std::vector<timing::Cycle>;

/// The outputs of a case, and the cycles of all handshakes, counted from its start.
template <class Case>
struct Seen {
  Case got;
  std::vector<Cycles> outputs;  // of each stream
  Cycles inputs;
  timing::Cycle end = 0;

  void count_from(timing::Cycle start) {
    for (Cycles& stream : outputs) {
      for (timing::Cycle& cycle : stream) cycle -= start;
    }
    for (timing::Cycle& cycle : inputs) cycle -= start;
    end -= start;
  }
};

void see(tb::SetupBench* bench, Seen<vectors::SetupCase>* seen) {
  bench->set_frame(seen->got.frame);
  auto trace = bench->run(seen->got.in, &seen->inputs);
  seen->got.out = std::move(trace.tokens);
  seen->outputs = {std::move(trace.cycles)};
}
void see(tb::TraversalBench* bench, Seen<vectors::TraversalCase>* seen) {
  auto trace = bench->run(seen->got.in, &seen->inputs);
  seen->got.out = std::move(trace.tokens);
  seen->outputs = {std::move(trace.cycles)};
}
void see(tb::InterpZtestBench* bench, Seen<vectors::InterpZtestCase>* seen) {
  auto writes = bench->run(seen->got.frame, seen->got.in, &seen->inputs);
  seen->got.depth = std::move(writes.depth.tokens);
  seen->got.color = std::move(writes.color.tokens);
  seen->outputs = {std::move(writes.depth.cycles), std::move(writes.color.cycles)};
}

/// The cycle of the first token of a stream that differs; the end of the case if it is missing.
template <class Token>
std::optional<timing::Cycle> first_cycle(const spec::Comparer<Token>& comparer,
                                         const std::vector<Token>& expected,
                                         const std::vector<Token>& got, const Cycles& cycles,
                                         timing::Cycle end) {
  for (size_t i = 0; i < std::max(expected.size(), got.size()); ++i) {
    if (i >= got.size()) return end;
    if (i >= expected.size() || comparer.difference(expected[i], got[i])) return cycles[i];
  }
  return std::nullopt;
}

/// Ports stall as the case says, not as the bench is told.
tb::BenchOptions options_of(const spec::Design& design) {
  tb::BenchOptions options;
  options.depth_latency_cycles = design.depth_latency_cycles;
  return options;
}

/// One mutant on its bench.
template <class Case>
class Patient {
 public:
  Patient(const tb::RtlLibrary& library, int mutant)
      : contract_(library.contract()), bench_(library, options_of(contract_.design)) {
    const auto number = static_cast<uint16_t>(mutant);
    std::memcpy(bench_.unit().port("mutant_i").data, &number, sizeof number);
    bench_.unit().reset();
  }

  Seen<Case> see_case(const Case& inputs, timing::Cycle limit) {
    Seen<Case> seen;
    seen.got = inputs;
    bench_.set_stalls(inputs.ports.stalls());
    bench_.set_cycle_limit(limit);
    start_ = cycle();
    see(&bench_, &seen);
    seen.end = cycle();
    seen.count_from(start_);
    return seen;
  }
  /// Begins a case and resets the unit in that cycle of it, if it gets so far.
  void reset_at_work(const Case& inputs, timing::Cycle cycle) {
    try {
      see_case(inputs, cycle);
    } catch (const tb::RtlError&) {
      // The limit, or what kills the mutant in the case as well.
    }
    bench_.reset();
  }
  /// Since the last case began.
  timing::Cycle cycle_of_case() { return cycle() - start_; }

 private:
  timing::Cycle cycle() { return bench_.unit().cycle(); }

  const spec::Contract& contract_;
  typename vectors::BenchOf<Case>::Type bench_;
  timing::Cycle start_ = 0;
};

/// Where the bits of a case differ first, in words and as a cycle.
template <class Case, class... Streams>
std::optional<Sight> death_of(const spec::Contract& contract, const Case& expected,
                              const Seen<Case>& seen, Streams... streams) {
  const auto text = vectors::difference(contract, expected, seen.got);
  if (!text) return std::nullopt;
  Sight sight{true, false, expected.name, text->substr(text->find(": ") + 2), seen.end};
  size_t i = 0;
  const auto look = [&](auto stream) {
    using Token = typename std::decay_t<decltype(expected.*stream)>::value_type;
    const auto cycle = first_cycle(spec::Comparer<Token>(contract), expected.*stream,
                                   seen.got.*stream, seen.outputs[i++], seen.end);
    if (cycle) sight.cycle = std::min(sight.cycle, *cycle);
  };
  (look(streams), ...);
  return sight;
}
std::optional<Sight> death(const spec::Contract& c, const vectors::SetupCase& expected,
                           const Seen<vectors::SetupCase>& seen) {
  return death_of(c, expected, seen, &vectors::SetupCase::out);
}
std::optional<Sight> death(const spec::Contract& c, const vectors::TraversalCase& expected,
                           const Seen<vectors::TraversalCase>& seen) {
  return death_of(c, expected, seen, &vectors::TraversalCase::out);
}
std::optional<Sight> death(const spec::Contract& c, const vectors::InterpZtestCase& expected,
                           const Seen<vectors::InterpZtestCase>& seen) {
  return death_of(c, expected, seen, &vectors::InterpZtestCase::depth,
                  &vectors::InterpZtestCase::color);
}

/// When the original does what it does in a case.
struct Times {
  std::vector<Cycles> outputs;
  Cycles inputs;
  timing::Cycle end = 0;

  /// The first cycle in which another one did something else.
  template <class Case>
  std::optional<timing::Cycle> difference(const Seen<Case>& seen) const {
    std::optional<timing::Cycle> first;
    const auto compare = [&](const Cycles& a, const Cycles& b) {
      const size_t common = std::min(a.size(), b.size());
      for (size_t i = 0; i < common; ++i) {
        if (a[i] == b[i]) continue;
        first = std::min({first.value_or(a[i]), a[i], b[i]});
        return;
      }
    };
    for (size_t i = 0; i < outputs.size(); ++i) compare(outputs[i], seen.outputs[i]);
    compare(inputs, seen.inputs);
    if (!first && end != seen.end) first = std::min(end, seen.end);
    return first;
  }
};

/// Each of the first cases is begun and reset at work, later each time, before it is seen.
template <class Case>
Seen<Case> see_case(Patient<Case>* patient, const std::vector<Case>& cases, size_t i,
                    timing::Cycle limit) {
  constexpr size_t kResets = 16;
  constexpr timing::Cycle kLater = 7;
  if (i < kResets) patient->reset_at_work(cases[i], kLater * (i + 1));
  return patient->see_case(cases[i], limit);
}

template <class Case>
std::vector<Times> times_of(const tb::RtlLibrary& library, const std::vector<Case>& cases) {
  std::vector<Times> times;
  Patient<Case> original(library, 0);
  for (size_t i = 0; i < cases.size(); ++i) {
    const Case& one = cases[i];
    try {
      Seen<Case> seen = see_case(&original, cases, i, tb::kNoCycleLimit);
      if (const auto sight = death(library.contract(), one, seen)) {
        throw AreaError(fmt::format("the RTL without a mutant: {}: {}", one.name, sight->what));
      }
      times.push_back({std::move(seen.outputs), std::move(seen.inputs), seen.end});
    } catch (const tb::RtlError& error) {
      throw AreaError(fmt::format("the RTL without a mutant: {}: {}", one.name, error.what()));
    }
  }
  return times;
}

template <class Case>
Sight sight_of(const tb::RtlLibrary& library, const std::vector<Case>& cases,
               const std::vector<Times>& times, int mutant) {
  // A mutant that hangs dies once it takes so long, against the original. Others are late by stalls
  // that now meet other tokens.
  constexpr timing::Cycle kTimes = 4, kMore = 4000;
  Sight late;
  Patient<Case> patient(library, mutant);
  for (size_t i = 0; i < cases.size(); ++i) {
    try {
      const Seen<Case> seen = see_case(&patient, cases, i, kTimes * times[i].end + kMore);
      if (const auto sight = death(library.contract(), cases[i], seen)) return *sight;
      if (late.is_late) continue;
      if (const auto cycle = times[i].difference(seen)) {
        late = {false, true, cases[i].name, "a handshake in another cycle", *cycle};
      }
    } catch (const tb::RtlError& error) {
      return {true, false, cases[i].name, error.what(), patient.cycle_of_case()};
    }
  }
  return late;
}

}  // namespace

template <class Case>
std::vector<Sight> sights_of(const tb::RtlLibrary& library, const std::vector<Case>& cases,
                             const std::vector<int>& mutants,
                             const std::function<void(size_t)>& done) {
  const std::vector<Times> times = times_of(library, cases);
  std::vector<Sight> sights(mutants.size());
  std::atomic<size_t> next{0}, finished{0};
  const auto work = [&] {
    for (size_t i = next++; i < mutants.size(); i = next++) {
      sights[i] = sight_of(library, cases, times, mutants[i]);
      done(++finished);
    }
  };
  std::vector<std::future<void>> workers;
  for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i) {
    workers.push_back(std::async(std::launch::async, work));
  }
  for (auto& worker : workers) worker.get();
  return sights;
}

template std::vector<Sight> sights_of(const tb::RtlLibrary&, const std::vector<vectors::SetupCase>&,
                                      const std::vector<int>&, const std::function<void(size_t)>&);
template std::vector<Sight> sights_of(const tb::RtlLibrary&,
                                      const std::vector<vectors::TraversalCase>&,
                                      const std::vector<int>&, const std::function<void(size_t)>&);
template std::vector<Sight> sights_of(const tb::RtlLibrary&,
                                      const std::vector<vectors::InterpZtestCase>&,
                                      const std::vector<int>&, const std::function<void(size_t)>&);

}  // namespace pineda::studies
