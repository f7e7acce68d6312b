#include "cli/report/seeing.h"

#include <CLI/CLI.hpp>

#include "cli/reserved_file.h"
#include "model/core/frame.h"
#include "model/scene/error.h"
#include "model/scene/writers.h"
#include "studies/seeing/heat_map.h"
#include "studies/seeing/state_trace.h"
#include "studies/seeing/timeline.h"

namespace pineda::cli {
namespace {

namespace fs = std::filesystem;

/// Tells several listeners the same.
class Listeners final : public timing::Listener {
 public:
  void add(timing::Listener* listener) { all_.push_back(listener); }
  bool empty() const { return all_.empty(); }

  void prim(timing::Cycle cycle, const spec::SetupPrim& prim) override {
    for (auto* one : all_) one->prim(cycle, prim);
  }
  void stamp(timing::Cycle cycle, const spec::Stamp& stamp) override {
    for (auto* one : all_) one->stamp(cycle, stamp);
  }
  void depth(timing::Cycle cycle, const spec::DepthWrite& write) override {
    for (auto* one : all_) one->depth(cycle, write);
  }
  void color(timing::Cycle cycle, const spec::ColorWrite& write) override {
    for (auto* one : all_) one->color(cycle, write);
  }
  void spent(timing::Unit unit, timing::Cause cause, timing::Cycle from, timing::Cycle until,
             uint32_t id) override {
    for (auto* one : all_) one->spent(unit, cause, from, until, id);
  }
  void slot(timing::Fifo fifo, timing::Cycle inserted, timing::Cycle freed) override {
    for (auto* one : all_) one->slot(fifo, inserted, freed);
  }

 private:
  std::vector<timing::Listener*> all_;
};

std::string save_file_of(const std::string& trace) {
  return fs::path(trace).replace_extension(".gtkw").string();
}

studies::Window window_of(const SeeingOptions& options) {
  studies::Window window;
  window.from = options.from;
  if (options.until) window.until = *options.until;
  return window;
}

std::string about(const Job& job) {
  Json json = header_json(job.scene, job.contract);
  json["time"] = "1 us is 1 cycle";
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

struct Seeing::Files {
  Files(const SeeingOptions& options, const Job& job_seen)
      : job(job_seen), window(window_of(options)) {
    if (!options.timeline.empty()) {
      timeline_file.emplace(options.timeline);
      timeline.emplace(timeline_file->file(), window, about(job));
      listeners.add(&*timeline);
    }
    if (!options.trace.empty()) {
      trace_file.emplace(options.trace);
      save_file.emplace(save_file_of(options.trace));
      trace.emplace(window, core::tests_depth(job.contract, job.scene.frame));
      listeners.add(&*trace);
    }
    if (!options.heat_map.empty()) {
      heat_map_file.emplace(options.heat_map);
      heat_map.emplace(job.contract, job.scene.frame, window);
      listeners.add(&*heat_map);
    }
  }

  Json end_timeline(const Output& output);
  Json end_trace(timing::Cycle drained, const Output& output);
  Json end_heat_map(const Output& output);

  const Job& job;
  studies::Window window;
  Listeners listeners;
  std::optional<ReservedFile> timeline_file, trace_file, save_file, heat_map_file;
  std::optional<studies::Timeline> timeline;
  std::optional<studies::StateTrace> trace;
  std::optional<studies::HeatMap> heat_map;
};

Json Seeing::Files::end_timeline(const Output& output) {
  timeline_file->keep(timeline->finish());
  output.row("timeline",
             fmt::format("{}: {} slices", timeline_file->path(), grouped(timeline->slices())));
  return {{"file", timeline_file->path()}, {"slices", timeline->slices()}};
}

Json Seeing::Files::end_trace(timing::Cycle drained, const Output& output) {
  trace->finish(drained);
  const bool fst = fs::path(trace_file->path()).extension() == ".fst";
  const auto signals = studies::StateTrace::signals();
  const auto waveform = fst ? studies::fst_waveform(trace_file->temporary(), signals)
                            : studies::vcd_waveform(trace_file->file(), signals);
  if (waveform != nullptr) trace->write(waveform.get());
  trace_file->keep(waveform != nullptr && waveform->finish());
  const std::string save = studies::gtkwave_save(fs::path(trace_file->path()).filename());
  save_file->keep(std::fwrite(save.data(), 1, save.size(), save_file->file()) == save.size());
  output.row("waveform", fmt::format("{}: {} changes; gtkwave {}", trace_file->path(),
                                     grouped(trace->changes()), save_file->path()));
  return {{"file", trace_file->path()},
          {"save_file", save_file->path()},
          {"changes", trace->changes()}};
}

Json Seeing::Files::end_heat_map(const Output& output) {
  const std::string path = heat_map_file->path();
  const auto picture = studies::heat_map_picture(*heat_map, job.contract, job.scene.frame);
  scene::write_rgb_png(heat_map_file->temporary(), picture.width, picture.height, picture.rgb);
  heat_map_file->keep(true);
  const auto hottest = heat_map->hottest();
  const int tile_px = 1 << job.contract.design.tile_log2;
  output.row("heat map", fmt::format("{}: {} tiles; {} cycles in the one at {},{} px", path,
                                     grouped(static_cast<uint64_t>(heat_map->touched())),
                                     grouped(static_cast<uint64_t>(hottest.cycles)),
                                     hottest.x * tile_px, hottest.y * tile_px));
  return {{"file", path},
          {"tiles", heat_map->touched()},
          {"cycles", heat_map->total()},
          {"hottest",
           {{"x", hottest.x * tile_px}, {"y", hottest.y * tile_px}, {"cycles", hottest.cycles}}}};
}

Seeing::Seeing(const SeeingOptions& options, const Job& job)
    : files_(std::make_unique<Files>(options, job)) {}

Seeing::~Seeing() = default;

timing::Listener* Seeing::listener() const {
  return files_->listeners.empty() ? nullptr : &files_->listeners;
}

void Seeing::finish(timing::Cycle drained, const Output& output, Json* json) {
  if (files_->timeline) (*json)["written"]["timeline"] = files_->end_timeline(output);
  if (files_->trace) (*json)["written"]["trace"] = files_->end_trace(drained, output);
  if (files_->heat_map) (*json)["written"]["heat_map"] = files_->end_heat_map(output);
}

void add_seeing_options(CLI::App* command, SeeingOptions* o, CLI::Option* bench) {
  const std::string seeing = "Seeing time (see docs/seeing-time.md)";
  command
      ->add_option("--timeline", o->timeline,
                   "Triangles and stalls of each unit, as Perfetto and chrome://tracing open them")
      ->type_name("FILE.json")
      ->excludes(bench)
      ->group(seeing);
  command
      ->add_option("--trace", o->trace,
                   "Waveform of unit states, FIFO levels and memory ports, with a .gtkw beside it")
      ->type_name("FILE.fst|.vcd")
      ->excludes(bench)
      ->group(seeing);
  command->add_option("--heat-map", o->heat_map, "Cycles by tile of the screen, a picture")
      ->type_name("FILE.png")
      ->excludes(bench)
      ->group(seeing);
  command->add_option("--from", o->from, "The first cycle seen")
      ->check(CLI::NonNegativeNumber)
      ->type_name("CYCLE")
      ->capture_default_str()
      ->group(seeing);
  command->add_option("--until", o->until, "The first cycle no longer seen; the end unless given")
      ->type_name("CYCLE")
      ->group(seeing);
}

void check_seeing_options(const SeeingOptions& o) {
  require_ending("--timeline", o.timeline, {".json"});
  require_ending("--trace", o.trace, {".fst", ".vcd"});
  require_ending("--heat-map", o.heat_map, {".png"});
  if (o.until && *o.until <= o.from) {
    throw UsageError(
        fmt::format("--until: expected a cycle after --from {}, got {}", o.from, *o.until));
  }
  const bool nothing = o.timeline.empty() && o.trace.empty() && o.heat_map.empty();
  if (nothing && (o.from != 0 || o.until)) {
    throw UsageError("--from, --until: expected with --timeline, --trace or --heat-map");
  }
}

}  // namespace pineda::cli
