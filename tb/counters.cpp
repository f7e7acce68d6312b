#include "tb/counters.h"

namespace pineda::tb {

Counters::Group::Group(const RtlUnit& top, const std::string& name)
    : port_(top.port(name)), first_(port_.bytes / sizeof(uint64_t)) {
  start();
}

void Counters::Group::start() { std::memcpy(first_.data(), port_.data, port_.bytes); }

uint64_t Counters::Group::now(size_t kind) const {
  return static_cast<const uint64_t*>(port_.data)[kind];
}

Counters::Counters(const RtlUnit& top)
    : drops_(top, "setup_drops"),
      tests_(top, "tiles_tests"),
      sent_(top, "stamps_sent"),
      passed_(top, "samples_passed"),
      failed_(top, "samples_failed") {
  for (const char* name : {"setup", "tiles", "stamps", "interp_ztest"}) {
    units_.emplace_back(top, std::string(name) + "_cycles");
  }
  for (const char* name : {"prims", "tiles", "stamps"}) {
    levels_.emplace_back(top, std::string(name) + "_levels");
  }
  const bool depth = top.contract().design.depth_test;
  for (const char* name : {"depth_read", "depth_write", "color_write"}) {
    if (depth || name == std::string("color_write")) {
      stalls_.emplace_back(top, std::string(name) + "_stalls");
    }
  }
}

void Counters::start() {
  for (auto* groups : {&units_, &levels_, &stalls_}) {
    for (Group& group : *groups) group.start();
  }
  for (Group* group : {&drops_, &tests_, &sent_, &passed_, &failed_}) group->start();
}

void Counters::read(timing::Cycle drained, timing::CycleCounters* spent,
                    core::FrameCounters* counters) const {
  spent->drained = drained;
  read_cycles(spent);
  read_work(spent, counters);
}

void Counters::read_cycles(timing::CycleCounters* spent) const {
  const auto cycles = [](uint64_t count) { return static_cast<timing::Cycle>(count); };
  for (size_t u = 0; u < timing::kUnits; ++u) {
    for (size_t c = 0; c < timing::kCauses; ++c) spent->units[u].spent[c] = cycles(units_[u][c]);
  }
  for (size_t f = 0; f < timing::kFifos; ++f) {
    for (size_t level = 0; level < levels_[f].kinds(); ++level) {
      spent->levels[f].push_back(cycles(levels_[f][level]));
    }
  }
  const size_t first = timing::kMemoryPorts - stalls_.size();
  for (size_t p = 0; p < stalls_.size(); ++p) spent->port_stalls[first + p] = cycles(stalls_[p][0]);
}

void Counters::read_work(timing::CycleCounters* spent, core::FrameCounters* counters) const {
  for (size_t cause = 0; cause < drops_.kinds(); ++cause) {
    counters->dropped[cause] = drops_[cause];
    counters->triangles += drops_[cause];
  }
  counters->tiles_tested = tests_[0] + tests_[1] + tests_[2] + tests_[3];
  counters->tiles_accepted = tests_[1];
  counters->tiles_rejected = tests_[2];
  counters->tiles_hidden = tests_[3];
  for (size_t samples = 0; samples < sent_.kinds(); ++samples) {
    spent->stamps_by_samples[samples] = sent_[samples];
    spent->samples_passed += samples * passed_[samples];
    spent->samples_failed += samples * failed_[samples];
    counters->stamps += sent_[samples];
    counters->fragments += samples * sent_[samples];
    if (samples > 0) counters->interpolated += passed_[samples];
  }
  counters->passed = spent->samples_passed;
}

}  // namespace pineda::tb
