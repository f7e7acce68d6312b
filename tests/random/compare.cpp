#include "tests/random/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "model/scene/scene.h"
#include "model/timing/counted/counters.h"
#include "studies/cycles/child.h"
#include "tb/ready.h"
#include "tests/timing/support.h"

namespace pineda::test {
namespace {

Scene read(const spec::Contract& contract, const Trial& trial) {
  scene::Options options;
  options.seed = trial.bench.seed;
  if (!trial.size.empty()) {
    scene::Size size;
    if (std::sscanf(trial.size.c_str(), "%dx%d", &size.width, &size.height) != 2) return {};
    options.size = size;
  }
  const scene::Scene opened = scene::open_scene(contract, trial.scene, options);
  Scene scene;
  scene.frame = opened.frame;
  for (spec::Triangle t; opened.source->next(&t);) scene.triangles.push_back(t);
  return scene;
}

void set_time(const spec::Contract& contract, const Trial& trial, int late,
              timing::RasterTop* top) {
  const int latency = trial.bench.depth_latency_cycles + late;
  top->set_memory(
      memory::make_timing(trial.memory, contract, std::min(latency, spec::kMaxDepthLatencyCycles)));
  top->set_ready(tb::ready_of({trial.bench.stall_mode, trial.bench.seed}));
}

/// The first counter that differs, of those that both sides know.
std::string counter_that_differs(const std::vector<timing::NamedCount>& expected,
                                 const std::vector<timing::NamedCount>& got, bool knows_passed) {
  for (const auto& d : timing::counter_differences(got, expected)) {
    if (d.known == core::Known::kIfTested && !knows_passed) continue;
    return fmt::format("{}: expected {}, got {}", d.name, d.rtl, d.model);
  }
  return {};
}

std::string result_that_differs(const spec::Contract& contract, const timing::FrameResult& expected,
                                const timing::FrameResult& got, bool knows_passed) {
  if (expected.cycles != got.cycles) {
    return fmt::format("cycles: expected {}, got {}", expected.cycles, got.cycles);
  }
  return counter_that_differs(timing::counter_list(contract, expected),
                              timing::counter_list(contract, got), knows_passed);
}

std::string frame_that_differs(const core::FrameBuffer& expected, const core::FrameBuffer& got) {
  if (expected.depth != got.depth) return "depth of the frame";
  return expected.color != got.color ? "colour of the frame" : "";
}

/// The first counter that differs, of those that core and a frame in time share: hierarchical z
/// keeps some tiles from being walked, and so some stamps from being sent.
std::string core_that_differs(const core::FrameCounters& expected, const core::FrameCounters& got,
                              bool hidden) {
  for (const core::FrameCounter& row : core::kFrameCounters) {
    const bool of_triangles = row.is_drop() || row.member == &core::FrameCounters::triangles;
    const bool is_shared = of_triangles || row.known == core::Known::kIfTested || !hidden;
    if (is_shared && row.of(expected) != row.of(got)) return row.name;
  }
  return "";
}

void compare_modes(const spec::Contract& contract, const Trial& trial, int late, Found* found) {
  const Scene scene = read(contract, trial);
  core::Renderer core(contract, scene.frame);
  for (const spec::Triangle& t : scene.triangles) core.draw(t);
  found->compared = core.counters().fragments;
  timing::RasterTop top("top", contract);
  set_time(contract, trial, 0, &top);
  Record record;
  Recorder recorder(&record);
  const auto stamps = top.run(scene.frame, pull_from(scene), &recorder);
  const auto check = [&](const char* mode, const std::string& difference) {
    if (found->difference().empty() && !difference.empty()) {
      found->set(fmt::format("{}: {}", mode, difference));
    }
  };
  const auto check_core = [&](const char* mode, const timing::FrameResult& result) {
    check(mode, frame_that_differs(core.buffer(), top.buffer()));
    check(mode,
          core_that_differs(core.counters(), result.counters, contract.design.hierarchical_z));
  };
  check_core("stamps", stamps);
  set_time(contract, trial, late, &top);
  const auto tiles = top.run(scene.frame, pull_from(scene));
  check_core("tiles", tiles);
  check("tiles", result_that_differs(contract, stamps, tiles, true));
  Trial free = trial;
  free.bench.stall_mode = tb::StallMode::kNone;
  set_time(contract, free, late, &top);
  const auto bits = top.run(scene.frame, pull_from(scene));
  top.set_bits(false);
  const auto cycles = top.run(scene.frame, pull_from(scene));
  check("cycles alone", result_that_differs(contract, bits, cycles, cycles.knows_passed));
}

void compare_with_rtl(const spec::Contract& contract, const Trial& trial, const std::string& plugin,
                      int late, Found* found) {
  const Scene scene = read(contract, trial);
  std::optional<tb::RtlLibrary> library;
  if (plugin.empty()) {
    library.emplace(contract);
  } else {
    library.emplace(contract, plugin);
  }
  tb::BenchOptions options = trial.bench;
  options.memory = memory::make_timing(trial.memory, contract, options.depth_latency_cycles);
  tb::FrameBench bench(*library, options);
  timing::RasterTop top("top", contract);
  set_time(contract, trial, late, &top);
  Record expected;
  Record got;
  Recorder bench_recorder(&expected);
  Recorder model_recorder(&got);
  const auto rtl = bench.run(scene.frame, pull_from(scene), &bench_recorder);
  const auto model = top.run(scene.frame, pull_from(scene), &model_recorder);
  found->compared = expected.prims.size() + expected.stamps.size() + expected.depths.size() +
                    expected.colors.size();
  std::string text = difference(expected, got, true, contract);
  if (text.empty()) text = result_that_differs(contract, rtl, model, true);
  if (text.empty()) text = frame_that_differs(bench.buffer(), top.buffer());
  found->set(text);
}

}  // namespace

void Found::set(const std::string& difference) {
  const size_t size = std::min(difference.size(), text.size() - 1);
  std::copy_n(difference.begin(), size, text.begin());
  text[size] = '\0';
}

Found model_against_rtl(const spec::Contract& contract, const Trial& trial,
                        const std::string& plugin, int late) {
  return studies::in_child([&] {
    Found found;
    compare_with_rtl(contract, trial, plugin, late, &found);
    return found;
  });
}

Found model_against_itself(const spec::Contract& contract, const Trial& trial, int late) {
  return studies::in_child([&] {
    Found found;
    compare_modes(contract, trial, late, &found);
    return found;
  });
}

}  // namespace pineda::test
