#include "cli/report/cycles.h"

#include <algorithm>
#include <numeric>

namespace pineda::cli {
namespace {

using timing::Cause;
using timing::Cycle;
using timing::CycleCounters;

double percent(uint64_t part, uint64_t whole) {
  return 100. * static_cast<double>(part) / static_cast<double>(std::max<uint64_t>(1, whole));
}
double percent(Cycle part, Cycle whole) {
  return percent(static_cast<uint64_t>(part), static_cast<uint64_t>(whole));
}

double mean_level(const std::vector<Cycle>& levels) {
  Cycle cycles = 0;
  Cycle sum = 0;
  for (size_t level = 0; level < levels.size(); ++level) {
    cycles += levels[level];
    sum += static_cast<Cycle>(level) * levels[level];
  }
  return static_cast<double>(sum) / static_cast<double>(std::max<Cycle>(1, cycles));
}

void print_units(const Output& output, const CycleCounters& spent) {
  static constexpr const char* kTitles[timing::kUnits] = {"setup", "traversal, tiles",
                                                          "traversal, stamps", "interp_ztest"};
  output.line("  {:<22}{:>9}{:>11}{:>11}{:>11}{:>11}", "unit", "busy", "starved", "blocked",
              "hazard", "memory");
  for (size_t u = 0; u < timing::kUnits; ++u) {
    const timing::UnitCycles& c = spent.units[u];
    const auto share = [&](Cause cause) { return percent(c[cause], c.total()); };
    output.line("  {:<22}{:>7.2f} %{:>9.2f} %{:>9.2f} %{:>9.2f} %{:>9.2f} %", kTitles[u],
                share(Cause::kBusy), share(Cause::kStarved), share(Cause::kBlocked),
                share(Cause::kHazard), share(Cause::kMemory));
  }
}

void print_fifos(const Output& output, const CycleCounters& spent) {
  output.line("  {:<22}{:>9}{:>11}{:>11}{:>11}", "FIFO", "depth", "mean", "empty", "full");
  for (size_t f = 0; f < timing::kFifos; ++f) {
    const std::vector<Cycle>& levels = spent.levels[f];
    output.line("  {:<22}{:>9}{:>11.2f}{:>9.2f} %{:>9.2f} %",
                timing::fifo_name(static_cast<timing::Fifo>(f)), levels.size() - 1,
                mean_level(levels), percent(levels.front(), spent.drained),
                percent(levels.back(), spent.drained));
  }
}

void print_ports(const Output& output, const CycleCounters& spent, bool depth) {
  const auto stalls = [&](timing::MemoryPort port) {
    return grouped(static_cast<uint64_t>(spent.port_stalls[static_cast<size_t>(port)]));
  };
  std::string text;
  if (depth) {
    text = fmt::format("{} depth read, {} depth write, ", stalls(timing::MemoryPort::kDepthRead),
                       stalls(timing::MemoryPort::kDepthWrite));
  }
  output.row("port stalls", text + stalls(timing::MemoryPort::kColorWrite) + " colour write");
}

// Shares by covered samples, eight in a row; all are of one where a stamp is a sample.
void print_stamps(const Output& output, const CycleCounters& spent, size_t lanes) {
  const auto& by = spent.stamps_by_samples;
  const uint64_t stamps = std::accumulate(by.begin(), by.end(), uint64_t{0});
  if (lanes == 1) return;
  for (size_t first = 1; first <= lanes; first += 8) {
    const size_t last = std::min(first + 7, lanes);
    std::string text;
    for (size_t samples = first; samples <= last; ++samples) {
      text += fmt::format("{:>{}.1f}", percent(by[samples], stamps), samples == first ? 5 : 6);
    }
    output.row(fmt::format("stamps of {}-{} samples", first, last), text + " %");
  }
}

}  // namespace

void add_cycles(const CycleCounters& spent, bool depth_tests, Json* json) {
  (*json)["drained"] = spent.drained;
  for (size_t u = 0; u < timing::kUnits; ++u) {
    Json& unit = (*json)["units"][timing::unit_name(static_cast<timing::Unit>(u))];
    for (size_t c = 0; c < timing::kCauses; ++c) {
      unit[timing::cause_name(static_cast<Cause>(c))] = spent.units[u].spent[c];
    }
  }
  for (size_t f = 0; f < timing::kFifos; ++f) {
    (*json)["fifos"][timing::fifo_name(static_cast<timing::Fifo>(f))] = {
        {"levels", spent.levels[f]}, {"mean", mean_level(spent.levels[f])}};
  }
  for (size_t p = 0; p < timing::kMemoryPorts; ++p) {
    (*json)["port_stalls"][timing::port_name(static_cast<timing::MemoryPort>(p))] =
        spent.port_stalls[p];
  }
  (*json)["stamps_by_samples"] = spent.stamps_by_samples;
  if (!depth_tests) return;
  (*json)["depth_tests"] = {{"passed", spent.samples_passed}, {"failed", spent.samples_failed}};
}

void print_cycles(const Output& output, const spec::Contract& contract, const CycleCounters& spent,
                  bool depth_tests) {
  const bool depth = contract.design.depth_test;
  print_stamps(output, spent, static_cast<size_t>(contract.width.lanes));
  if (depth && !depth_tests) {
    output.row("depth tests", "not needed for the time, so not made; --bits makes them");
  } else if (depth) {
    output.row("depth tests", fmt::format("{} passed, {} failed", grouped(spent.samples_passed),
                                          grouped(spent.samples_failed)));
  }
  print_units(output, spent);
  print_fifos(output, spent);
  print_ports(output, spent, depth);
}

}  // namespace pineda::cli
