// pineda vectors: makes test vectors, says what a file holds, runs it on the model or on the RTL.
#include "cli/commands/vectors.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "cli/models.h"
#include "studies/portable/portable_file.h"
#include "studies/vectors/benches.h"
#include "studies/vectors/timed_coverage.h"
#include "vectors/coverage/coverage.h"
#include "vectors/generator/generate.h"

namespace pineda::cli {
namespace {

using vectors::Unit;

enum class Side { kModel, kRtl };
inline constexpr spec::Name<Side> kSideNames[] = {{Side::kModel, "model"}, {Side::kRtl, "rtl"}};
constexpr const auto& names(Side) { return kSideNames; }

int generate(const VectorOptions& options) {
  const Output output(options);
  const spec::Contract contract = contract_of(options);
  require_of(options, contract.design, spec::no_rtl_reason);
  const Unit unit = *spec::named<Unit>(options.unit);
  const vectors::Tally tally =
      vectors::generate_file(unit, contract, {options.level, options.seed, options.count},
                             spec::error_bounds(contract.design), options.file);
  Json json = header_json(options, {unit, contract, options.level, options.seed});
  json["cases"] = tally.cases;
  json["empty"] = tally.empty;
  json["large"] = tally.large;
  if (!options.count) json["missed"] = tally.missed;
  output.line("{}: {} cases of {}, {}", options.file, grouped(tally.cases), options.unit,
              contract.design.name);
  output.row("left out", fmt::format("{} scenes that reach the unit with nothing, {} too large",
                                     grouped(tally.empty), grouped(tally.large)));
  if (!options.count) {
    output.row("missed", tally.missed == 0 ? std::string("no bin of the coverage")
                                           : fmt::format("{} bins of the coverage; info names them",
                                                         grouped(tally.missed)));
  }
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
  return {{"triangles", c.in.size()}, {"samples", c.samples.size()}};
}

/// The points with their bins hit, and the bins that are not, as text; all of it in JSON.
Json coverage_of(const std::vector<vectors::PointHits>& points, const Output& output) {
  const size_t bins = vectors::reachable_bins(points), hit_bins = vectors::hit_bins(points);
  Json json{{"bins", bins}, {"hit", hit_bins}};
  output.line("\n{:<24}{:>8}{:>8}", "coverage", "bins", "hit");
  std::vector<std::string> missed;
  for (const vectors::PointHits& point : points) {
    size_t reachable = 0, hit = 0;
    Json counts = Json::object(), unreachable;
    for (size_t i = 0; i < point.bins.size(); ++i) {
      const vectors::Bin& bin = point.bins[i];
      if (!bin.unreachable.empty()) {
        unreachable[bin.name] = bin.unreachable;
        continue;
      }
      ++reachable;
      hit += point.count[i] > 0 ? 1 : 0;
      counts[bin.name] = point.count[i];
      if (point.count[i] == 0) missed.push_back(point.name + ": " + bin.name);
    }
    json["points"][point.name] = {{"what", point.what}, {"hits", counts}};
    if (!unreachable.empty()) json["points"][point.name]["unreachable"] = unreachable;
    output.line("{:<24}{:>8}{:>8}", point.name, reachable, hit);
  }
  output.line("{:<24}{:>8}{:>8}", "all", bins, hit_bins);
  for (const std::string& bin : vectors::contradictions(points)) output.warn(bin);
  if (!missed.empty()) output.line("\nnot hit");
  for (const std::string& bin : missed) output.line("  {}", bin);
  return json;
}

std::string not_timed_text(const vectors::WholeCoverage& coverage) {
  return fmt::format("{} frames of more than {} samples", grouped(coverage.not_timed()),
                     grouped(vectors::kTimedSamples));
}

int info(const VectorOptions& options) {
  if (studies::is_portable(options.file)) return portable_info(options);
  const Output output(options);
  Json json = with_case(vectors::read_header(options.file).unit, [&](auto kind) {
    using Case = decltype(kind);
    vectors::Reader<Case> reader(options.file);
    const vectors::Header& header = reader.header();
    std::map<std::string, size_t> tokens;
    std::map<std::string, size_t> classes;
    uint64_t cases = 0;
    int width = 0, height = 0;
    vectors::WholeCoverage coverage(header.unit, header.contract);
    for (Case c; reader.next(&c);) {
      ++cases;
      coverage.see(c);
      for (const auto& [name, count] : counts(c)) tokens[name] += count;
      ++classes[c.name.substr(0, c.name.rfind('.'))];
      width = std::max(width, c.frame.width);
      height = std::max(height, c.frame.height);
    }
    output.line("{}: {} cases of {}, {}, level {}, seed {}", options.file, grouped(cases),
                spec::name_of(header.unit), header.contract.design.name, header.level, header.seed);
    for (const auto& [name, count] : tokens) output.row(name, grouped(count));
    output.row("greatest frame", fmt::format("{}x{}", width, height));
    Json told = header_json(options, header);
    if (header.unit == vectors::Unit::kFrame) told["not_timed"] = coverage.not_timed();
    if (coverage.not_timed() > 0) output.row("not seen in time", not_timed_text(coverage));
    output.line("\n{:<24}{:>8}", "class", "cases");
    for (const auto& [name, count] : classes) output.line("{:<24}{:>8}", name, count);
    told["cases"] = cases;
    told["tokens"] = tokens;
    told["greatest_frame"] = {{"width", width}, {"height", height}};
    told["classes"] = classes;
    told["coverage"] = coverage_of(coverage.points(), output);
    return told;
  });
  output.json(json);
  return kHolds;
}

/// The first difference, and how many cases have one.
struct Mismatches {
  size_t cases = 0;
  std::string first;

  void add(const std::optional<std::string>& difference) {
    if (!difference) return;
    if (cases++ == 0) first = *difference;
  }
};

/// The cases of a file, each on one side; their number goes to *cases.
template <class Case>
Mismatches run_on(Side side, const VectorOptions& options, const Output& output, Progress* progress,
                  uint64_t* cases) {
  vectors::Reader<Case> reader(options.file);
  const spec::Contract& contract = reader.header().contract;
  Mismatches mismatches;
  if (side == Side::kModel) {
    for (Case c; reader.next(&c);) {
      mismatches.add(vectors::difference(contract, c, vectors::run_model(contract, c)));
      progress->update("running", ++*cases);
    }
    return mismatches;
  }
  const tb::RtlLibrary library(contract, [&](const std::string& text) { output.say(text); });
  vectors::RtlRunner<Case> runner(library, bench_options(options, contract));
  const memory::Stalls asked(stall_mode_of(options), options.seed);
  for (Case c; reader.next(&c);) {
    mismatches.add(runner.difference(c, asked.any() ? std::optional(asked) : std::nullopt));
    progress->update("running", ++*cases);
  }
  return mismatches;
}

int run(const VectorOptions& options) {
  const Output output(options);
  Progress progress(options);
  const Side side = *spec::named<Side>(options.on);
  const vectors::Header header = vectors::read_header(options.file);
  Json json = header_json(options, header);
  uint64_t cases = 0;
  const Mismatches mismatches = with_case(header.unit, [&](auto kind) {
    return run_on<decltype(kind)>(side, options, output, &progress, &cases);
  });
  progress.clear();
  output.line("{}: {} cases of {}, {}, on the {}", options.file, grouped(cases),
              spec::name_of(header.unit), header.contract.design.name, options.on);
  const bool holds = mismatches.cases == 0;
  output.row("mismatches", fmt::format("{} cases", grouped(mismatches.cases)));
  if (!holds) output.row("first", mismatches.first);
  output.line("{}", holds ? "It holds." : "IT DOES NOT HOLD.");
  json["cases"] = cases;
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
  add_output_options(command, options.get());
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
  command
      ->add_option("--count", options->count,
                   "So many cases: the level's first, then random ones; not given: the level's")
      ->check(CLI::Range(uint64_t{1}, uint64_t{1} << 40))
      ->type_name("K");
  command->add_option("-o,--out", options->file, "The file")->required()->type_name("FILE");
}

void add_info(CLI::App* parent, int* exit_code) {
  const auto [command, options] =
      add(parent, "info", "What a file holds, once it is read whole", info, exit_code);
  add_output_options(command, options.get());
  command->add_option("FILE", options->file, "The file")->required()->type_name("");
}

void add_run(CLI::App* parent, int* exit_code) {
  const auto [command, options] =
      add(parent, "run", "Runs each case and compares every bit that comes out", run, exit_code);
  add_output_options(command, options.get());
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

void add_shrink(CLI::App* parent, int* exit_code) {
  const auto [command, options] =
      add(parent, "shrink", "The first case that fails, as small as it still fails in the same way",
          shrink_vectors, exit_code);
  add_output_options(command, options.get());
  command->add_option("FILE", options->file, "The file")->required()->type_name("");
  command
      ->add_option("--run", options->command,
                   "A command, {} for the file's name, that exits non-zero where a case fails; "
                   "not given: our RTL")
      ->type_name("'COMMAND {}'");
  command->add_option("-o,--out", options->result, "The small file; default FILE_shrunk")
      ->type_name("FILE");
  command->add_option("--seed", options->seed, "Of the stalls")
      ->type_name("N")
      ->capture_default_str();
  add_time_options(command, options.get());
}

void add_score(CLI::App* parent, int* exit_code) {
  const auto [command, options] =
      add(parent, "score", "Mutants of the RTL: which vectors kill them, which are equivalent",
          score_vectors, exit_code);
  options->level = vectors::kMaxLevel;
  options->unit = "all";
  options->seed = 1;
  add_output_options(command, options.get());
  command
      ->add_option("FILES", options->files,
                   "Vectors in place of the levels, at most one file a unit")
      ->type_name("");
  command->add_option("--unit", options->unit, "The unit: setup, traversal, interp_ztest or all")
      ->check(CLI::IsMember({"setup", "traversal", "interp_ztest", "all"}))
      ->type_name("UNIT")
      ->capture_default_str();
  command->add_option("--design", options->design, "Design point, or a design file")
      ->type_name("NAME|FILE.toml")
      ->capture_default_str();
  command->add_option("--level", options->level, "The last level that is tried")
      ->check(CLI::Range(1, vectors::kMaxLevel))
      ->type_name("L")
      ->capture_default_str();
  command->add_option("--mutants", options->mutants, "Of all units together")
      ->check(CLI::Range(1, 60'000))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Of the choice of mutants")
      ->check(CLI::Range(0, 1'000'000'000))
      ->type_name("S")
      ->capture_default_str();
  command->add_flag("--all", options->all, "Print all mutants, not only those that live");
  command->add_flag("--no-proofs", options->no_proofs, "Leave what lives undecided");
}

void add_export(CLI::App* parent, int* exit_code) {
  const auto [command, options] =
      add(parent, "export", "The streams as memories for $readmemh, as tables or as JSON",
          export_vectors, exit_code);
  command->add_option("FILE", options->file, "The file")->required()->type_name("");
  auto* forms = command->add_option_group("form");
  const auto form = [&, chosen = &options->form](const char* name, const char* what) {
    return forms->add_flag_callback(
        "--" + std::string(name), [chosen, name] { *chosen = name; }, what);
  };
  form("readmemh", "A folder, a file a stream: a packed row a line; rows.hex, vectors.svh: sizes");
  form("csv", "A folder, a file a stream: a row a line");
  form("json", "A file: columns, and of each case the rows of its streams");
  auto* portable =
      form("portable", "Of frames: a file of cases for any rasterizer, for judge --portable");
  form("tri", "Of portable cases: a folder with a scene a case");
  forms->require_option(1);
  command->add_option("-o,--out", options->result, "The folder or file")
      ->required()
      ->type_name("PATH");
  command
      ->add_option("--depth-ulp", options->depth_ulp,
                   "With --portable: greatest error of a depth, codes; default: 1")
      ->check(CLI::Range(0., 4294967296.))
      ->needs(portable)
      ->type_name("E");
  command
      ->add_option("--color-lsb", options->color_lsb,
                   "With --portable: greatest error of a colour, of 255; default: 1")
      ->check(CLI::Range(0., 255.))
      ->needs(portable)
      ->type_name("E");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
}

}  // namespace

void add_vectors(CLI::App* program, int* exit_code) {
  auto* command =
      program->add_subcommand("vectors", "Test vectors: what goes in, which bits come out");
  command->require_subcommand(1);
  add_generate(command, exit_code);
  add_info(command, exit_code);
  add_run(command, exit_code);
  add_shrink(command, exit_code);
  add_score(command, exit_code);
  add_export(command, exit_code);
  add_coverage(command, exit_code);
  add_report(command, exit_code);
}

}  // namespace pineda::cli
