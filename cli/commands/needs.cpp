// pineda needs: the smallest design that is right on a scene.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/job.h"
#include "cli/report/needs_report.h"
#include "model/scene/writers.h"
#include "model/spec/design_file.h"

namespace pineda::cli {
namespace {

struct NeedsOptions : Options {
  studies::NeedsOptions needs;
  std::string out;
};

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
