// The rasterizer's memory sockets with targets of all sorts, and the project's memory model with
// initiators of all sorts.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <functional>

#include "tests/timing/support.h"

namespace pineda::test {
namespace {

using sc_core::sc_time;
using timing::HandshakeExtension;
using timing::MemorySocket;

sc_time ns(double x) { return {x, sc_core::SC_NS}; }

// A foreign memory: handles each transaction by `serve`, and remembers the last one.
struct Target : sc_core::sc_module {
  tlm_utils::simple_target_socket<Target> socket{"socket"};
  std::function<void(tlm::tlm_generic_payload&, sc_time&)> serve;
  std::function<void(HandshakeExtension*)> ask;  // of one that knows the handshake
  std::vector<unsigned char> bytes = std::vector<unsigned char>(1 << 16);
  bool grants = false;
  int calls = 0;  // reads and writes
  int asks = 0;
  uint64_t address = 0;
  std::vector<unsigned char> enables;
  sc_time delay;

  explicit Target(sc_core::sc_module_name name) : sc_module(name) {
    socket.register_b_transport(this, &Target::b_transport);
    socket.register_get_direct_mem_ptr(this, &Target::direct);
  }
  void b_transport(tlm::tlm_generic_payload& payload, sc_time& time) {
    const bool asked = payload.get_command() == tlm::TLM_IGNORE_COMMAND;
    ++(asked ? asks : calls);
    address = payload.get_address();
    delay = time;
    const unsigned char* const enable = payload.get_byte_enable_ptr();
    const size_t length = payload.get_data_length();
    enables.assign(length, 0xff);
    for (size_t i = 0; i < length && enable != nullptr; ++i) {
      enables[i] = enable[i % payload.get_byte_enable_length()];
    }
    if (asked) payload.set_response_status(tlm::TLM_OK_RESPONSE);
    if (asked && ask) ask(payload.get_extension<HandshakeExtension>());
    if (asked) return;
    for (size_t i = 0; i < length; ++i) {
      if (enables[i] == 0) continue;
      unsigned char& here = bytes[address + i];
      unsigned char& there = payload.get_data_ptr()[i];
      payload.is_read() ? there = here : here = there;
    }
    payload.set_dmi_allowed(grants);
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
    if (serve) serve(payload, time);
  }
  bool direct(tlm::tlm_generic_payload&, tlm::tlm_dmi& dmi) {
    dmi.set_dmi_ptr(bytes.data());
    dmi.set_end_address(bytes.size() - 1);
    dmi.allow_read_write();
    dmi.set_read_latency(ns(6));
    return grants;
  }
};

class MemoryPort : public testing::Test {
 protected:
  MemoryPort() {
    ports_.depth.socket.bind(depth_.socket);
    ports_.color.socket.bind(color_.socket);
    sc_core::sc_start(sc_core::SC_ZERO_TIME);
    ports_.begin_frame({9, 4});  // five stamps in a row
  }

  timing::MemoryPorts ports_{"ports", kContract};
  Target depth_{"depth"};
  Target color_{"color"};
};

spec::DepthWrite depth_write(int x, int y, uint32_t mask) {
  spec::DepthWrite write;
  write.x = x;
  write.y = y;
  write.mask = mask;
  for (uint32_t lane = 0; lane < 4; ++lane) write.z[lane] = (mask >> lane & 1) * (0xa0b0c0 + lane);
  return write;
}

TEST_F(MemoryPort, StampIsOneBurstWithByteEnables) {
  ports_.depth.set_base(0x1000);
  ports_.depth.write(depth_write(2, 1, 0b1010), 7);
  EXPECT_EQ(depth_.address, 0x1000u + (1 * 5 + 2) * 16);
  EXPECT_EQ(depth_.delay, ns(7));
  const std::vector<unsigned char> enables{0, 0, 0, 0, 255, 255, 255, 255,
                                           0, 0, 0, 0, 255, 255, 255, 255};
  EXPECT_EQ(depth_.enables, enables);
  const unsigned char* const lane = &depth_.bytes[depth_.address + 4];
  EXPECT_EQ(std::vector<int>(lane, lane + 4), (std::vector<int>{0xc1, 0xb0, 0xa0, 0}));

  spec::DepthData data;
  ports_.depth.read(2, 1, 0b1110, 8, &data);
  EXPECT_EQ(data.z[0], 0u);  // not asked for
  EXPECT_EQ(data.z[1], 0xa0b0c1u);
  EXPECT_EQ(data.z[2], 0u);  // not written
  EXPECT_EQ(data.z[3], 0xa0b0c3u);
}

TEST_F(MemoryPort, ColorsAreBytesInOrder) {
  spec::ColorWrite write;
  write.mask = 0b1111;
  for (size_t lane = 0; lane < 4; ++lane) {
    for (size_t a = 0; a < 4; ++a) write.attr[lane][a] = static_cast<uint16_t>(16 * lane + a);
  }
  ports_.color.write(write, 3);
  EXPECT_EQ(color_.enables, std::vector<unsigned char>(16, 0xff));
  for (size_t i = 0; i < 16; ++i) EXPECT_EQ(color_.bytes[i], 16 * (i / 4) + i % 4);
}

// The target has no ready signal: reads are accepted at once and answered after the delay.
TEST_F(MemoryPort, ForeignTargetAnswersAfterItsDelay) {
  spec::DepthData data;
  EXPECT_EQ(ports_.depth.read(0, 0, 1, 10, &data).response, 11);  // no delay: the next cycle
  depth_.serve = [](auto&, sc_time& time) { time += ns(4.5); };
  const auto taken = ports_.depth.read(1, 0, 1, 20, &data);
  EXPECT_EQ(taken.accepted, 20);
  EXPECT_EQ(taken.response, 25);
  depth_.serve = nullptr;
  EXPECT_EQ(ports_.depth.read(2, 0, 1, 21, &data).response, 26);  // in order
  color_.serve = [](auto&, sc_time& time) { time += ns(3); };
  EXPECT_EQ(ports_.color.write(spec::ColorWrite{}, 30).accepted, 33);
}

TEST_F(MemoryPort, CyclesAreAsLongAsThePlatformSays) {
  ports_.depth.set_period(ns(2.5));
  depth_.serve = [](auto&, sc_time& time) { time += ns(10); };
  spec::DepthData data;
  EXPECT_EQ(ports_.depth.read(0, 0, 1, 100, &data).response, 104);
  EXPECT_EQ(depth_.delay, ns(250));
}

// Not ready until 40, and asked about it; a request is served by one call.
class AskedPort : public MemoryPort {
 protected:
  void begin() {
    depth_.ask = [](HandshakeExtension* handshake) {
      handshake->ready_from = std::max<Cycle>(handshake->offered, 40);
    };
    depth_.serve = [](tlm::tlm_generic_payload& payload, sc_time& time) {
      auto* const handshake = payload.get_extension<HandshakeExtension>();
      handshake->accepted = handshake->offered;
      time += ns(3);
    };
    ports_.depth.set_base(0x1000);  // another target, for all that the port knows
    ports_.begin_frame({9, 4});
    depth_.asks = depth_.calls = 0;
  }
};

TEST_F(AskedPort, RequestIsOfferedAgainWhenTheTargetSays) {
  begin();
  spec::DepthData data;
  const auto taken = ports_.depth.read(0, 0, 1, 10, &data);
  EXPECT_EQ(taken.retry_from, 40);
  EXPECT_EQ(taken.accepted, -1);
  const auto refused = ports_.read({0, 0, 0, 1}, 10, &data);
  EXPECT_FALSE(refused.taken);
  EXPECT_EQ(refused.cycle, 40);
  EXPECT_EQ(depth_.calls, 0);
  const auto read = ports_.read({0, 0, 0, 1}, 40, &data);
  EXPECT_TRUE(read.taken);
  EXPECT_EQ(read.cycle, 40);
  EXPECT_EQ(read.response, 43);
  EXPECT_EQ(ports_.write(depth_write(0, 0, 1), 12).cycle, 40);
  EXPECT_EQ(depth_.calls, 1);
  EXPECT_EQ(depth_.asks, 4);
}

// The question is a transaction that reads and writes nothing, even where it is taken for a write.
TEST_F(MemoryPort, WhoDoesNotKnowTheHandshakeIsAskedOnce) {
  EXPECT_EQ(depth_.asks, 1);
  EXPECT_EQ(color_.asks, 1);
  EXPECT_EQ(depth_.enables, std::vector<unsigned char>(16, 0));
  ports_.begin_frame({9, 4});
  ports_.depth.write(depth_write(0, 0, 1), 12);
  EXPECT_EQ(depth_.asks, 1);
  EXPECT_EQ(depth_.calls, 1);
}

TEST_F(MemoryPort, GrantedDirectAccessNeedsNoMoreCalls) {
  depth_.grants = true;
  ports_.depth.write(depth_write(0, 0, 0b1111), 1);
  EXPECT_EQ(depth_.calls, 1);
  spec::DepthData data;
  const auto taken = ports_.depth.read(0, 0, 0b0100, 10, &data);
  EXPECT_EQ(taken.accepted, 10);
  EXPECT_EQ(taken.response, 16);
  EXPECT_EQ(data.z[2], 0xa0b0c2u);
  EXPECT_EQ(data.z[1], 0u);
  EXPECT_EQ(ports_.depth.write(depth_write(1, 1, 0b0010), 11).accepted, 11);
  EXPECT_EQ(depth_.bytes[(5 + 1) * 16 + 4], 0xc1);
  EXPECT_EQ(depth_.bytes[(5 + 1) * 16 + 0], 0);  // not in the mask
  EXPECT_EQ(depth_.calls, 1);
}

TEST_F(MemoryPort, DirectAccessEndsWhenItIsInvalidated) {
  depth_.grants = true;
  ports_.depth.write(depth_write(0, 0, 0b1111), 1);
  depth_.socket->invalidate_direct_mem_ptr(1 << 20, 1 << 21);  // an address range of other memory
  ports_.depth.write(depth_write(0, 0, 0b1111), 2);
  EXPECT_EQ(depth_.calls, 1);
  depth_.socket->invalidate_direct_mem_ptr(0, 100);
  ports_.depth.write(depth_write(0, 0, 0b1111), 3);
  EXPECT_EQ(depth_.calls, 2);
}

TEST_F(MemoryPort, ErrorResponseNamesSocketAddressCommandAndResponse) {
  depth_.serve = [](tlm::tlm_generic_payload& payload, auto&) {
    payload.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
  };
  EXPECT_EQ(reported([&] { ports_.depth.write(depth_write(2, 1, 1), 1); }),
            "pineda/memory/response: ports.depth_socket: write of 16 bytes at 0x70: "
            "TLM_ADDRESS_ERROR_RESPONSE");
  depth_.serve = nullptr;
  EXPECT_EQ(ports_.depth.write(depth_write(2, 1, 1), 1).accepted, 1);
}

// A target that does nothing at all.
TEST_F(MemoryPort, ResponseThatIsNotSetIsAnError) {
  depth_.serve = [](tlm::tlm_generic_payload& payload, auto&) {
    payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  };
  spec::DepthData data;
  EXPECT_EQ(reported([&] { ports_.depth.read(0, 0, 1, 1, &data); }),
            "pineda/memory/response: ports.depth_socket: read of 16 bytes at 0x0: "
            "TLM_INCOMPLETE_RESPONSE");
}

// SystemC reports on stdout, a death test listens to stderr.
void report_on_stderr() { dup2(STDERR_FILENO, STDOUT_FILENO); }

TEST(Unbound, MemoryOutsideIsMissed) {
  EXPECT_DEATH(
      {
        report_on_stderr();
        timing::RasterTop top("top", kContract, timing::Memories::kOutside);
        sc_core::sc_start();
      },
      "pineda/raster_top/unbound: top.memory_ports.depth_socket");
}

}  // namespace
}  // namespace pineda::test
