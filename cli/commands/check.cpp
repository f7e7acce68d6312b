// pineda check: functional model, SystemC model and Verilated RTL on one scene, compared at every
// unit boundary, and judged by exact arithmetic.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/job.h"
#include "cli/models.h"
#include "cli/report/cycles.h"
#include "cli/report/judge.h"
#include "cli/report/memory_report.h"
#include "cli/report/needs_report.h"
#include "cli/report/pictures.h"
#include "cli/report/report.h"
#include "cli/triangles.h"
#include "tb/scoreboard.h"

namespace pineda::cli {
namespace {

struct CheckOptions : Options {
  std::string out;
};

/// Passes the triangles that a model pulls to its scoreboard, too. The scoreboard is never ahead of
/// the model, and at most kBehind triangles behind.
class Tee {
 public:
  static constexpr size_t kBehind = 4096;

  explicit Tee(ChunkedTriangles* triangles) : triangles_(triangles) {}
  bool pull(spec::Triangle* triangle, tb::Scoreboard* scoreboard) {
    if (!triangles_->next(triangle)) return false;
    pulled_.push_back(*triangle);
    if (pulled_.size() > kBehind) scoreboard->draw_ahead();
    return true;
  }
  bool follow(spec::Triangle* triangle) {
    if (pulled_.empty()) return false;
    *triangle = pulled_.front();
    pulled_.pop_front();
    return true;
  }

 private:
  ChunkedTriangles* triangles_;
  std::deque<spec::Triangle> pulled_;
};

/// Hands tokens on to a scoreboard and notes when triangles retire.
class Observer final : public timing::Listener {
 public:
  explicit Observer(tb::Scoreboard* to) : to_(*to) {}
  void prim(timing::Cycle cycle, const spec::SetupPrim& t) override { to_.prim(cycle, t); }
  void stamp(timing::Cycle cycle, const spec::Stamp& t) override { to_.stamp(cycle, t); }
  void depth(timing::Cycle cycle, const spec::DepthWrite& t) override {
    retired_.note(cycle, t.id);
    to_.depth(cycle, t);
  }
  void color(timing::Cycle cycle, const spec::ColorWrite& t) override {
    retired_.note(cycle, t.id);
    to_.color(cycle, t);
  }
  const std::vector<int64_t>& retired() const { return retired_.cycles(); }

 private:
  tb::Scoreboard& to_;
  studies::RetireCycles retired_;
};

/// Samples whose memories differ. The SystemC model does not count hits.
uint64_t differing_samples(const core::FrameBuffer& a, const core::FrameBuffer& b, bool with_hits) {
  uint64_t count = 0;
  const auto n = static_cast<size_t>(a.channels);
  for (size_t i = 0; i < a.depth.size(); ++i) {
    const auto color = a.color.begin() + static_cast<std::ptrdiff_t>(i * n);
    const bool same = a.depth[i] == b.depth[i] && (!with_hits || a.hits[i] == b.hits[i]) &&
                      std::equal(color, color + static_cast<std::ptrdiff_t>(n),
                                 b.color.begin() + static_cast<std::ptrdiff_t>(i * n));
    count += same ? 0 : 1;
  }
  return count;
}

/// Finishes the scoreboard and adds what it and the memories found.
Side conclude(const char* name, tb::Scoreboard* scoreboard, const core::FrameBuffer& reference,
              const core::FrameBuffer& got, bool with_hits) {
  scoreboard->finish();
  Side side;
  side.name = name;
  side.compared = scoreboard->compared();
  side.mismatches = scoreboard->mismatches();
  side.left_out = scoreboard->left_out();
  side.differing_samples = differing_samples(reference, got, with_hits);
  side.first_divergence = scoreboard->first_divergence();
  return side;
}

Side check_model(const scene::Scene& scene, const spec::Contract& contract, timing::RasterTop* top,
                 const core::FrameBuffer& reference, Progress* progress) {
  scene.source->rewind();
  ChunkedTriangles triangles(scene.source.get(), progress, "SystemC");
  Tee tee(&triangles);
  tb::Scoreboard scoreboard("SystemC", contract, scene.frame,
                            [&](spec::Triangle* t) { return tee.follow(t); });
  Observer observer(&scoreboard);
  timing::FrameResult result;
  const double seconds = seconds_of([&] {
    result = top->run(
        scene.frame, [&](spec::Triangle* t) { return tee.pull(t, &scoreboard); }, &observer);
  });
  Side side = conclude("SystemC", &scoreboard, reference, top->buffer(), false);
  side.frame = result;
  side.retired = observer.retired();
  side.seconds = seconds - triangles.load_seconds();
  return side;
}

Side check_rtl(const scene::Scene& scene, const tb::RtlLibrary& library,
               const tb::BenchOptions& options, const core::FrameBuffer& reference,
               Progress* progress) {
  scene.source->rewind();
  ChunkedTriangles triangles(scene.source.get(), progress, "RTL");
  Tee tee(&triangles);
  tb::Scoreboard scoreboard("RTL", library.contract(), scene.frame,
                            [&](spec::Triangle* t) { return tee.follow(t); });
  Observer observer(&scoreboard);
  tb::FrameBench bench(library, options);
  timing::FrameResult result;
  const double seconds = seconds_of([&] {
    result = bench.run(
        scene.frame, [&](spec::Triangle* t) { return tee.pull(t, &scoreboard); }, &observer);
  });
  Side side = conclude("RTL", &scoreboard, reference, bench.buffer(),
                       !library.contract().design.hierarchical_z);
  side.frame = result;
  side.retired = observer.retired();
  side.seconds = seconds - triangles.load_seconds();
  return side;
}

void compare_counters(const spec::Contract& contract, CheckResult* r) {
  const auto model = timing::counter_list(contract, r->model.frame);
  r->counters_compared = model.size();
  r->counters_differ =
      timing::counter_differences(model, timing::counter_list(contract, r->rtl.frame));
}

Json check_json(const CheckResult& r, const scene::Scene& scene, const spec::Contract& contract) {
  Json json = header_json(scene, contract);
  json["holds"] = r.holds();
  json["seconds"] = r.seconds;
  json["triangles"] = r.input.triangles;
  json["stamps"] = r.counters.stamps;
  json["fragments"] = r.counters.fragments;
  json["mismatches"] = r.mismatches();
  json["cycles"] = {
      {"model", r.model.frame.cycles}, {"rtl", r.rtl.frame.cycles}, {"error", r.cycle_error()}};
  json["retirement"] = retire_json(r.retire);
  json["first_retire_difference"] = difference_json(r.first_retire);
  json["counters_compared"] = r.counters_compared;
  json["counters_differ"] = Json::array();
  for (const auto& d : r.counters_differ) {
    json["counters_differ"].push_back({{"name", d.name}, {"model", d.model}, {"rtl", d.rtl}});
  }
  json["coverage"] = {{"missing", r.judgement.missing}, {"extra", r.judgement.extra}};
  json["depth"] = {{"max_ulp", r.judgement.max_depth_ulp},
                   {"bound_ulp", r.judgement.bounds.depth_ulp}};
  json["color"] = {{"max_lsb", r.judgement.max_color_lsb},
                   {"bound_lsb", r.judgement.bounds.attribute_lsb}};
  json["beyond_bounds"] = r.judgement.beyond;
  if (r.judgement.mesh) json["mesh"] = mesh_json(*r.judgement.mesh);
  for (const Side* side : {&r.model, &r.rtl}) {
    json["sides"][side->name] = {{"compared", side->compared},
                                 {"mismatches", side->mismatches},
                                 {"left_out", side->left_out},
                                 {"differing_samples", side->differing_samples},
                                 {"first_divergence", side->first_divergence},
                                 {"seconds", side->seconds}};
  }
  json["input"] = input_json(r.input);
  json["counters"] = counters_json(r.counters);
  add_cycles(contract, r.model.frame, &json);
  return json;
}

void print(const Output& output, const CheckResult& r, const spec::Contract& contract,
           const std::string& out) {
  print_counters(output, r.counters);
  print_cycles(output, contract, r.model.frame);
  for (const Side* side : {&r.model, &r.rtl}) {
    output.row(side->name, fmt::format("{} tokens compared, {} mismatches, {} samples differ",
                                       grouped(side->compared), grouped(side->mismatches),
                                       grouped(side->differing_samples)));
    if (side->left_out != 0) {
      output.row("  left out", fmt::format("{} stamps, hidden as hierarchical z saw in time",
                                           grouped(side->left_out)));
    }
    if (!side->first_divergence.empty()) output.row("  first divergence", side->first_divergence);
  }
  output.row("cycles", cycles_text(r));
  output.row("retirement", retire_text(r.retire));
  if (r.first_retire) {
    for (const auto& [name, value] : difference_rows(*r.first_retire)) output.row(name, value);
  }
  output.row("counters", counters_text(r));
  for (const auto& d : r.counters_differ) {
    output.row("  " + d.name, fmt::format("{} model, {} RTL", d.model, d.rtl));
  }
  output.row("coverage", fmt::format("{} samples missing, {} too many, by exact arithmetic",
                                     grouped(r.judgement.missing), grouped(r.judgement.extra)));
  output.row("depth error", depth_error_text(r.judgement));
  output.row("colour error", color_error_text(r.judgement));
  if (r.judgement.mesh) output.row("mesh", mesh_text(*r.judgement.mesh));
  if (r.judgement.beyond > 0) output.row("beyond their bounds", grouped(r.judgement.beyond));
  output.row("seconds", fmt::format("{:.2f} (SystemC {:.2f}, RTL {:.2f})", r.seconds,
                                    r.model.seconds, r.rtl.seconds));
  if (!out.empty()) {
    output.row("written", fmt::format("{}/color.png, depth.png, report.html, check.json", out));
  }
  output.line("{}", r.holds() ? "It holds." : "IT DOES NOT HOLD.");
}

int run(const CheckOptions& options) {
  const Output output(options);
  Progress progress(options);
  const Job job = open_job(options, spec::no_rtl_reason, true, output, &progress);
  const spec::Contract& contract = job.contract;
  const scene::Scene& scene = job.scene;
  const auto bench = bench_options(options, contract);
  const tb::RtlLibrary library(contract, [&](const std::string& text) { output.say(text); });
  const std::string state = scene::unusual_state(scene.frame);
  const std::string settings =
      fmt::format("cull {}, depth {}{}{}, {}, stalls {}, seed {}", spec::name_of(scene.frame.cull),
                  spec::name_of(scene.frame.depth), state.empty() ? "" : ", ", state,
                  memory_text(options, contract), options.stall, options.seed);
  output.line("{}: {}x{}, {}, {}", scene.name, scene.frame.width, scene.frame.height,
              contract.design.name, settings);

  const auto top = make_model(contract, bench);
  CheckResult result;
  core::Renderer reference(contract, scene.frame);
  result.seconds = seconds_of([&] {
    result.judgement = judge(scene, &reference, &progress);
    result.counters = reference.counters();
    result.model = check_model(scene, contract, top.get(), reference.buffer(), &progress);
    result.rtl = check_rtl(scene, library, bench, reference.buffer(), &progress);
    compare_counters(contract, &result);
  });
  result.input = scene.source->counters();
  result.retire = studies::retire_errors(result.model.retired, result.rtl.retired);
  result.first_retire =
      find_retire_difference({scene, library, bench, top.get(), &progress}, result.model.retired,
                             result.rtl.retired, options.out);
  progress.clear();
  print_notes(output, job);

  Json json = check_json(result, scene, contract);
  add_memory(&json, options, bench);
  if (job.needs) json["needs"] = needs_json(*job.needs, kAutoBase);
  if (!options.out.empty()) {
    write_pictures(options.out, picture_of(contract, reference.buffer()));
    scene::write_file(options.out + "/check.json", json.dump(2) + "\n");
    scene::write_file(options.out + "/report.html", report_html(result, scene, contract, settings));
  }
  print(output, result, contract, options.out);
  output.json(json);
  return result.holds() ? kHolds : kMismatch;
}

}  // namespace

void add_check(CLI::App* program, int* exit_code) {
  auto options = std::make_shared<CheckOptions>();
  auto* command = program->add_subcommand(
      "check", "Model, SystemC and RTL on one scene: every boundary compared bit for bit");
  add_scene_options(command, options.get());
  add_time_options(command, options.get());
  allow_auto(command);
  command->add_option("-o,--out", options->out, "Folder for the pictures and the report")
      ->type_name("DIR");
  command->callback([options, exit_code] { *exit_code = run(*options); });
}

}  // namespace pineda::cli
