#include "studies/area/area.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pineda::studies {
namespace {

constexpr int kMostClocks = 4;
constexpr double kPrecision = 1.03;
constexpr int kLeastDelayPs = 10;

using Delays = std::map<std::string, int>;

/// What modules on paths slower than the clock may take: of each path's logic all shrink alike.
Delays shorter_delays(const std::vector<TimingPath>& paths, int clock_ps, const Delays& now) {
  Delays shorter;
  for (const TimingPath& path : paths) {
    if (path.ps <= clock_ps || path.ps <= path.fixed_ps) continue;
    const double share = std::max(0., clock_ps - path.fixed_ps) / (path.ps - path.fixed_ps);
    std::map<std::string, double> own;
    for (const PathPart& part : path.parts) own[part.module] += part.ps;
    for (const auto& [module, ps] : own) {
      const int delay = std::max(kLeastDelayPs, static_cast<int>(ps * share));
      if (delay >= now.at(module)) continue;
      const auto [place, is_new] = shorter.try_emplace(module, delay);
      place->second = std::min(place->second, delay);
    }
  }
  return shorter;
}

/// The fastest netlist that was found.
struct Best {
  double period_ps = std::numeric_limits<double>::max();
  Delays delays;
};

std::string unit_of(const std::string& path) {
  const std::string child = path.substr(0, path.find('.'));
  // FIFOs belong to their producers.
  if (child == "u_setup" || child == "u_prims") return "setup";
  if (child == "u_traversal" || child == "u_stamps" || child == "u_hierarchical_z") {
    return "traversal";
  }
  return child == "u_interp_ztest" ? "interp_ztest" : "top";
}

void add_up(const Synthesis& synthesis, const Technology& technology, AreaStudy* study) {
  double macros = 0;
  for (const auto& [path, name] : synthesis.instances(kTop)) {
    const SynthesizedModule& module = synthesis.modules().at(name);
    AreaPart part{path, name, unit_of(path), 0, 0, module.memory_bits, module.memory_words};
    for (const auto& [cell, count] : module.cells) {
      const LibertyCell& known = technology.liberty.cells().at(cell);
      part.area_um2 += count * known.area_um2;
      part.flip_flops += count * known.flip_flops;
    }
    UnitArea& unit = study->units[part.unit];
    unit.area_um2 += part.area_um2;
    unit.flip_flops += part.flip_flops;
    study->area_um2 += part.area_um2;
    study->flip_flops += part.flip_flops;
    study->memory_bits += part.memory_bits;
    if (part.memory_bits > 0) {
      macros += std::min(part.area_um2,
                         macro_area(technology.macros, part.memory_words, part.memory_bits));
    } else {
      study->area_without_memory_um2 += part.area_um2;
    }
    study->parts.push_back(part);
  }
  if (!technology.macros.empty() && study->memory_bits > 0) study->macro_area_um2 = macros;
}

}  // namespace

AreaStudy study_area(const spec::Contract& contract, const Technology& technology,
                     const AreaOptions& options, const ToolRuns& runs) {
  Synthesis synthesis(contract, technology, options.least_memory_bits, runs);
  AreaStudy study;
  int clock_ps = options.clock_ps > 0 ? options.clock_ps : technology.first_clock_ps;
  const int clocks = options.clock_ps > 0 ? 1 : kMostClocks;
  Delays delays = first_delays(synthesis, kTop, clock_ps);
  synthesis.map(delays);
  Best best;
  double failed_ps = 0;  // the slowest clock that failed
  while (true) {
    study.asked_ps.push_back(clock_ps);
    const auto paths = netlist_timings(synthesis, technology, runs, {kTop}, clock_ps).front().slow;
    if (paths.front().ps < best.period_ps) best = {paths.front().ps, delays};
    if (paths.front().ps > clock_ps) failed_ps = std::max<double>(failed_ps, clock_ps);
    if (static_cast<int>(study.asked_ps.size()) == clocks) break;
    // Nothing is known to fail: 15 % faster. Else between what failed and what was reached.
    const double next_ps =
        failed_ps == 0 ? best.period_ps * .85 : std::sqrt(failed_ps * best.period_ps);
    if (failed_ps > 0 && best.period_ps / failed_ps <= kPrecision) break;
    clock_ps = static_cast<int>(next_ps);
    const auto slow = netlist_timings(synthesis, technology, runs, {kTop}, clock_ps).front().slow;
    const Delays shorter = shorter_delays(slow, clock_ps, delays);
    if (shorter.empty()) break;
    for (const auto& [module, delay] : shorter) delays[module] = delay;
    synthesis.map(shorter);
  }
  synthesis.map(best.delays);
  std::vector<std::string> tops{kTop};
  tops.insert(tops.end(), std::begin(kUnits), std::end(kUnits));
  const auto timings = netlist_timings(synthesis, technology, runs, tops, clock_ps);
  study.slowest = timings.front().slow.front();
  add_up(synthesis, technology, &study);
  for (size_t i = 1; i < tops.size(); ++i) {
    UnitArea& unit = study.units[unit_name(tops[i])];
    unit.slowest = timings[i].slow.front();
    unit.through = timings[i].through;
  }
  return study;
}

}  // namespace pineda::studies
