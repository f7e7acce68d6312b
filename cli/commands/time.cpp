// pineda time: the SystemC cycle model alone.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands/sample.h"
#include "cli/models.h"
#include "cli/report/cycles.h"
#include "cli/report/memory_report.h"
#include "cli/report/seeing.h"
#include "cli/simd_option.h"
#include "cli/triangles.h"

namespace pineda::cli {
namespace {

struct TimeOptions : Options {
  bool bits = false;
  int bench = 0;
  SampleOptions sample;
  SeeingOptions seeing;
};

int run(const TimeOptions& options) {
  check_seeing_options(options.seeing);
  const Output output(options);
  Progress progress(options);
  const bool repeats = !options.sample.share.empty() && options.bench > 1;
  const Job job = open_job(options, spec::no_cycles_reason, repeats, output, &progress);
  const spec::Contract& contract = job.contract;
  const scene::Scene& scene = job.scene;
  const auto bench = bench_options(options, contract);
  const auto top = make_model(contract, bench);
  top->set_bits(options.bits);
  if (const auto plan = sample_plan(options.sample, job, output)) {
    run_sample(*plan, options, options.bench, job, top.get(), output);
    return kHolds;
  }

  Seeing seeing(options.seeing, job);
  timing::FrameResult result;
  const FrameSeconds seconds = frame_seconds(
      scene, options.bench, &progress, "timing",
      [&](const auto& from) { result = top->run(scene.frame, from, seeing.listener()); });
  progress.clear();
  print_notes(output, job);

  Json json = header_json(scene, contract);
  json["cycles"] = result.cycles;
  if (!options.sample.share.empty()) {
    add_whole(result.spent.drained, scene.source->counters().triangles, &json);
  }
  json["seconds"] = seconds.drawing;
  json["triangles"] = scene.source->counters().triangles;
  add_memory(&json, options, bench);
  json["input"] = input_json(scene.source->counters());
  json["bits"] = result.knows_passed;
  json["counters"] = counters_json(result.counters, result.knows_passed);
  add_cycles(contract, result, &json);
  output.line("{}: {}x{}, {}, {}", scene.name, scene.frame.width, scene.frame.height,
              contract.design.name, memory_text(options, contract));
  print_state(output, scene);
  output.row("cycles", grouped(static_cast<uint64_t>(result.cycles)));
  print_memory(output, bench);
  print_counters(output, result.counters, result.knows_passed);
  print_cycles(output, contract, result);
  output.row("seconds", fmt::format("{:.6f} ({:.2f} M cycles/s)", seconds.drawing,
                                    static_cast<double>(result.cycles) / seconds.drawing * 1e-6));
  report_stream(scene, seconds, output, &json);
  seeing.finish(result.spent.drained, output, &json);
  output.json(json);
  return kHolds;
}

}  // namespace

void add_time(CLI::App* program, int* exit_code) {
  auto options = std::make_shared<TimeOptions>();
  auto* command = program->add_subcommand("time", "The SystemC cycle model alone: cycles, stalls");
  add_scene_options(command, options.get());
  add_time_options(command, options.get());
  allow_auto(command);
  add_simd_option(command);
  command->add_flag("--bits", options->bits, "Compute every bit, not only what time depends on");
  auto* bench = command->add_option("--bench", options->bench, "Median seconds of N runs in memory")
                    ->check(CLI::Range(1, 1'000'000))
                    ->type_name("N");
  add_seeing_options(command, &options->seeing, bench);
  add_sample_options(command, &options->sample);
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
