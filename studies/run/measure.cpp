#include "studies/run/measure.h"

#include <fmt/format.h>

#include <chrono>

#include "model/judge/comparison.h"
#include "model/memory/layout.h"
#include "model/timing/raster_top.h"
#include "studies/area/area.h"
#include "studies/judge/scene_judge.h"
#include "studies/run/memory_parameters.h"

namespace pineda::studies {
namespace {

using Figures = std::vector<Figure>;

template <class Number>
void add(Figures* figures, const std::string& name, Number value) {
  figures->push_back({name, static_cast<double>(value)});
}

// ---- Of a frame

/// A frame that was timed, and the memory behind it.
struct TimedFrame {
  spec::Contract contract;
  spec::FrameState state;
  timing::FrameResult result;
  std::shared_ptr<memory::MemoryTiming> memory;
  double seconds = 0;
};

std::vector<spec::Triangle> all_of(scene::SnappedSource* source) {
  constexpr size_t kChunk = 2048;
  std::vector<spec::Triangle> all;
  for (size_t read = 1; read != 0;) {
    const size_t before = all.size();
    all.resize(before + kChunk);
    read = source->next_many(all.data() + before, kChunk);
    all.resize(before + read);
  }
  return all;
}

TimedFrame timed(const Study& study, const Task& task) {
  const spec::Contract contract = spec::contract(study.designs[task.design]);
  const scene::Scene scene = study.scenes[task.scene].open(contract, false);
  const auto triangles = all_of(scene.source.get());
  TimedFrame frame{
      contract, scene.frame, {}, make_memory(study.memories[task.memory], contract), 0};
  timing::RasterTop top("raster_top", contract);
  top.set_memory(frame.memory);
  // What is written is only known with every bit.
  top.set_bits(task.measures(Measure::kBandwidth));
  const auto start = std::chrono::steady_clock::now();
  frame.result = top.run(scene.frame, triangles);
  frame.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return frame;
}

Figures cycles_of(const TimedFrame& frame) {
  const core::FrameCounters& c = frame.result.counters;
  Figures figures;
  add(&figures, "cycles", frame.result.cycles);
  add(&figures, "width", frame.state.width);
  add(&figures, "height", frame.state.height);
  add(&figures, "triangles", c.triangles);
  add(&figures, "fragments", c.fragments);
  return figures;
}

// Every counter whose value is known without bits: the same figures whatever else was asked for.
Figures stalls_of(const TimedFrame& frame) {
  Figures figures;
  timing::for_each_counter(frame.contract, frame.result,
                           [&](const timing::Counter& row, auto count) {
                             if (row.known != core::Known::kIfTested)
                               add(&figures, row.name, count);
                           });
  return figures;
}

/// Bytes that go over the ports of an ideal memory: whole stamps.
void add_port_bytes(const TimedFrame& frame, Figures* figures) {
  const core::FrameCounters& c = frame.result.counters;
  const spec::Contract& contract = frame.contract;
  const auto stamp = [&](int sample_bytes) {
    return static_cast<uint64_t>(sample_bytes) * static_cast<uint64_t>(contract.width.lanes);
  };
  const bool reads = core::tests_depth(contract, frame.state);
  const bool writes = reads && frame.state.depth_write;
  add(figures, "bytes_read", reads ? c.stamps * stamp(memory::kDepthBytes) : 0);
  add(figures, "bytes_written",
      c.interpolated * (stamp(memory::color_bytes(contract.design)) +
                        (writes ? stamp(memory::kDepthBytes) : 0)));
}

void add_cache(const std::string& name, const memory::CacheCounters& cache,
               const memory::ChannelCounters& channel, Figures* figures) {
  const uint64_t accesses = cache.hits + cache.misses;
  add(figures, name + ".accesses", accesses);
  add(figures, name + ".misses", cache.misses);
  add(figures, name + ".write_backs", cache.write_backs);
  add(figures, name + ".busy", channel.busy);
  add(figures, name + ".row_hits", channel.row_hits);
  add(figures, name + ".row_misses", channel.row_misses);
  add(figures, name + ".row_conflicts", channel.row_conflicts);
}

/// Bytes between caches and DRAM: whole tiles.
void add_dram_bytes(const TimedFrame& frame, const memory::DramTiming& dram, Figures* figures) {
  const spec::Design& d = frame.contract.design;
  const auto tile = [&](int sample_bytes) {
    return static_cast<uint64_t>(sample_bytes) << (2 * d.tile_log2);
  };
  const uint64_t depth = tile(memory::kDepthBytes), color = tile(memory::color_bytes(d));
  const memory::CacheCounters &z = dram.depth_cache(), &c = dram.color_cache();
  add(figures, "bytes_read", z.misses * depth + c.misses * color);
  add(figures, "bytes_written", z.write_backs * depth + c.write_backs * color);
  add_cache("depth", z, dram.depth_channel(), figures);
  add_cache("color", c, dram.color_channel(), figures);
}

Figures bandwidth_of(const TimedFrame& frame) {
  Figures figures;
  if (const auto* dram = dynamic_cast<const memory::DramTiming*>(frame.memory.get())) {
    add_dram_bytes(frame, *dram, &figures);
  } else {
    add_port_bytes(frame, &figures);
  }
  return figures;
}

Figures host_speed_of(const TimedFrame& frame) {
  Figures figures;
  add(&figures, "seconds", frame.seconds);
  add(&figures, "cycles_per_second", static_cast<double>(frame.result.cycles) / frame.seconds);
  return figures;
}

// ---- Of a scene

Figures error_of(const Study& study, const Task& task) {
  const spec::Design& design = study.designs[task.design];
  const spec::Contract contract = spec::contract(design);
  const scene::Scene scene = study.scenes[task.scene].open(contract, true);
  Winners winners;
  scene_use(scene, contract, &winners);
  const SceneJudgement judged = judge_scene(scene, design, design.guard_bits, winners, {});
  const spec::ErrorBounds bounds = spec::error_bounds(design);
  Figures figures;
  add(&figures, "samples", judged.samples);
  add(&figures, "missing", judged.missing);
  add(&figures, "extra", judged.extra);
  add(&figures, "other_winner", judged.other_winner);
  if (design.depth_test) {
    add(&figures, "depth_max_ulp", judged.max_depth_ulp);
    add(&figures, "depth_bound_ulp", bounds.depth_ulp);
  }
  if (spec::channels(design) > 0) {
    add(&figures, "color_max_lsb", judged.max_color_lsb);
    add(&figures, "color_bound_lsb", bounds.attribute_lsb);
  }
  return figures;
}

// ---- Of a technology

Figures area_of(const AreaStudy& study) {
  Figures figures;
  add(&figures, "area_um2", study.area_um2);
  add(&figures, "area_without_memory_um2", study.area_without_memory_um2);
  if (study.macro_area_um2 >= 0) {
    add(&figures, "area_with_macros_um2", study.area_without_memory_um2 + study.macro_area_um2);
  }
  add(&figures, "flip_flops", study.flip_flops);
  add(&figures, "memory_bits", study.memory_bits);
  for (const auto& [name, unit] : study.units) {
    add(&figures, name + ".area_um2", unit.area_um2);
    add(&figures, name + ".flip_flops", unit.flip_flops);
  }
  return figures;
}

Figures timing_of(const AreaStudy& study) {
  Figures figures;
  add(&figures, "fmax_mhz", study.fmax_mhz());
  for (const auto& [name, unit] : study.units) {
    if (unit.slowest.ps > 0) add(&figures, name + ".fmax_mhz", unit.fmax_mhz());
  }
  return figures;
}

}  // namespace

std::vector<Row> measured(const Study& study, const Task& task, const std::string& made_by,
                          const std::function<void(const std::string&)>& say) {
  std::vector<Row> rows = task.rows;
  const auto fill = [&](Measure measure, const Figures& figures, const std::string& by) {
    for (Row& row : rows) {
      if (row.measure != spec::name_of(measure)) continue;
      row.figures = figures;
      row.made_by = by;
    }
  };
  switch (task.on) {
    case DependsOn::kFrame:
    case DependsOn::kMachine: {
      const TimedFrame frame = timed(study, task);
      fill(Measure::kCycles, cycles_of(frame), made_by);
      fill(Measure::kStalls, stalls_of(frame), made_by);
      fill(Measure::kBandwidth, bandwidth_of(frame), made_by);
      fill(Measure::kHostSpeed, host_speed_of(frame), made_by);
      break;
    }
    case DependsOn::kScene:
      fill(Measure::kError, error_of(study, task), made_by);
      break;
    case DependsOn::kTechnology: {
      const ToolRuns runs = area_tool_runs(say);
      const StudyTechnology& asked = study.technologies[task.technology];
      const Technology technology = read_technology(asked.name, asked.liberty);
      AreaOptions options;
      options.clock_ps = study.clock_ps;
      const AreaStudy area =
          study_area(spec::contract(study.designs[task.design]), technology, options, runs);
      const std::string by = fmt::format("{}; {}", made_by, fmt::join(runs.versions(), "; "));
      fill(Measure::kArea, area_of(area), by);
      fill(Measure::kTiming, timing_of(area), by);
      break;
    }
  }
  return rows;
}

}  // namespace pineda::studies
