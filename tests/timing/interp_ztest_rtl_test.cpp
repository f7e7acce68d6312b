// Interpolation and depth test on its own: the model's cycles are those of the Verilated unit,
// write by write, in every kind of design and raster state.
#include "model/memory/kinds.h"
#include "model/timing/ports/frame_memory.h"
#include "tb/ready.h"
#include "tests/rtl/support.h"
#include "tests/timing/support.h"

namespace pineda::test {
namespace {

// The tile that traversal would send with a stamp, made from the stamp.
class Tiled {
 public:
  explicit Tiled(const spec::Contract& contract) : design_(contract.design), cover_(contract) {}

  timing::StampToken operator()(const spec::Stamp& stamp) {
    const int x_log2 = design_.tile_log2 - design_.stamp_width_log2;
    const int y_log2 = design_.tile_log2 - design_.stamp_height_log2;
    stamp_ = stamp;
    prim_.id = stamp.id;
    cover_.x = stamp.x >> x_log2;
    cover_.y = stamp.y >> y_log2;
    tile_ = {&prim_, &cover_, &stamp_};
    const int place = (stamp.y - (cover_.y << y_log2)) << x_log2 | (stamp.x - (cover_.x << x_log2));
    cover_.covered.first = stamp.first ? place : -1;
    return {&tile_, place};
  }

 private:
  spec::Design design_;
  fast::TileCover cover_;
  spec::SetupPrim prim_;
  spec::Stamp stamp_;
  timing::TileToken tile_;
};

class Unit {
 public:
  explicit Unit(const spec::Contract& contract)
      : contract_(contract),
        stamps_("stamps", contract.design.stamp_fifo_depth),
        unit_("unit", contract),
        ports_("ports", contract),
        memory_("memory", contract, memory::make_timing(memory::Kind::kIdeal, contract, 1)) {
    if (contract.design.depth_test) {
      unit_.depth_io(ports_);
      ports_.depth.socket.bind(memory_.depth_socket);
    }
    stamps_.out_o(unit_.stamp_i);
    unit_.color_wr_o(ports_);
    ports_.color.socket.bind(memory_.color_socket);
    sc_core::sc_start(sc_core::SC_ZERO_TIME);
  }

  void run(const spec::FrameState& state, const std::vector<spec::Stamp>& stamps,
           const tb::BenchOptions& options, timing::Listener* listener) {
    const tb::Stalls stalls(options.stall_mode, options.seed);
    memory_.set_timing(
        memory::make_timing(memory::Kind::kIdeal, contract_, options.depth_latency_cycles));
    memory_.set_ready(tb::ready_of(stalls));
    memory_.begin_frame(state);
    ports_.begin_frame(state);
    frame_ = {};
    frame_.state = state;
    frame_.listener = listener;
    frame_.tokens = true;
    stamps_.begin_frame(nullptr);
    unit_.begin_frame(&frame_);
    // The next stamp is offered in the first cycle, after the last one was taken, in which the
    // input does not stall.
    accepted_.clear();
    Cycle offered = 0;
    for (const spec::Stamp& stamp : stamps) {
      while (stalls(tb::Port::kInput, offered)) ++offered;
      accepted_.push_back(stamps_.push(tiled_(stamp), offered));
      offered = accepted_.back() + 1;
    }
    unit_.drain();
  }
  const std::vector<Cycle>& accepted() const { return accepted_; }
  const core::FrameCounters& counters() const { return frame_.counters; }

 private:
  spec::Contract contract_;
  timing::StampFifo stamps_;
  timing::InterpZtestUnit unit_;
  Tiled tiled_{contract_};
  std::vector<Cycle> accepted_;
  timing::MemoryPorts ports_;
  timing::FrameMemory memory_;
  timing::Frame frame_;
};

template <class T>
std::vector<Cycle> cycles_of(const std::vector<Event<T>>& events) {
  std::vector<Cycle> cycles;
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
  spec::Random random(11);
  size_t writes = 0;
  for (const int latency : {1, 2, 3, 8, c.design.max_depth_latency_cycles, 1024}) {
    for (const tb::StallMode mode : tb::kStallModes) {
      for (int i = 0; i < 6; ++i) {
        const auto drawing = tb::random_traversal(&random, c, i < 3 ? 8 : 40, 16, 200);
        tb::BenchOptions options;
        options.depth_latency_cycles = latency;
        options.stall_mode = mode;
        options.seed = random.bits();
        Record record;
        Recorder recorder(&record);
        unit.run(drawing.frame, drawing.out, options, &recorder);
        std::vector<Cycle> accepted;
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

// The mutant: a model with a pipeline stage less has other cycles.
TEST(InterpZtestCyclesMutant, AStageLessIsNoticed) {
  const tb::RtlLibrary& library = tb::raster_rtl("sheer");
  spec::Contract shorter = library.contract();
  --shorter.width.attribute_cycles;
  Unit unit(shorter);
  spec::Random random(12);
  const auto drawing = tb::random_traversal(&random, library.contract(), 40, 16, 100);
  Record record;
  Recorder recorder(&record);
  unit.run(drawing.frame, drawing.out, {}, &recorder);
  const auto written = tb::InterpZtestBench(library, {}).run(drawing.frame, drawing.out);
  EXPECT_EQ(record.colors.size(), written.color.cycles.size());
  EXPECT_NE(cycles_of(record.colors), written.color.cycles);
}

}  // namespace
}  // namespace pineda::test
