// pineda needs: the smallest design that is right on a scene.
#include "cli/needs.h"

#include <memory>

#include "cli/needs_report.h"
#include "model/scene/resnap.h"
#include "model/scene/writers.h"
#include "model/spec/design_file.h"

namespace pineda::cli {
namespace {

constexpr const char* kAuto = "auto";

struct NeedsOptions : Options {
  studies::NeedsOptions needs;
  std::string out;
};

std::string not_found(const scene::Scene& scene, const studies::Needs& needs) {
  return fmt::format("{}: {} itself does not hold the limits on it: {}", scene.name,
                     needs.start.name, needs.of_start.broken(needs.limits));
}

/// What the design is in one line: its parameters that differ from the base's.
std::string differences(const spec::Design& design, const spec::Design& base) {
  std::string text;
  const auto of_base = spec::parameters(base);
  size_t i = 0;
  for (const auto& p : spec::parameters(design)) {
    if (p.value == of_base[i++].value) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", p.name, p.value);
  }
  return text;
}

int run(const NeedsOptions& options) {
  const std::string& out = options.out;
  require_ending("--out", out, {".toml"});
  studies::NeedsOptions needs_options = options.needs;
  const spec::Design base = needs_options.base = contract_of(options).design;
  require_of(options, base, spec::no_cycles_reason);
  const Output output(options);
  Progress progress(options);
  const scene::Scene scene = open(options, spec::contract(base), true);
  output.line("{}: {}x{}, from {}, depth within {} ulp, colour within {} LSB", scene.name,
              scene.frame.width, scene.frame.height, base.name, options.needs.depth_ulp,
              options.needs.color_lsb);
  studies::Needs needs;
  const double seconds =
      seconds_of([&] { needs = needs_of(scene, needs_options, false, &progress); });
  print_notes(output, scene);
  print_needs(output, needs, base);
  output.row("seconds", fmt::format("{:.2f}, {} designs judged", seconds, needs.judged_designs));
  if (!needs.found) {
    output.line("{}", not_found(scene, needs));
  } else if (out.empty()) {
    output.line("\n{}", needs_toml(needs, base));
  } else {
    scene::write_file(out, needs_toml(needs, base));
    output.row("written", out);
  }
  Json json = header_json(scene, spec::contract(base));
  json.update(needs_json(needs, base));
  json["seconds"] = seconds;
  json["input"] = input_json(scene.source->counters());
  output.json(json);
  return needs.found ? kHolds : kMismatch;
}

}  // namespace

studies::Needs needs_of(const scene::Scene& scene, const studies::NeedsOptions& options,
                        bool must_hold, Progress* progress) {
  studies::NeedsOptions with_progress = options;
  with_progress.progress = [progress](uint64_t designs, uint64_t triangles) {
    progress->update(fmt::format("design {}", designs).c_str(), triangles);
  };
  studies::Needs needs = studies::find_needs(scene, with_progress);
  progress->clear();
  if (must_hold && !needs.found) throw scene::InputError("--design auto", not_found(scene, needs));
  return needs;
}

Job open_job(const Options& options, Lack lack, bool multi_pass, const Output& output,
             Progress* progress) {
  Job job;
  if (options.design != kAuto) {
    job.contract = contract_of(options);
    require_of(options, job.contract.design, lack);
    job.scene = open(options, job.contract, multi_pass);
    return job;
  }
  studies::NeedsOptions needs_options;
  needs_options.base = kAutoBase;
  job.scene = open(options, spec::contract(needs_options.base), true);
  job.needs = needs_of(job.scene, needs_options, true, progress);
  const spec::Design& design = job.needs->design;
  output.line("--design auto: {} with {}; {} of {} bits", needs_options.base.name,
              differences(design, needs_options.base),
              grouped(static_cast<uint64_t>(job.needs->cost.total())),
              grouped(static_cast<uint64_t>(job.needs->base_cost.total())));
  require_of(options, design, lack);
  job.contract = spec::contract(design);
  job.scene.source->rewind();
  job.scene.source = std::make_unique<scene::SnappedSource>(
      job.contract, std::make_unique<scene::Unsnapped>(std::move(job.scene.source)));
  return job;
}

void print_notes(const Output& output, const Job& job) {
  if (!job.needs) return print_notes(output, job.scene);
  const auto warn = [&](const std::string& text) {
    output.warn(fmt::format("{}: {}", job.scene.name, text));
  };
  const auto& counters = job.scene.source->counters();
  for (const auto& text : job.scene.warnings) warn(text);
  for (const auto& text : scene::notes(job.needs->start, job.scene.frame, counters)) warn(text);
}

void allow_auto(CLI::App* command) {
  command->get_option("--design")
      ->description("Design point, see `pineda designs`; auto: what the scene needs")
      ->type_name("NAME|FILE.toml|auto");
}

void add_needs(CLI::App* program, int* exit_code) {
  auto options = std::make_shared<NeedsOptions>();
  auto* command = program->add_subcommand(
      "needs", "What a scene needs: the smallest design that is right at every sample of it");
  add_scene_options(command, options.get());
  command->get_option("--design")->description("Base, of which only what is needed is left");
  command
      ->add_option("--depth-ulp", options->needs.depth_ulp,
                   "Greatest error of a depth, in codes of the design's own depth")
      ->check(CLI::PositiveNumber)
      ->type_name("X")
      ->capture_default_str();
  command
      ->add_option("--color-lsb", options->needs.color_lsb,
                   "Greatest error of a colour; where the w of a triangle differ, against the "
                   "perspective-correct one")
      ->check(CLI::PositiveNumber)
      ->type_name("Y")
      ->capture_default_str();
  command->add_option("-o,--out", options->out, "File for the design, standard output unless given")
      ->type_name("FILE.toml");
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
