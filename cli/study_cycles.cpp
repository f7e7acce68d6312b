// pineda study cycles: the cycle model against the RTL, cycles and speed of both.
#include <filesystem>
#include <memory>

#include "cli/study_cycles_report.h"
#include "cli/triangles.h"
#include "tb/bench_top.h"

namespace pineda::cli {
namespace {

constexpr const char* kBunny = "bunny";
constexpr const char* kDefaultScenes[] = {"bunny", "teapot", "random/px1", "random/px1000",
                                          "random/screen"};
constexpr const char* kStallNames[] = {"none", "source", "sink", "both"};
constexpr double kGreatestError = .001;

struct CyclesOptions : Options {
  std::vector<std::string> scenes;
  std::vector<std::string> designs;
  std::vector<int> latencies;
  std::vector<std::string> stalls;
  std::vector<std::string> compilers;
  std::string bunny = "/usr/share/glmark2/models/bunny.obj";
  int runs = 5;
  bool all = false;
};

/// What is asked for: the default table unless the options say otherwise.
CyclesOptions filled_in(CyclesOptions o) {
  if (o.designs.empty() && o.all) {
    for (const spec::Design& d : spec::designs()) {
      if (spec::no_rtl_reason(d).empty()) o.designs.emplace_back(d.name);
    }
  }
  if (o.designs.empty()) o.designs = {"high_tile"};
  if (o.stalls.empty() && o.all) o.stalls.assign(std::begin(kStallNames), std::end(kStallNames));
  if (o.stalls.empty()) o.stalls = {"none"};
  if (o.latencies.empty() && o.all) o.latencies = {1, 8, 64};
  if (o.compilers.empty()) o.compilers = tb::bench_compilers();
  return o;
}

/// The scenes to draw; the default one that lies in a file is left out where the file is not.
std::vector<std::string> scenes_of(const CyclesOptions& o, std::vector<std::string>* left_out) {
  if (!o.scenes.empty()) return o.scenes;
  std::vector<std::string> scenes;
  for (const char* name : kDefaultScenes) {
    const bool there = name != std::string(kBunny) || std::filesystem::exists(o.bunny);
    (there ? scenes : *left_out).emplace_back(name);
  }
  return scenes;
}

scene::Scene open_named(const CyclesOptions& o, const std::string& name,
                        const spec::Contract& contract) {
  CyclesOptions one = o;
  one.scene = name == kBunny ? o.bunny : name;
  if (name == kBunny && o.size.empty()) one.size = "1920x1080";
  return open(one, contract, false);
}

/// Everything asked for, row by row as it is done.
class Table {
 public:
  Table(const CyclesOptions& options, const Output& output) : o_(options), output_(output) {}

  std::vector<CycleRow> run(const std::vector<std::string>& scenes) {
    // What is wrong is said before anything is drawn.
    for (const auto& name : scenes) open_named(o_, name, contract_of(with(o_.designs.front())));
    for (const std::string& design : o_.designs) latencies_of(design);

    for (const std::string& design : o_.designs) {
      CyclesOptions one = with(design);
      for (const int latency : latencies_of(design)) {
        one.latency_cycles = latency;
        for (const std::string& stall : o_.stalls) {
          one.stall = stall;
          part(one, contract_of(one), scenes);
        }
      }
    }
    return std::move(rows_);
  }

 private:
  CyclesOptions with(const std::string& design) const {
    CyclesOptions one = o_;
    one.design = design;
    return one;
  }

  std::vector<int> latencies_of(const std::string& design) const {
    CyclesOptions one = with(design);
    const spec::Contract contract = contract_of(one);
    require_of(one, contract.design, spec::no_rtl_reason);
    if (o_.latencies.empty()) return {contract.design.depth_latency_cycles};
    for (const int latency : o_.latencies) {
      one.latency_cycles = latency;
      latency_of(one, contract);
    }
    return o_.latencies;
  }

  void part(const CyclesOptions& one, const spec::Contract& contract,
            const std::vector<std::string>& scenes) {
    output_.line("{}{}, depth latency {}, stalls {}", rows_.empty() ? "" : "\n",
                 contract.design.name, *one.latency_cycles, one.stall);
    print_columns(output_);
    for (const std::string& name : scenes) {
      rows_.push_back(row(one, contract, name));
      print_row(output_, rows_.back());
    }
  }

  CycleRow row(const CyclesOptions& one, const spec::Contract& contract,
               const std::string& name) const {
    Progress progress(one);
    const scene::Scene scene = open_named(one, name, contract);
    const auto triangles = load_all(scene.source.get(), &progress);
    progress.update(name.c_str(), triangles.size());
    studies::CycleOptions options;
    options.depth_latency_cycles = *one.latency_cycles;
    options.stall_mode = stall_mode_of(one);
    options.seed = one.seed;
    options.runs = one.runs;
    options.compilers = one.compilers;
    options.say = [&](const std::string& text) { output_.say(text); };
    CycleRow row{name, contract.design.name, one.stall, *one.latency_cycles,
                 {},   triangles.size(),     {}};
    row.size = {scene.frame.width, scene.frame.height};
    row.point = studies::compare_cycles(contract, scene.frame, triangles, options);
    return row;
  }

  const CyclesOptions& o_;
  const Output& output_;
  std::vector<CycleRow> rows_;
};

/// The worst of all rows. The default table allows no cycle of difference.
bool holds(const std::vector<CycleRow>& rows, bool exactly) {
  for (const CycleRow& r : rows) {
    if (r.point.error() > (exactly ? 0 : kGreatestError) || !r.point.same_frame) return false;
    if (exactly && r.point.retire.off != 0) return false;
  }
  return true;
}

int run(const CyclesOptions& given) {
  const CyclesOptions options = filled_in(given);
  const Output output(options);
  std::vector<std::string> left_out;
  const auto scenes = scenes_of(options, &left_out);
  const std::vector<CycleRow> rows = Table(options, output).run(scenes);

  const CycleMeans means = means_of(rows);
  const bool exactly =
      given.designs.empty() && given.latencies.empty() && given.stalls.empty() && !given.all;
  const bool it_holds = holds(rows, exactly);
  Json json{{"runs", options.runs}, {"seed", options.seed}, {"left_out", left_out}};
  for (const CycleRow& r : rows) json["rows"].push_back(row_json(r));
  if (means.rtl > 0) json["geometric_means"] = means_json(means);
  output.line("");
  for (const auto& name : left_out)
    output.line("Left out: {}, {} is not there", name, options.bunny);
  if (options.runs > 0) {
    output.line(
        "Speed in M cycles/s of one thread, the median of {} runs in CPU time; the RTL bare, "
        "without stalls alone",
        options.runs);
  }
  output.line("{}", it_holds ? fmt::format("It holds: {}.", exactly ? "not a cycle differs"
                                                                    : "no frame is off by .1 %")
                             : "IT DOES NOT HOLD.");
  print_means(output, means);
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
  command->add_option("--latency", options->latencies, "Cycles from a depth read to its data")
      ->delimiter(',')
      ->type_name("N");
  command->add_option("--stall", options->stalls, "Who stalls: none, source, sink or both")
      ->delimiter(',')
      ->check(
          CLI::IsMember(std::vector<std::string>(std::begin(kStallNames), std::end(kStallNames))))
      ->type_name("MODE");
  command->add_flag("--all", options->all,
                    "Every design, latencies 1, 8 and 64, every stall, unless given: hours");
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
      ->add_option("--bunny", options->bunny, "The scene bunny, 1920x1080 unless --size is given")
      ->type_name("FILE")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Of random scenes and of stalls")
      ->type_name("N")
      ->capture_default_str();
  add_output_options(command, options.get());
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
