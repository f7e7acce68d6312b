// pineda time: the SystemC cycle model alone.
#include <memory>

#include "cli/models.h"
#include "cli/needs.h"
#include "cli/triangles.h"

namespace pineda::cli {
namespace {

struct TimeOptions : Options {
  bool bits = false;
  int bench = 0;
};

Json cycles_json(const timing::UnitCycles& c) {
  return {{"busy", c.busy}, {"starved", c.starved}, {"blocked", c.blocked}, {"hazard", c.hazard}};
}

void print_unit(const Output& output, const char* name, const timing::UnitCycles& c) {
  const auto share = [&](timing::Cycle cycles) {
    return 100. * static_cast<double>(cycles) /
           static_cast<double>(std::max<int64_t>(1, c.total()));
  };
  output.line("  {:<22}{:>7.2f} % {:>8.2f} % {:>8.2f} % {:>7.2f} %", name, share(c.busy),
              share(c.starved), share(c.blocked), share(c.hazard));
}

int run(const TimeOptions& options) {
  const Output output(options);
  Progress progress(options);
  const Job job = open_job(options, spec::no_cycles_reason, false, output, &progress);
  const spec::Contract& contract = job.contract;
  const scene::Scene& scene = job.scene;
  const auto bench = bench_options(options, contract);
  const auto top = make_model(contract, bench);

  timing::FrameResult result;
  const double seconds =
      frame_seconds(scene, options.bench, &progress, "timing",
                    [&](timing::Pull pull) { result = top->run(scene.frame, std::move(pull)); });
  progress.clear();
  print_notes(output, job);

  Json json = header_json(scene, contract);
  json["cycles"] = result.cycles;
  json["seconds"] = seconds;
  json["triangles"] = scene.source->counters().triangles;
  json["depth_latency_cycles"] = bench.depth_latency_cycles;
  json["input"] = input_json(scene.source->counters());
  json["counters"] = counters_json(result.counters);
  json["units"] = {{"setup", cycles_json(result.setup)},
                   {"tiles", cycles_json(result.tiles)},
                   {"stamps", cycles_json(result.stamps)},
                   {"interp_ztest", cycles_json(result.interp_ztest)}};
  output.line("{}: {}x{}, {}, depth latency {} cycles", scene.name, scene.frame.width,
              scene.frame.height, contract.design.name, bench.depth_latency_cycles);
  print_state(output, scene);
  output.row("cycles", grouped(static_cast<uint64_t>(result.cycles)));
  print_counters(output, result.counters);
  output.line("  {:<22}{:>9} {:>10} {:>10} {:>9}", "unit", "busy", "starved", "blocked", "hazard");
  print_unit(output, "setup", result.setup);
  print_unit(output, "traversal, tiles", result.tiles);
  print_unit(output, "traversal, stamps", result.stamps);
  print_unit(output, "interp_ztest", result.interp_ztest);
  output.row("seconds", fmt::format("{:.6f} ({:.2f} M cycles/s)", seconds,
                                    static_cast<double>(result.cycles) / seconds * 1e-6));
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
  command->add_flag("--bits", options->bits,
                    "Compute every bit, not only what time depends on (this version always does)");
  command->add_option("--bench", options->bench, "Median seconds of N runs in memory")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("N");
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
