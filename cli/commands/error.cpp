// pineda error: each design point and each baseline against exact arithmetic, and what it costs.
#include "studies/error/error.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>

#include "cli/report/judge.h"
#include "model/scene/writers.h"
#include "studies/cycles/model_cycles.h"
#include "studies/error/error_page.h"
#include "studies/error/error_pictures.h"
#include "studies/error/error_table.h"
#include "studies/judge/front_end.h"
#include "studies/judge/stated.h"

namespace pineda::cli {
namespace {

struct ErrorOptions : Options {
  std::string out;
  uint64_t every = 1;
  bool all_designs = true;
};

/// "high,med": the designs in this order, each once.
std::vector<spec::Design> designs_of(const ErrorOptions& options) {
  if (options.all_designs) return spec::designs();
  std::vector<spec::Design> designs;
  for (const std::string& name : CLI::detail::split(options.design, ',')) {
    Options one = options;
    one.design = name;
    designs.push_back(contract_of(one).design);
  }
  return designs;
}

constexpr const char* kCheckInstead =
    "pineda check judges one design on it and needs no room for the scene";

[[noreturn]] void refuse(const scene::Scene& scene, int64_t most, const std::string& what) {
  throw scene::InputError(scene.name,
                          fmt::format("expected at most {} {} in exact mode: --every N judges a "
                                      "part of them, and {}",
                                      grouped(static_cast<uint64_t>(most)), what, kCheckInstead));
}

std::vector<studies::SceneTriangle> load(const scene::Scene& scene, const ErrorOptions& options,
                                         const spec::Design& design, Progress* progress) {
  constexpr studies::ErrorLimits kLimits;
  if (int64_t{scene.frame.width} * scene.frame.height > kLimits.pixels) {
    throw scene::InputError(
        scene.name,
        fmt::format("expected a frame of at most {} pixels in exact mode, got {}x{}: {}",
                    grouped(static_cast<uint64_t>(kLimits.pixels)), scene.frame.width,
                    scene.frame.height, kCheckInstead));
  }
  std::vector<studies::SceneTriangle> triangles;
  studies::SceneTriangle triangle;
  for (uint64_t n = 0; scene.source->next(&triangle.snapped); ++n) {
    if (n % options.every != 0) continue;
    if (static_cast<int64_t>(triangles.size()) == kLimits.triangles) {
      refuse(scene, kLimits.triangles, "triangles");
    }
    triangle.screen = studies::stated(scene.source->screen());
    triangles.push_back(triangle);
    progress->update("loading", n);
  }
  if (triangles.empty()) {
    throw scene::InputError(scene.name, "expected at least one triangle to judge, got none");
  }
  if (studies::count_samples(triangles, scene.frame, design, kLimits.samples) > kLimits.samples) {
    refuse(scene, kLimits.samples, "covered samples");
  }
  return triangles;
}

/// Adds the cycles of the designs that have a cycle model.
void add_cycles(const std::vector<studies::SceneTriangle>& triangles, const scene::Scene& scene,
                const std::vector<spec::Design>& designs, Progress* progress,
                studies::ErrorStudy* study) {
  std::vector<spec::Triangle> snapped;
  for (const auto& t : triangles) snapped.push_back(t.snapped);
  for (size_t i = 0; i < designs.size(); ++i) {
    progress->update("cycles", i);
    if (!spec::no_cycles_reason(designs[i]).empty()) continue;
    study->subjects[i].cycles = static_cast<double>(
        studies::model_cycles(spec::contract(designs[i]), scene.frame, snapped));
  }
}

Json distribution_json(const studies::Distribution& d, const char* unit) {
  return {{fmt::format("max_{}", unit), d.max()},
          {fmt::format("p999_{}", unit), d.quantile(.999)},
          {fmt::format("rms_{}", unit), d.rms()},
          {"misrounded", d.misrounded()}};
}

Json subject_json(const studies::Subject& s, const studies::ErrorStudy& study) {
  const auto triangles = static_cast<double>(study.triangles);
  // Designs with other subpixel bits cover other samples.
  const uint64_t covered = s.is_design ? s.judged + s.missing : study.samples;
  const auto samples = static_cast<double>(std::max<uint64_t>(covered, 1));
  Json json{{"summary", s.summary},
            {"coverage", {{"missing", s.missing}, {"extra", s.extra}}},
            {"depth", distribution_json(s.depth, "ulp")},
            {"color", distribution_json(s.color, "lsb")}};
  if (s.bounds) {
    json["holds"] = s.holds();
    json["depth"]["bound_ulp"] = s.bounds->depth_ulp;
    json["color"]["bound_lsb"] = s.bounds->attribute_lsb;
  }
  if (s.judged_by_frame) json["judged_by_frame"] = true;
  json["seconds"] = s.seconds;
  json["triangles_per_second"] = triangles / s.seconds;
  json["samples_per_second"] = static_cast<double>(covered) / s.seconds;
  if (s.cycles) {
    json["cycles"] = {{"total", static_cast<uint64_t>(*s.cycles)},
                      {"per_triangle", *s.cycles / triangles},
                      {"per_sample", *s.cycles / samples}};
  }
  if (s.visited) {
    json["visited"] = {{"total", static_cast<uint64_t>(*s.visited)},
                       {"per_triangle", *s.visited / triangles},
                       {"per_sample", *s.visited / samples}};
  }
  return json;
}

Json error_json(const studies::ErrorStudy& study, const scene::Scene& scene, double seconds) {
  Json json{{"scene", scene.name}, {"width", study.width}, {"height", study.height}};
  json["cull"] = spec::name_of(scene.frame.cull);
  json["depth_func"] = spec::name_of(scene.frame.depth);
  const Json state = unusual_state_json(scene.frame);
  json.insert(state.begin(), state.end());
  json["seconds"] = seconds;
  json["triangles"] = scene.source->counters().triangles;
  json["judged_triangles"] = study.triangles;
  json["samples"] = study.samples;
  json["runs"] = study.runs;
  json["affine_lsb"] = study.affine_lsb;
  json["designs"] = Json::object();
  json["baselines"] = Json::object();
  for (const auto& s : study.subjects) {
    json[s.is_design ? "designs" : "baselines"][s.name] = subject_json(s, study);
  }
  json["input"] = input_json(scene.source->counters());
  return json;
}

void write_folder(const std::string& folder, const studies::ErrorStudy& study,
                  const scene::Scene& scene, const Json& json) {
  const studies::ErrorScale scale(study, studies::Quantity::kDepth);
  for (const auto& s : study.subjects) {
    scene::write_rgb_png(folder + "/" + studies::map_file(s), study.width, study.height,
                         studies::error_map_rgb(s.map, scale));
  }
  scene::write_file(folder + "/speed_error.svg", studies::speed_error_svg(study, scene.name));
  scene::write_file(folder + "/histogram.svg", studies::histogram_svg(study));
  scene::write_file(folder + "/error.json", json.dump(2) + "\n");
  scene::write_file(folder + "/report.html", studies::error_page(study, scene.name));
}

void print(const Output& output, const studies::ErrorStudy& study, const ErrorOptions& options,
           double seconds) {
  output.line("{} triangles, {} covered samples judged, hidden ones included\n",
              grouped(study.triangles), grouped(study.samples));
  for (const auto& line : studies::accuracy_table(study)) output.line("{}", line);
  output.line("");
  for (const auto& line : studies::speed_table(study)) output.line("{}", line);
  output.line("");
  if (study.affine_lsb > 0) {
    output.line(
        "Colours are judged as these designs interpolate them, affinely; perspective-correct ones "
        "lie up to {:.3g} LSB away.",
        study.affine_lsb);
  }
  output.row("seconds", fmt::format("{:.1f}; a frame's is the median of {}", seconds, study.runs));
  if (!options.out.empty()) {
    output.row("written", fmt::format("{}/report.html, speed_error.svg, histogram.svg, maps/, "
                                      "error.json",
                                      options.out));
  }
}

/// Groups designs with the same input formats, which are judged in one pass. Groups are in the
/// order of their first designs.
std::vector<std::vector<spec::Design>> by_format(const std::vector<spec::Design>& designs) {
  std::vector<std::vector<spec::Design>> groups;
  for (const spec::Design& d : designs) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) {
      return studies::same_formats(g.front(), d);
    });
    if (group == groups.end()) {
      groups.push_back({d});
    } else {
      group->push_back(d);
    }
  }
  return groups;
}

/// What was found wrong of a mesh before any design drew it.
using FrontEnd = std::optional<studies::MeshJudgement>;

studies::ErrorStudy study_group(const scene::Scene& scene, const ErrorOptions& options,
                                const std::vector<spec::Design>& designs, bool baselines,
                                Progress* progress, FrontEnd* front_end) {
  const auto triangles = load(scene, options, designs.front(), progress);
  if (scene.mesh && options.every == 1 && (!*front_end || (*front_end)->holds())) {
    *front_end = studies::judge_front_end(*scene.mesh, scene.frame, triangles, designs.front());
  }
  studies::ErrorOptions study_options;
  study_options.designs = designs;
  study_options.baselines = baselines;
  study_options.maps = !options.out.empty();
  study_options.progress = [&](const char* what, uint64_t done) { progress->update(what, done); };
  studies::ErrorStudy study = studies::study_errors(triangles, scene.frame, study_options);
  add_cycles(triangles, scene, designs, progress, &study);
  return study;
}

/// Puts another group's designs behind those of the first group, before the baselines.
void join(studies::ErrorStudy other, studies::ErrorStudy* study) {
  const auto baseline = std::find_if(study->subjects.begin(), study->subjects.end(),
                                     [](const studies::Subject& s) { return !s.is_design; });
  study->subjects.insert(baseline, std::make_move_iterator(other.subjects.begin()),
                         std::make_move_iterator(other.subjects.end()));
}

/// The raster state that the textbook algorithms do not have; empty: they can be judged.
std::string unknown_to_baselines(const spec::FrameState& frame) {
  std::string state = scene::unusual_state(frame);
  if (frame.depth > spec::DepthFunc::kOff) {
    state += fmt::format("{}depth {}", state.empty() ? "" : ", ", spec::name_of(frame.depth));
  }
  return state;
}

int run(const ErrorOptions& options) {
  const auto groups = by_format(designs_of(options));
  const Output output(options);
  Progress progress(options);
  const scene::Scene scene = open(options, spec::contract(groups.front().front()), false);
  output.line("{}: {}x{}", scene.name, scene.frame.width, scene.frame.height);
  print_state(output, scene);
  const std::string unknown = unknown_to_baselines(scene.frame);

  FrontEnd front_end;
  studies::ErrorStudy study;
  const double seconds = seconds_of([&] {
    study = study_group(scene, options, groups.front(), unknown.empty(), &progress, &front_end);
    for (size_t i = 1; i < groups.size(); ++i) {
      const scene::Scene again = open(options, spec::contract(groups[i].front()), false);
      join(study_group(again, options, groups[i], false, &progress, &front_end), &study);
    }
  });
  progress.clear();
  print_notes(output, scene);
  if (!unknown.empty()) {
    output.warn(fmt::format("{}: the textbook algorithms know no {}: they are left out", scene.name,
                            unknown));
  }

  const bool holds = study.holds() && (!front_end || front_end->holds());
  Json json = error_json(study, scene, seconds);
  json["holds"] = holds;
  if (front_end) json["mesh"] = mesh_json(*front_end);
  if (!options.out.empty()) write_folder(options.out, study, scene, json);
  print(output, study, options, seconds);
  if (front_end) output.row("mesh", mesh_text(*front_end));
  if (scene.mesh && !front_end) output.row("mesh", "not judged from clip space with --every");
  output.line("{}",
              holds ? "It holds: no design misses a sample or its bounds." : "IT DOES NOT HOLD.");
  output.json(json);
  return holds ? kHolds : kMismatch;
}

}  // namespace

void add_error(CLI::App* program, int* exit_code) {
  auto options = std::make_shared<ErrorOptions>();
  auto* command = program->add_subcommand(
      "error", "Every design point and every textbook baseline against exact arithmetic");
  add_scene_options(command, options.get());
  auto* design = command->get_option("--design");
  design->description("Only these design points, NAME,NAME..; all of them unless given");
  design->default_str("");
  command->add_option("--every", options->every, "Judge every Nth triangle only")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  command->add_option("-o,--out", options->out, "Folder for the page, the plots and the error maps")
      ->type_name("DIR");
  command->callback([options, exit_code, design] {
    options->all_designs = design->count() == 0;
    *exit_code = run(*options);
  });
}

}  // namespace pineda::cli
