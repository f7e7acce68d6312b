// Rasterizers that share a channel take as long as Verilated ones that share it clock edge by clock
// edge: exactly so in time, and nearly so with a quantum.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "model/spec/clear_depth.h"
#include "model/timing/ports/shared_memory.h"
#include "tests/timing/clocked.h"

namespace pineda::test {
namespace {

using sc_core::sc_time;

sc_time ns(double x) { return {x, sc_core::SC_NS}; }

constexpr uint64_t kFrameBytes = 1 << 16;  // of depth, and of colour

// A rasterizer and the process that drives it.
class Client : public sc_core::sc_module {
 public:
  Client(sc_core::sc_module_name name, uint64_t base, timing::SharedMemory* memory)
      : sc_module(name), base_(base), memory_(*memory) {
    top.depth_socket().bind(memory->socket);
    top.color_socket().bind(memory->socket);
    top.set_memory_map(ns(1), base, base + kFrameBytes);
    SC_HAS_PROCESS(Client);
    SC_THREAD(loop);
  }
  timing::RasterTop top{"top", kContract, timing::Memories::kOutside};
  const Scene* scene = nullptr;
  sc_core::sc_event go;
  Cycle drained = 0;
  sc_time passed;

 private:
  void loop() {
    for (;;) {
      wait(go);
      const uint32_t code = spec::cleared_depth(kContract.design, scene->frame);
      for (uint64_t i = 0; i < kFrameBytes; ++i) {
        memory_.bytes()[base_ + i] = static_cast<unsigned char>(code >> (8 * (i % 4)));
      }
      const sc_time begun = sc_core::sc_time_stamp();
      drained = top.run(scene->frame, scene->triangles).spent.drained;
      passed = sc_core::sc_time_stamp() - begun;
    }
  }
  uint64_t base_;
  timing::SharedMemory& memory_;
};

struct Load {
  const char* name;
  size_t rasterizers;
  double least_load, most_load;  // of the channel, in the reference
  Traffic traffic;
  int triangles;
};

std::vector<Scene> scenes_of(const Load& load) {
  std::vector<Scene> scenes;
  for (size_t r = 0; r < load.rasterizers; ++r) {
    scenes.push_back(random_scene(Kind::kMedium, 50 + r, load.triangles));
    scenes.back().frame = {128, 96, spec::Cull::kNone, spec::DepthFunc::kLess};
    for (auto& t : scenes.back().triangles) {
      for (auto& v : t.v) {  // nearer and nearer: every sample passes
        v.z = (int64_t{1} << 31) - (int64_t{t.id} << 12) + (v.z >> 24);
      }
    }
  }
  return scenes;
}

class Contention : public testing::TestWithParam<Load> {
 protected:
  Contention() : memory_("memory", parameters()) {
    for (size_t r = 0; r < GetParam().rasterizers; ++r) {
      const std::string name = "client" + std::to_string(r);
      clients_.push_back(std::make_unique<Client>(name.c_str(), 2 * kFrameBytes * r, &memory_));
    }
  }
  static timing::SharedMemoryParameters parameters() {
    const Traffic& traffic = GetParam().traffic;
    timing::SharedMemoryParameters p;
    p.bytes = 2 * kFrameBytes * GetParam().rasterizers;
    p.bytes_per_cycle = static_cast<unsigned>(16 / traffic.channel_cycles);
    p.latency_cycles = traffic.latency_cycles;
    return p;
  }
  /// Draws all frames at once, from one instant on.
  void run(const std::vector<Scene>& scenes, const sc_time& quantum) {
    tlm::tlm_global_quantum::instance().set(quantum);
    const Traffic& traffic = GetParam().traffic;
    for (size_t r = 0; r < scenes.size(); ++r) {
      clients_[r]->scene = &scenes[r];
      clients_[r]->top.set_ready([traffic](timing::ExternalPort port, Cycle cycle) {
        return port != timing::ExternalPort::kTriangle || traffic.triangle_ready(cycle);
      });
      clients_[r]->go.notify(ns(1));
    }
    sc_core::sc_start();
  }
  /// The largest deviation of a finish time from the reference, of that.
  double deviation(const ClockedResult& reference) const {
    double most = 0;
    for (size_t r = 0; r < clients_.size(); ++r) {
      EXPECT_EQ(clients_[r]->passed, static_cast<double>(clients_[r]->drained) * ns(1));
      const auto expected = static_cast<double>(reference.drained[r]);
      const auto got = static_cast<double>(clients_[r]->drained);
      most = std::max(most, std::abs(got - expected) / expected);
    }
    return most;
  }
  std::string finish_times(const ClockedResult& reference) const {
    std::string text;
    for (size_t r = 0; r < clients_.size(); ++r) {
      text += (r == 0 ? "" : ", ") + std::to_string(clients_[r]->drained) + " for " +
              std::to_string(reference.drained[r]);
    }
    return text;
  }

  timing::SharedMemory memory_;
  std::vector<std::unique_ptr<Client>> clients_;
};

constexpr Load kLoads[] = {
    {"TwoAtHalfLoad", 2, .4, .6, {1, 6, 290}, 360},
    {"TwoAtFullLoad", 2, .9, 1, {1, 0, 1}, 720},
    {"FourAtHalfLoad", 4, .4, .6, {1, 0, 680}, 155},
    {"FourAtFullLoad", 4, .9, 1, {2, 6, 1}, 160},
};

TEST_P(Contention, FinishTimesAreThoseOfTheClockedReference) {
  const Load& load = GetParam();
  const std::vector<Scene> scenes = scenes_of(load);
  const tb::RtlLibrary library(kContract);
  const ClockedResult reference = run_clocked(library, scenes, load.traffic);
  const Cycle longest = *std::max_element(reference.drained.begin(), reference.drained.end());
  ASSERT_GT(longest, 100'000);
  const double busy = static_cast<double>(reference.busy) / static_cast<double>(longest);
  EXPECT_GE(busy, load.least_load);
  EXPECT_LE(busy, load.most_load);

  run(scenes, sc_core::SC_ZERO_TIME);
  std::printf("%.0f %% load, on time: %s\n", 100 * busy, finish_times(reference).c_str());
  EXPECT_EQ(deviation(reference), 0);
  EXPECT_EQ(memory_.busy_cycles(), reference.busy);
  run(scenes, sc_time(1, sc_core::SC_US));
  std::printf("%.0f %% load, 1 us: %s\n", 100 * busy, finish_times(reference).c_str());
  EXPECT_LE(deviation(reference), .1);
}

INSTANTIATE_TEST_SUITE_P(, Contention, testing::ValuesIn(kLoads),
                         [](const auto& p) { return p.param.name; });

}  // namespace
}  // namespace pineda::test
