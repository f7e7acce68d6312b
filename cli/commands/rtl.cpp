// pineda rtl: the Verilated RTL alone.
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "cli/job.h"
#include "cli/models.h"
#include "cli/report/cycles.h"
#include "cli/report/memory_report.h"
#include "cli/report/pictures.h"
#include "cli/reserved_file.h"
#include "cli/triangles.h"

namespace pineda::cli {
namespace {

constexpr const char* kDump = "/hits.u16, depth.u32, color.rgba";
constexpr const char* kDumpWithoutHits =
    "/depth.u32, color.rgba; no hits.u16: hierarchical z hides triangles";

struct RtlOptions : Options {
  std::string out;
  std::string dump;
  std::string trace;
  int bench = 0;
};

Json rtl_json(const RtlOptions& options, const tb::BenchOptions& bench, const Job& job,
              const timing::FrameResult& result, double seconds) {
  const scene::Counters& input = job.scene.source->counters();
  Json json = header_json(job.scene, job.contract);
  json["cycles"] = result.cycles;
  json["seconds"] = seconds;
  json["triangles"] = input.triangles;
  add_memory(&json, options, bench);
  json["stall"] = options.stall;
  json["input"] = input_json(input);
  json["counters"] = counters_json(result.counters);
  add_cycles(job.contract, result, &json);
  return json;
}

void begin_trace(const std::string& path, tb::FrameBench* bench,
                 std::optional<ReservedFile>* file) {
  if (path.empty()) return;
  file->emplace(path);
  if (bench->trace((*file)->temporary())) return;
  throw scene::InputError(path, "expected to write it, got: it cannot be opened");
}

int run(const RtlOptions& options) {
  require_ending("--trace", options.trace, {".fst"});
  const Output output(options);
  Progress progress(options);
  const bool multi_pass = options.bench > 0 && !options.dump.empty();
  const Job job = open_job(options, spec::no_rtl_reason, multi_pass, output, &progress);
  const spec::Contract& contract = job.contract;
  const scene::Scene& scene = job.scene;
  const auto bench_opts = bench_options(options, contract);
  const tb::RtlLibrary library(contract, [&](const std::string& text) { output.say(text); });
  auto bench = std::make_unique<tb::FrameBench>(library, bench_opts);
  std::optional<ReservedFile> trace;
  begin_trace(options.trace, bench.get(), &trace);

  timing::FrameResult result;
  const auto run_frame = [&](timing::Listener* listener) {
    return [&, listener](const tb::NextTriangle& next) {
      result = bench->run(scene.frame, next, listener);
    };
  };
  // Hits are counted by a listener that sees the stamps. So a dump needs a run with a listener,
  // which is slower and not the one that --bench times.
  timing::Listener looks;
  timing::Listener* const listener = options.dump.empty() ? nullptr : &looks;
  double seconds = 0;
  if (options.bench > 0) {
    seconds = frame_seconds(scene, options.bench, &progress, "RTL", run_frame(nullptr)).drawing;
  }
  if (options.bench == 0 || listener != nullptr) {
    if (options.bench > 0) scene.source->rewind();
    const double once = frame_seconds(scene, 0, &progress, "RTL", run_frame(listener)).drawing;
    if (options.bench == 0) seconds = once;
  }
  progress.clear();
  print_notes(output, job);

  scene::Frame frame = picture_of(contract, bench->buffer());
  // Stamps of hidden tiles are never sent, so their hits are unknown.
  if (contract.design.hierarchical_z) frame.hits.clear();
  bench.reset();  // closes the waveform
  if (trace) trace->keep(true);
  if (!options.out.empty()) write_pictures(options.out, frame);
  if (!options.dump.empty()) scene::write_dump(options.dump, frame);

  output.line("{}: {}x{}, {}, {}", scene.name, scene.frame.width, scene.frame.height,
              contract.design.name, memory_text(options, contract));
  print_state(output, scene);
  output.row("cycles", grouped(static_cast<uint64_t>(result.cycles)));
  print_memory(output, bench_opts);
  print_counters(output, result.counters);
  print_cycles(output, contract, result);
  output.row("seconds", fmt::format("{:.6f} ({:.2f} M cycles/s)", seconds,
                                    static_cast<double>(result.cycles) / seconds * 1e-6));
  if (!options.out.empty()) output.row("pictures", options.out + "/color.png, depth.png");
  if (!options.dump.empty()) {
    output.row("dump", options.dump + (frame.hits.empty() ? kDumpWithoutHits : kDump));
  }
  if (!options.trace.empty()) output.row("waveform", options.trace);
  output.json(rtl_json(options, bench_opts, job, result, seconds));
  return kHolds;
}

}  // namespace

void add_rtl(CLI::App* program, int* exit_code) {
  auto options = std::make_shared<RtlOptions>();
  auto* command =
      program->add_subcommand("rtl", "The Verilated RTL alone: cycles, dumps, waveform");
  add_scene_options(command, options.get());
  add_time_options(command, options.get());
  allow_auto(command);
  command->add_option("-o,--out", options->out, "Folder for color.png and depth.png")
      ->type_name("DIR");
  command->add_option("--dump", options->dump, "Folder for hits.u16, depth.u32 and color.rgba")
      ->type_name("DIR");
  auto* bench = command->add_option("--bench", options->bench, "Median seconds of N runs in memory")
                    ->check(CLI::Range(1, 1'000'000))
                    ->type_name("N");
  command->add_option("--trace", options->trace, "Waveform of the frame")
      ->type_name("FILE.fst")
      ->excludes(bench);
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
