// The rasterizer as a device: registers, frames from memory and through the window, the queue,
// resets, errors. Every socket is behind a checker.
#include "model/timing/device/raster_device.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <functional>
#include <sstream>

#include "model/spec/clear_depth.h"
#include "model/timing/ports/shared_memory.h"
#include "tests/timing/support.h"
#include "tests/timing/tlm_checker.h"

namespace pineda::test {
namespace {

using sc_core::sc_time;
using timing::Register;

sc_time ns(double x) { return {x, sc_core::SC_NS}; }

constexpr uint64_t kDepthBase = 0x00000, kColorBase = 0x40000, kTriangleBase = 0x80000;
constexpr spec::FrameState kFrame{70, 50, spec::Cull::kNone, spec::DepthFunc::kLess};

// A processor that runs a script, a device and a memory.
struct Platform : sc_core::sc_module {
  tlm_utils::simple_initiator_socket<Platform> processor{"processor"};
  timing::RasterDevice device{"device", kContract};
  timing::SharedMemory memory{"memory", {}};
  sc_core::sc_signal<bool> interrupt{"interrupt"};
  Checkers checkers;
  std::function<void()> script;
  tlm::tlm_generic_payload payload;
  bool done = false;

  explicit Platform(sc_core::sc_module_name name) : sc_module(name) {
    checkers.between(&processor, &device.registers);
    checkers.between(&device.triangle_socket(), &memory.socket);
    checkers.between(&device.depth_socket(), &memory.socket);
    checkers.between(&device.color_socket(), &memory.socket);
    device.interrupt(interrupt);
    SC_HAS_PROCESS(Platform);
    SC_THREAD(run);
  }
  void run() {
    script();
    done = true;
  }
  tlm::tlm_response_status access(tlm::tlm_command command, uint64_t address, uint32_t* value,
                                  unsigned length = 4) {
    unsigned char bytes[8] = {};
    std::memcpy(bytes, value, 4);  // little-endian, as it is here
    payload.set_command(command);
    payload.set_address(address);
    payload.set_data_ptr(bytes);
    payload.set_data_length(length);
    payload.set_streaming_width(length);
    payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
    sc_time delay;
    processor->b_transport(payload, delay);
    std::memcpy(value, bytes, 4);
    return payload.get_response_status();
  }
  tlm::tlm_response_status write(Register reg, uint32_t value) {
    return access(tlm::TLM_WRITE_COMMAND, timing::offset_of(reg), &value);
  }
  uint32_t read(Register reg) {
    uint32_t value = 0;
    EXPECT_EQ(access(tlm::TLM_READ_COMMAND, timing::offset_of(reg), &value), tlm::TLM_OK_RESPONSE);
    return value;
  }
  void clear(uint64_t depth_base = kDepthBase) {
    const uint32_t code = spec::cleared_depth(kContract.design, kFrame);
    for (uint64_t i = 0; i < 0x4000; i += 4) std::memcpy(&memory.bytes()[depth_base + i], &code, 4);
  }
  void lay(const std::vector<spec::Triangle>& triangles, uint64_t address = kTriangleBase) {
    const spec::Packer<spec::Triangle> packer(kContract);
    for (const spec::Triangle& t : triangles) {
      const spec::Packed words = packer.pack(t);
      std::memcpy(&memory.bytes()[address], words.data(), 4 * words.size());
      address += 4 * words.size();
    }
  }
  void set_up(size_t triangles) {
    write(Register::kFrameSize, 70 | 50 << 16);
    write(Register::kDepthBase, kDepthBase);
    write(Register::kColorBase, kColorBase);
    write(Register::kTriangleBase, kTriangleBase);
    write(Register::kTriangleCount, static_cast<uint32_t>(triangles));
    write(Register::kInterruptEnable, 3);
  }
  // The bits that are pending; cleared.
  uint32_t wait_for_interrupt() {
    if (!interrupt.read()) wait(interrupt.posedge_event());
    const uint32_t bits = read(Register::kInterruptPending);
    write(Register::kInterruptPending, bits);
    wait(sc_core::SC_ZERO_TIME);
    wait(sc_core::SC_ZERO_TIME);
    return bits;
  }
  // Samples whose depth is not that of core.
  int mismatches(const std::vector<spec::Triangle>& triangles, uint64_t depth_base = kDepthBase) {
    core::Renderer renderer(kContract, kFrame);
    for (const spec::Triangle& t : triangles) renderer.draw(t);
    const memory::FrameLayout layout(kContract, kFrame, memory::kDepthBytes);
    int wrong = 0;
    for (int y = 0; y < 50; ++y) {
      for (int x = 0; x < 70; ++x) {
        const auto lane = static_cast<uint64_t>(2 * (y % 2) + x % 2);
        uint32_t z = 0;
        std::memcpy(&z, &memory.bytes()[depth_base + layout.offset(x / 2, y / 2) + 4 * lane], 4);
        wrong += z != renderer.buffer().depth[static_cast<size_t>(y * 70 + x)] ? 1 : 0;
      }
    }
    return wrong;
  }
};

std::vector<spec::Triangle> triangles(uint64_t seed = 8) {
  return random_scene(Kind::kMedium, seed, 30).triangles;
}

class RasterDevice : public testing::Test {
 protected:
  void run(std::function<void()> script) {
    platform_.script = std::move(script);
    sc_core::sc_start();
    EXPECT_TRUE(platform_.done);
    for (const auto& fault : faults()) ADD_FAILURE() << fault;
  }
  std::vector<std::string> faults() const {
    std::istringstream lines(platform_.checkers.faults());
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) {
      if (line.find("saw nothing") == std::string::npos) all.push_back(line);
    }
    return all;
  }
  Platform platform_{"platform"};
  Platform& p_ = platform_;
};

TEST_F(RasterDevice, DrawsTrianglesFromMemoryAtAnyQuantum) {
  run([&] {
    p_.lay(triangles());
    p_.set_up(30);
    uint32_t cycles = 0;
    for (const double quantum : {0., 1000.}) {
      tlm::tlm_global_quantum::instance().set(ns(quantum));
      p_.clear();
      const sc_time begun = sc_core::sc_time_stamp();
      EXPECT_EQ(p_.write(Register::kControl, timing::kStart), tlm::TLM_OK_RESPONSE);
      EXPECT_EQ(p_.read(Register::kStatus) & 0xff, timing::kStatusBusy);
      EXPECT_EQ(p_.wait_for_interrupt(), timing::kInterruptDone);
      EXPECT_FALSE(p_.interrupt.read());
      EXPECT_EQ(p_.read(Register::kStatus), 0u);
      EXPECT_EQ(p_.mismatches(triangles()), 0);
      EXPECT_GE(sc_core::sc_time_stamp() - begun,
                static_cast<double>(p_.read(Register::kCycles)) * ns(1));
      if (quantum == 0) cycles = p_.read(Register::kCycles);
    }
    EXPECT_GT(cycles, 500u);
    EXPECT_NEAR(p_.read(Register::kCycles), cycles, cycles / 10.);
    EXPECT_EQ(p_.read(Register::kFramesDone), 2u);
    EXPECT_EQ(p_.memory.counters(0).transactions, 60u);
  });
}

// The mutant in mind: a device that forgets what was pushed, or draws it twice.
TEST_F(RasterDevice, DrawsTrianglesThatAreWrittenToIt) {
  run([&] {
    const spec::Packer<spec::Triangle> packer(kContract);
    EXPECT_EQ(p_.read(Register::kTriangleWords), static_cast<uint32_t>(packer.words()));
    p_.set_up(0);
    for (const uint64_t seed : {8, 9}) {
      p_.clear();
      for (const spec::Triangle& t : triangles(seed)) {
        for (const uint32_t word : packer.pack(t)) p_.write(Register::kTriangleData, word);
      }
      p_.write(Register::kControl, timing::kStartPushed);
      EXPECT_EQ(p_.wait_for_interrupt(), timing::kInterruptDone);
      EXPECT_EQ(p_.mismatches(triangles(seed)), 0);
    }
    for (int i = 0; i < 64 * packer.words(); ++i) {
      EXPECT_EQ(p_.write(Register::kTriangleData, 0), tlm::TLM_OK_RESPONSE);
    }
    EXPECT_EQ(p_.write(Register::kTriangleData, 0), tlm::TLM_GENERIC_ERROR_RESPONSE);
  });
}

TEST_F(RasterDevice, QueuesFramesAndRefusesOneTooMany) {
  run([&] {
    p_.lay(triangles());
    p_.set_up(30);
    for (uint32_t i = 0; i < 4; ++i) {
      p_.clear(0x4000 * i);
      p_.write(Register::kDepthBase, 0x4000 * i);
      EXPECT_EQ(p_.write(Register::kControl, timing::kStart), tlm::TLM_OK_RESPONSE);
      EXPECT_EQ(p_.read(Register::kStatus) >> timing::kStatusQueuedShift, i + 1);
    }
    EXPECT_EQ(p_.read(Register::kStatus) & timing::kStatusFull, timing::kStatusFull);
    EXPECT_EQ(p_.write(Register::kControl, timing::kStart), tlm::TLM_GENERIC_ERROR_RESPONSE);
    while (p_.read(Register::kFramesDone) < 4) sc_core::wait(ns(100));
    for (uint32_t i = 0; i < 4; ++i) EXPECT_EQ(p_.mismatches(triangles(), 0x4000 * i), 0) << i;
  });
}

TEST_F(RasterDevice, ResetInMidFrameStopsItAndTheNextFrameIsRight) {
  run([&] {
    p_.lay(triangles());
    for (int at = 50; at < 1000; at += 61) {
      p_.set_up(30);
      p_.clear();
      p_.write(Register::kControl, timing::kStart);
      p_.write(Register::kControl, timing::kStart);
      sc_core::wait(ns(at));
      p_.write(Register::kControl, timing::kReset);
      const auto written = p_.memory.counters(1).transactions;
      EXPECT_EQ(p_.read(Register::kFrameSize), 0x10001u);
      if (at % 2 == 0) {  // a start at once, or when the old frame has stopped
        while (p_.read(Register::kStatus) != 0) sc_core::wait(ns(10));
        EXPECT_LE(p_.memory.counters(1).transactions, written + 1);
        EXPECT_GT(p_.mismatches(triangles()), 0) << at;
      }
      EXPECT_EQ(p_.read(Register::kInterruptPending), 0u);
      p_.clear();
      p_.set_up(30);
      p_.write(Register::kControl, timing::kStart);
      EXPECT_EQ(p_.wait_for_interrupt(), timing::kInterruptDone);
      EXPECT_EQ(p_.mismatches(triangles()), 0) << at;
      EXPECT_EQ(p_.read(Register::kFramesDone), 1u);
    }
  });
}

// Three kinds of failure, each followed by a frame that is right.
TEST_F(RasterDevice, FailedFrameIsToldAndTheNextOneIsDrawn) {
  run([&] {
    p_.lay(triangles());
    const std::pair<Register, uint32_t> wrong[] = {
        {Register::kFrameSize, 0},               // pineda/raster_top/frame
        {Register::kTriangleBase, 0xfffffff0u},  // nothing is there
        {Register::kDepthBase, 0xfffffff0u},
    };
    for (const auto& [reg, value] : wrong) {
      p_.set_up(30);
      p_.write(reg, value);
      p_.write(Register::kControl, timing::kStart);
      EXPECT_EQ(p_.wait_for_interrupt(), timing::kInterruptFailed) << timing::row_of(reg).name;
      EXPECT_EQ(p_.read(Register::kStatus), timing::kStatusFailed);
      p_.clear();
      p_.set_up(30);
      p_.write(Register::kControl, timing::kStart);
      EXPECT_EQ(p_.wait_for_interrupt(), timing::kInterruptDone);
      EXPECT_EQ(p_.mismatches(triangles()), 0);
    }
  });
}

TEST_F(RasterDevice, StateThatDoesNotExistIsRefused) {
  run([&] {
    const std::pair<Register, uint32_t> wrong[] = {
        {Register::kState, 3},
        {Register::kState, 9 << 4},
        {Register::kBiasSlope, 32768},
        {Register::kBiasConstant, 1 << 24},
        {Register::kBiasConstantHigh, 1},
        {Register::kClearDepth, 0x7fc00000},
        {Register::kClearDepth, 0xbf800000},
    };
    for (const auto& [reg, value] : wrong) {
      p_.write(reg, value);
      EXPECT_EQ(p_.write(Register::kControl, timing::kStart), tlm::TLM_GENERIC_ERROR_RESPONSE);
      p_.write(reg, timing::row_of(reg).reset);
      EXPECT_EQ(p_.read(Register::kStatus), 0u);
    }
  });
}

TEST_F(RasterDevice, AccessesThatBreakTheRulesAreAnswered) {
  run([&] {
    uint32_t value = 0;
    const auto write = tlm::TLM_WRITE_COMMAND, read = tlm::TLM_READ_COMMAND;
    for (const auto& row : timing::kRegisters) {
      const bool readable = row.access != timing::Access::kWrite;
      const bool writable = row.access != timing::Access::kRead;
      if (row.value == Register::kControl || row.value == Register::kTriangleData) {
        EXPECT_EQ(p_.access(read, row.offset, &value), tlm::TLM_COMMAND_ERROR_RESPONSE);
        continue;
      }
      ASSERT_TRUE(readable);
      EXPECT_EQ(p_.access(read, row.offset, &value), tlm::TLM_OK_RESPONSE);
      EXPECT_TRUE(value == row.reset || row.value == Register::kTriangleWords) << row.name;
      EXPECT_EQ(p_.access(write, row.offset, &value),
                writable ? tlm::TLM_OK_RESPONSE : tlm::TLM_COMMAND_ERROR_RESPONSE);
      EXPECT_EQ(p_.access(read, row.offset + 1, &value), tlm::TLM_ADDRESS_ERROR_RESPONSE);
      EXPECT_EQ(p_.access(read, row.offset, &value, 8), tlm::TLM_BURST_ERROR_RESPONSE);
    }
    EXPECT_EQ(p_.access(read, 0x1000, &value), tlm::TLM_ADDRESS_ERROR_RESPONSE);
    unsigned char enables[4] = {TLM_BYTE_ENABLED, TLM_BYTE_ENABLED, 0, TLM_BYTE_ENABLED};
    p_.payload.set_byte_enable_ptr(enables);
    p_.payload.set_byte_enable_length(4);
    EXPECT_EQ(p_.access(write, 0x18, &value), tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
    p_.payload.set_byte_enable_ptr(nullptr);
  });
}

// What a write keeps of a register, and a delay that passes before the access.
TEST_F(RasterDevice, RegistersHoldWhatIsWrittenAndDebugTransportReadsThem) {
  run([&] {
    for (const auto& row : timing::kRegisters) {
      if (row.access != timing::Access::kReadWrite || row.value == Register::kInterruptPending) {
        continue;
      }
      p_.write(row.value, 0xa5a50000u + row.offset);
    }
    for (const auto& row : timing::kRegisters) {
      if (row.access != timing::Access::kReadWrite || row.value == Register::kInterruptPending) {
        continue;
      }
      EXPECT_EQ(p_.read(row.value), 0xa5a50000u + row.offset) << row.name;
      uint32_t seen = 0;
      p_.payload.set_command(tlm::TLM_READ_COMMAND);
      p_.payload.set_address(row.offset);
      p_.payload.set_data_ptr(reinterpret_cast<unsigned char*>(&seen));
      EXPECT_EQ(p_.processor->transport_dbg(p_.payload), 4u);
      EXPECT_EQ(seen, 0xa5a50000u + row.offset);
    }
  });
}

std::string row_text(const timing::RegisterRow& row) {
  static constexpr const char* kAccess[] = {"read", "write", "read, write"};
  const std::string reset = row.value == Register::kTriangleWords ? "by design"
                            : row.access == timing::Access::kWrite
                                ? ""
                                : fmt::format("`0x{:08x}`", row.reset);
  return fmt::format("| `0x{:02x}` | `{}` | {} | {} | {} |", row.offset, row.name,
                     kAccess[static_cast<size_t>(row.access)], reset, row.meaning);
}

TEST(RasterDeviceTable, IsTheOneInTheDocument) {
  std::ifstream file(PINEDA_DEVICE_DOCUMENT);
  std::vector<std::string> written, expected;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("| `0x", 0) == 0) written.push_back(line);
  }
  for (const auto& row : timing::kRegisters) expected.push_back(row_text(row));
  EXPECT_EQ(written, expected);
}

TEST(RasterDeviceTable, RowsStandInOrder) {
  for (size_t i = 0; i < timing::kRegisterCount; ++i) {
    EXPECT_EQ(static_cast<size_t>(timing::kRegisters[i].value), i);
    EXPECT_EQ(timing::kRegisters[i].offset, 4 * i);
  }
}

}  // namespace
}  // namespace pineda::test
