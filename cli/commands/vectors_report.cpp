// pineda vectors report: test plan, bins, code and mutants on one page.
#include <CLI/CLI.hpp>
#include <fstream>
#include <memory>

#include "cli/commands/vectors_coverage.h"
#include "cli/report/vectors_page.h"
#include "cli/reserved_file.h"
#include "model/files/data_folder.h"

namespace pineda::cli {
namespace {

struct ReportOptions : CoverageOptions {
  std::string page;
  std::string plan = default_testplan();
  std::string mutants;  // JSON of what became of them
};

uint64_t count_of(const Json& unit, const char* key) {
  const auto at = unit.find(key);
  if (at == unit.end() || !at->is_number_unsigned()) {
    throw UsageError(fmt::format("expected a count '{}'", key));
  }
  return *at;
}

std::vector<UnitMutants> read_mutants(const std::string& file) {
  if (file.empty()) return {};
  std::ifstream stream(file);
  if (!stream) throw UsageError(fmt::format("{}: expected a file to read", file));
  std::vector<UnitMutants> all;
  try {
    const Json json = Json::parse(stream);
    if (!json.is_object() || !json.contains("units") || !json["units"].is_object()) {
      throw UsageError("expected an object 'units'");
    }
    for (const auto& [unit, m] : json["units"].items()) {
      all.push_back({unit, count_of(m, "mutants"), count_of(m, "killed_level1"),
                     count_of(m, "killed_level2"), count_of(m, "equivalent"),
                     count_of(m, "undecided")});
    }
  } catch (const Json::exception& error) {
    throw UsageError(fmt::format("{}: expected JSON: {}", file, error.what()));
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}: {}", file, error.what()));
  }
  return all;
}

/// Lines FILE | TEXT | REPLACEMENT; a bar in a text is written \|.
std::vector<CoreMutant> core_mutants() {
  std::ifstream lines(files::data_folder() / "vectors/mutants/core.txt");
  std::vector<CoreMutant> all;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> fields(1);
    for (size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '|' && i > 0 && line[i - 1] == '\\') {
        fields.back().back() = '|';
      } else if (line[i] == '|') {
        fields.emplace_back();
      } else {
        fields.back() += line[i];
      }
    }
    for (std::string& field : fields) {
      field.erase(0, field.find_first_not_of(' '));
      field.erase(field.find_last_not_of(' ') + 1);
    }
    fields.resize(3);
    all.push_back({fields[0], fields[1], fields[2]});
  }
  return all;
}

std::string settings_of(const CoverageOptions& options, uint64_t cases) {
  if (!options.files.empty()) return fmt::format("{} cases of files", grouped(cases));
  return fmt::format("{} cases of level {}, seed {}", grouped(cases), options.level, options.seed);
}

int report(const ReportOptions& options) {
  const Output output(options);
  VectorsPage page;
  page.plan = read_testplan(options.plan);
  page.mutants = read_mutants(options.mutants);
  page.core = core_mutants();
  const std::vector<vectors::CodeWaiver> waivers = vectors::read_code_waivers(options.waivers);
  CoverageRun run(options, output);
  ReservedFile file(options.page);
  run.run([&](const auto& value) {
    if (page.bins.empty() || page.bins.back().unit() != value.kUnit) {
      page.bins.emplace_back(value.kUnit, run.contract());
    }
    page.bins.back().see(value);
  });
  page.design = run.contract().design.name;
  page.settings = settings_of(options, run.cases());
  page.code = code_coverage(run.counts(), waivers, run.contract());
  file.keep(std::fputs(vectors_page_html(page).c_str(), file.file()) >= 0);
  output.line("{}: {} testpoints, {} cases of {}", options.page, page.plan.size(),
              grouped(run.cases()), page.design);
  return kHolds;
}

}  // namespace

void add_report(CLI::App* parent, int* exit_code) {
  auto options = std::make_shared<ReportOptions>();
  auto* command = parent->add_subcommand(
      "report", "One page: test plan, bins and the cases that hit them, code of the RTL, mutants");
  add_coverage_options(command, options.get());
  command->add_option("--mutants", options->mutants, "What became of mutants of the RTL")
      ->type_name("FILE.json");
  command->add_option("--plan", options->plan, "The test plan; default vectors/testplan.hjson")
      ->type_name("FILE.hjson");
  command->add_option("-o,--out", options->page, "The page")->required()->type_name("FILE.html");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->callback([options, exit_code] {
    try {
      *exit_code = report(*options);
    } catch (const vectors::Refused& error) {
      throw UsageError(error.what());
    }
  });
}

}  // namespace pineda::cli
