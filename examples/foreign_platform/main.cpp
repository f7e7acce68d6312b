// The rasterizer in someone else's platform: a processor and a memory that know nothing of it but
// TLM-2.0.
//
//   processor --+
//   depth ------+--> memory, 1 MiB
//   colour -----+
//
// The processor clears the frame in the memory, has it drawn, and reads it back. The memory takes a
// given time for each transaction; it has no ready and valid signals and grants no direct access.
#include <tlm_utils/multi_passthrough_target_socket.h>
#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/tlm_quantumkeeper.h>

#include <cstdio>
#include <cstring>
#include <systemc>
#include <tlm>
#include <vector>

#include "model/timing/raster_top.h"

namespace {

using namespace pineda;  // NOLINT: a program, not a header
using sc_core::sc_time;

constexpr uint64_t kDepthBase = 0x00000;
constexpr uint64_t kColorBase = 0x80000;
const sc_time kCycle(2.5, sc_core::SC_NS);  // the rasterizer runs at 400 MHz

// Someone else's memory.
struct Memory : sc_core::sc_module {
  tlm_utils::multi_passthrough_target_socket<Memory> socket{"socket"};
  std::vector<unsigned char> bytes = std::vector<unsigned char>(1 << 20);
  sc_time latency;

  explicit Memory(sc_core::sc_module_name name) : sc_module(name) {
    socket.register_b_transport(this, &Memory::b_transport);
  }

  void b_transport(int, tlm::tlm_generic_payload& payload, sc_time& delay) {
    const uint64_t length = payload.get_data_length();
    if (payload.get_address() + length > bytes.size()) {
      payload.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
      return;
    }
    const unsigned char* const enables = payload.get_byte_enable_ptr();
    for (uint64_t i = 0; i < length; ++i) {
      if (enables != nullptr && enables[i % payload.get_byte_enable_length()] == 0) continue;
      unsigned char& here = bytes[payload.get_address() + i];
      unsigned char& there = payload.get_data_ptr()[i];
      payload.is_read() ? there = here : here = there;
    }
    delay += latency;
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
  }
};

spec::Triangle triangle(int x0, int y0, int x1, int y1, int x2, int y2, int z, int gray) {
  constexpr int kPx = 1 << spec::kHighTile.subpixel_bits;
  const int corners[3][2] = {{x0, y0}, {x1, y1}, {x2, y2}};
  spec::Triangle t;
  for (size_t i = 0; i < 3; ++i) {
    t.v[i].x = corners[i][0] * kPx;
    t.v[i].y = corners[i][1] * kPx;
    t.v[i].z = int64_t{z} << spec::kDepthInputFractionBits;
    for (size_t a = 0; a < 4; ++a) t.v[i].attr[a] = gray + 20 * static_cast<int>(i);
  }
  return t;
}

struct Processor : sc_core::sc_module {
  tlm_utils::simple_initiator_socket<Processor> socket{"socket"};
  bool failed = true;

  Processor(sc_core::sc_module_name name, Memory* memory, timing::RasterTop* rasterizer)
      : sc_module(name), memory_(*memory), rasterizer_(*rasterizer) {
    SC_HAS_PROCESS(Processor);
    SC_THREAD(run);
  }

 private:
  void run() {
    // One stamp: a read, then a depth write and behind it a colour write, each as long as the
    // memory takes; all else of a frame of one stamp takes 38 cycles.
    const std::vector<spec::Triangle> one{triangle(0, 0, 128, 0, 0, 128, 1000, 50)};
    const std::vector<spec::Triangle> many{triangle(3, 1, 90, 20, 10, 60, 4000, 30),
                                           triangle(60, 2, 70, 62, 0, 33, 3000, 90),
                                           triangle(0, 40, 95, 45, 50, 63, 5000, 150)};
    bool right = true;
    for (const int cycles : {4, 20}) {
      memory_.latency = cycles * kCycle;
      right = draw({2, 2}, one) == 38 + 2 * cycles && right;
    }
    memory_.latency = 4 * kCycle;
    const timing::Cycle fast = draw({96, 64}, many);
    memory_.latency = 20 * kCycle;
    right = draw({96, 64}, many) > fast && right;
    spec::FrameState reversed{96, 64, spec::Cull::kNone, spec::DepthFunc::kGreater};
    reversed.clear_depth = 0;
    draw(reversed, many);
    failed = !right || mismatches_ > 0;
    sc_core::sc_stop();
  }

  // Clears, draws, compares; the cycles of the frame.
  timing::Cycle draw(const spec::FrameState& frame, const std::vector<spec::Triangle>& triangles) {
    const spec::Contract contract = spec::contract(spec::kHighTile);
    const memory::FrameLayout depth(contract, frame, memory::kDepthBytes);
    const memory::FrameLayout color(contract, frame, memory::color_bytes(contract.design));
    transfer(tlm::TLM_WRITE_COMMAND, kDepthBase, depth_bytes(contract, frame, depth));
    transfer(tlm::TLM_WRITE_COMMAND, kColorBase, std::vector<unsigned char>(color.bytes()));
    keeper_.sync();

    const sc_time begun = sc_core::sc_time_stamp();
    const auto pull = [&triangles, i = size_t{0}](spec::Triangle* t) mutable {
      if (i == triangles.size()) return false;
      *t = triangles[i++];
      return true;
    };
    const timing::FrameResult result = rasterizer_.run(frame, pull);
    const sc_time passed = sc_core::sc_time_stamp() - begun;
    if (passed != static_cast<double>(result.spent.drained) * kCycle) ++mismatches_;

    core::Renderer reference(contract, frame);
    for (const spec::Triangle& t : triangles) reference.draw(t);
    compare(contract, frame, depth, color, reference.buffer());
    std::printf("%dx%d, memory %s: %lld cycles, %s, %llu samples drawn, %d mismatches\n",
                frame.width, frame.height, memory_.latency.to_string().c_str(),
                static_cast<long long>(result.cycles), passed.to_string().c_str(),
                static_cast<unsigned long long>(result.counters.passed), mismatches_);
    if (result.counters.passed == 0) ++mismatches_;
    return result.cycles;
  }

  static std::vector<unsigned char> depth_bytes(const spec::Contract& contract,
                                                const spec::FrameState& frame,
                                                const memory::FrameLayout& layout) {
    std::vector<unsigned char> bytes(layout.bytes());
    // Little-endian, as it is here
    const uint32_t cleared = spec::cleared_depth(contract.design, frame);
    for (size_t i = 0; i < bytes.size(); i += 4) std::memcpy(&bytes[i], &cleared, 4);
    return bytes;
  }

  void compare(const spec::Contract& contract, const spec::FrameState& frame,
               const memory::FrameLayout& depth, const memory::FrameLayout& color,
               const core::FrameBuffer& expected) {
    const auto depths =
        transfer(tlm::TLM_READ_COMMAND, kDepthBase, std::vector<unsigned char>(depth.bytes()));
    const auto colors =
        transfer(tlm::TLM_READ_COMMAND, kColorBase, std::vector<unsigned char>(color.bytes()));
    keeper_.sync();
    const int w_log2 = contract.design.stamp_width_log2;
    const int h_log2 = contract.design.stamp_height_log2;
    size_t sample = 0;
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x, ++sample) {
        const auto lane = static_cast<uint64_t>((y % (1 << h_log2)) << w_log2 | x % (1 << w_log2));
        const uint64_t at = depth.offset(x >> w_log2, y >> h_log2) + 4 * lane;  // in both
        uint32_t z;
        std::memcpy(&z, &depths[at], 4);
        if (z != expected.depth[sample]) ++mismatches_;
        for (size_t c = 0; c < 4; ++c) {
          if (colors[at + c] != expected.color[4 * sample + c]) ++mismatches_;
        }
      }
    }
  }

  std::vector<unsigned char> transfer(tlm::tlm_command command, uint64_t address,
                                      std::vector<unsigned char> bytes) {
    tlm::tlm_generic_payload payload;
    payload.set_command(command);
    payload.set_address(address);
    payload.set_data_ptr(bytes.data());
    payload.set_data_length(static_cast<unsigned>(bytes.size()));
    payload.set_streaming_width(static_cast<unsigned>(bytes.size()));
    sc_time delay = keeper_.get_local_time();
    socket->b_transport(payload, delay);
    keeper_.set(delay);
    if (payload.is_response_error()) ++mismatches_;
    return bytes;
  }

  Memory& memory_;
  timing::RasterTop& rasterizer_;
  tlm_utils::tlm_quantumkeeper keeper_;
  int mismatches_ = 0;
};

}  // namespace

int sc_main(int, char*[]) {
  Memory memory("memory");
  timing::RasterTop rasterizer("rasterizer", spec::contract(spec::kHighTile),
                               timing::Memories::kOutside);
  rasterizer.set_memory_map(kCycle, kDepthBase, kColorBase);
  Processor processor("processor", &memory, &rasterizer);
  processor.socket.bind(memory.socket);
  rasterizer.depth_socket().bind(memory.socket);
  rasterizer.color_socket().bind(memory.socket);
  sc_core::sc_start();
  std::printf("%s\n", processor.failed ? "IT DOES NOT HOLD." : "It holds.");
  return processor.failed ? 1 : 0;
}
