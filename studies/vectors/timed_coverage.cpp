#include "studies/vectors/timed_coverage.h"

#include "tb/ready.h"

namespace pineda::vectors {

using timing::Cause;
using timing::Cycle;
using timing::Fifo;
using timing::MemoryPort;

namespace {

constexpr auto kHazard = static_cast<size_t>(Cause::kHazard);
constexpr auto kMemory = static_cast<size_t>(Cause::kMemory);

std::string name_of_fifo(size_t fifo) { return timing::fifo_name(static_cast<Fifo>(fifo)); }
std::string name_of_unit(size_t unit) { return timing::unit_name(static_cast<timing::Unit>(unit)); }

// ---- What each unit does in a cycle

std::string never(const spec::Design& design, size_t unit, size_t cause) {
  const bool has_memory = static_cast<timing::Unit>(unit) == timing::Unit::kInterpZtest;
  if (!has_memory && (cause == kHazard || cause == kMemory)) return "the unit reads no memory";
  if (!design.depth_test && (cause == kHazard || cause == kMemory)) {
    return "the design reads no depth";
  }
  return "";
}

Bins causes(const spec::Contract& c) {
  Bins bins;
  for (size_t unit = 0; unit < timing::kUnits; ++unit) {
    for (size_t cause = 0; cause < timing::kCauses; ++cause) {
      bins.push_back({name_of_unit(unit) + ", " + timing::cause_name(static_cast<Cause>(cause)),
                      never(c.design, unit, cause)});
    }
  }
  return bins;
}
void see_causes(const SeenTimedFrame& s, Hits* hits) {
  for (size_t unit = 0; unit < timing::kUnits; ++unit) {
    for (size_t cause = 0; cause < timing::kCauses; ++cause) {
      if (s.result.spent.units[unit].spent[cause] > 0) hits->add(unit * timing::kCauses + cause);
    }
  }
}

// ---- Levels of the FIFOs, from empty to full

Bins levels(const spec::Contract& c) {
  Bins bins;
  for (size_t fifo = 0; fifo < timing::kFifos; ++fifo) {
    const int depth = timing::fifo_depth(c.design, static_cast<Fifo>(fifo));
    for (int level = 0; level <= depth && depth > 0; ++level) {
      bins.push_back({fmt::format("{}, {} of {}", name_of_fifo(fifo), level, depth), ""});
    }
  }
  return bins;
}
void see_levels(const SeenTimedFrame& s, Hits* hits) {
  size_t bin = 0;
  for (size_t fifo = 0; fifo < timing::kFifos; ++fifo) {
    const int depth = timing::fifo_depth(s.contract.design, static_cast<Fifo>(fifo));
    for (int level = 0; level <= depth && depth > 0; ++level, ++bin) {
      if (s.result.spent.levels[fifo][static_cast<size_t>(level)] > 0) hits->add(bin);
    }
  }
}

// ---- Ports

std::vector<size_t> ports_of(const spec::Contract& c) {
  if (!c.design.depth_test) return {static_cast<size_t>(MemoryPort::kColorWrite)};
  std::vector<size_t> all;
  for (size_t port = 0; port < timing::kMemoryPorts; ++port) all.push_back(port);
  return all;
}
Bins stalled_ports(const spec::Contract& c) {
  Bins bins;
  for (const size_t port : ports_of(c)) {
    bins.push_back({timing::port_name(static_cast<MemoryPort>(port)), ""});
  }
  return bins;
}
void see_stalled_ports(const SeenTimedFrame& s, Hits* hits) {
  const std::vector<size_t> ports = ports_of(s.contract);
  for (size_t i = 0; i < ports.size(); ++i) {
    if (s.result.spent.port_stalls[ports[i]] > 0) hits->add(i);
  }
}

// ---- Resets on the way

Bins at_reset(const spec::Contract& c) {
  Bins bins;
  for (size_t unit = 0; unit < timing::kUnits; ++unit) {
    bins.push_back({name_of_unit(unit) + " works", ""});
  }
  for (size_t fifo = 0; fifo < timing::kFifos; ++fifo) {
    if (timing::fifo_depth(c.design, static_cast<Fifo>(fifo)) == 0) continue;
    bins.push_back({name_of_fifo(fifo) + " are in their FIFO", ""});
  }
  bins.push_back({"a colour is written", ""});
  if (c.design.depth_test) bins.push_back({"a depth is written", ""});
  return bins;
}
void see_at_reset(const SeenTimedFrame& s, Hits* hits) {
  for (size_t unit = 0; unit < timing::kUnits; ++unit) {
    if (s.works_at_reset[unit]) hits->add(unit);
  }
  size_t bin = timing::kUnits;
  for (size_t fifo = 0; fifo < timing::kFifos; ++fifo) {
    if (timing::fifo_depth(s.contract.design, static_cast<Fifo>(fifo)) == 0) continue;
    if (s.holds_at_reset[fifo]) hits->add(bin);
    ++bin;
  }
  if (s.writes_color_at_reset) hits->add(bin);
  if (s.writes_depth_at_reset) hits->add(bin + 1);
}

// ---- Tiles behind what is drawn

Bins hidden_tiles(const spec::Contract& c) {
  return where(c.design.hierarchical_z, named({"a tile is hidden", "none is"}));
}
void see_hidden_tiles(const SeenTimedFrame& s, Hits* hits) {
  hits->add(s.result.counters.tiles_hidden > 0 ? 0 : 1);
}

/// What is under way in the cycle of the reset.
class AtReset : public timing::Listener {
 public:
  AtReset(Cycle cycle, SeenTimedFrame* seen) : cycle_(cycle), seen_(seen) {}

  void spent(timing::Unit unit, Cause, Cycle from, Cycle until, uint32_t) override {
    if (from <= cycle_ && cycle_ < until) seen_->works_at_reset[static_cast<size_t>(unit)] = true;
  }
  void depth(Cycle cycle, const spec::DepthWrite&) override {
    if (cycle == cycle_) seen_->writes_depth_at_reset = true;
  }
  void color(Cycle cycle, const spec::ColorWrite&) override {
    if (cycle == cycle_) seen_->writes_color_at_reset = true;
  }
  void slot(Fifo fifo, Cycle inserted, Cycle freed) override {
    if (inserted < cycle_ && cycle_ <= freed) {
      seen_->holds_at_reset[static_cast<size_t>(fifo)] = true;
    }
  }

 private:
  Cycle cycle_;
  SeenTimedFrame* seen_;
};

}  // namespace

template <>
const std::vector<Point<SeenTimedFrame>>& points<SeenTimedFrame>() {
  static const std::vector<Point<SeenTimedFrame>> all = {
      {"cause", "what a unit does in a cycle", causes, see_causes},
      {"fifo_level", "slots of a FIFO that are taken", levels, see_levels},
      {"port_stall", "a memory port that does not take what is offered", stalled_ports,
       see_stalled_ports},
      {"reset_in_flight", "what is under way when the frame is reset", at_reset, see_at_reset},
      {"hidden_tiles", "tiles that hierarchical z drops", hidden_tiles, see_hidden_tiles},
  };
  return all;
}

TimedCoverage::TimedCoverage(const spec::Contract& contract)
    : contract_(contract),
      top_("raster_top", contract),
      table_(vectors::points<SeenTimedFrame>(), contract) {}

void TimedCoverage::see(const FrameCase& value) {
  if (int64_t{value.frame.width} * value.frame.height > kTimedSamples) {
    ++too_large_;
    return;
  }
  top_.set_ready(tb::ready_of(value.ports.stalls()));
  timing::FrameResult result;
  SeenTimedFrame seen{contract_, value, result};
  if (value.reset_cycle) {
    AtReset at_reset(static_cast<Cycle>(*value.reset_cycle), &seen);
    top_.run(value.frame, begun_triangles(contract_, value), &at_reset);
  }
  result = top_.run(value.frame, value.in);
  table_.see(seen);
}

std::vector<PointHits> TimedCoverage::points() const {
  std::vector<PointHits> all;
  table_.list(&all);
  return all;
}

WholeCoverage::WholeCoverage(Unit unit, const spec::Contract& contract)
    : coverage_(unit, contract),
      in_time_(unit == Unit::kFrame ? std::make_unique<TimedCoverage>(contract) : nullptr) {}

std::vector<PointHits> WholeCoverage::points() const {
  std::vector<PointHits> all = coverage_.points();
  if (!in_time_) return all;
  for (PointHits& point : in_time_->points()) all.push_back(std::move(point));
  return all;
}

}  // namespace pineda::vectors
