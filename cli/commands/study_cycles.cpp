// pineda study cycles: the cycle model against the RTL, cycles and speed of both.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/report/study_cycles_report.h"
#include "cli/study_scenes.h"
#include "cli/triangles.h"
#include "tb/bench_top.h"

namespace pineda::cli {
namespace {

constexpr const char* kNoStalls = spec::name_of(memory::StallMode::kNone);
constexpr const char* kIdeal = spec::name_of(memory::Kind::kIdeal);
constexpr int kLatencies[] = {1, 8, 64};

struct CyclesOptions : Options {
  std::vector<std::string> scenes;
  std::vector<std::string> designs;
  std::vector<std::string> memories;
  std::vector<int> latencies;  // of an ideal memory
  std::vector<std::string> stalls;
  std::vector<std::string> compilers;
  std::string bunny = kBunnyFile;
  int runs = 5;
  bool all = false;
  bool one_by_one = false;  // memories without stalls, then stalls at ideal memory
};

/// What is asked for: the default table unless the options say otherwise.
CyclesOptions filled_in(CyclesOptions o) {
  if (o.designs.empty() && o.all) {
    for (const spec::Design& d : spec::designs()) {
      if (spec::no_rtl_reason(d).empty()) o.designs.emplace_back(d.name);
    }
  }
  if (o.designs.empty()) o.designs = {"high_tile"};
  o.one_by_one = o.all && o.memories.empty() && o.latencies.empty() && o.stalls.empty();
  if (o.stalls.empty())
    o.stalls = o.all ? spec::word_list<memory::StallMode>() : std::vector<std::string>{kNoStalls};
  if (o.memories.empty()) {
    o.memories = o.all ? spec::word_list<memory::Kind>() : std::vector<std::string>{kIdeal};
  }
  if (o.compilers.empty()) o.compilers = tb::bench_compilers();
  return o;
}

/// Memory and stalls of some rows.
struct Part {
  std::string memory;
  std::optional<int> latency_cycles;  // of an ideal memory; none: the design's own
  std::string stall;
};

/// Latencies of an ideal memory.
std::vector<std::optional<int>> latencies_of(const CyclesOptions& o) {
  if (!o.latencies.empty()) return {o.latencies.begin(), o.latencies.end()};
  if (o.all) return {std::begin(kLatencies), std::end(kLatencies)};
  return {std::nullopt};
}

std::vector<Part> parts_of(const CyclesOptions& o) {
  std::vector<Part> parts;
  for (const std::string& memory : o.memories) {
    std::vector<std::optional<int>> latencies{std::nullopt};
    if (memory == kIdeal) latencies = latencies_of(o);
    for (const auto& latency : latencies) {
      for (const std::string& stall : o.stalls) {
        if (!o.one_by_one || stall == kNoStalls) parts.push_back({memory, latency, stall});
      }
    }
  }
  if (!o.one_by_one) return parts;
  for (const std::string& stall : o.stalls) {
    if (stall != kNoStalls) parts.push_back({kIdeal, std::nullopt, stall});
  }
  return parts;
}

/// Runs everything asked for and prints each row as it is done.
class Table {
 public:
  Table(const CyclesOptions& options, const Output& output) : o_(options), output_(output) {}

  std::vector<CycleRow> run(const std::vector<std::string>& scenes) {
    // Errors in the options are reported before anything is drawn.
    for (const std::string& design : o_.designs) {
      parts_of(design);
      for (const auto& name : scenes)
        open_study_scene(o_, o_.bunny, name, contract_of(with(design, {})));
    }
    for (const std::string& design : o_.designs) {
      for (const Part& part : parts_of(design)) run(with(design, part), scenes);
    }
    return std::move(rows_);
  }

 private:
  CyclesOptions with(const std::string& design, const Part& part) const {
    CyclesOptions one = o_;
    one.design = design;
    one.memory = part.memory;
    one.latency_cycles = part.latency_cycles;
    one.stall = part.stall;
    return one;
  }

  std::vector<Part> parts_of(const std::string& design) const {
    const CyclesOptions any = with(design, {});
    const spec::Contract contract = contract_of(any);
    require_of(any, contract.design, spec::no_rtl_reason);
    std::vector<Part> parts = cli::parts_of(o_);
    for (const Part& part : parts) latency_of(with(design, part), contract);
    return parts;
  }

  void run(const CyclesOptions& one, const std::vector<std::string>& scenes) {
    const spec::Contract contract = contract_of(one);
    output_.line("{}{}, {}, stalls {}", rows_.empty() ? "" : "\n", contract.design.name,
                 memory_text(one, contract), one.stall);
    print_columns(output_);
    for (const std::string& name : scenes) {
      rows_.push_back(row(one, contract, name));
      print_row(output_, rows_.back());
    }
  }

  CycleRow row(const CyclesOptions& one, const spec::Contract& contract,
               const std::string& name) const {
    Progress progress(one);
    const scene::Scene scene = open_study_scene(one, one.bunny, name, contract);
    const auto triangles = load_all(scene.source.get(), &progress);
    progress.update(name.c_str(), triangles.size());
    studies::CycleOptions options;
    options.memory = memory_kind_of(one);
    options.depth_latency_cycles = latency_of(one, contract);
    options.stall_mode = stall_mode_of(one);
    options.seed = one.seed;
    options.runs = one.runs;
    options.compilers = one.compilers;
    options.say = [&](const std::string& text) { output_.say(text); };
    CycleRow row;
    row.scene = name;
    row.design = contract.design.name;
    row.memory = one.memory;
    row.stall = one.stall;
    if (options.memory == memory::Kind::kIdeal) row.latency_cycles = options.depth_latency_cycles;
    row.triangles = triangles.size();
    row.size = {scene.frame.width, scene.frame.height};
    row.point = studies::compare_cycles(contract, scene.frame, triangles, options);
    return row;
  }

  const CyclesOptions& o_;
  const Output& output_;
  std::vector<CycleRow> rows_;
};

std::string verdict(const CycleWorst& all) {
  if (!all.holds) return "IT DOES NOT HOLD.";
  if (all.off == 0) return "It holds: not a cycle, retirement or counter differs.";
  return fmt::format("It holds: {} of {} rows differ, none by .1 %.", all.off, all.rows);
}

int run(const CyclesOptions& given) {
  if (!given.latencies.empty() && !given.memories.empty() &&
      std::count(given.memories.begin(), given.memories.end(), kIdeal) == 0) {
    throw UsageError("--latency: only an ideal memory has one");
  }
  const CyclesOptions options = filled_in(given);
  const Output output(options);
  std::vector<std::string> left_out;
  const auto scenes = study_scenes(options.scenes, options.bunny, &left_out);
  const std::vector<CycleRow> rows = Table(options, output).run(scenes);

  const CycleMeans means = means_of(rows);
  const std::vector<CycleWorst> worst = worst_of(rows);
  const bool it_holds = worst.back().holds;
  Json json{{"runs", options.runs}, {"seed", options.seed}, {"left_out", left_out}};
  for (const CycleRow& r : rows) json["rows"].push_back(row_json(r));
  if (means.rtl > 0) json["geometric_means"] = means_json(means);
  output.line("");
  for (const auto& name : left_out)
    output.line("Left out: {}, {} is not there", name, options.bunny);
  if (options.runs > 0) {
    output.line(
        "Speed in M cycles/s of one thread, the median of {} runs in CPU time; the RTL bare",
        options.runs);
  }
  print_means(output, means);
  print_worst(output, worst);
  output.line("{}", verdict(worst.back()));
  json["worst"] = worst_json(worst);
  json["holds"] = it_holds;
  output.json(json);
  return it_holds ? kHolds : kMismatch;
}

}  // namespace

void add_cycles_study(CLI::App* study, int* exit_code) {
  auto options = std::make_shared<CyclesOptions>();
  auto* command = study->add_subcommand(
      "cycles", "The cycle model against the RTL: cycles, retirement of triangles, speed");
  command
      ->add_option("--scene", options->scenes, "Only these, bunny or as `pineda scenes` has them")
      ->delimiter(',')
      ->type_name("SCENE");
  command->add_option("--designs", options->designs, "Design points, high_tile unless given")
      ->delimiter(',')
      ->type_name("NAME|FILE.toml");
  command->add_option("--memory", options->memories, spec::alternatives<memory::Kind>())
      ->delimiter(',')
      ->check(CLI::IsMember(spec::word_list<memory::Kind>()))
      ->type_name("KIND");
  command
      ->add_option("--latency", options->latencies,
                   "Ideal memory: cycles from a depth read to its data")
      ->delimiter(',')
      ->type_name("N");
  command
      ->add_option("--stall", options->stalls,
                   "Who stalls: " + spec::alternatives<memory::StallMode>())
      ->delimiter(',')
      ->check(CLI::IsMember(spec::word_list<memory::StallMode>()))
      ->type_name("MODE");
  command->add_flag(
      "--all", options->all,
      "Every design with latencies 1, 8 and 64, with every other memory, and with every stall at "
      "its own latency: an hour; unless given. If --memory, --latency or --stall is: each memory "
      "under each stall");
  command->add_option("--runs", options->runs, "Speed is the median of so many; 0: cycles alone")
      ->check(CLI::Range(0, 1000))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--compiler", options->compilers, "Of the RTL: g++, clang++; those there are")
      ->delimiter(',')
      ->check(CLI::IsMember({"g++", "clang++"}))
      ->type_name("NAME");
  command->add_option("--size", options->size, "Of every scene, px")->type_name("WxH");
  command
      ->add_option("--bunny", options->bunny,
                   "The scene bunny: 1920x1080, or 640x480 where a design cannot, or --size")
      ->type_name("FILE")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Of random scenes and of stalls")
      ->type_name("N")
      ->capture_default_str();
  add_output_options(command, options.get());
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
