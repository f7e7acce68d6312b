// The memory model that comes with the project: with other initiators, and behind the rasterizer.
#include "model/timing/ports/frame_memory.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "model/memory/dram_timing.h"
#include "model/memory/kinds.h"
#include "tb/ready.h"
#include "tests/timing/support.h"

namespace pineda::test {
namespace {

using sc_core::sc_time;
using timing::FrameMemory;

sc_time ns(double x) { return {x, sc_core::SC_NS}; }

// A processor that knows only TLM-2.0.
struct Initiator : sc_core::sc_module {
  tlm_utils::simple_initiator_socket<Initiator> depth{"depth"};
  tlm_utils::simple_initiator_socket<Initiator> color{"color"};

  explicit Initiator(sc_core::sc_module_name name) : sc_module(name) {}

  // The delay that is returned for a transaction with an initial delay of `at`.
  template <class Socket>
  sc_time transfer(Socket* socket, tlm::tlm_command command, uint64_t address,
                   std::vector<unsigned char>* bytes, const sc_time& at) {
    payload.set_command(command);
    payload.set_address(address);
    payload.set_data_ptr(bytes->data());
    payload.set_data_length(static_cast<unsigned>(bytes->size()));
    payload.set_streaming_width(streaming_width != 0 ? streaming_width : payload.get_data_length());
    payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
    sc_time delay = at;
    (*socket)->b_transport(payload, delay);
    return delay;
  }

  tlm::tlm_generic_payload payload;
  unsigned streaming_width = 0;
};

class ForeignInitiator : public testing::Test {
 protected:
  ForeignInitiator() {
    initiator_.depth.bind(memory_.depth_socket);
    initiator_.color.bind(memory_.color_socket);
    sc_core::sc_start(sc_core::SC_ZERO_TIME);
    memory_.begin_frame({8, 8});
  }
  sc_time read(uint64_t address, size_t length, double at) {
    bytes_.assign(length, 0);
    return initiator_.transfer(&initiator_.depth, tlm::TLM_READ_COMMAND, address, &bytes_, ns(at));
  }
  sc_time write(uint64_t address, std::vector<unsigned char> bytes, double at) {
    return initiator_.transfer(&initiator_.depth, tlm::TLM_WRITE_COMMAND, address, &bytes, ns(at));
  }
  void make_dram() {
    memory_.set_timing(memory::make_timing(memory::Kind::kDram, kContract, 8));
    memory_.begin_frame({8, 8});
  }

  FrameMemory memory_{"memory", kContract, memory::make_timing(memory::Kind::kIdeal, kContract, 8)};
  Initiator initiator_{"initiator"};
  std::vector<unsigned char> bytes_;
};

TEST_F(ForeignInitiator, ReadsWhatIsThereAfterTheLatency) {
  EXPECT_EQ(read(0, 4, 100), ns(108));
  EXPECT_TRUE(initiator_.payload.is_response_ok());
  EXPECT_TRUE(initiator_.payload.is_dmi_allowed());
  EXPECT_EQ(bytes_, (std::vector<unsigned char>{0xff, 0xff, 0xff, 0}));  // cleared
  EXPECT_EQ(write(20, {1, 2, 3}, 110), ns(110));
  EXPECT_EQ(read(19, 5, 111), ns(119));
  EXPECT_EQ(bytes_, (std::vector<unsigned char>{0, 1, 2, 3, 0}));
  EXPECT_EQ(memory_.buffer().depth[3], 0x030201u);  // lane 1 of stamp 1
}

TEST_F(ForeignInitiator, ReadsWhatTheFrameIsClearedTo) {
  spec::FrameState frame{8, 8};
  frame.clear_depth = 1 / 3.;
  memory_.begin_frame(frame);
  read(0, 8, 100);
  EXPECT_EQ(bytes_, (std::vector<unsigned char>{0x55, 0x55, 0x55, 0, 0x55, 0x55, 0x55, 0}));
  EXPECT_EQ(memory_.buffer().depth[63], 0x555555u);
}

// Bytes 8 .. 39 lie in three stamps, which are read in three cycles.
TEST_F(ForeignInitiator, RangeIsAccessedStampByStamp) { EXPECT_EQ(read(8, 32, 0), ns(10)); }

// As in DramTiming.MissWaitsForItsFillAndBlocksItsPortAlone; the next request waits for the port.
TEST_F(ForeignInitiator, WaitsForDram) {
  make_dram();
  EXPECT_EQ(read(0, 16, 100), ns(131));
  EXPECT_FALSE(initiator_.payload.is_dmi_allowed());
  EXPECT_EQ(read(16, 16, 101), ns(129 + 3));
}

TEST_F(ForeignInitiator, ByteEnablesRepeat) {
  unsigned char enables[2] = {0, TLM_BYTE_ENABLED};
  initiator_.payload.set_byte_enable_ptr(enables);
  initiator_.payload.set_byte_enable_length(2);
  write(0, {1, 2, 3, 4}, 0);
  initiator_.payload.set_byte_enable_ptr(nullptr);
  read(0, 4, 1);
  EXPECT_EQ(bytes_, (std::vector<unsigned char>{0xff, 2, 0xff, 4}));
}

TEST_F(ForeignInitiator, ColorsAreReadAndWritten) {
  std::vector<unsigned char> color{9, 8, 7, 6};
  initiator_.transfer(&initiator_.color, tlm::TLM_WRITE_COMMAND, 4, &color, ns(5));
  EXPECT_EQ(memory_.buffer().color[4], 9);
  std::vector<unsigned char> back(4);
  EXPECT_EQ(initiator_.transfer(&initiator_.color, tlm::TLM_READ_COMMAND, 4, &back, ns(6)), ns(14));
  EXPECT_EQ(back, color);
}

TEST_F(ForeignInitiator, IsToldWhatItDoesWrong) {
  read(16 * 16 - 4, 4, 0);
  EXPECT_TRUE(initiator_.payload.is_response_ok());
  read(16 * 16 - 4, 5, 0);
  EXPECT_EQ(initiator_.payload.get_response_status(), tlm::TLM_ADDRESS_ERROR_RESPONSE);
  read(~uint64_t{0}, 4, 0);
  EXPECT_EQ(initiator_.payload.get_response_status(), tlm::TLM_ADDRESS_ERROR_RESPONSE);
  initiator_.streaming_width = 4;
  read(0, 8, 0);
  EXPECT_EQ(initiator_.payload.get_response_status(), tlm::TLM_BURST_ERROR_RESPONSE);
}

TEST_F(ForeignInitiator, DebugTransportTakesNoTimeAndStopsAtTheEnd) {
  std::vector<unsigned char> bytes(100);
  tlm::tlm_generic_payload payload;
  payload.set_command(tlm::TLM_READ_COMMAND);
  payload.set_address(16 * 16 - 40);
  payload.set_data_ptr(bytes.data());
  payload.set_data_length(100);
  EXPECT_EQ(initiator_.depth->transport_dbg(payload), 40u);
  EXPECT_EQ(bytes[0], 0xff);
}

// ---- Behind the rasterizer

core::FrameBuffer core_frame(const Scene& scene, const spec::Contract& contract) {
  core::Renderer renderer(contract, scene.frame);
  for (const spec::Triangle& t : scene.triangles) renderer.draw(t);
  return renderer.buffer();
}

// Always ready, but through a function that could say otherwise: so no direct access is granted.
const timing::Ready kAlways = [](timing::ExternalPort, Cycle) { return true; };

TEST(RasterMemory, DirectAccessAndTransportTakeTheSameCycles) {
  timing::RasterTop top("top", kContract);
  for (const Kind kind : kKinds) {
    const Scene scene = random_scene(kind, 3, 25);
    Record direct, transported;
    Recorder direct_recorder(&direct), transport_recorder(&transported);
    top.set_ready({});
    const auto first = top.run(scene.frame, pull_from(scene), &direct_recorder);
    const auto buffer = top.buffer();
    top.set_ready(kAlways);
    const auto second = top.run(scene.frame, pull_from(scene), &transport_recorder);
    ASSERT_EQ(difference(direct, transported, true), "") << kind_name(kind);
    ASSERT_EQ(first.cycles, second.cycles);
    ASSERT_EQ(buffer.depth, top.buffer().depth);
    ASSERT_EQ(buffer.color, top.buffer().color);
  }
}

// Where nobody listens the memory is asked for time alone, and values are drawn tile by tile.
TEST(RasterMemory, ListenerChangesNothing) {
  timing::RasterTop top("top", kContract);
  for (const memory::Kind memory : memory::kKinds) {
    for (const memory::StallMode mode : memory::kStallModes) {
      top.set_memory(memory::make_timing(memory, kContract, 8));
      top.set_ready(tb::ready_of({mode, 5}));
      for (const Kind kind : kKinds) {
        const Scene scene = random_scene(kind, 4, 25);
        timing::Listener listener;
        const auto heard = top.run(scene.frame, pull_from(scene), &listener);
        const auto buffer = top.buffer();
        const auto alone = top.run(scene.frame, pull_from(scene));
        ASSERT_EQ(top.buffer().depth, buffer.depth) << kind_name(kind);
        ASSERT_EQ(top.buffer().color, buffer.color) << kind_name(kind);
        top.set_bits(false);
        const auto time = top.run(scene.frame, pull_from(scene));
        top.set_bits(true);
        for (const auto& result : {alone, time}) {
          const auto expected = timing::counter_list(kContract, heard);
          const auto got = timing::counter_list(kContract, result);
          for (const auto& d : timing::counter_differences(got, expected)) {
            EXPECT_TRUE(!result.knows_passed && d.known == core::Known::kIfTested) << d.name;
          }
          ASSERT_EQ(result.cycles, heard.cycles) << kind_name(kind);
        }
      }
    }
  }
}

TEST(RasterMemory, DramIsSlowerAndLeavesTheSameFrame) {
  timing::RasterTop top("top", kContract);
  const Scene scene = random_scene(Kind::kMedium, 8, 60);
  const core::FrameBuffer expected = core_frame(scene, kContract);
  Cycle ideal = 0;
  for (const memory::Kind kind : memory::kKinds) {
    top.set_memory(memory::make_timing(kind, kContract, 8));
    const Cycle cycles = top.run(scene.frame, pull_from(scene)).cycles;
    if (kind == memory::Kind::kIdeal) ideal = cycles;
    EXPECT_EQ(cycles > ideal, kind != memory::Kind::kIdeal) << spec::name_of(kind);
    EXPECT_EQ(top.buffer().depth, expected.depth);
    EXPECT_EQ(top.buffer().color, expected.color);
    EXPECT_EQ(top.run(scene.frame, pull_from(scene)).cycles, cycles) << "another frame";
  }
}

/// DRAM that checks whether requests come in the order of their cycles, as they do at the RTL. The
/// order matters since the ports affect one another.
class OrderSeeing final : public memory::MemoryTiming {
 public:
  explicit OrderSeeing(const spec::Contract& contract)
      : dram_(memory::make_timing(memory::Kind::kDramMerged, contract, 8)) {}

  void begin_frame(const spec::FrameState& frame) override {
    dram_->begin_frame(frame);
    last_ = {-1, {}};
  }
  Cycle ready_from(memory::MemoryPort port, Cycle from) override {
    return dram_->ready_from(port, from);
  }
  Cycle accept(memory::MemoryPort port, Cycle cycle, int x, int y) override {
    const std::pair request(cycle, port);
    late += request > last_ ? 0 : 1;
    ++requests;
    last_ = request;
    return dram_->accept(port, cycle, x, y);
  }

  size_t requests = 0;
  size_t late = 0;  // those that came after one of a later cycle

 private:
  std::shared_ptr<memory::MemoryTiming> dram_;
  std::pair<Cycle, memory::MemoryPort> last_;
};

TEST(RasterMemory, IsAskedInTheOrderOfCycles) {
  timing::RasterTop top("top", kContract);
  const auto memory = std::make_shared<OrderSeeing>(kContract);
  top.set_memory(memory);
  for (const Kind kind : kKinds) {
    for (uint64_t seed = 0; seed < 20; ++seed) {
      const Scene scene = random_scene(kind, seed, 60);
      timing::Listener listener;
      top.run(scene.frame, pull_from(scene), seed % 2 == 0 ? nullptr : &listener);
      ASSERT_EQ(memory->late, 0u) << kind_name(kind) << ", seed " << seed;
    }
  }
  EXPECT_GT(memory->requests, 10'000u);
}

TEST(RasterMemory, RequestThatComesLateIsSeen) {
  OrderSeeing memory(kContract);
  memory.begin_frame({8, 8});
  memory.accept(memory::MemoryPort::kColorWrite, 20, 0, 0);
  EXPECT_EQ(memory.late, 0u);
  memory.accept(memory::MemoryPort::kDepthRead, 20, 0, 0);
  memory.accept(memory::MemoryPort::kDepthRead, 12, 0, 0);
  EXPECT_EQ(memory.late, 2u);
}

// Stamps of other shapes, no depth, no attribute, values of more than a byte.
class RasterMemoryDesigns : public testing::TestWithParam<const char*> {};

TEST_P(RasterMemoryDesigns, HoldTheFrameOfCore) {
  spec::Design design = spec::kHighTile;
  if (const auto* named = spec::find_design(GetParam()); named != nullptr) design = *named;
  if (std::string(GetParam()) == "bare") {
    design = *spec::find_design("flat");
    design.flat_attributes = 0;
  }
  if (std::string(GetParam()) == "deep") design.attribute_bits = 12;
  ASSERT_EQ(spec::invalid_reason(design), "");
  const spec::Contract contract = spec::contract(design);
  timing::RasterTop top("top", contract);
  for (uint64_t seed = 0; seed < 6; ++seed) {
    Scene scene = random_scene(Kind::kMedium, seed, 30, contract);
    if (!design.depth_test) scene.frame.depth = spec::DepthFunc::kOff;
    top.set_ready(seed % 2 == 0 ? timing::Ready() : kAlways);
    timing::Listener listener;
    top.run(scene.frame, pull_from(scene), seed < 2 ? nullptr : &listener);
    const core::FrameBuffer expected = core_frame(scene, contract);
    EXPECT_EQ(top.buffer().depth, expected.depth);
    EXPECT_EQ(top.buffer().color, expected.color);
  }
}

INSTANTIATE_TEST_SUITE_P(, RasterMemoryDesigns,
                         testing::Values("wide", "tiny", "flat", "persp", "bare", "deep"),
                         [](const auto& p) { return std::string(p.param); });

// A foreign memory whose transport calls wait(), so that time passes inside of run().
struct Waiting : sc_core::sc_module {
  tlm_utils::simple_target_socket<Waiting> depth{"depth"};
  tlm_utils::simple_target_socket<Waiting> color{"color"};
  std::vector<unsigned char> depths = std::vector<unsigned char>(1 << 16, 0xff);
  int calls = 0;

  explicit Waiting(sc_core::sc_module_name name) : sc_module(name) {
    depth.register_b_transport(this, &Waiting::depth_transport);
    color.register_b_transport(this, &Waiting::color_transport);
  }
  void depth_transport(tlm::tlm_generic_payload& payload, sc_time& delay) {
    wait(delay + ns(3));
    delay = sc_core::SC_ZERO_TIME;
    for (unsigned i = 0; i < payload.get_data_length(); ++i) {
      if (payload.get_byte_enable_ptr() != nullptr && payload.get_byte_enable_ptr()[i] == 0)
        continue;
      unsigned char& here = depths[payload.get_address() + i];
      unsigned char& there = payload.get_data_ptr()[i];
      payload.is_read() ? there = here : here = there;
    }
    color_transport(payload, delay);
  }
  void color_transport(tlm::tlm_generic_payload& payload, sc_time&) {
    ++calls;
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
  }
};

struct Platform : sc_core::sc_module {
  timing::RasterTop top{"top", kContract, timing::Memories::kOutside};
  Waiting memory{"memory"};
  Scene scene;
  timing::FrameResult result;
  sc_time begun, ended;

  explicit Platform(sc_core::sc_module_name name) : sc_module(name) {
    top.depth_socket().bind(memory.depth);
    top.color_socket().bind(memory.color);
    SC_HAS_PROCESS(Platform);
    SC_THREAD(run);
  }
  void run() {
    wait(ns(1000));
    begun = sc_core::sc_time_stamp();
    result = top.run(scene.frame, pull_from(scene));
    ended = sc_core::sc_time_stamp();
  }
};

TEST(RasterMemory, TargetThatWaitsIsWaitedFor) {
  Platform platform("platform");
  platform.scene = random_scene(Kind::kMedium, 8, 30);
  platform.scene.frame.depth = spec::DepthFunc::kLess;
  platform.scene.frame.depth_write = true;
  platform.scene.frame.clear_depth = 1;  // as that memory starts
  sc_core::sc_start();
  core::Renderer renderer(kContract, platform.scene.frame);
  for (const spec::Triangle& t : platform.scene.triangles) renderer.draw(t);
  EXPECT_EQ(platform.result.counters.passed, renderer.counters().passed);
  EXPECT_GT(platform.result.counters.passed, 100u);
  EXPECT_EQ(static_cast<uint64_t>(platform.result.counters.triangles),
            platform.scene.triangles.size());
  EXPECT_GE(platform.ended - platform.begun, static_cast<double>(platform.result.cycles) * ns(1));
  EXPECT_GT(platform.memory.calls, 100);
}

}  // namespace
}  // namespace pineda::test
