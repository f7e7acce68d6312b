// pineda study area: cells, clock and storage of designs, and their throughput for it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "cli/output.h"
#include "cli/report/area_ratchet.h"
#include "cli/report/area_tables.h"
#include "cli/reserved_file.h"
#include "cli/study_scenes.h"
#include "cli/triangles.h"
#include "studies/area/area.h"
#include "studies/area/area_picture.h"
#include "studies/area/fpga.h"
#include "studies/cycles/model_cycles.h"

namespace pineda::cli {
namespace {

struct AreaStudyOptions : Options {
  std::vector<std::string> designs;
  std::string technology = "osu018";
  std::string liberty;
  std::vector<std::string> scenes;
  std::string bunny = kBunnyFile;
  std::string picture;
  bool throughput = false;
  bool tables = false;
  std::vector<std::string> fpgas;  // if any, these in place of the technology
  studies::AreaOptions area;
  AreaRatchetOptions ratchet;
};

Throughput throughput_of(const AreaStudyOptions& options, const std::string& name,
                         const spec::Contract& contract, double fmax_mhz) {
  Progress progress(options);
  const scene::Scene scene = open_study_scene(options, options.bunny, name, contract);
  const auto triangles = load_all(scene.source.get(), &progress);
  const auto frame = studies::model_frame(contract, scene.frame, triangles);
  const double seconds = static_cast<double>(frame.cycles) / (1e6 * fmax_mhz);
  return {name, frame.cycles, static_cast<double>(triangles.size()) / seconds,
          static_cast<double>(frame.fragments) / seconds};
}

Json path_json(const studies::TimingPath& path) {
  Json parts = Json::array();
  for (const auto& part : path.parts) {
    parts.push_back({{"instance", part.instance},
                     {"module", part.module},
                     {"ps", part.ps},
                     {"cells", part.cells}});
  }
  return {{"ps", path.ps}, {"levels", path.levels()},       {"from", path.from},
          {"to", path.to}, {"registers_ps", path.fixed_ps}, {"parts", parts}};
}

Json row_json(const AreaRow& row) {
  const studies::AreaStudy& a = row.area;
  Json json{{"area_um2", a.area_um2},
            {"area_without_memory_um2", a.area_without_memory_um2},
            {"fmax_mhz", a.fmax_mhz()},
            {"flip_flops", a.flip_flops},
            {"memory_bits", a.memory_bits}};
  if (a.macro_area_um2 >= 0) {
    json["area_with_macros_um2"] = a.area_without_memory_um2 + a.macro_area_um2;
  }
  json["slowest_path"] = path_json(a.slowest);
  json["clocks_ps"] = a.asked_ps;
  for (const auto& [name, unit] : a.units) {
    Json& u = json["units"][name];
    u = {{"area_um2", unit.area_um2}, {"flip_flops", unit.flip_flops}};
    if (unit.slowest.ps == 0) continue;
    u["fmax_mhz"] = unit.fmax_mhz();
    u["slowest_path"] = path_json(unit.slowest);
    if (unit.through.ps > 0) u["input_to_output"] = path_json(unit.through);
  }
  for (const auto& part : a.parts) {
    json["modules"].push_back({{"instance", part.path},
                               {"module", part.module},
                               {"unit", part.unit},
                               {"area_um2", part.area_um2},
                               {"flip_flops", part.flip_flops},
                               {"memory_bits", part.memory_bits}});
  }
  for (const Throughput& t : row.scenes) {
    json["scenes"][t.scene] = {
        {"cycles", t.cycles},
        {"triangles_per_second", t.triangles_per_second},
        {"pixels_per_second", t.pixels_per_second},
        {"triangles_per_second_mm2", t.triangles_per_second / row.square_mm()},
        {"pixels_per_second_mm2", t.pixels_per_second / row.square_mm()}};
  }
  return json;
}

/// How an instance below `top` is called: the top itself by its module.
std::string shown(const std::string& instance, const std::string& module) {
  return instance.empty() ? module : instance;
}

void print_path(const Output& output, const std::string& name, const studies::TimingPath& path) {
  output.row(name, fmt::format("{:.0f} ps, {} cells; of it registers and inputs {:.0f} ps", path.ps,
                               path.levels(), path.fixed_ps));
  for (const auto& part : path.parts) {
    output.row("", fmt::format("  {:>6.0f} ps, {:>3} cells in {}", part.ps, part.cells,
                               shown(part.instance, part.module)));
  }
}

void print_parts(const Output& output, const studies::AreaStudy& a) {
  constexpr double kLeastShare = .005;
  output.line("\n{:<14}{:<36}{:>12}{:>8}{:>12}{:>12}", "unit", "instance", "um^2", "%",
              "flip-flops", "memory bits");
  for (const auto& [name, unit] : a.units) {
    output.line("{:<50}{:>12.0f}{:>8.1f}{:>12}", name, unit.area_um2,
                100 * unit.area_um2 / a.area_um2, grouped(static_cast<uint64_t>(unit.flip_flops)));
    auto parts = a.parts;
    std::stable_sort(parts.begin(), parts.end(), [](const auto& one, const auto& other) {
      return one.area_um2 > other.area_um2;
    });
    for (const auto& part : parts) {
      if (part.unit != name || part.area_um2 < kLeastShare * a.area_um2) continue;
      output.line("{:<14}{:<36}{:>12.0f}{:>8.1f}{:>12}{:>12}", "", shown(part.path, part.module),
                  part.area_um2, 100 * part.area_um2 / a.area_um2,
                  grouped(static_cast<uint64_t>(part.flip_flops)),
                  part.memory_bits > 0 ? grouped(static_cast<uint64_t>(part.memory_bits)) : "");
    }
  }
}

void print_row(const Output& output, const AreaRow& row) {
  const studies::AreaStudy& a = row.area;
  output.row("Design", row.contract.design.name);
  output.row("Area", fmt::format("{:.0f} um^2 of cells, every stored bit a flip-flop", a.area_um2));
  output.row("", fmt::format("{:.0f} um^2 without {} bits of memories", a.area_without_memory_um2,
                             grouped(static_cast<uint64_t>(a.memory_bits))));
  if (a.macro_area_um2 >= 0) {
    output.row("", fmt::format("{:.0f} um^2 with macros where they are smaller",
                               a.area_without_memory_um2 + a.macro_area_um2));
  }
  output.row("Flip-flops", grouped(static_cast<uint64_t>(a.flip_flops)));
  output.row("Clock", fmt::format("{:.0f} MHz", a.fmax_mhz()));
  print_path(output, "Slowest path", a.slowest);
  for (const auto& [name, unit] : a.units) {
    if (unit.slowest.ps > 0) print_path(output, "  of " + name, unit.slowest);
    if (unit.through.ps > 0) print_path(output, "    input to output", unit.through);
  }
  print_parts(output, a);
  if (row.scenes.empty()) return;
  output.line("\n{:<16}{:>12}{:>12}{:>12}{:>16}{:>16}", "scene", "cycles", "Mtri/s", "Gpix/s",
              "Mtri/s/mm^2", "Gpix/s/mm^2");
  for (const Throughput& t : row.scenes) {
    output.line("{:<16}{:>12}{:>12.2f}{:>12.3f}{:>16.1f}{:>16.2f}", t.scene,
                grouped(static_cast<uint64_t>(t.cycles)), 1e-6 * t.triangles_per_second,
                1e-9 * t.pixels_per_second, 1e-6 * t.triangles_per_second / row.square_mm(),
                1e-9 * t.pixels_per_second / row.square_mm());
  }
}

/// The designs asked for; "all": every named one that has RTL.
std::vector<spec::Contract> designs_of(const AreaStudyOptions& options) {
  std::vector<spec::Contract> contracts;
  for (const std::string& name : options.designs) {
    if (name == "all") {
      for (const spec::Design& design : spec::designs()) {
        if (spec::no_rtl_reason(design).empty()) contracts.push_back(spec::contract(design));
      }
      continue;
    }
    Options one = options;
    one.design = name;
    contracts.push_back(contract_of(one));
    require_of(one, contracts.back().design, spec::no_rtl_reason);
  }
  return contracts;
}

studies::ToolRuns tool_runs(const Output& output) {
  return studies::area_tool_runs([output](const std::string& text) { output.say(text); });
}

int run_fpga(const AreaStudyOptions& options) {
  const Output output(options);
  const auto contracts = designs_of(options);
  std::vector<std::string> families = options.fpgas;
  const std::vector<std::string> known = studies::fpga_families();
  if (families == std::vector<std::string>{"all"}) families = known;
  for (const std::string& name : families) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw UsageError(
        fmt::format("--fpga: expected {} or all, got '{}'", fmt::join(known, ", "), name));
  }
  const studies::ToolRuns runs = tool_runs(output);
  Json json{{"tools", runs.versions()}};
  output.row("Tools", fmt::format("{}", fmt::join(runs.versions(), "; ")));
  output.line("\n{:<16}{:<10}{:>10}{:>10}{:>12}{:>8}{:>12}{:>14}", "design", "family", "LUTs",
              "carries", "flip-flops", "DSPs", "block RAMs", "RAMs of LUTs");
  for (const auto& contract : contracts) {
    Json design;
    for (const studies::FpgaCells& cells : studies::study_fpga(contract, families, runs)) {
      const auto number = [](long n) { return grouped(static_cast<uint64_t>(n)); };
      output.line("{:<16}{:<10}{:>10}{:>10}{:>12}{:>8}{:>12}{:>14}", contract.design.name,
                  cells.family, number(cells.luts), number(cells.carries), number(cells.flip_flops),
                  number(cells.dsps), number(cells.block_rams), number(cells.distributed));
      design["fpga"][cells.family] = {
          {"luts", cells.luts}, {"carries", cells.carries},       {"flip_flops", cells.flip_flops},
          {"dsps", cells.dsps}, {"block_rams", cells.block_rams}, {"lut_rams", cells.distributed}};
    }
    if (contracts.size() == 1) {
      json["design"] = contract.design.name;
      json.update(design);
    } else {
      json["designs"][contract.design.name] = design;
    }
  }
  output.json(json);
  return kHolds;
}

int run(AreaStudyOptions options) {
  if (!options.fpgas.empty()) return run_fpga(options);
  const Output output(options);
  require_ending("--picture", options.picture, {".svg"});
  const auto contracts = designs_of(options);
  if (!options.picture.empty() && contracts.size() != 1) {
    throw UsageError("--picture: expected one design");
  }
  if (options.ratchet.is_wanted() && contracts.size() != 1) {
    throw UsageError("--check, --update: expected one design");
  }
  if (options.ratchet.allow_growth && options.ratchet.update.empty()) {
    throw UsageError("--allow-growth: expected --update");
  }
  std::vector<std::string> left_out;
  std::vector<std::string> scenes = options.scenes;
  if (options.throughput) scenes = study_scenes(options.scenes, options.bunny, &left_out);
  for (const auto& contract : contracts) {
    for (const auto& name : scenes) open_study_scene(options, options.bunny, name, contract);
  }
  std::optional<ReservedFile> picture;
  if (!options.picture.empty()) picture.emplace(options.picture);
  const auto technology = studies::read_technology(options.technology, options.liberty);
  const studies::ToolRuns runs = tool_runs(output);
  const std::string tools = fmt::format("{}", fmt::join(runs.versions(), "; "));
  std::optional<AreaRatchet> ratchet;
  if (options.ratchet.is_wanted()) {
    ratchet.emplace(options.ratchet,
                    AreaRatchet::Subject{contracts.front().design.name, technology.name, tools,
                                         options.area.clock_ps, technology.first_clock_ps});
    options.area.clock_ps = ratchet->clock_ps();
  }
  bool holds = true;
  Json json{{"technology", technology.name},
            {"process", technology.process},
            {"liberty", technology.liberty_file},
            {"tools", runs.versions()},
            {"least_memory_bits", options.area.least_memory_bits}};
  output.row("Technology", fmt::format("{}: {}", technology.name, technology.process));
  output.row("Tools", tools);
  std::vector<AreaRow> rows;
  for (const auto& contract : contracts) {
    rows.push_back({contract, studies::study_area(contract, technology, options.area, runs), {}});
    AreaRow& row = rows.back();
    for (const auto& name : scenes) {
      row.scenes.push_back(throughput_of(options, name, contract, row.area.fmax_mhz()));
    }
    if (!options.tables) {
      output.line("");
      print_row(output, row);
    }
    if (contracts.size() == 1) {
      json["design"] = contract.design.name;
      json.update(row_json(row));
    } else {
      json["designs"][contract.design.name] = row_json(row);
    }
    if (ratchet) holds = ratchet->run(output, row.area, &json);
    if (picture) {
      const std::string svg = studies::area_picture(
          row.area, fmt::format("{} on {}", contract.design.name, technology.process));
      picture->keep(std::fputs(svg.c_str(), picture->file()) >= 0);
    }
  }
  if (options.tables) print_area_tables(output, rows);
  for (const auto& name : left_out)
    output.line("Left out: {}, {} is not there", name, options.bunny);
  output.json(json);
  return holds ? kHolds : kMismatch;
}

}  // namespace

void add_area_study(CLI::App* study, int* exit_code) {
  auto options = std::make_shared<AreaStudyOptions>();
  options->designs = {"high_tile"};
  auto* command = study->add_subcommand(
      "area", "Area, clock and storage of designs in a process, by Yosys and OpenSTA");
  command->add_option("--design,--designs", options->designs, "Design points; all: every named one")
      ->delimiter(',')
      ->type_name("NAME|FILE.toml")
      ->capture_default_str();
  command
      ->add_option(
          "--technology", options->technology,
          "The process: " + fmt::format("{}", fmt::join(studies::technology_names(), ", ")) +
              ", or a file like those in studies/area/technologies")
      ->type_name("NAME|FILE.toml")
      ->capture_default_str();
  command
      ->add_option("--liberty", options->liberty,
                   "Its cells, plain or gzip; needed unless the technology says where they are")
      ->type_name("FILE");
  command
      ->add_option("--memory-bits", options->area.least_memory_bits,
                   "Memories of fewer bits count as logic")
      ->check(CLI::Range(1L, 1L << 30))
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--clock", options->area.clock_ps,
                   "Ask for this clock alone, ps; else the fastest one is searched")
      ->check(CLI::Range(1, studies::kMostClockPs))
      ->type_name("PS");
  command
      ->add_option("--scene", options->scenes,
                   "Throughput on these scenes, bunny or as `pineda scenes` has them")
      ->delimiter(',')
      ->type_name("SCENE");
  command->add_flag("--throughput", options->throughput,
                    "Throughput on the scenes of study cycles");
  command->add_flag("--tables", options->tables,
                    "Tables in Markdown, a row a design, in place of each design's figures");
  command->add_option("--size", options->size, "Of every scene, px")->type_name("WxH");
  command->add_option("--bunny", options->bunny, "The scene bunny, as in study cycles")
      ->type_name("FILE")
      ->capture_default_str();
  auto* fpga = command->add_option(
      "--fpga", options->fpgas,
      "Cells of an FPGA in place of a technology's: " +
          fmt::format("{}", fmt::join(studies::fpga_families(), ", ")) + "; all: each of them");
  fpga->delimiter(',')->type_name("FAMILY");
  command->add_option("--picture", options->picture, "Bars of the area by module")
      ->type_name("FILE.svg");
  auto* check =
      command->add_option("--check", options->ratchet.check,
                          "Fail if area or slowest path of a unit is 2 % above this file");
  check->type_name("FILE.json");
  auto* update = command->add_option("--update", options->ratchet.update,
                                     "Store in this file what has shrunk by 2 %, and new figures");
  update->type_name("FILE.json")->excludes(check);
  command->add_flag("--allow-growth", options->ratchet.allow_growth,
                    "--update also what has grown");
  for (auto* option : {check, update}) option->excludes(command->get_option("--memory-bits"));
  for (const char* other : {"--technology", "--liberty", "--memory-bits", "--clock", "--scene",
                            "--throughput", "--tables", "--picture", "--check", "--update"}) {
    fpga->excludes(command->get_option(other));
  }
  add_output_options(command, options.get());
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
