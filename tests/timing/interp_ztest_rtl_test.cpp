// Interpolation and depth test on its own: the model's cycles are those of the Verilated unit,
// write by write, in every kind of design and raster state.
#include "tests/rtl/support.h"
#include "tests/timing/support.h"

namespace pineda::test {
namespace {

// The stream that a bench feeds: the next stamp is offered in the first cycle after the last one
// was taken in which the input does not stall.
class StampSource final : public sc_core::sc_module, public timing::StreamIn<spec::Stamp> {
 public:
  explicit StampSource(sc_core::sc_module_name name) : sc_module(name) {}
  void begin(std::vector<spec::Stamp> stamps, const tb::Stalls& stalls) {
    stamps_ = std::move(stamps);
    stalls_ = stalls;
    next_ = 0;
    accepted_.clear();
    begun_.notify(sc_core::SC_ZERO_TIME);
  }
  const spec::Stamp& front(Cycle* visible) override {
    while (next_ == stamps_.size()) sc_core::wait(begun_);
    *visible = accepted_.empty() ? 0 : static_cast<Cycle>(accepted_.back()) + 1;
    while (stalls_(tb::Port::kInput, static_cast<uint64_t>(*visible))) ++*visible;
    return stamps_[next_];
  }
  void pop(Cycle cycle) override {
    accepted_.push_back(static_cast<uint64_t>(cycle));
    ++next_;
  }
  const std::vector<uint64_t>& accepted() const { return accepted_; }

 private:
  std::vector<spec::Stamp> stamps_;
  tb::Stalls stalls_;
  size_t next_ = 0;
  std::vector<uint64_t> accepted_;
  sc_core::sc_event begun_;
};

class Unit {
 public:
  explicit Unit(const spec::Contract& contract)
      : unit_("unit", contract), source_("source"), memory_("memory", contract) {
    unit_.stamp_i(source_);
    if (contract.design.depth_test) unit_.depth_io(memory_);
    unit_.color_wr_o(memory_);
  }

  void run(const spec::FrameState& state, const std::vector<spec::Stamp>& stamps,
           const tb::BenchOptions& options, timing::Listener* listener) {
    const tb::Stalls stalls(options.stall_mode, options.seed);
    memory_.set_latency_cycles(options.depth_latency_cycles);
    memory_.set_ready([stalls](timing::ExternalPort port, Cycle cycle) {
      const tb::Port ports[] = {tb::Port::kTriangle, tb::Port::kClear, tb::Port::kDepthRead,
                                tb::Port::kDepthWrite, tb::Port::kColorWrite};
      return !stalls(ports[static_cast<int>(port)], static_cast<uint64_t>(cycle));
    });
    memory_.begin_frame(state);
    frame_ = {state, listener, {}};
    unit_.begin_frame(&frame_);
    source_.begin(stamps, stalls);
    sc_core::sc_start();
  }
  const std::vector<uint64_t>& accepted() const { return source_.accepted(); }
  const core::FrameCounters& counters() const { return frame_.counters; }

 private:
  timing::InterpZtestUnit unit_;
  StampSource source_;
  timing::IdealMemory memory_;
  timing::Frame frame_;
};

template <class T>
std::vector<uint64_t> cycles_of(const std::vector<Event<T>>& events) {
  std::vector<uint64_t> cycles;
  for (const auto& event : events) cycles.push_back(event.cycle);
  return cycles;
}

class InterpZtestCycles : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(, InterpZtestCycles, testing::ValuesIn(tb::kRasterDesigns),
                         [](const auto& p) { return std::string(p.param); });

TEST_P(InterpZtestCycles, EqualWriteByWrite) {
  const tb::RtlLibrary& library = tb::raster_rtl(GetParam());
  const spec::Contract& c = library.contract();
  Unit unit(c);
  vectors::Rng rng(11);
  size_t writes = 0;
  for (const int latency : {1, 2, 3, 8, c.design.max_depth_latency_cycles}) {
    for (const tb::StallMode mode : tb::kStallModes) {
      for (int i = 0; i < 6; ++i) {
        const auto drawing = tb::random_traversal(&rng, c, i < 3 ? 8 : 40, 16, 200);
        tb::BenchOptions options;
        options.depth_latency_cycles = latency;
        options.stall_mode = mode;
        options.seed = rng.next();
        Record record;
        ModelRecorder recorder(&record);
        unit.run(drawing.frame, drawing.out, options, &recorder);
        std::vector<uint64_t> accepted;
        tb::InterpZtestBench bench(library, options);
        const auto written = bench.run(drawing.frame, drawing.out, &accepted);
        ASSERT_EQ(unit.accepted(), accepted) << "latency " << latency;
        ASSERT_EQ(cycles_of(record.depths), written.depth.cycles) << "latency " << latency;
        ASSERT_EQ(cycles_of(record.colors), written.color.cycles) << "latency " << latency;
        ASSERT_EQ(unit.counters().interpolated, written.color.tokens.size());
        writes += written.color.tokens.size();
      }
    }
  }
  EXPECT_GT(writes, 3'000u);
}

// A pipe of one stage less in the model: other cycles.
TEST(InterpZtestCyclesMutant, AStageLessIsNoticed) {
  const tb::RtlLibrary& library = tb::raster_rtl("sheer");
  spec::Contract shorter = library.contract();
  --shorter.width.attribute_cycles;
  Unit unit(shorter);
  vectors::Rng rng(12);
  const auto drawing = tb::random_traversal(&rng, library.contract(), 40, 16, 100);
  Record record;
  ModelRecorder recorder(&record);
  unit.run(drawing.frame, drawing.out, {}, &recorder);
  const auto written = tb::InterpZtestBench(library, {}).run(drawing.frame, drawing.out);
  EXPECT_EQ(record.colors.size(), written.color.cycles.size());
  EXPECT_NE(cycles_of(record.colors), written.color.cycles);
}

}  // namespace
}  // namespace pineda::test
