// Cases run through the functional model.
#include "vectors/runner/sparse_memories.h"

namespace pineda::vectors {

using spec::Contract;

SetupCase run_model(const Contract& c, const SetupCase& inputs) {
  SetupCase result = inputs;
  result.drops.clear();
  result.out.clear();
  for (const auto& triangle : inputs.in) {
    spec::SetupPrim prim;
    result.drops.push_back(core::setup(c, inputs.frame, triangle, &prim));
    if (result.drops.back() == core::Drop::kNone) result.out.push_back(prim);
  }
  return result;
}

TraversalCase run_model(const Contract& c, const TraversalCase& inputs) {
  TraversalCase result = inputs;
  result.out.clear();
  for (const auto& prim : inputs.in) {
    core::for_each_stamp(c, prim, [&](const spec::Stamp& stamp) { result.out.push_back(stamp); });
  }
  return result;
}

InterpZtestCase run_model(const Contract& c, const InterpZtestCase& inputs) {
  struct Writes : core::Sink {
    explicit Writes(InterpZtestCase* into) : result(into) {}
    void depth(const spec::DepthWrite& write) const { result->depth.push_back(write); }
    void color(const spec::ColorWrite& write) const { result->color.push_back(write); }
    InterpZtestCase* result;
  };
  InterpZtestCase result = inputs;
  result.depth.clear();
  result.color.clear();
  SparseMemories memories(c, inputs.frame);
  core::FrameCounters uncounted;
  Writes writes(&result);
  core::FrameWriter<SparseMemories, Writes> writer{c, inputs.frame, &memories, &uncounted, writes};
  for (const auto& stamp : inputs.in) {
    spec::Fragment fragment;
    core::interpolate(c, stamp, &fragment);
    writer.fragment(stamp, fragment);
  }
  return result;
}

std::vector<spec::Triangle> begun_triangles(const Contract& c, const FrameCase& value) {
  const int64_t far = ((int64_t{1} << c.design.depth_bits) - 1) << spec::kDepthInputFractionBits;
  const int32_t full = (1 << c.design.attribute_bits) - 1;
  const auto channels = static_cast<size_t>(spec::channels(c.design));
  std::vector<spec::Triangle> triangles = value.in;
  for (spec::Triangle& triangle : triangles) {
    for (spec::Vertex& vertex : triangle.v) {
      vertex.z = far - vertex.z;
      for (size_t i = 0; i < channels; ++i) vertex.attr[i] = full - vertex.attr[i];
    }
  }
  return triangles;
}

FrameCase run_model(const Contract& c, const FrameCase& inputs) {
  FrameCase result = inputs;
  result.counters = {};
  SparseMemories memories(c, inputs.frame);
  core::Sink unseen;
  for (const auto& triangle : inputs.in) {
    core::draw_triangle(c, inputs.frame, {}, triangle, &result.counters,
                        core::FrameWriter<SparseMemories, core::Sink>{c, inputs.frame, &memories,
                                                                      &result.counters, unseen});
  }
  result.samples = memories.samples();
  return result;
}

}  // namespace pineda::vectors
