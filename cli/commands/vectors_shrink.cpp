// pineda vectors shrink: the smallest case that still fails.
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "cli/commands/vectors.h"
#include "cli/models.h"
#include "studies/vectors/benches.h"
#include "tb/scoreboard.h"
#include "vectors/runner/shrink.h"

namespace pineda::cli {
namespace {

/// A shell's command with a file's name in it.
class Command {
 public:
  Command(const std::string& command, const std::string& file) : command_(command) {
    const size_t at = command_.find("{}");
    if (at == std::string::npos) {
      throw UsageError(
          fmt::format("--run: expected a command with {{}} for the file, got '{}'", command));
    }
    std::string quoted = "'";
    for (const char c : file) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    command_.replace(at, 2, quoted + "'");
  }

  /// Does it exit with anything but 0? Throws UsageError where it cannot be run.
  bool fails() const {
    constexpr int kNotExecutable = 126, kNotFound = 127;
    const int status = std::system(command_.c_str());
    if (WIFEXITED(status) &&
        (WEXITSTATUS(status) == kNotExecutable || WEXITSTATUS(status) == kNotFound)) {
      throw UsageError(fmt::format("--run: expected a command that runs, got '{}'", command_));
    }
    return status != 0;
  }

 private:
  std::string command_;
};

std::string default_result(const std::string& file) {
  const std::filesystem::path path(file);
  return (path.parent_path() / (path.stem().string() + "_shrunk" + path.extension().string()))
      .string();
}

/// What failed, and with which case.
template <class Case>
struct Failure {
  Case value;
  std::string what;
};

template <class Case>
class Shrinking {
 public:
  Shrinking(const VectorOptions& options, const Output& output)
      : options_(options),
        output_(output),
        progress_(options),
        reader_(options.file),
        contract_(reader_.header().contract),
        result_(options.result.empty() ? default_result(options.file) : options.result) {}

  int run() {
    if (options_.command.empty()) {
      library_ = std::make_unique<tb::RtlLibrary>(
          contract_, [&](const std::string& text) { output_.say(text); });
      runner_.emplace(*library_, bench_options(options_, contract_));
    }
    std::optional<Failure<Case>> failure = next_failure();
    Json json = header_json(options_, reader_.header());
    json["fails"] = failure.has_value();
    if (!failure) {
      progress_.clear();
      output_.line("{}: no case fails", options_.file);
      output_.json(json);
      return kHolds;
    }
    const Case small = smallest(&*failure);
    write(small, result_);
    const std::optional<std::string> alone = failure_of(small);
    const std::string what = alone.value_or(failure->what);
    progress_.clear();
    output_.line("{}: case {}, {} of {} inputs, {}x{} px", result_, small.name, small.in.size(),
                 failure->value.in.size(), small.frame.width, small.frame.height);
    output_.row("fails", what);
    if (!alone) output_.row("", "only after the cases before it, so nothing is left out");
    output_.row("tried", fmt::format("{} cases", grouped(tried_)));
    json["case"] = small.name;
    json["result"] = result_;
    json["inputs"] = {{"before", failure->value.in.size()}, {"after", small.in.size()}};
    json["frame"] = {{"width", small.frame.width}, {"height", small.frame.height}};
    json["what"] = what;
    json["fails_alone"] = alone.has_value();
    json["tried"] = tried_;
    look_closer(small, &json);
    output_.json(json);
    return kMismatch;
  }

 private:
  // The first case that fails, made small; on our RTL also a later one, where that leaves fewer inputs.
  Case smallest(Failure<Case>* failure) {
    constexpr size_t kFewInputs = 3;
    constexpr int kCases = 8;
    Case small = shrunk(*failure);
    for (int i = 1; runner_ && i < kCases && small.in.size() > kFewInputs; ++i) {
      const auto later = next_failure();
      if (!later) break;
      const Case other = shrunk(*later);
      if (other.in.size() >= small.in.size()) continue;
      small = other;
      *failure = *later;
    }
    return small;
  }

  Case shrunk(const Failure<Case>& failure) {
    const std::string kind = vectors::kind_of(failure.what);
    return vectors::shrunk<Case>(contract_, failure.value, [&](const Case& candidate) {
      progress_.update("trying", ++tried_);
      const auto what = failure_of(candidate);
      return what && vectors::kind_of(*what) == kind;
    });
  }

  std::optional<Failure<Case>> next_failure() {
    for (Case c; reader_.next(&c);) {
      progress_.update("looking", ++looked_);
      if (const auto what = failure_of(c)) return Failure<Case>{c, *what};
    }
    return std::nullopt;
  }

  // What fails, or nothing. Of a command only that it does is known.
  std::optional<std::string> failure_of(const Case& value) {
    if (runner_) {
      const memory::Stalls asked(stall_mode_of(options_), options_.seed);
      return runner_->difference(value, asked.any() ? std::optional(asked) : std::nullopt);
    }
    const std::string file = result_ + ".trial";
    const files::Unfinished trial(file);
    write(value, file);
    const bool fails = Command(options_.command, file).fails();
    std::filesystem::remove(file);
    return fails ? std::optional<std::string>("the command") : std::nullopt;
  }

  void write(const Case& value, const std::string& file) {
    const vectors::Header& h = reader_.header();
    vectors::write(file, vectors::File<Case>{h.contract, h.level, h.seed, {value}});
  }

  // Of a frame on our RTL: the first unit, field and cycle that differ, and a waveform around it.
  void look_closer(const vectors::FrameCase& value, Json* json) {
    if (!runner_) return;
    const Difference first = first_difference(value);
    if (!first.what.empty()) output_.row("first", first.what);
    (*json)["first"] = first.what;
    constexpr tb::Cycle kBefore = 40, kAfter = 8;
    std::filesystem::path waveform{result_};
    waveform.replace_extension(".fst");
    tb::CloseUp window{std::max<tb::Cycle>(first.cycle - kBefore, 0), first.cycle,
                       first.cycle + kAfter, waveform.string()};
    if (first.is_before) window = {0, first.cycle, first.cycle + 1, window.trace};
    try {
      tb::FrameBench bench(*library_, bench_of(value));
      if (first.is_before && !bench.trace(window.trace)) {
        throw UsageError(fmt::format("{}: cannot be written", window.trace));
      }
      vectors::begin(&bench, value);
      bench.run_close_up(value.frame, vectors::each_of(value.in), nullptr, window);
    } catch (const tb::RtlError& error) {
      // What ended the frame before ends it again: the waveform goes as far.
      if (error.what() != first.what) throw;
    }
    output_.row("waveform",
                fmt::format("{}, cycles {} to {}", window.trace, window.from, window.until - 1));
    (*json)["cycle"] = first.cycle;
    (*json)["waveform"] = {{"file", window.trace}, {"from", window.from}, {"until", window.until}};
  }
  template <class Other>
  void look_closer(const Other&, Json*) {}

  /// Where a frame differs first.
  struct Difference {
    std::string what;  // empty: in memories or counters alone
    tb::Cycle cycle;   // of what never comes, that of the last handshake
    bool is_before;    // in the frame that is begun and reset before it
  };
  Difference first_difference(const vectors::FrameCase& value) {
    tb::Scoreboard scoreboard("RTL", contract_, value.frame, vectors::each_of(value.in));
    tb::FrameBench bench(*library_, bench_of(value));
    bool is_before = true;
    try {
      vectors::begin(&bench, value);
      is_before = false;
      bench.run(value.frame, vectors::each_of(value.in), &scoreboard);
      scoreboard.finish();
      return {scoreboard.first_divergence(), scoreboard.first_cycle().value_or(bench.last_moved()),
              false};
    } catch (const tb::RtlError& error) {
      return {error.what(), bench.last_moved(), is_before};
    }
  }

  tb::BenchOptions bench_of(const vectors::FrameCase& value) const {
    tb::BenchOptions bench = bench_options(options_, contract_);
    if (stall_mode_of(options_) == memory::StallMode::kNone) {
      bench.stall_mode = value.ports.mode;
      bench.seed = value.ports.seed;
    }
    return bench;
  }

  const VectorOptions& options_;
  const Output& output_;
  Progress progress_;
  vectors::Reader<Case> reader_;
  spec::Contract contract_;
  std::string result_;
  std::unique_ptr<tb::RtlLibrary> library_;
  std::optional<vectors::RtlRunner<Case>> runner_;  // none: the command
  uint64_t looked_ = 0, tried_ = 0;
};

}  // namespace

int shrink_vectors(const VectorOptions& options) {
  const Output output(options);
  return with_case(vectors::read_header(options.file).unit,
                   [&](auto kind) { return Shrinking<decltype(kind)>(options, output).run(); });
}

}  // namespace pineda::cli
