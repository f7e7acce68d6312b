// pineda study netlist: the mapped netlist of each unit on its committed vectors, in Icarus Verilog.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <list>
#include <memory>
#include <sstream>

#include "cli/output.h"
#include "cli/reserved_file.h"
#include "studies/area/area.h"
#include "studies/netlist/netlist_replay.h"
#include "tb/plugin_cache.h"

namespace pineda::cli {
namespace {

namespace fs = std::filesystem;

struct NetlistOptions : Options {
  std::string technology = "osu018";
  std::string liberty;
  std::string models;
  int clock_ps = 0;  // 0: the technology's first
  std::vector<std::string> units;
  size_t cases = 0;  // of a unit; 0: all
  std::string netlist;
  std::string folder;
};

std::vector<std::string> unit_names() {
  std::vector<std::string> names;
  for (const char* unit : studies::kUnits) names.push_back(studies::unit_name(unit));
  return names;
}

/// The units asked for, each once, in the order of a triangle's way.
std::vector<std::string> units_of(const NetlistOptions& options) {
  const std::vector<std::string> known = unit_names();
  for (const std::string& unit : options.units) {
    if (std::find(known.begin(), known.end(), unit) != known.end()) continue;
    throw UsageError(fmt::format("--unit: expected {}, got '{}'", fmt::join(known, ", "), unit));
  }
  if (options.units.empty()) return known;
  std::vector<std::string> units;
  for (const std::string& unit : known) {
    const auto& asked = options.units;
    if (std::find(asked.begin(), asked.end(), unit) != asked.end()) units.push_back(unit);
  }
  return units;
}

void require_readable(const char* option, const std::string& file) {
  if (fs::is_regular_file(file) && std::ifstream(file)) return;
  throw UsageError(fmt::format("{}: {}: cannot read it", option, file));
}

/// The Verilog models of the technology's cells.
std::string models_of(const NetlistOptions& options, const studies::Technology& technology) {
  const std::string& file = options.models.empty() ? technology.models_file : options.models;
  if (file.empty()) {
    throw UsageError(
        fmt::format("--models: expected the Verilog models of the cells of {}", technology.name));
  }
  require_readable("--models", file);
  return file;
}

std::vector<fs::path> netlists_of(const NetlistOptions& options, const spec::Contract& contract,
                                  const studies::Technology& technology, int clock_ps,
                                  const std::vector<std::string>& units, const Output& output,
                                  std::vector<std::string>* tools) {
  if (!options.netlist.empty()) return {options.netlist};
  const studies::ToolRuns runs =
      studies::area_tool_runs([output](const std::string& text) { output.say(text); });
  for (const std::string& version : runs.versions()) tools->push_back(version);
  std::vector<std::string> modules;
  for (const std::string& unit : units) modules.push_back(unit + "_unit");
  return studies::unit_netlists(contract, technology, clock_ps, modules, runs);
}

void copy(const fs::path& from, ReservedFile* to) {
  std::ifstream stream(from, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  to->keep(stream && std::fputs(text.str().c_str(), to->file()) >= 0);
}

int run(const NetlistOptions& options) {
  const Output output(options);
  const auto units = units_of(options);
  if (!options.netlist.empty()) {
    if (units.size() != 1) throw UsageError("--netlist: expected --unit, one");
    require_readable("--netlist", options.netlist);
  }
  const spec::Contract contract = contract_of(options);
  require_of(options, contract.design, spec::no_rtl_reason);
  std::vector<studies::NetlistTask> tasks;
  for (const std::string& unit : units) {
    tasks.push_back({{}, studies::committed_vectors(contract, unit, options.cases)});
  }
  const auto technology = studies::read_technology(options.technology, options.liberty);
  const std::string models = models_of(options, technology);
  const int clock_ps = options.clock_ps > 0 ? options.clock_ps : technology.first_clock_ps;
  std::vector<std::string> tools{studies::icarus_version()};
  std::list<ReservedFile> files;
  if (!options.folder.empty()) {
    for (const auto& unit : units) files.emplace_back(options.folder + "/" + unit + "_unit.v");
  }

  const auto netlists = netlists_of(options, contract, technology, clock_ps, units, output, &tools);
  for (size_t i = 0; i < tasks.size(); ++i) tasks[i].netlist = netlists[i];
  auto file = files.begin();
  for (const auto& netlist : netlists) {
    if (file != files.end()) copy(netlist, &*file++);
  }
  output.say("replaying the vectors");
  const auto replays = studies::replay_netlists(tasks, models, options.seed,
                                                fs::absolute(tb::plugin_cache_folder()));

  output.row("Technology", fmt::format("{}: {}", technology.name, technology.process));
  output.row("Tools", fmt::format("{}", fmt::join(tools, "; ")));
  output.row("Netlist",
             options.netlist.empty() ? fmt::format("mapped for {} ps", clock_ps) : options.netlist);
  Json json{{"technology", technology.name}, {"design", contract.design.name}, {"tools", tools}};
  bool holds = true;
  output.line("\n{:<14}{:>10}{:>10}{:>10}", "unit", "cases", "words", "cycles");
  for (const studies::Replay& replay : replays) {
    output.line("{:<14}{:>10}{:>10}{:>10}", replay.unit, replay.cases, replay.words, replay.cycles);
    if (!replay.difference.empty()) output.line("  {}", replay.difference);
    holds &= replay.difference.empty();
    Json& unit = json["units"][replay.unit];
    unit = {{"cases", replay.cases}, {"words", replay.words}, {"cycles", replay.cycles}};
    if (!replay.difference.empty()) unit["difference"] = replay.difference;
  }
  output.line("{}", holds ? "It holds: every word is that of the vectors." : "IT DOES NOT HOLD.");
  json["holds"] = holds;
  output.json(json);
  return holds ? kHolds : kMismatch;
}

}  // namespace

void add_netlist_study(CLI::App* study, int* exit_code) {
  auto options = std::make_shared<NetlistOptions>();
  options->seed = 1;
  auto* command = study->add_subcommand(
      "netlist", "The mapped netlist of each unit on its committed vectors, in Icarus Verilog");
  command->add_option("--design", options->design, "A design in whose formats there are vectors")
      ->type_name("NAME|FILE.toml")
      ->capture_default_str();
  command
      ->add_option("--unit", options->units,
                   "Only these: " + fmt::format("{}", fmt::join(unit_names(), ", ")))
      ->delimiter(',')
      ->type_name("UNIT");
  command->add_option("--cases", options->cases, "Of each unit, spread over its vectors; else all")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N");
  command->add_option("--seed", options->seed, "Of the stalls")
      ->check(CLI::Range(0, 1'000'000'000))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--technology", options->technology, "As in study area")
      ->type_name("NAME|FILE.toml")
      ->capture_default_str();
  command->add_option("--liberty", options->liberty, "As in study area")->type_name("FILE");
  command
      ->add_option("--models", options->models,
                   "Verilog of its cells; needed unless the technology says where it is")
      ->type_name("FILE.v");
  auto* clock = command->add_option("--clock", options->clock_ps,
                                    "Mapped for this clock, ps; else the technology's first");
  clock->check(CLI::Range(1, studies::kMostClockPs))->type_name("PS");
  command
      ->add_option("--netlist", options->netlist,
                   "Replay this netlist of --unit, with the RTL's ports, in place of a mapped one")
      ->type_name("FILE.v")
      ->excludes(clock);
  command->add_option("-o", options->folder, "Write the netlists there, UNIT_unit.v")
      ->type_name("DIR");
  add_output_options(command, options.get());
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
