// Two rasterizers that share a DRAM's channel in a SystemC platform: each draws a frame alone, then both at the
// same time.
//
//   processor 0 -- rasterizer 0 --+
//                                 +--> SharedMemory, 4 bytes a cycle
//   processor 1 -- rasterizer 1 --+
//
//   two_rasterizers [QUANTUM_NS]     how far a rasterizer may run ahead of simulated time
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <systemc>
#include <tlm>
#include <vector>

#include "model/spec/clear_depth.h"
#include "model/timing/ports/shared_memory.h"
#include "model/timing/raster_top.h"

namespace {

using namespace pineda;  // NOLINT: a program, not a header
using sc_core::sc_time;

constexpr spec::Contract kContract = spec::contract(spec::kHighTile);
constexpr spec::FrameState kFrame{96, 64};
const sc_time kPeriod(1, sc_core::SC_NS);

// Depth and colour of a rasterizer lie one behind the other.
struct Region {
  explicit Region(uint64_t base)
      : depth(base),
        color(base + memory::FrameLayout(kContract, kFrame, memory::kDepthBytes).bytes()),
        end(color +
            memory::FrameLayout(kContract, kFrame, memory::color_bytes(kContract.design)).bytes()) {
  }
  uint64_t depth, color, end;
};

std::vector<spec::Triangle> scene() {
  std::vector<spec::Triangle> all(60);
  for (int i = 0; i < 60; ++i) {
    spec::Triangle& t = all[static_cast<size_t>(i)];
    t.id = static_cast<uint32_t>(i);
    const int px[3][2] = {{i, i / 2}, {95 - i / 3, 63 - i}, {(7 * i) % 96, 63}};
    for (size_t k = 0; k < 3; ++k) {
      t.v[k].x = px[k][0] << kContract.design.subpixel_bits;
      t.v[k].y = px[k][1] << kContract.design.subpixel_bits;
      t.v[k].z = int64_t{100'000} * (60 - i) << spec::kDepthInputFractionBits;
      for (size_t a = 0; a < 4; ++a) t.v[k].attr[a] = 4 * i + static_cast<int>(k);
    }
  }
  return all;
}

// Has its rasterizer draw a frame at each of its start times.
struct Processor : sc_core::sc_module {
  std::vector<sc_time> starts;
  std::vector<timing::Cycle> cycles;

  Processor(sc_core::sc_module_name name, timing::RasterTop* rasterizer,
            timing::SharedMemory* memory, Region region)
      : sc_module(name), rasterizer_(*rasterizer), memory_(*memory), region_(region) {
    SC_HAS_PROCESS(Processor);
    SC_THREAD(run);
  }

 private:
  void run() {
    for (const sc_time& start : starts) {
      if (start > sc_core::sc_time_stamp()) wait(start - sc_core::sc_time_stamp());
      clear();
      cycles.push_back(rasterizer_.run(kFrame, scene()).cycles);
    }
  }
  // A platform clears its memories before each frame; here it takes no time.
  void clear() {
    std::vector<unsigned char>& bytes = memory_.bytes();
    const uint32_t depth = spec::cleared_depth(kContract.design, kFrame);
    for (uint64_t at = region_.depth; at < region_.color; ++at) {
      bytes[at] = static_cast<unsigned char>(depth >> 8 * (at % memory::kDepthBytes));
    }
    std::fill(bytes.begin() + static_cast<long>(region_.color),
              bytes.begin() + static_cast<long>(region_.end), 0);
  }

  timing::RasterTop& rasterizer_;
  timing::SharedMemory& memory_;
  Region region_;
};

}  // namespace

int sc_main(int argc, char* argv[]) {
  tlm::tlm_global_quantum::instance().set(
      sc_time(argc > 1 ? std::atof(argv[1]) : 0, sc_core::SC_NS));
  const Region region[2] = {Region(0), Region(Region(0).end)};
  timing::SharedMemoryParameters parameters;
  parameters.bytes = region[1].end;
  parameters.period = kPeriod;
  parameters.bytes_per_cycle = 4;
  timing::SharedMemory dram("dram", parameters);
  timing::RasterTop left("left", kContract, timing::Memories::kOutside);
  timing::RasterTop right("right", kContract, timing::Memories::kOutside);
  timing::RasterTop* const rasterizer[2] = {&left, &right};
  for (size_t i = 0; i < 2; ++i) {
    rasterizer[i]->set_memory_map(kPeriod, region[i].depth, region[i].color);
    rasterizer[i]->depth_socket().bind(dram.socket);
    rasterizer[i]->color_socket().bind(dram.socket);
  }
  Processor first("first", &left, &dram, region[0]);
  Processor second("second", &right, &dram, region[1]);
  first.starts = {sc_time(0, sc_core::SC_US), sc_time(1000, sc_core::SC_US)};
  second.starts = {sc_time(500, sc_core::SC_US), sc_time(1000, sc_core::SC_US)};
  sc_core::sc_start();

  const auto& bytes = dram.bytes();
  const bool same = std::equal(bytes.begin(), bytes.begin() + static_cast<long>(region[0].end),
                               bytes.begin() + static_cast<long>(region[1].depth));
  const bool drawn = std::any_of(bytes.begin() + static_cast<long>(region[0].color),
                                 bytes.begin() + static_cast<long>(region[0].end),
                                 [](int byte) { return byte > 0; });
  std::printf("alone     %lld and %lld cycles\ntogether  %lld and %lld cycles\n",
              static_cast<long long>(first.cycles[0]), static_cast<long long>(second.cycles[0]),
              static_cast<long long>(first.cycles[1]), static_cast<long long>(second.cycles[1]));
  for (size_t i = 0; i < 4; ++i) {
    std::printf("socket %d  %llu bytes, waited %lld cycles\n", static_cast<int>(i),
                static_cast<unsigned long long>(dram.counters(i).bytes),
                static_cast<long long>(dram.counters(i).waited));
  }
  const bool holds =
      same && drawn && first.cycles[0] == second.cycles[0] && first.cycles[1] > first.cycles[0];
  std::printf("%s\n", holds ? "Both frames are the same." : "IT DOES NOT HOLD.");
  return holds ? 0 : 1;
}
