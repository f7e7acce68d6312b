// pineda vectors: makes test vectors, says what a file holds, runs it on the model or on the RTL.
#include <memory>

#include "cli/models.h"
#include "cli/output.h"
#include "cli/reserved_file.h"
#include "model/spec/package.h"
#include "studies/vectors/benches.h"
#include "tb/unit_bench.h"
#include "vectors/generator/generate.h"

namespace pineda::cli {
namespace {

using vectors::Unit;

enum class Side { kModel, kRtl };
inline constexpr spec::Name<Side> kSideNames[] = {{Side::kModel, "model"}, {Side::kRtl, "rtl"}};
constexpr const auto& names(Side) { return kSideNames; }

struct VectorOptions : Options {
  std::string file;
  std::string unit;
  int level = 1;
  std::string on = spec::name_of(Side::kRtl);
};

/// Calls work(Case{}) with the case of a unit.
template <class Work>
auto with_case(Unit unit, Work&& work) {
  switch (unit) {
    case Unit::kSetup:
      return work(vectors::SetupCase{});
    case Unit::kTraversal:
      return work(vectors::TraversalCase{});
    case Unit::kInterpZtest:
      return work(vectors::InterpZtestCase{});
    case Unit::kFrame:
      break;
  }
  return work(vectors::FrameCase{});
}

Json header_json(const VectorOptions& options, const vectors::Header& header) {
  return {{"file", options.file},
          {"unit", spec::name_of(header.unit)},
          {"design", header.contract.design.name},
          {"level", header.level},
          {"seed", header.seed},
          {"formats", fmt::format("{:016x}", spec::formats_hash(header.contract))}};
}

int generate(const VectorOptions& options) {
  const Output output(options);
  const spec::Contract contract = contract_of(options);
  require_of(options, contract.design, spec::no_rtl_reason);
  const Unit unit = *spec::named<Unit>(options.unit);
  const vectors::Tally tally =
      vectors::generate_file(unit, contract, options.level, options.seed,
                             spec::error_bounds(contract.design), options.file);
  vectors::Header header{unit, contract, options.level, options.seed, tally.cases};
  Json json = header_json(options, header);
  json["cases"] = tally.cases;
  json["empty"] = tally.empty;
  json["large"] = tally.large;
  output.line("{}: {} cases of {}, {}", options.file, grouped(tally.cases), options.unit,
              contract.design.name);
  output.row("left out", fmt::format("{} scenes that reach the unit with nothing, {} too large",
                                     grouped(tally.empty), grouped(tally.large)));
  output.json(json);
  return kHolds;
}

/// What is in a case of each unit, in words and in JSON.
std::map<std::string, size_t> counts(const vectors::SetupCase& c) {
  return {{"triangles", c.in.size()}, {"setup_prims", c.out.size()}};
}
std::map<std::string, size_t> counts(const vectors::TraversalCase& c) {
  return {{"setup_prims", c.in.size()}, {"stamps", c.out.size()}};
}
std::map<std::string, size_t> counts(const vectors::InterpZtestCase& c) {
  return {
      {"stamps", c.in.size()}, {"depth_writes", c.depth.size()}, {"color_writes", c.color.size()}};
}
std::map<std::string, size_t> counts(const vectors::FrameCase& c) {
  return {{"triangles", c.in.size()}, {"samples", c.buffer.hits.size()}};
}

int info(const VectorOptions& options) {
  const Output output(options);
  const vectors::Header header = vectors::read_header(options.file);
  Json json = header_json(options, header);
  with_case(header.unit, [&](auto kind) {
    using Case = decltype(kind);
    const auto file = vectors::read<Case>(options.file);
    std::map<std::string, size_t> tokens;
    std::map<std::string, size_t> classes;
    int width = 0, height = 0;
    for (const Case& c : file.cases) {
      for (const auto& [name, count] : counts(c)) tokens[name] += count;
      ++classes[c.name.substr(0, c.name.rfind('.'))];
      width = std::max(width, c.frame.width);
      height = std::max(height, c.frame.height);
    }
    json["cases"] = file.cases.size();
    json["tokens"] = tokens;
    json["greatest_frame"] = {{"width", width}, {"height", height}};
    json["classes"] = classes;
    output.line("{}: {} cases of {}, {}, level {}, seed {}", options.file,
                grouped(file.cases.size()), spec::name_of(header.unit), header.contract.design.name,
                header.level, header.seed);
    for (const auto& [name, count] : tokens) output.row(name, grouped(count));
    output.row("greatest frame", fmt::format("{}x{}", width, height));
    output.line("\n{:<24}{:>8}", "class", "cases");
    for (const auto& [name, count] : classes) output.line("{:<24}{:>8}", name, count);
  });
  output.json(json);
  return kHolds;
}

template <class Case>
struct BenchOf;
template <>
struct BenchOf<vectors::SetupCase> {
  using Type = tb::SetupBench;
};
template <>
struct BenchOf<vectors::TraversalCase> {
  using Type = tb::TraversalBench;
};
template <>
struct BenchOf<vectors::InterpZtestCase> {
  using Type = tb::InterpZtestBench;
};
template <>
struct BenchOf<vectors::FrameCase> {
  using Type = tb::FrameBench;
};

/// The first difference, and how many cases have one.
struct Mismatches {
  size_t cases = 0;
  std::string first;

  void add(const std::optional<std::string>& difference) {
    if (!difference) return;
    if (cases++ == 0) first = *difference;
  }
};

template <class Case>
Mismatches run_on(Side side, const vectors::File<Case>& file, const VectorOptions& options,
                  const Output& output, Progress* progress) {
  Mismatches mismatches;
  uint64_t done = 0;
  const auto judge = [&](const Case& expected, const Case& got) {
    mismatches.add(vectors::difference(file.contract, expected, got));
    progress->update("running", ++done);
  };
  if (side == Side::kModel) {
    for (const Case& c : file.cases) judge(c, vectors::run_model(file.contract, c));
    return mismatches;
  }
  const tb::RtlLibrary library(file.contract, [&](const std::string& text) { output.say(text); });
  typename BenchOf<Case>::Type bench(library, bench_options(options, file.contract));
  for (const Case& c : file.cases) judge(c, vectors::run(&bench, c));
  return mismatches;
}

int run(const VectorOptions& options) {
  const Output output(options);
  Progress progress(options);
  const Side side = *spec::named<Side>(options.on);
  const vectors::Header header = vectors::read_header(options.file);
  Json json = header_json(options, header);
  Mismatches mismatches;
  with_case(header.unit, [&](auto kind) {
    const auto file = vectors::read<decltype(kind)>(options.file);
    json["cases"] = file.cases.size();
    mismatches = run_on(side, file, options, output, &progress);
    progress.clear();
    output.line("{}: {} cases of {}, {}, on the {}", options.file, grouped(file.cases.size()),
                spec::name_of(header.unit), header.contract.design.name, options.on);
  });
  const bool holds = mismatches.cases == 0;
  output.row("mismatches", fmt::format("{} cases", grouped(mismatches.cases)));
  if (!holds) output.row("first", mismatches.first);
  output.line("{}", holds ? "It holds." : "IT DOES NOT HOLD.");
  json["on"] = options.on;
  json["stall"] = options.stall;
  json["mismatches"] = mismatches.cases;
  if (!holds) json["first"] = mismatches.first;
  json["holds"] = holds;
  output.json(json);
  return holds ? kHolds : kMismatch;
}

/// Adds a command that does `work`; the options that all have in common.
std::pair<CLI::App*, std::shared_ptr<VectorOptions>> add(CLI::App* parent, const char* name,
                                                         const char* what,
                                                         int (*work)(const VectorOptions&),
                                                         int* exit_code) {
  auto options = std::make_shared<VectorOptions>();
  auto* command = parent->add_subcommand(name, what);
  add_output_options(command, options.get());
  command->callback([options, work, exit_code] {
    try {
      *exit_code = work(*options);
    } catch (const vectors::Refused& error) {
      throw UsageError(error.what());
    }
  });
  return {command, options};
}

void add_generate(CLI::App* parent, int* exit_code) {
  const auto [command, options] =
      add(parent, "generate", "Makes a file, judged by exact arithmetic", generate, exit_code);
  command->add_option("--unit", options->unit, "The unit: " + spec::alternatives<Unit>())
      ->required()
      ->check(CLI::IsMember(spec::word_list<Unit>()))
      ->type_name("UNIT");
  command->add_option("--design", options->design, "Design point, or a design file")
      ->type_name("NAME|FILE.toml")
      ->capture_default_str();
  command->add_option("--level", options->level, "1: what is committed; 2: eight times the scenes")
      ->check(CLI::Range(1, vectors::kMaxLevel))
      ->type_name("L")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Of the random numbers")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("-o,--out", options->file, "The file")->required()->type_name("FILE");
}

void add_info(CLI::App* parent, int* exit_code) {
  const auto [command, options] =
      add(parent, "info", "What a file holds, once it is read whole", info, exit_code);
  command->add_option("FILE", options->file, "The file")->required()->type_name("");
}

void add_run(CLI::App* parent, int* exit_code) {
  const auto [command, options] =
      add(parent, "run", "Runs each case and compares every bit that comes out", run, exit_code);
  command->add_option("FILE", options->file, "The file")->required()->type_name("");
  command->add_option("--on", options->on, "Who runs it: " + spec::alternatives<Side>())
      ->check(CLI::IsMember(spec::word_list<Side>()))
      ->type_name("SIDE")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Of the stalls")
      ->type_name("N")
      ->capture_default_str();
  add_time_options(command, options.get());
}

}  // namespace

void add_vectors(CLI::App* program, int* exit_code) {
  auto* command =
      program->add_subcommand("vectors", "Test vectors: what goes in, which bits come out");
  command->require_subcommand(1);
  add_generate(command, exit_code);
  add_info(command, exit_code);
  add_run(command, exit_code);
}

}  // namespace pineda::cli
