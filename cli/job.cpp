// Opens a scene for the design of the options, or for the one that it needs.
#include "cli/job.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "model/scene/resnap.h"
#include "model/spec/design_file.h"

namespace pineda::cli {
namespace {

constexpr const char* kAuto = "auto";

/// What the design is in one line: its parameters that differ from the base's.
std::string differences_text(const spec::Design& design, const spec::Design& base) {
  std::string text;
  for (const spec::Setting& s : spec::differences(design, base)) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", s.key, s.value);
  }
  return text;
}

}  // namespace

std::string not_found(const scene::Scene& scene, const studies::Needs& needs) {
  return fmt::format("{}: {} itself does not hold the limits on it: {}", scene.name,
                     needs.start.name, needs.of_start.broken(needs.limits));
}

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
              differences_text(design, needs_options.base),
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

}  // namespace pineda::cli
