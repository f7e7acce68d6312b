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
  const auto width = [](size_t cause) { return cause == 0 ? 9 : 11; };
  std::string head;
  for (size_t c = 0; c < timing::kCauses; ++c) {
    head += fmt::format("{:>{}}", timing::cause_name(static_cast<Cause>(c)), width(c));
  }
  output.line("  {:<22}{}", "unit", head);
  for (size_t u = 0; u < timing::kUnits; ++u) {
    const timing::UnitCycles& cycles = spent.units[u];
    std::string shares;
    for (size_t c = 0; c < timing::kCauses; ++c) {
      shares += fmt::format("{:>{}.2f} %", percent(cycles.spent[c], cycles.total()), width(c) - 2);
    }
    output.line("  {:<22}{}", timing::unit_title(static_cast<timing::Unit>(u)), shares);
  }
}

void print_fifos(const Output& output, const CycleCounters& spent) {
  output.line("  {:<22}{:>9}{:>11}{:>11}{:>11}", "FIFO", "depth", "mean", "empty", "full");
  for (size_t f = 0; f < timing::kFifos; ++f) {
    const std::vector<Cycle>& levels = spent.levels[f];
    if (levels.size() == 1) continue;  // the design has none
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

// Prints the shares of stamps by covered samples, eight in a row; nothing where a stamp is one
// sample.
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

void add_cycles(const spec::Contract& contract, const timing::FrameResult& result, Json* json) {
  timing::for_each_cycle_counter(contract, result.spent,
                                 [&](const timing::Counter& row, auto count) {
                                   if (row.known == core::Known::kIfTested && !result.knows_passed)
                                     return;
                                   (*json)[Json::json_pointer(row.json)] = count;
                                 });
  for (size_t f = 0; f < timing::kFifos; ++f) {
    (*json)["fifos"][timing::fifo_name(static_cast<timing::Fifo>(f))]["mean"] =
        mean_level(result.spent.levels[f]);
  }
  // Always as long as for the largest stamps of any design.
  Json& stamps = (*json)["stamps_by_samples"];
  while (stamps.size() < result.spent.stamps_by_samples.size()) stamps.push_back(0);
}

void print_cycles(const Output& output, const spec::Contract& contract,
                  const timing::FrameResult& result) {
  const CycleCounters& spent = result.spent;
  const bool depth = contract.design.depth_test;
  print_stamps(output, spent, static_cast<size_t>(contract.width.lanes));
  if (depth && !result.knows_passed) {
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
