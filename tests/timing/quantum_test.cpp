// When the rasterizer issues its transactions in a platform, and that memories which wait and
// memories which return delays give the same cycles.
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "model/memory/layout.h"
#include "model/spec/clear_depth.h"
#include "tests/timing/support.h"

namespace pineda::test {
namespace {

using sc_core::sc_time;
using timing::HandshakeExtension;

sc_time ns(double x) { return {x, sc_core::SC_NS}; }

// A memory of a fixed latency, which it waits for or returns. Depth and colour at any address.
struct Memory : sc_core::sc_module {
  struct Call {
    sc_time issued;
    sc_time delay;
    Cycle offered;
    tlm::tlm_command command;
  };
  tlm_utils::simple_target_socket<Memory> depth{"depth"};
  tlm_utils::simple_target_socket<Memory> color{"color"};
  std::vector<unsigned char> bytes;
  sc_time latency;
  bool waits = false;
  size_t fails_at = 0;  // the number of the call that fails, from 1
  std::vector<Call> calls;

  explicit Memory(sc_core::sc_module_name name) : sc_module(name) {
    depth.register_b_transport(this, &Memory::depth_transport);
    color.register_b_transport(this, &Memory::color_transport);
  }
  void clear(const spec::FrameState& frame) {
    bytes.resize(memory::FrameLayout(kContract, frame, memory::kDepthBytes).bytes());
    const uint32_t code = spec::cleared_depth(kContract.design, frame);
    for (size_t i = 0; i < bytes.size(); ++i) {
      bytes[i] = static_cast<unsigned char>(code >> (8 * (i % 4)));
    }
    calls.clear();
  }
  void depth_transport(tlm::tlm_generic_payload& payload, sc_time& delay) {
    const unsigned char* const enables = payload.get_byte_enable_ptr();
    for (unsigned i = 0; i < payload.get_data_length(); ++i) {
      if (enables != nullptr && enables[i % payload.get_byte_enable_length()] == 0) continue;
      unsigned char& here = bytes[payload.get_address() + i];
      unsigned char& there = payload.get_data_ptr()[i];
      payload.is_read() ? there = here : here = there;
    }
    color_transport(payload, delay);
  }
  void color_transport(tlm::tlm_generic_payload& payload, sc_time& delay) {
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
    if (payload.get_command() != tlm::TLM_IGNORE_COMMAND) {
      const Cycle offered = payload.get_extension<HandshakeExtension>()->offered;
      calls.push_back({sc_core::sc_time_stamp(), delay, offered, payload.get_command()});
      if (calls.size() == fails_at) payload.set_response_status(tlm::TLM_GENERIC_ERROR_RESPONSE);
    }
    delay += latency;
    if (!waits) return;
    wait(delay);
    delay = sc_core::SC_ZERO_TIME;
  }
};

// Runs a function in a process, as often as wanted.
class Platform : public sc_core::sc_module {
 public:
  explicit Platform(sc_core::sc_module_name name) : sc_module(name) {
    top.depth_socket().bind(memory.depth);
    top.color_socket().bind(memory.color);
    SC_HAS_PROCESS(Platform);
    SC_THREAD(loop);
  }
  void in_process(std::function<void()> action) {
    action_ = std::move(action);
    go_.notify(ns(1000));
    sc_core::sc_start();
  }
  timing::FrameResult draw(const Scene& scene) {
    memory.clear(scene.frame);
    begun = sc_core::sc_time_stamp();
    const timing::FrameResult result = top.run(scene.frame, scene.triangles);
    passed = sc_core::sc_time_stamp() - begun;
    return result;
  }

  timing::RasterTop top{"top", kContract, timing::Memories::kOutside};
  Memory memory{"memory"};
  sc_time begun, passed;

 private:
  void loop() {
    for (;;) {
      wait(go_);
      action_();
    }
  }
  sc_core::sc_event go_;
  std::function<void()> action_;
};

// With many reads and writes.
Scene busy_scene(uint64_t seed = 8) {
  Scene scene = random_scene(Kind::kMedium, seed, 30);
  scene.frame = {70, 50, spec::Cull::kNone, spec::DepthFunc::kLess};
  return scene;
}

void set_quantum(const sc_time& time) { tlm::tlm_global_quantum::instance().set(time); }

TEST(Quantum, TransactionsAreIssuedInTheirCycleWithoutOne) {
  Platform platform("platform");
  platform.top.set_memory_map(ns(2.5), 0, 0);
  platform.memory.latency = ns(20);
  Cycle drained = 0;
  platform.in_process([&] { drained = platform.draw(busy_scene()).spent.drained; });
  ASSERT_GT(platform.memory.calls.size(), 500u);
  for (const auto& call : platform.memory.calls) {
    ASSERT_EQ(call.delay, sc_core::SC_ZERO_TIME);
    ASSERT_EQ(call.issued - platform.begun, static_cast<double>(call.offered) * ns(2.5));
  }
  EXPECT_EQ(platform.passed, static_cast<double>(drained) * ns(2.5));
}

// The quantum is read when a transaction is issued: each frame has another one.
TEST(Quantum, TransactionsAreAtMostAQuantumAhead) {
  Platform platform("platform");
  platform.memory.latency = ns(20);
  Cycle cycles = 0;
  for (const double quantum : {0., 30., 1000., 1e9}) {
    set_quantum(ns(quantum));
    Cycle drained = 0;
    platform.in_process([&] { drained = platform.draw(busy_scene()).spent.drained; });
    sc_time most;
    size_t synced = 0;
    for (const auto& call : platform.memory.calls) {
      most = std::max(most, call.delay);
      synced += call.delay == sc_core::SC_ZERO_TIME ? 1 : 0;
      ASSERT_EQ(call.issued + call.delay - platform.begun,
                static_cast<double>(call.offered) * ns(1));
    }
    EXPECT_LE(most, ns(quantum));
    EXPECT_EQ(most > sc_core::SC_ZERO_TIME, quantum > 0) << most;
    EXPECT_EQ(synced == platform.memory.calls.size(), quantum == 0);
    EXPECT_EQ(platform.passed, static_cast<double>(drained) * ns(1));
    if (quantum == 0) cycles = drained;
    EXPECT_EQ(drained, cycles);  // the latency does not depend on who asks when
  }
}

TEST(Quantum, NobodyWaitsOutsideOfAProcess) {
  Platform platform("platform");
  platform.memory.latency = ns(20);
  sc_core::sc_start(ns(10));
  const auto alone = platform.draw(busy_scene());
  EXPECT_EQ(platform.passed, sc_core::SC_ZERO_TIME);
  timing::FrameResult within;
  platform.in_process([&] { within = platform.draw(busy_scene()); });
  EXPECT_EQ(alone.cycles, within.cycles);
  EXPECT_GT(platform.passed, sc_core::SC_ZERO_TIME);
}

// A latency that does not depend on load: a transaction is as long whether the target waits or
// returns a delay, and whether it is issued on time or, behind one that waited, late.
TEST(Quantum, TargetsThatWaitAndTargetsThatReturnDelaysGiveTheSameCycles) {
  Platform platform("platform");
  for (const Kind kind : kKinds) {
    for (uint64_t seed = 0; seed < 6; ++seed) {
      const Scene scene = random_scene(kind, seed, 20);
      platform.memory.latency = ns(static_cast<double>(1 + 7 * seed));
      for (const double quantum : {0., 500.}) {
        set_quantum(ns(quantum));
        Cycle cycles[2] = {};
        for (const bool waits : {false, true}) {
          platform.memory.waits = waits;
          platform.in_process([&] { cycles[waits ? 1 : 0] = platform.draw(scene).spent.drained; });
          EXPECT_GE(platform.passed, static_cast<double>(cycles[waits ? 1 : 0]) * ns(1));
        }
        ASSERT_EQ(cycles[0], cycles[1]) << kind_name(kind) << ", seed " << seed;
      }
    }
  }
}

// A frame takes no less than its cycles and no more than these and all that the target waited.
TEST(Quantum, TargetThatWaitsMakesTheFrameLateByNoMoreThanItWaited) {
  Platform platform("platform");
  platform.memory.latency = ns(20);
  platform.memory.waits = true;
  Cycle drained = 0;
  platform.in_process([&] { drained = platform.draw(busy_scene()).spent.drained; });
  const auto waited = static_cast<double>(platform.memory.calls.size()) * ns(20);
  EXPECT_GT(platform.passed, static_cast<double>(drained) * ns(1));
  EXPECT_LE(platform.passed, static_cast<double>(drained) * ns(1) + waited);
}

// ---- Errors in a platform

// The frame ends at the failed transaction; the next one is as if it had not been.
TEST(QuantumErrors, FrameAfterAFailedTransactionStartsClean) {
  Platform platform("platform");
  platform.memory.latency = ns(4);
  const Scene scene = busy_scene();
  timing::FrameResult first, second;
  std::string text;
  platform.in_process([&] {
    first = platform.draw(scene);
    platform.memory.fails_at = 100;
    text = reported([&] { platform.draw(scene); });
    EXPECT_EQ(platform.memory.calls.size(), 100u);
    platform.memory.fails_at = 0;
    second = platform.draw(scene);
  });
  EXPECT_EQ(text.find("pineda/memory/response: platform.top.memory_ports."), 0u) << text;
  EXPECT_NE(text.find("TLM_GENERIC_ERROR_RESPONSE"), std::string::npos) << text;
  EXPECT_EQ(first.spent.drained, second.spent.drained);
  EXPECT_EQ(first.counters.passed, second.counters.passed);
}

// The error is noted, the request counts as served.
TEST(QuantumErrors, HandlerThatDoesNotThrowLetsTheFrameGoOn) {
  sc_core::sc_report_handler::set_actions(sc_core::SC_ERROR, sc_core::SC_CACHE_REPORT);
  Platform platform("platform");
  platform.memory.fails_at = 100;
  timing::FrameResult failed, whole;
  platform.in_process([&] {
    failed = platform.draw(busy_scene());
    EXPECT_EQ(sc_core::sc_report_handler::get_count(sc_core::SC_ERROR), 1);
    platform.memory.fails_at = 0;
    whole = platform.draw(busy_scene());
  });
  EXPECT_EQ(failed.spent.drained, whole.spent.drained);
}

// A second process that wants the same rasterizer while it draws.
class Rival : public sc_core::sc_module {
 public:
  Rival(sc_core::sc_module_name name, timing::RasterTop* top) : sc_module(name), top_(*top) {
    SC_HAS_PROCESS(Rival);
    SC_THREAD(run);
  }
  std::string text;

 private:
  void run() {
    wait(ns(1100));
    text = reported([&] { top_.run({2, 2}, std::vector<spec::Triangle>{}); });
  }
  timing::RasterTop& top_;
};

TEST(QuantumErrors, SecondProcessIsRefusedWhileAFrameIsDrawn) {
  Platform platform("platform");
  Rival rival("rival", &platform.top);
  Cycle drained[2] = {};
  for (Cycle& cycles : drained) {
    platform.in_process([&] { cycles = platform.draw(busy_scene()).spent.drained; });
  }
  EXPECT_EQ(rival.text, "pineda/raster_top/busy: platform.top draws a frame already");
  EXPECT_EQ(drained[0], drained[1]);
}

// stop() from another process, in the middle of the frame.
class Stopper : public sc_core::sc_module {
 public:
  Stopper(sc_core::sc_module_name name, timing::RasterTop* top) : sc_module(name), top_(*top) {
    SC_HAS_PROCESS(Stopper);
    SC_THREAD(run);
  }
  sc_time at;

 private:
  void run() {
    wait(at);
    top_.stop();
  }
  timing::RasterTop& top_;
};

TEST(QuantumErrors, StoppedFrameEndsAtItsNextTransactionAndTheNextOneIsWhole) {
  Platform platform("platform");
  Stopper stopper("stopper", &platform.top);
  stopper.at = ns(1000 + 150);
  const Scene scene = busy_scene();
  size_t transactions = 0;
  timing::FrameResult whole;
  platform.in_process([&] {
    EXPECT_THROW(platform.draw(scene), timing::Stopped);
    transactions = platform.memory.calls.size();
    EXPECT_LE(platform.memory.calls.back().issued, stopper.at);
    EXPECT_GE(sc_core::sc_time_stamp(), stopper.at);
    whole = platform.draw(scene);
  });
  EXPECT_GT(transactions, 10u);
  EXPECT_GT(platform.memory.calls.size(), transactions);
  core::Renderer renderer(kContract, scene.frame);
  for (const spec::Triangle& t : scene.triangles) renderer.draw(t);
  EXPECT_EQ(whole.counters.passed, renderer.counters().passed);
}

}  // namespace
}  // namespace pineda::test
