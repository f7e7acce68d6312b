#include "cli/commands/sample.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <limits>

namespace pineda::cli {
namespace {

// The interval in whole cycles, rounded outward.
struct Interval {
  explicit Interval(const studies::CycleEstimate& estimate)
      : cycles(std::llround(estimate.cycles)),
        half_width(std::llround(std::ceil(estimate.half_width))),
        low(std::max<timing::Cycle>(0, cycles - half_width)),
        high(cycles + half_width) {}

  timing::Cycle cycles;
  timing::Cycle half_width;
  timing::Cycle low;
  timing::Cycle high;
};

uint64_t count_triangles(scene::SnappedSource* source) {
  if (const auto size = source->size()) return *size;
  const uint64_t triangles = source->skip(std::numeric_limits<uint64_t>::max());
  source->rewind();
  return triangles;
}

// Prints the notes that are known once the scene is opened: counts by triangle are known for the
// windows only.
void print_opening_notes(const Output& output, const Job& job) {
  scene::Counters counters;
  counters.rounded_slope = job.scene.source->counters().rounded_slope;
  const spec::Design& design = job.needs ? job.needs->start : job.contract.design;
  for (const auto& text : job.scene.warnings) {
    output.warn(fmt::format("{}: {}", job.scene.name, text));
  }
  for (const auto& text : scene::notes(design, job.scene.frame, counters)) {
    output.warn(fmt::format("{}: {}", job.scene.name, text));
  }
}

std::string refused_share(const std::string& text) {
  double share = 0;
  if (CLI::detail::lexical_cast(text, share) && share > 0 && share <= 1) return {};
  return fmt::format("expected a share of the triangles, above 0 and up to 1, got {}", text);
}

studies::SampleResult timed_sample(const studies::SamplePlan& plan, const Options& options,
                                   int runs, const Job& job, timing::RasterTop* top,
                                   double* seconds) {
  Progress progress(options);
  studies::SampleResult result;
  std::vector<double> all_seconds;
  for (int i = 0; i < runs; ++i) {
    if (i > 0) job.scene.source->rewind();
    all_seconds.push_back(seconds_of([&] {
      result = studies::sample_cycles(
          top, job.contract, job.scene.frame, job.scene.source.get(), plan, options.seed,
          [&](uint64_t triangles) { progress.update("sampling", triangles); });
    }));
  }
  *seconds = median(all_seconds);
  return result;
}

bool holds(const studies::SampleResult& result) {
  return result.estimate.windows_wanted <= result.windows.size();
}

// Warns where too few windows make the interval unreliable.
void warn_if_too_small(const studies::SampleResult& result, const Job& job, const Output& output) {
  if (holds(result)) return;
  output.warn(
      fmt::format("{}: --sample: {} windows are too few, since a few of them make much of the "
                  "cycles: {} are wanted for the interval to hold; a larger share, or the whole",
                  job.scene.name, result.windows.size(), grouped(result.estimate.windows_wanted)));
}

Json sample_json(const studies::SamplePlan& plan, const studies::SampleResult& result,
                 const Options& options, const Job& job) {
  const Interval interval(result.estimate);
  Json json = header_json(job.scene, job.contract);
  json["drained"] = interval.cycles;
  json["drained_low"] = interval.low;
  json["drained_high"] = interval.high;
  json["windows"] = result.windows.size();
  json["windows_wanted"] = result.estimate.windows_wanted;
  json["window_triangles"] = plan.window;
  json["warm_up_triangles"] = plan.warm_up;
  json["sampled_triangles"] = result.counted;
  json["simulated_triangles"] = result.simulated;
  json["triangles"] = plan.triangles;
  json["memory"] = options.memory;
  json["depth_latency_cycles"] = latency_of(options, job.contract);
  return json;
}

void print_sample(const Output& output, const studies::SamplePlan& plan,
                  const studies::SampleResult& result) {
  const Interval interval(result.estimate);
  const double share =
      100 * static_cast<double>(result.counted) / static_cast<double>(plan.triangles);
  output.row("cycles until drained",
             fmt::format("{} +- {}{} {} windows of {} triangles, {:.1f} % of the stream)",
                         grouped(static_cast<uint64_t>(interval.cycles)),
                         grouped(static_cast<uint64_t>(interval.half_width)),
                         holds(result) ? " (95 %," : " or more (too few:", result.windows.size(),
                         plan.window, share));
  output.row("triangles",
             fmt::format("{}, {} simulated with those that warm up, {} a window",
                         grouped(plan.triangles), grouped(result.simulated), plan.warm_up));
  output.row("counters", "left out: they would be those of the windows alone");
}

}  // namespace

void add_sample_options(CLI::App* command, SampleOptions* options) {
  auto* sample =
      command
          ->add_flag("--sample{0.02}", options->share,
                     "Estimate the cycles from windows; --sample=SHARE of the triangles instead of "
                     ".02, --seed for other windows")
          ->check(refused_share);
  for (const char* option : {"--bits", "--timeline", "--trace", "--heat-map"}) {
    sample->excludes(command->get_option(option));
  }
}

std::optional<studies::SamplePlan> sample_plan(const SampleOptions& options, const Job& job,
                                               const Output& output) {
  if (options.share.empty()) return std::nullopt;
  if (job.contract.design.hierarchical_z) {
    throw UsageError(fmt::format(
        "--sample: design {} has hierarchical z, whose time depends on the depth of every triangle",
        job.contract.design.name));
  }
  const uint64_t triangles = count_triangles(job.scene.source.get());
  const auto plan = studies::plan_sample(triangles, std::stod(options.share));
  if (!plan) {
    output.say(
        fmt::format("{}: --sample would run half of its {} triangles or more, so all are run",
                    job.scene.name, grouped(triangles)));
  }
  return plan;
}

void run_sample(const studies::SamplePlan& plan, const Options& options, int bench, const Job& job,
                timing::RasterTop* top, const Output& output) {
  double seconds = 0;
  const auto result = timed_sample(plan, options, std::max(1, bench), job, top, &seconds);
  print_opening_notes(output, job);
  warn_if_too_small(result, job, output);
  Json json = sample_json(plan, result, options, job);
  json["seconds"] = seconds;
  output.line("{}: {}x{}, {}, {}", job.scene.name, job.scene.frame.width, job.scene.frame.height,
              job.contract.design.name, memory_text(options, job.contract));
  print_state(output, job.scene);
  print_sample(output, plan, result);
  output.row("seconds", fmt::format("{:.6f}, reading included", seconds));
  output.json(json);
}

void add_whole(timing::Cycle drained, uint64_t triangles, Json* json) {
  (*json)["drained_low"] = drained;
  (*json)["drained_high"] = drained;
  (*json)["windows"] = 1;
  (*json)["windows_wanted"] = 1;
  (*json)["sampled_triangles"] = triangles;
  (*json)["simulated_triangles"] = triangles;
}

}  // namespace pineda::cli
