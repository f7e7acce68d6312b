#include "model/timing/counter_list.h"

#include <algorithm>
#include <stdexcept>

namespace pineda::timing {
namespace {

class List {
 public:
  void add(std::string name, int64_t count) { list_.push_back({std::move(name), count}); }
  void add(std::string name, uint64_t count) { add(std::move(name), static_cast<int64_t>(count)); }
  std::vector<NamedCount> take() { return std::move(list_); }

 private:
  std::vector<NamedCount> list_;
};

void add_cycles(const CycleCounters& spent, List* list) {
  list->add("drained", spent.drained);
  for (size_t u = 0; u < kUnits; ++u) {
    for (size_t c = 0; c < kCauses; ++c) {
      list->add(
          std::string(unit_name(static_cast<Unit>(u))) + "." + cause_name(static_cast<Cause>(c)),
          spent.units[u].spent[c]);
    }
  }
  for (size_t f = 0; f < kFifos; ++f) {
    for (size_t level = 0; level < spent.levels[f].size(); ++level) {
      list->add(std::string(fifo_name(static_cast<Fifo>(f))) + ".level_" + std::to_string(level),
                spent.levels[f][level]);
    }
  }
  for (size_t p = 0; p < kMemoryPorts; ++p) {
    list->add(std::string(port_name(static_cast<MemoryPort>(p))) + ".stalls", spent.port_stalls[p]);
  }
}

void add_work(int lanes, const CycleCounters& spent, const core::FrameCounters& n, List* list) {
  for (int samples = 0; samples <= lanes; ++samples) {
    list->add("stamps_of_" + std::to_string(samples) + "_samples",
              spent.stamps_by_samples[static_cast<size_t>(samples)]);
  }
  list->add("samples_passed", spent.samples_passed);
  list->add("samples_failed", spent.samples_failed);
  list->add("triangles", n.triangles);
  list->add("dropped.none", n.dropped[0]);
  for (int cause = 1; cause < core::kDropCauses; ++cause) {
    std::string name = core::drop_name(static_cast<core::Drop>(cause));
    std::replace(name.begin(), name.end(), ' ', '_');
    list->add("dropped." + name, n.dropped[static_cast<size_t>(cause)]);
  }
  list->add("tiles_tested", n.tiles_tested);
  list->add("tiles_rejected", n.tiles_rejected);
  list->add("tiles_accepted", n.tiles_accepted);
  list->add("tiles_hidden", n.tiles_hidden);
  list->add("stamps", n.stamps);
  list->add("fragments", n.fragments);
  list->add("interpolated", n.interpolated);
  list->add("passed", n.passed);
}

}  // namespace

std::vector<NamedCount> counter_list(const spec::Contract& contract, const CycleCounters& spent,
                                     const core::FrameCounters& counters) {
  List list;
  add_cycles(spent, &list);
  add_work(contract.width.lanes, spent, counters, &list);
  return list.take();
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
    differences.push_back({model[i].name, model[i].count, rtl[i].count});
  }
  return differences;
}

}  // namespace pineda::timing
