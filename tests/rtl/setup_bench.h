// A Verilated setup_unit under a script of offers and takes; and random frames and triangles.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "model/core/setup.h"
#include "model/spec/pack.h"
#include "tests/rtl/lone.h"

namespace pineda::tb {

/// When the source offers and the sink takes: token i from cycle i of the list on.
struct Script {
  std::vector<int64_t> offers;
  std::vector<int64_t> takes;
};

/// What happened, in cycles.
struct SetupRun {
  std::vector<spec::Packed> prims;
  std::vector<int64_t> accepted;
  std::vector<int64_t> taken;
  int64_t idle_from = 0;

  bool same_cycles(const SetupRun& other) const {
    return accepted == other.accepted && taken == other.taken && idle_from == other.idle_from;
  }
};

struct SetupScene {
  spec::FrameState frame;
  std::vector<spec::Triangle> triangles;
};

template <class Model>
SetupRun run_setup(const spec::Contract& contract, const SetupScene& scene, const Script& script) {
  const spec::Packer<spec::Triangle> triangle(contract);
  const auto prim_words = static_cast<size_t>(spec::Packer<spec::SetupPrim>(contract).words());
  const auto state = spec::Packer<spec::FrameState>(contract).pack(scene.frame);
  Model model;
  model.rst_ni = 0;
  model.tri_valid_i = 0;
  model.prim_ready_i = 0;
  std::memcpy(&model.frame_i, state.data(), 4 * state.size());
  clock(&model);
  model.rst_ni = 1;
  SetupRun run;
  const size_t count = scene.triangles.size();
  bool idle = false;
  for (int64_t cycle = 0; run.accepted.size() < count || !idle; ++cycle) {
    const size_t next = run.accepted.size();
    model.tri_valid_i = next < count && cycle >= script.offers[next];
    if (next < count) {
      const auto words = triangle.pack(scene.triangles[next]);
      std::memcpy(&model.tri_i, words.data(), 4 * words.size());
    }
    model.prim_ready_i = cycle >= script.takes[run.taken.size()];
    model.eval();
    idle = model.idle_o && !model.tri_valid_i;
    if (!idle) run.idle_from = cycle + 1;
    if (model.tri_valid_i && model.tri_ready_o) run.accepted.push_back(cycle);
    if (model.prim_valid_o && model.prim_ready_i) {
      run.taken.push_back(cycle);
      run.prims.emplace_back(prim_words);
      std::memcpy(run.prims.back().data(), &model.prim_o, 4 * prim_words);
    }
    clock(&model);
  }
  return run;
}

/// What core makes of the scene.
std::vector<spec::Packed> expected_prims(const spec::Contract& contract, const SetupScene& scene);

/// Frames of any size, cull, shade, scissor and bias; triangles of every size, many of them
/// dropped.
SetupScene random_setup_scene(const spec::Contract& contract, uint64_t seed, int triangles);

/// A script for `count` triangles, with stalls of source, sink or both of up to twice the interval.
Script random_script(const spec::Contract& contract, uint64_t seed, bool source, bool sink,
                     size_t count);

}  // namespace pineda::tb
