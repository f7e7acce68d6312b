// pineda vectors coverage: which lines of the RTL run and which bits change under vectors.
#include "cli/commands/vectors_coverage.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "cli/reserved_file.h"
#include "studies/area/tool_runs.h"
#include "tb/work_folder.h"

namespace pineda::cli {
namespace {

using vectors::Unit;

std::vector<Unit> units_of(const CoverageOptions& options) {
  std::vector<Unit> units;
  for (const auto& [unit, name] : vectors::kUnitNames) {
    const auto& asked = options.units;
    if (asked.empty() || std::find(asked.begin(), asked.end(), name) != asked.end()) {
      units.push_back(unit);
    }
  }
  return units;
}

/// The counts in Verilator's form and in lcov's, and the package of the design, which the others name.
class CountFiles {
 public:
  explicit CountFiles(const std::string& folder)
      : package_(folder + "/" + vectors::kPackageFile),
        counts_(folder + "/coverage.dat"),
        info_(folder + "/coverage.info") {
    if (!tb::on_path("verilator_coverage")) {
      throw UsageError("-o: verilator_coverage is not on the path: install verilator");
    }
  }

  void write(const vectors::CodeCounts& counts, const spec::Contract& contract) {
    const std::string text = counts.text(std::filesystem::absolute(package_.path()));
    keep(&package_, spec::package_text(contract));
    keep(&counts_, text);
    keep(&info_, info_of(text));
  }

 private:
  static void keep(ReservedFile* file, const std::string& text) {
    file->keep(std::fputs(text.c_str(), file->file()) >= 0);
  }
  static std::string info_of(const std::string& counts) {
    const tb::WorkFolder folder(tb::plugin_cache_folder(), "coverage");
    const std::string in = folder.path() / "in.dat", out = folder.path() / "out.info";
    std::ofstream(in) << counts;
    if (!folder.run(fmt::format("exec verilator_coverage --write-info {} {} > /dev/null 2>&1",
                                studies::quoted(out), studies::quoted(in)))) {
      throw UsageError("verilator_coverage: expected it to read the counts of Verilator");
    }
    std::ostringstream text;
    text << std::ifstream(out).rdbuf();
    return text.str();
  }

  ReservedFile package_, counts_, info_;
};

int coverage(const CoverageOptions& options) {
  const Output output(options);
  const std::vector<vectors::CodeWaiver> waivers = vectors::read_code_waivers(options.waivers);
  CoverageRun run(options, output);
  std::optional<CountFiles> files;
  if (!options.folder.empty()) files.emplace(options.folder);
  run.run([](const auto&) {});
  const CodeCoverage coverage = code_coverage(run.counts(), waivers, run.contract());
  if (files) files->write(run.counts(), run.contract());
  output.line("{} of {}: {} cases", unit_names(run.units()), run.contract().design.name,
              grouped(run.cases()));
  print_code_coverage(output, coverage);
  const bool holds = coverage.holds();
  output.line("\n{}", holds ? "It holds." : "IT DOES NOT HOLD.");
  Json json{{"design", run.contract().design.name}, {"cases", run.cases()}};
  for (const Unit unit : run.units()) json["units"].push_back(spec::name_of(unit));
  json["holds"] = holds;
  json.update(code_coverage_json(coverage));
  output.json(json);
  return holds ? kHolds : kMismatch;
}

}  // namespace

CoverageRun::CoverageRun(const CoverageOptions& options, const Output& output)
    : options_(options), output_(output), progress_(options) {
  if (options.files.empty()) {
    contract_ = contract_of(options);
    units_ = units_of(options);
    require_of(options, contract_.design, spec::no_rtl_reason);
    return;
  }
  for (const std::string& file : options.files) {
    const vectors::Header header = vectors::read_header(file);
    if (units_.empty()) contract_ = header.contract;
    if (spec::package_hash(header.contract) != spec::package_hash(contract_)) {
      throw UsageError(fmt::format("{}: expected vectors of {}, as in {}, got {}", file,
                                   contract_.design.name, options.files[0],
                                   header.contract.design.name));
    }
    if (std::find(units_.begin(), units_.end(), header.unit) == units_.end()) {
      units_.push_back(header.unit);
    }
  }
  require_of(options, contract_.design, spec::no_rtl_reason);
}

std::string unit_names(const std::vector<Unit>& units) {
  std::vector<std::string> names;
  for (const Unit unit : units) names.emplace_back(spec::name_of(unit));
  return fmt::format("{}", fmt::join(names, ", "));
}

void add_coverage_options(CLI::App* command, CoverageOptions* options) {
  auto* files = command->add_option("FILE", options->files,
                                    "Files of one design; none: the cases that generate makes");
  files->type_name("");
  auto* design = command->add_option("--design", options->design, "Design point, or a design file")
                     ->type_name("NAME|FILE.toml")
                     ->capture_default_str();
  auto* unit =
      command->add_option("--unit", options->units, "Of these alone: " + spec::alternatives<Unit>())
          ->delimiter(',')
          ->check(CLI::IsMember(spec::word_list<Unit>()))
          ->type_name("UNIT");
  options->seed = 1;
  auto* level = command->add_option("--level", options->level, "Of the cases, as in generate")
                    ->check(CLI::Range(1, vectors::kMaxLevel))
                    ->type_name("L")
                    ->capture_default_str();
  auto* seed = command->add_option("--seed", options->seed, "Of the cases")
                   ->type_name("N")
                   ->capture_default_str();
  for (auto* option : {design, unit, level, seed}) files->excludes(option);
  command
      ->add_option("--waivers", options->waivers,
                   "What need not be hit; default vectors/coverage/code_waivers.toml")
      ->type_name("FILE.toml");
}

void add_coverage(CLI::App* parent, int* exit_code) {
  auto options = std::make_shared<CoverageOptions>();
  auto* command = parent->add_subcommand(
      "coverage", "Which lines of the RTL run and which of its bits change under vectors");
  add_output_options(command, options.get());
  add_coverage_options(command, options.get());
  command
      ->add_option("-o,--out", options->folder,
                   "Write coverage.dat (Verilator) and coverage.info (lcov) to this folder")
      ->type_name("DIR");
  command->callback([options, exit_code] {
    try {
      *exit_code = coverage(*options);
    } catch (const vectors::Refused& error) {
      throw UsageError(error.what());
    }
  });
}

}  // namespace pineda::cli
