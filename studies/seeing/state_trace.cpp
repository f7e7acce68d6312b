#include "studies/seeing/state_trace.h"

#include <fmt/format.h>

namespace pineda::studies {

using timing::Cause;
using timing::Cycle;
using timing::Fifo;
using timing::MemoryPort;
using timing::Unit;

namespace {

constexpr uint32_t kStarved = static_cast<uint32_t>(Cause::kStarved);
constexpr int kTriangleBits = 32;
constexpr int kLevelBits = 16;
// Stands for "never", for a port that has not moved yet.
constexpr Cycle kNever = -2;

}  // namespace

StateTrace::StateTrace(const Window& window, bool reads_depth)
    : window_(window), reads_depth_(reads_depth) {
  moved_.fill(kNever);
  for (size_t i = 0; i < timing::kUnits; ++i) {
    first_[2 * i] = {kStarved, true};
    first_[2 * i + 1] = {0, false};
  }
  last_ = first_;
}

void StateTrace::change(size_t signal, Cycle cycle, Value value) {
  Value& last = last_[signal];
  if (value.known == last.known && value.number == last.number) return;
  last = value;
  if (cycle <= window_.from) {
    first_[signal] = value;
  } else if (cycle < window_.until) {
    changes_.push_back({cycle, value.number, static_cast<uint8_t>(signal), value.known});
  }
}

void StateTrace::spent(Unit unit, Cause cause, Cycle from, Cycle until, uint32_t id) {
  units_[static_cast<size_t>(unit)].spans.add({cause, from, until, id}, window_,
                                              [&](const Span& span) { add(unit, span); });
}

void StateTrace::add(Unit unit, const Span& span) {
  const auto i = static_cast<size_t>(unit);
  if (units_[i].until < span.from) starve(unit, units_[i].id == span.id);
  change(2 * i, span.from, {static_cast<uint32_t>(span.cause), true});
  change(2 * i + 1, span.from, {span.id, true});
  units_[i].until = span.until;
  units_[i].id = span.id;
}

void StateTrace::starve(Unit unit, bool within_triangle) {
  const auto i = static_cast<size_t>(unit);
  change(2 * i, units_[i].until, {kStarved, true});
  if (!within_triangle) change(2 * i + 1, units_[i].until, {0, false});
}

void StateTrace::slot(Fifo fifo, Cycle inserted, Cycle freed) {
  const auto i = static_cast<size_t>(fifo);
  levels_[i].slot(inserted, freed, [&](Cycle cycle, int level) {
    change(kLevels + i, cycle, {static_cast<uint32_t>(level), true});
  });
  if (fifo == Fifo::kStamps && reads_depth_) move(MemoryPort::kDepthRead, freed);
}

void StateTrace::depth(Cycle cycle, const spec::DepthWrite&) {
  move(MemoryPort::kDepthWrite, cycle);
}

void StateTrace::color(Cycle cycle, const spec::ColorWrite&) {
  move(MemoryPort::kColorWrite, cycle);
}

void StateTrace::move(MemoryPort port, Cycle cycle) {
  const auto i = static_cast<size_t>(port);
  if (moved_[i] != kNever && moved_[i] + 1 < cycle) change(kPorts + i, moved_[i] + 1, {0, true});
  change(kPorts + i, cycle, {1, true});
  moved_[i] = cycle;
}

void StateTrace::finish(Cycle drained) {
  window_.until = std::max(window_.from, std::min(window_.until, drained));
  for (size_t i = 0; i < timing::kUnits; ++i) {
    const auto unit = static_cast<Unit>(i);
    units_[i].spans.finish([&](const Span& span) { add(unit, span); });
    starve(unit, false);
  }
  for (size_t i = 0; i < timing::kFifos; ++i) {
    levels_[i].finish([&](Cycle cycle, int level) {
      change(kLevels + i, cycle, {static_cast<uint32_t>(level), true});
    });
  }
  for (size_t i = 0; i < timing::kMemoryPorts; ++i) change(kPorts + i, moved_[i] + 1, {0, true});
  std::stable_sort(changes_.begin(), changes_.end(),
                   [](const Change& a, const Change& b) { return a.cycle < b.cycle; });
}

std::vector<Signal> StateTrace::signals() {
  std::vector<Signal> all;
  for (size_t i = 0; i < timing::kUnits; ++i) {
    const char* unit = timing::unit_name(static_cast<Unit>(i));
    all.push_back({unit, "state", 0});
    all.push_back({unit, "triangle", kTriangleBits});
  }
  for (size_t i = 0; i < timing::kFifos; ++i) {
    all.push_back({"fifos", timing::fifo_name(static_cast<Fifo>(i)), kLevelBits});
  }
  for (size_t i = 0; i < timing::kMemoryPorts; ++i) {
    all.push_back({"memory", timing::port_name(static_cast<MemoryPort>(i)), 1});
  }
  return all;
}

void StateTrace::write(Waveform* waveform) const {
  const std::vector<Signal> all = signals();
  const auto put = [&](size_t signal, Value value) {
    const auto bits = static_cast<size_t>(all[signal].bits);
    if (bits == 0) {
      waveform->value(signal, timing::cause_name(static_cast<Cause>(value.number)));
    } else if (!value.known) {
      waveform->value(signal, std::string(bits, 'x'));
    } else {
      waveform->value(signal, fmt::format("{:0{}b}", value.number, bits));
    }
  };
  waveform->cycle(window_.from);
  for (size_t i = 0; i < kSignals; ++i) put(i, first_[i]);
  Cycle now = window_.from;
  for (const Change& c : changes_) {
    if (c.cycle != now) waveform->cycle(now = c.cycle);
    put(c.signal, {c.number, c.known});
  }
  if (now < window_.until) waveform->cycle(window_.until);
}

std::string gtkwave_save(const std::string& file) {
  // Display flags of a row in GTKWave's save format.
  constexpr const char* kText = "@820";
  constexpr const char* kDecimal = "@24";
  constexpr const char* kSteps = "@8024";  // decimal, drawn as a curve of steps
  constexpr const char* kBit = "@28";
  std::string text = fmt::format("[dumpfile] \"{}\"\n", file);
  std::string group;
  for (const Signal& signal : StateTrace::signals()) {
    if (signal.scope != group) {
      if (!group.empty()) text += fmt::format("@1000200\n-{}\n", group);
      group = signal.scope;
      text += fmt::format("@800200\n-{}\n", group);
    }
    const char* look = signal.bits == 0               ? kText
                       : signal.bits == kTriangleBits ? kDecimal
                       : signal.bits == kLevelBits    ? kSteps
                                                      : kBit;
    const std::string range = signal.bits > 1 ? fmt::format("[{}:0]", signal.bits - 1) : "";
    text += fmt::format("{}\npineda.{}.{}{}\n", look, signal.scope, signal.name, range);
  }
  return text + fmt::format("@1000200\n-{}\n", group);
}

}  // namespace pineda::studies
