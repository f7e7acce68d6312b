// Every socket of the project keeps the rules of the TLM-2.0 base protocol, and the checker that
// says so refuses whoever breaks one.
#include <gtest/gtest.h>
#include <tlm_utils/simple_target_socket.h>

#include <functional>

#include "model/memory/kinds.h"
#include "model/spec/clear_depth.h"
#include "model/timing/ports/shared_memory.h"
#include "tests/timing/support.h"
#include "tests/timing/tlm_checker.h"

namespace pineda::test {
namespace {

using sc_core::sc_time;
using timing::FrameMemory;
using tlm::tlm_generic_payload;

sc_time ns(double x) { return {x, sc_core::SC_NS}; }

core::FrameBuffer core_frame(const Scene& scene) {
  core::Renderer renderer(kContract, scene.frame);
  for (const spec::Triangle& t : scene.triangles) renderer.draw(t);
  return renderer.buffer();
}

// A rasterizer in a process, with checked memories outside.
class Drawer : public sc_core::sc_module {
 public:
  explicit Drawer(sc_core::sc_module_name name) : sc_module(name) {
    SC_HAS_PROCESS(Drawer);
    SC_THREAD(run);
  }
  timing::RasterTop top{"top", kContract, timing::Memories::kOutside};
  std::function<void()> script;

 private:
  void run() { script(); }
};

// What a FrameMemory is asked, it answers; what it is not asked, it serves as well.
class FrameMemoryRules : public testing::TestWithParam<bool> {};

TEST_P(FrameMemoryRules, HoldOnEveryMemoryWithAndWithoutTheHandshake) {
  Drawer drawer("drawer");
  FrameMemory memory("memory", kContract, memory::make_timing(memory::Kind::kIdeal, kContract, 8));
  Checkers checkers;
  for (TlmChecker* checker : {checkers.between(&drawer.top.depth_socket(), &memory.depth_socket),
                              checkers.between(&drawer.top.color_socket(), &memory.color_socket)}) {
    if (GetParam()) checker->strip_extensions();
  }
  int frames = 0;
  drawer.script = [&] {
    for (const memory::Kind kind : memory::kKinds) {
      for (const double quantum : {0., 100.}) {
        tlm::tlm_global_quantum::instance().set(ns(quantum));
        const Scene scene = random_scene(Kind::kMedium, 8, 30);
        memory.set_timing(memory::make_timing(kind, kContract, 8));
        memory.begin_frame(scene.frame);
        drawer.top.set_memory_map(ns(1), 0, 0);
        drawer.top.run(scene.frame, scene.triangles);
        EXPECT_EQ(memory.buffer().depth, core_frame(scene).depth) << spec::name_of(kind);
        EXPECT_EQ(memory.buffer().color, core_frame(scene).color) << spec::name_of(kind);
        ++frames;
      }
    }
  };
  sc_core::sc_start();
  EXPECT_EQ(frames, 6);
  EXPECT_EQ(checkers.faults(), "");
}

INSTANTIATE_TEST_SUITE_P(, FrameMemoryRules, testing::Values(false, true),
                         [](const auto& p) { return p.param ? "Stripped" : "Asked"; });

TEST(SharedMemoryRules, HoldBehindARasterizer) {
  Drawer drawer("drawer");
  timing::SharedMemory memory("memory", {});
  Checkers checkers;
  checkers.between(&drawer.top.depth_socket(), &memory.socket);
  checkers.between(&drawer.top.color_socket(), &memory.socket);
  drawer.top.set_memory_map(ns(1), 0, 1 << 19);
  bool done = false;
  drawer.script = [&] {
    for (const double quantum : {0., 100.}) {
      tlm::tlm_global_quantum::instance().set(ns(quantum));
      drawer.top.run({60, 40}, random_scene(Kind::kMedium, 8, 30).triangles);
    }
    done = true;
  };
  sc_core::sc_start();
  EXPECT_TRUE(done);
  EXPECT_EQ(checkers.faults(), "");
}

// ---- Mutants

// A good initiator and a good target, either of which can be told to go wrong.
struct Pair : sc_core::sc_module {
  tlm_utils::simple_initiator_socket<Pair> initiator{"initiator"};
  tlm_utils::simple_target_socket<Pair> target{"target"};
  Checkers checkers;
  TlmChecker* checker;
  std::function<void(tlm_generic_payload*, sc_time*)> wrong_target = [](auto*, auto*) {};
  std::function<unsigned(unsigned)> wrong_count = [](unsigned length) { return length; };
  std::function<void(tlm::tlm_dmi*)> wrong_dmi = [](auto*) {};
  unsigned char bytes[16] = {};
  unsigned char data[16] = {};
  unsigned char enables[4] = {TLM_BYTE_ENABLED, 0, TLM_BYTE_ENABLED, TLM_BYTE_ENABLED};
  tlm_generic_payload payload;

  explicit Pair(sc_core::sc_module_name name) : sc_module(name) {
    checker = checkers.between(&initiator, &target);
    target.register_b_transport(this, &Pair::b_transport);
    target.register_transport_dbg(this, &Pair::transport_dbg);
    target.register_get_direct_mem_ptr(this, &Pair::get_direct_mem_ptr);
    payload.set_data_ptr(data);
    payload.set_data_length(8);
    payload.set_streaming_width(8);
    payload.set_byte_enable_ptr(enables);
    payload.set_byte_enable_length(4);
    payload.set_command(tlm::TLM_READ_COMMAND);
  }
  void b_transport(tlm_generic_payload& p, sc_time& delay) {
    timing::move_bytes(p, bytes);
    delay += ns(3);
    p.set_response_status(tlm::TLM_OK_RESPONSE);
    wrong_target(&p, &delay);
  }
  unsigned transport_dbg(tlm_generic_payload& p) { return wrong_count(p.get_data_length()); }
  bool get_direct_mem_ptr(tlm_generic_payload&, tlm::tlm_dmi& dmi) {
    dmi.init();
    dmi.set_dmi_ptr(bytes);
    dmi.set_end_address(15);
    dmi.allow_read_write();
    wrong_dmi(&dmi);
    return true;
  }
  std::string faults() const {
    std::string text;
    for (const auto& fault : checker->faults()) text += fault + ";";
    return text;
  }
  void call() {
    sc_time delay = ns(10);
    initiator->b_transport(payload, delay);
  }
};

TEST(TlmCheckerMutants, WhoKeepsTheRulesIsPassed) {
  Pair pair("pair");
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  pair.call();
  tlm::tlm_dmi dmi;
  EXPECT_TRUE(pair.initiator->get_direct_mem_ptr(pair.payload, dmi));
  EXPECT_EQ(pair.initiator->transport_dbg(pair.payload), 8u);
  pair.target->invalidate_direct_mem_ptr(0, 15);
  EXPECT_EQ(pair.faults(), "");
}

TEST(TlmCheckerMutants, EveryWrongInitiatorIsRefused) {
  struct Case {
    const char* text;
    void (*wrong)(tlm_generic_payload*);
  };
  const Case cases[] = {
      {"call: no such command", [](auto* p) { p->set_command(static_cast<tlm::tlm_command>(3)); }},
      {"call: no data length", [](auto* p) { p->set_data_length(0); }},
      {"call: no streaming width", [](auto* p) { p->set_streaming_width(0); }},
      {"call: response is not TLM_INCOMPLETE_RESPONSE",
       [](auto* p) { p->set_response_status(tlm::TLM_OK_RESPONSE); }},
      {"call: DMI hint is set", [](auto* p) { p->set_dmi_allowed(true); }},
  };
  Pair pair("pair");
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  std::string expected;
  for (const Case& c : cases) {
    expected += std::string(c.text) + ";";
    pair.payload.set_command(tlm::TLM_READ_COMMAND);
    pair.payload.set_data_length(8);
    pair.payload.set_streaming_width(8);
    pair.payload.set_dmi_allowed(false);
    pair.payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
    c.wrong(&pair.payload);
    pair.call();
    EXPECT_EQ(pair.faults(), expected);
  }
}

TEST(TlmCheckerMutants, EveryWrongTargetIsRefused) {
  struct Case {
    const char* text;
    void (*wrong)(tlm_generic_payload*, sc_time*);
  };
  static unsigned char elsewhere[16];
  static timing::HandshakeExtension extension;
  const Case cases[] = {
      {"return: time went back", [](auto*, sc_time* delay) { *delay = ns(2); }},
      {"return: response is TLM_INCOMPLETE_RESPONSE",
       [](auto* p, auto*) { p->set_response_status(tlm::TLM_INCOMPLETE_RESPONSE); }},
      {"return: command has changed",
       [](auto* p, auto*) { p->set_command(tlm::TLM_WRITE_COMMAND); }},
      {"return: address has changed", [](auto* p, auto*) { p->set_address(4); }},
      {"return: data pointer has changed", [](auto* p, auto*) { p->set_data_ptr(elsewhere); }},
      {"return: data length has changed", [](auto* p, auto*) { p->set_data_length(4); }},
      {"return: streaming width has changed", [](auto* p, auto*) { p->set_streaming_width(4); }},
      {"return: byte enables have changed",
       [](auto* p, auto*) { p->get_byte_enable_ptr()[0] ^= 0xff; }},
      {"return: extensions have changed", [](auto* p, auto*) { p->set_extension(&extension); }},
      {"return: data have changed", [](auto* p, auto*) { p->get_data_ptr()[1] ^= 1; }},
  };
  Pair pair("pair");
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  std::string expected;
  for (const Case& c : cases) {
    expected += std::string(c.text) + ";";
    pair.enables[0] = TLM_BYTE_ENABLED;
    pair.payload.set_command(tlm::TLM_READ_COMMAND);
    pair.payload.set_address(0);
    pair.payload.set_data_ptr(pair.data);
    pair.payload.set_data_length(8);
    pair.payload.set_streaming_width(8);
    pair.payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
    pair.payload.clear_extension(&extension);
    pair.wrong_target = c.wrong;
    pair.call();
    EXPECT_EQ(pair.faults(), expected);
  }
  pair.payload.clear_extension(&extension);
}

TEST(TlmCheckerMutants, WrongDebugAndDirectAccessAreRefused) {
  Pair pair("pair");
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  pair.wrong_count = [](unsigned length) { return length + 1; };
  pair.initiator->transport_dbg(pair.payload);
  std::string expected = "debug return: more bytes than asked for;";
  EXPECT_EQ(pair.faults(), expected);
  tlm::tlm_dmi dmi;
  pair.wrong_dmi = [](tlm::tlm_dmi* d) { d->set_start_address(4); };
  pair.initiator->get_direct_mem_ptr(pair.payload, dmi);
  expected += "DMI return: the address is not in the range;";
  EXPECT_EQ(pair.faults(), expected);
  pair.wrong_dmi = [](tlm::tlm_dmi* d) { d->allow_write(); };
  pair.initiator->get_direct_mem_ptr(pair.payload, dmi);
  expected += "DMI return: granted, but not what was asked for;";
  EXPECT_EQ(pair.faults(), expected);
  pair.wrong_dmi = [](tlm::tlm_dmi* d) { d->set_dmi_ptr(nullptr); };
  pair.initiator->get_direct_mem_ptr(pair.payload, dmi);
  expected += "DMI return: granted without a pointer;";
  EXPECT_EQ(pair.faults(), expected);
  pair.target->invalidate_direct_mem_ptr(8, 4);
  EXPECT_EQ(pair.faults(), expected + "DMI invalidated: no range;");
}

}  // namespace
}  // namespace pineda::test
