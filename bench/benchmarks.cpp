// The units of the quick model, and beside them what this machine can do at most:
//   benchmarks [--simd NAME] [Google Benchmark's options]
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/limits.h"
#include "bench/scenes.h"
#include "cli/simd_option.h"
#include "model/fast/band_renderer.h"
#include "model/fast/level.h"
#include "model/fast/renderer.h"
#include "model/fast/setup.h"

namespace pineda::bench {
namespace {

using benchmark::Counter;
using benchmark::State;

constexpr const char* kDesign = "high_tile";
constexpr size_t kCodeBytes = 4;                  // of a depth, of a colour
constexpr size_t kBufferBytes = size_t{1} << 28;  // far more than caches hold

const spec::Contract& contract() {
  static const spec::Contract value = spec::contract(*spec::find_design(kDesign));
  return value;
}

// The triangles of one scene; those of the last one stay in memory.
const fast::TriangleList& triangles_in_memory(const std::string& scene) {
  static std::string name;
  static fast::TriangleList triangles(contract(), frame_state());
  if (name != scene) {
    triangles = fast::TriangleList(contract(), frame_state());
    triangles = snapped(contract(), triangles_of(contract(), scene));
    name = scene;
  }
  return triangles;
}

// A counter of the time that one of those takes of which every iteration has so many.
Counter time_of_one(uint64_t count) {
  return {static_cast<double>(count), Counter::kIsIterationInvariantRate | Counter::kInvert};
}

void set_items(State* state, uint64_t items, uint64_t bytes) {
  const auto iterations = static_cast<int64_t>(state->iterations());
  state->SetItemsProcessed(iterations * static_cast<int64_t>(items));
  state->SetBytesProcessed(iterations * static_cast<int64_t>(bytes));
}

void measure_clear(State& state) {
  fast::Renderer renderer(contract(), frame_state(), {}, fast::Renderer::Hits::kUncounted);
  for ([[maybe_unused]] auto _ : state) {
    renderer.clear();
    benchmark::ClobberMemory();
  }
  const uint64_t samples = uint64_t{kWidth} * kHeight;
  set_items(&state, samples, samples * 2 * kCodeBytes);
}

void measure_setup(State& state, const std::string& scene) {
  const auto& triangles = triangles_in_memory(scene);
  const fast::SetupLanes lanes(contract(), frame_state());
  fast::PrimGroup prims;
  std::array<uint64_t, core::kDropCauses> drops{};
  for ([[maybe_unused]] auto _ : state) {
    for (const fast::TriangleGroup& group : triangles.groups()) {
      fast::set_up(lanes, group, fast::kGroup, ~0U, &prims, &drops);
      benchmark::DoNotOptimize(&prims);
      benchmark::ClobberMemory();
    }
  }
  set_items(&state, triangles.size(), triangles.groups().size() * sizeof(fast::TriangleGroup));
  state.counters["triangle"] = time_of_one(triangles.size());
}

// Setup and drawing, without the clear. Bytes: triangles and the depths of covered samples that are
// read, depths and colours of those that pass.
void measure_draw(State& state, const std::string& scene) {
  const auto& triangles = triangles_in_memory(scene);
  fast::Renderer renderer(contract(), frame_state(), {}, fast::Renderer::Hits::kUncounted);
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    renderer.clear();
    state.ResumeTiming();
    renderer.draw(triangles);
    benchmark::ClobberMemory();
  }
  const core::FrameCounters counters = renderer.counters();
  const uint64_t read =
      triangles.groups().size() * sizeof(fast::TriangleGroup) + counters.fragments * kCodeBytes;
  set_items(&state, triangles.size(), read + counters.passed * 2 * kCodeBytes);
  state.counters["triangle"] = time_of_one(triangles.size());
  state.counters["sample"] = time_of_one(counters.fragments);
}

// Setup and drawing by some threads: from beginning to end, and of all processors together.
void measure_threads(State& state, const std::string& scene, int threads) {
  const auto& triangles = triangles_in_memory(scene);
  fast::BandRenderer renderer(contract(), frame_state(), threads, fast::Renderer::Hits::kUncounted);
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    renderer.clear();
    state.ResumeTiming();
    renderer.draw(triangles);
    benchmark::ClobberMemory();
  }
  set_items(&state, triangles.size(), triangles.groups().size() * sizeof(fast::TriangleGroup));
}

void measure_fill(State& state) {
  std::vector<uint8_t> to(kBufferBytes, 1);
  int value = 0;
  for ([[maybe_unused]] auto _ : state) {
    std::memset(to.data(), ++value & 0xff, to.size());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<int64_t>(state.iterations() * kBufferBytes));
}

// Bytes that are read and bytes that are written.
void measure_copy(State& state) {
  const std::vector<uint8_t> from(kBufferBytes, 1);
  std::vector<uint8_t> to(kBufferBytes, 2);
  for ([[maybe_unused]] auto _ : state) {
    std::memcpy(to.data(), from.data(), to.size());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(static_cast<int64_t>(state.iterations() * 2 * kBufferBytes));
}

void measure_words(State& state) {
  uint64_t factor = 3;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(factor);
    benchmark::DoNotOptimize(multiply_words(factor));
  }
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * kWordProducts));
}

void measure_lanes(State& state) {
  uint32_t factor = 3;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(factor);
    benchmark::DoNotOptimize(multiply_lanes(factor));
  }
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * lane_products()));
}

void register_all() {
  using benchmark::RegisterBenchmark;
  RegisterBenchmark("limit/fill", measure_fill)->Unit(benchmark::kMillisecond);
  RegisterBenchmark("limit/copy", measure_copy)->Unit(benchmark::kMillisecond);
  RegisterBenchmark("limit/products_64_bits", measure_words);
  RegisterBenchmark("limit/products_32_bits_in_vectors", measure_lanes);
  RegisterBenchmark("clear", measure_clear)->Unit(benchmark::kMillisecond);
  for (const std::string& scene : scene_names()) {
    const std::string file = file_of(scene);
    if (!file.empty() && !std::filesystem::exists(file)) {
      fmt::print(stderr, "{} is left out: there is no {}\n", scene, file);
      continue;
    }
    RegisterBenchmark(("setup/" + scene).c_str(), measure_setup, scene)
        ->Unit(benchmark::kMillisecond);
    RegisterBenchmark(("draw/" + scene).c_str(), measure_draw, scene)
        ->Unit(benchmark::kMillisecond);
    for (const int threads : {1, 2, 4, 8, 16}) {
      const std::string name = fmt::format("threads/{}/{}", scene, threads);
      RegisterBenchmark(name.c_str(), measure_threads, scene, threads)
          ->Unit(benchmark::kMillisecond)
          ->MeasureProcessCPUTime()
          ->UseRealTime();
    }
  }
}

// What is not --simd is for Google Benchmark.
int run(int argc, char** argv) {
  CLI::App program("", "benchmarks");
  program.set_help_flag();
  program.allow_extras();
  cli::add_simd_option(&program);
  program.parse(argc, argv);
  const auto* simd = program.get_option("--simd");
  const std::string best = fast::level_name(fast::levels().back());
  benchmark::AddCustomContext("vector unit", simd->count() > 0 ? simd->results().front() : best);
  std::vector<std::string> rest = program.remaining();
  std::vector<char*> arguments{argv[0]};
  for (std::string& argument : rest) arguments.push_back(argument.data());
  int count = static_cast<int>(arguments.size());
  register_all();
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace
}  // namespace pineda::bench

int main(int argc, char** argv) {
  try {
    return pineda::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "benchmarks: %s\n", error.what());
  }
  return 2;
}
