// shared_channel [RASTERIZERS]: rasterizers that share a memory's channel, at several quanta, where
// they want all of it and where they want half: how long their frames take, and how many cycles of
// all of them are simulated in a second.
//
//   rasterizer 0 --+
//   rasterizer 1 --+--> SharedMemory, 16 bytes a cycle
//   ...          --+
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>
#include <systemc>
#include <tlm>
#include <vector>

#include "model/spec/clear_depth.h"
#include "model/spec/random.h"
#include "model/timing/ports/shared_memory.h"
#include "model/timing/raster_top.h"

namespace {

using namespace pineda;  // NOLINT: a program, not a header
using sc_core::sc_time;

constexpr spec::Contract kContract = spec::contract(spec::kHighTile);
constexpr uint64_t kBufferBytes = 1 << 16;  // of depth, and of colour
constexpr int kTriangles = 400;
constexpr int kFrames = 10;                    // a measurement
constexpr timing::Cycle kTriangleCycles = 38;  // that the channel works for a triangle

std::vector<spec::Triangle> triangles_of(uint64_t seed) {
  spec::RandomFrom<spec::SplitMix64> random(seed);
  constexpr int64_t kPx = 1 << spec::kHighTile.subpixel_bits;
  std::vector<spec::Triangle> triangles(kTriangles);
  for (int i = 0; i < kTriangles; ++i) {
    spec::Triangle& t = triangles[static_cast<size_t>(i)];
    t.id = static_cast<uint32_t>(i);
    const int64_t x = random.between(0, 128 * kPx);
    const int64_t y = random.between(0, 96 * kPx);
    for (spec::Vertex& v : t.v) {
      v.x = static_cast<int32_t>(random.between(x - 12 * kPx, x + 12 * kPx));
      v.y = static_cast<int32_t>(random.between(y - 12 * kPx, y + 12 * kPx));
      v.z = random.between(0, int64_t{1} << 31);
    }
  }
  return triangles;
}

// A rasterizer and the processor that starts it.
struct Client : sc_core::sc_module {
  timing::RasterTop top{"top", kContract, timing::Memories::kOutside};
  std::vector<spec::Triangle> triangles;
  sc_core::sc_event start;
  timing::Cycle cycles = 0;

  Client(sc_core::sc_module_name name, uint64_t number, timing::SharedMemory* memory)
      : sc_module(name),
        triangles(triangles_of(number)),
        base_(2 * kBufferBytes * number),
        memory_(*memory) {
    top.depth_socket().bind(memory->socket);
    top.color_socket().bind(memory->socket);
    top.set_memory_map({1, sc_core::SC_NS}, base_, base_ + kBufferBytes);
    SC_HAS_PROCESS(Client);
    SC_THREAD(run);
  }

 private:
  void run() {
    const spec::FrameState frame{128, 96};
    const uint32_t cleared = spec::cleared_depth(kContract.design, frame);
    for (;;) {
      wait(start);
      for (uint64_t i = 0; i < kBufferBytes; ++i) {
        memory_.bytes()[base_ + i] = static_cast<unsigned char>(cleared >> (8 * (i % 4)));
      }
      cycles = top.run(frame, triangles).spent.drained;
    }
  }
  uint64_t base_;
  timing::SharedMemory& memory_;
};

struct Platform {
  explicit Platform(uint64_t rasterizers) {
    timing::SharedMemoryParameters parameters;
    parameters.bytes = 2 * kBufferBytes * rasterizers;
    memory = std::make_unique<timing::SharedMemory>("memory", parameters);
    for (uint64_t i = 0; i < rasterizers; ++i) {
      const std::string name = "client" + std::to_string(i);
      clients.push_back(std::make_unique<Client>(name.c_str(), i, memory.get()));
    }
  }
  std::unique_ptr<timing::SharedMemory> memory;
  std::vector<std::unique_ptr<Client>> clients;
};

// Draws a frame of each of the first `rasterizers`, together, a triangle every `interval` cycles at
// most. Their cycles.
std::vector<timing::Cycle> draw(Platform* platform, size_t rasterizers, timing::Cycle interval) {
  for (size_t i = 0; i < rasterizers; ++i) {
    Client& client = *platform->clients[i];
    client.top.set_ready([interval](timing::ExternalPort port, timing::Cycle cycle) {
      return port != timing::ExternalPort::kTriangle || cycle % interval == 0;
    });
    client.start.notify(sc_time(1, sc_core::SC_NS));
  }
  sc_core::sc_start();
  std::vector<timing::Cycle> cycles;
  for (size_t i = 0; i < rasterizers; ++i) cycles.push_back(platform->clients[i]->cycles);
  return cycles;
}

// False if a frame took no time.
bool measure(Platform* platform, size_t rasterizers, timing::Cycle interval,
             const sc_time& quantum) {
  tlm::tlm_global_quantum::instance().set(quantum);
  const timing::Cycle busy_before = platform->memory->busy_cycles();
  timing::Cycle sum = 0, longest = 0;
  bool all = true;
  const std::clock_t begun = std::clock();
  for (int frame = 0; frame < kFrames; ++frame) {
    const auto cycles = draw(platform, rasterizers, interval);
    longest += *std::max_element(cycles.begin(), cycles.end());
    for (const timing::Cycle c : cycles) sum += c;
    all = all && *std::min_element(cycles.begin(), cycles.end()) > 0;
  }
  const double seconds = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
  const timing::Cycle busy = platform->memory->busy_cycles() - busy_before;
  std::printf("%zu rasterizers, channel %3.0f %% busy, quantum %6s: %6lld cycles, ", rasterizers,
              100 * static_cast<double>(busy) / static_cast<double>(longest),
              quantum.to_string().c_str(), static_cast<long long>(longest / kFrames));
  std::printf("%.2f M cycles/s\n", static_cast<double>(sum) / seconds * 1e-6);
  return all;
}

}  // namespace

int sc_main(int argc, char* argv[]) {
  const long rasterizers = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 4;
  if (rasterizers < 1 || rasterizers > 64) {
    std::printf("rasterizers: expected 1 to 64\n");
    return 1;
  }
  Platform platform(static_cast<uint64_t>(rasterizers));
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  bool right = true;
  for (size_t n = 1; n <= platform.clients.size(); n *= 2) {
    const auto half = 2 * kTriangleCycles * static_cast<timing::Cycle>(n);
    for (const timing::Cycle interval : {timing::Cycle{1}, half}) {
      for (const double nanoseconds : {0., 100., 1000., 10000.}) {
        const sc_time quantum(nanoseconds, sc_core::SC_NS);
        right = measure(&platform, n, interval, quantum) && right;
      }
    }
  }
  return right ? 0 : 1;
}
