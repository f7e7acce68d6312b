#include "model/timing/counted/counters.h"

#include <algorithm>
#include <stdexcept>

namespace pineda::timing {
namespace {

using core::RtlKinds;

RtlKinds kind(size_t number) { return {RtlKinds::Which::kOne, static_cast<int>(number)}; }

}  // namespace

FrameResult empty_result(const spec::Contract& contract) {
  FrameResult result;
  for (size_t f = 0; f < kFifos; ++f) {
    const int depth = fifo_depth(contract.design, static_cast<Fifo>(f));
    result.spent.levels[f].resize(static_cast<size_t>(depth) + 1);
  }
  return result;
}

Counter drained_row() {
  return {"drained", "/drained", "cycles", "until the whole pipeline is empty", "", {}};
}

Counter unit_row(Unit unit, Cause cause) {
  const std::string name = unit_name(unit);
  const std::string why = cause_name(cause);
  return {name + "." + why, "/units/" + name + "/" + why,
          "cycles",         std::string(unit_title(unit)) + ": " + cause_meaning(cause),
          name + "_cycles", kind(static_cast<size_t>(cause))};
}

Counter level_row(Fifo fifo, size_t level) {
  const std::string name = fifo_name(fifo);
  const std::string number = std::to_string(level);
  return {name + ".level_" + number,
          "/fifos/" + name + "/levels/" + number,
          "cycles",
          "that begin with " + number + " slots of the FIFO taken",
          name + "_levels",
          kind(level)};
}

Counter stall_row(MemoryPort port, bool has_depth) {
  const std::string name = port_name(port);
  const bool exists = has_depth || port == MemoryPort::kColorWrite;
  return {name + ".stalls",
          "/port_stalls/" + name,
          "cycles",
          "in which the port's offer is not taken",
          exists ? name + "_stalls" : "",
          kind(0)};
}

Counter stamps_row(size_t samples) {
  const std::string number = std::to_string(samples);
  return {"stamps_of_" + number + "_samples",
          "/stamps_by_samples/" + number,
          "stamps",
          "sent with " + number + " covered samples",
          "stamps_sent",
          kind(samples)};
}

Counter passed_row() {
  return {"samples_passed",           "/depth_tests/passed", "samples",
          "that pass the depth test", "samples_passed",      {RtlKinds::Which::kByNumber},
          core::Known::kIfTested};
}

Counter failed_row() {
  return {"samples_failed",           "/depth_tests/failed", "samples",
          "that fail the depth test", "samples_failed",      {RtlKinds::Which::kByNumber},
          core::Known::kIfTested};
}

Counter frame_row(const core::FrameCounter& row) {
  const std::string json = row.json();
  return {row.full_name(), json.empty() ? json : "/counters" + json,
          row.unit,        row.meaning,
          row.rtl,         row.kinds,
          row.known};
}

std::vector<NamedCount> counter_list(const spec::Contract& contract, const FrameResult& result) {
  std::vector<NamedCount> list;
  for_each_counter(contract, result, [&](const Counter& row, auto count) {
    list.push_back({row.name, static_cast<int64_t>(count), row.known});
  });
  return list;
}

std::vector<CounterDifference> counter_differences(const std::vector<NamedCount>& model,
                                                   const std::vector<NamedCount>& rtl) {
  const auto same_name = [](const NamedCount& a, const NamedCount& b) { return a.name == b.name; };
  if (!std::equal(model.begin(), model.end(), rtl.begin(), rtl.end(), same_name)) {
    throw std::invalid_argument("counters of two designs cannot be compared");
  }
  std::vector<CounterDifference> differences;
  for (size_t i = 0; i < model.size(); ++i) {
    if (model[i].count == rtl[i].count) continue;
    differences.push_back({model[i].name, model[i].count, rtl[i].count, model[i].known});
  }
  return differences;
}

}  // namespace pineda::timing
