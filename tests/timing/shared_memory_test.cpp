// A channel that several initiators share: order, ties, counters, and what it refuses.
#include "model/timing/ports/shared_memory.h"

#include <gtest/gtest.h>
#include <tlm_utils/simple_initiator_socket.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <vector>

#include "tests/timing/support.h"

namespace pineda::test {
namespace {

using sc_core::sc_time;
using timing::SharedMemory;
using timing::SharedMemoryParameters;

sc_time ns(double x) { return {x, sc_core::SC_NS}; }

// A process that plays a script.
struct Initiator : sc_core::sc_module {
  tlm_utils::simple_initiator_socket<Initiator> socket{"socket"};
  std::function<void(Initiator*)> script;
  tlm::tlm_generic_payload payload;
  std::vector<unsigned char> data = std::vector<unsigned char>(256);

  explicit Initiator(sc_core::sc_module_name name) : sc_module(name) {
    SC_HAS_PROCESS(Initiator);
    SC_THREAD(run);
  }
  void run() {
    if (script) script(this);
  }
  // When a transaction ends that is issued now with a delay.
  double transfer(tlm::tlm_command command, uint64_t address, unsigned length, double ahead = 0) {
    payload.set_command(command);
    payload.set_address(address);
    payload.set_data_ptr(data.data());
    payload.set_data_length(length);
    payload.set_streaming_width(length);
    payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
    sc_time delay = ns(ahead);
    socket->b_transport(payload, delay);
    return (sc_core::sc_time_stamp() + delay) / ns(1);
  }
  double read(unsigned length, double ahead = 0) {
    return transfer(tlm::TLM_READ_COMMAND, 0, length, ahead);
  }
};

class Shared : public testing::Test {
 protected:
  Shared() {
    for (auto& i : initiators_) i.socket.bind(memory_.socket);
  }
  static SharedMemoryParameters parameters() {
    SharedMemoryParameters p;
    p.bytes = 256;
    p.bytes_per_cycle = 8;
    p.latency_cycles = 5;
    return p;
  }
  SharedMemory memory_{"memory", parameters()};
  Initiator initiators_[3] = {Initiator("a"), Initiator("b"), Initiator("c")};
};

TEST_F(Shared, TransactionTakesItsBytesAndTheLatencyInWhichOthersAreServed) {
  initiators_[0].script = [](Initiator* i) {
    EXPECT_EQ(i->read(16), 2 + 5);
    EXPECT_EQ(i->read(17, 1), 2 + 3 + 5);
    sc_core::wait(ns(99));
    EXPECT_EQ(i->read(1), 100 + 1 + 5);
  };
  sc_core::sc_start();
  EXPECT_EQ(memory_.counters(0).transactions, 3u);
  EXPECT_EQ(memory_.counters(0).bytes, 34u);
  EXPECT_EQ(memory_.counters(0).waited, 1);
  EXPECT_EQ(memory_.counters(1).transactions, 0u);
  EXPECT_EQ(memory_.busy_cycles(), 2 + 3 + 1);
}

// At one instant: c is the first to run, since it was woken first, and yet the last to be served.
TEST_F(Shared, AtATieTheLowerInitiatorGoesFirst) {
  sc_core::sc_event events[3];
  double ends[3] = {}, seconds[3] = {};
  for (size_t n = 0; n < 3; ++n) {
    initiators_[n].script = [&, n](Initiator* i) {
      sc_core::wait(events[n]);
      ends[n] = i->read(8);
      seconds[n] = i->read(8);
    };
  }
  sc_core::sc_start(ns(1));
  for (const size_t n : {2, 1, 0}) events[n].notify(ns(10));
  sc_core::sc_start();
  EXPECT_EQ(ends[0], 11 + 1 + 5);
  EXPECT_EQ(ends[1], 11 + 2 + 5);
  EXPECT_EQ(ends[2], 11 + 3 + 5);
  // Second requests of the instant come behind the first ones of all.
  EXPECT_EQ(seconds[0], 11 + 4 + 5);
  EXPECT_EQ(seconds[1], 11 + 5 + 5);
  EXPECT_EQ(seconds[2], 11 + 6 + 5);
  EXPECT_EQ(memory_.counters(2).waited, 2 + 5);
}

// The first to ask is 50 ns ahead. Who asks later for an earlier time is not behind it. The channel
// has been free before, so nobody is held.
TEST_F(Shared, EarlierTimeStampGoesFirstWhoeverAsksFirst) {
  tlm::tlm_global_quantum::instance().set(ns(100));
  initiators_[0].script = [](Initiator* i) {
    sc_core::wait(ns(1000));
    EXPECT_EQ(i->read(8, 50), 1051 + 5);
    EXPECT_EQ(sc_core::sc_time_stamp(), ns(1000));
  };
  initiators_[1].script = [](Initiator* i) {
    sc_core::wait(ns(1020));
    EXPECT_EQ(i->read(8), 1021 + 5);
    EXPECT_EQ(i->read(16, 29), 1051 + 2 + 5);  // the cycle before 1050 is too short for it
    EXPECT_EQ(i->read(8, 29), 1050 + 5);
    EXPECT_EQ(sc_core::sc_time_stamp(), ns(1020));
  };
  sc_core::sc_start();
}

// Two processes that keep the channel busy, each as far ahead as it may: both are held, and each
// gets its half. One alone is not.
TEST_F(Shared, WhoFightsForTheChannelIsHeldToItsTime) {
  tlm::tlm_global_quantum::instance().set(ns(1000));
  double most_ahead = 0;
  const auto greedy = [&](Initiator* i, double until) {
    double end = sc_core::sc_time_stamp() / ns(1);
    while (end < until) {
      const double ahead = end - sc_core::sc_time_stamp() / ns(1);
      if (ahead > 1000) sc_core::wait(ns(ahead));
      end = i->read(32, std::max(0., end - sc_core::sc_time_stamp() / ns(1)));
      most_ahead = std::max(most_ahead, end - sc_core::sc_time_stamp() / ns(1));
    }
  };
  for (size_t n = 0; n < 2; ++n) {
    initiators_[n].script = [&](Initiator* i) { greedy(i, 20'000); };
  }
  initiators_[2].script = [&](Initiator* i) {
    sc_core::wait(ns(30'000));
    most_ahead = 0;
    greedy(i, 40'000);
  };
  sc_core::sc_start(ns(25'000));
  EXPECT_LT(most_ahead, 100);
  EXPECT_NEAR(static_cast<double>(memory_.counters(0).transactions),
              static_cast<double>(memory_.counters(1).transactions), 30);
  sc_core::sc_start();
  EXPECT_GT(most_ahead, 900);
}

TEST_F(Shared, BytesMoveByEnablesAndDebugTransportTakesNoTime) {
  initiators_[0].script = [](Initiator* i) {
    unsigned char enables[2] = {0, TLM_BYTE_ENABLED};
    std::fill(i->data.begin(), i->data.end(), 7);
    i->payload.set_byte_enable_ptr(enables);
    i->payload.set_byte_enable_length(2);
    i->transfer(tlm::TLM_WRITE_COMMAND, 252, 4);
    i->payload.set_byte_enable_ptr(nullptr);
    std::fill(i->data.begin(), i->data.end(), 9);
    i->payload.set_command(tlm::TLM_READ_COMMAND);
    i->payload.set_data_length(8);
    EXPECT_EQ(i->socket->transport_dbg(i->payload), 4u);
    EXPECT_EQ(std::vector<int>(i->data.begin(), i->data.begin() + 5),
              (std::vector<int>{0, 7, 0, 7, 9}));
    tlm::tlm_dmi dmi;
    EXPECT_FALSE(i->socket->get_direct_mem_ptr(i->payload, dmi));
  };
  sc_core::sc_start();
  EXPECT_EQ(memory_.counters(0).transactions, 1u);
}

TEST_F(Shared, WhatIsRefusedTakesNoTime) {
  initiators_[0].script = [](Initiator* i) {
    EXPECT_EQ(i->transfer(tlm::TLM_READ_COMMAND, 253, 4), 0);
    EXPECT_EQ(i->payload.get_response_status(), tlm::TLM_ADDRESS_ERROR_RESPONSE);
    EXPECT_EQ(i->transfer(tlm::TLM_IGNORE_COMMAND, 0, 4), 0);
    EXPECT_TRUE(i->payload.is_response_ok());
  };
  sc_core::sc_start();
  EXPECT_EQ(memory_.busy_cycles(), 0);
}

TEST(SharedParameters, ChannelWithoutBytesIsRefused) {
  SharedMemoryParameters none;
  none.bytes_per_cycle = 0;
  EXPECT_THROW(SharedMemory("none", none), std::invalid_argument);
}

// A process that is killed while its request is collected.
TEST_F(Shared, RequestOfAKilledProcessIsForgotten) {
  sc_core::sc_process_handle handle;
  initiators_[0].script = [&](Initiator* i) {
    handle = sc_core::sc_get_current_process_handle();
    i->read(8);
  };
  initiators_[1].script = [&](Initiator* i) {
    handle.kill();
    EXPECT_EQ(i->read(8), 1 + 5);
  };
  sc_core::sc_start();
  EXPECT_EQ(memory_.busy_cycles(), 1);
}

}  // namespace
}  // namespace pineda::test
