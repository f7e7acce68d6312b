// Cases run through the functional model.
#include "vectors/grammar/cases.h"

namespace pineda::vectors {

using spec::Contract;

SetupCase run_model(const Contract& c, const SetupCase& inputs) {
  SetupCase result{inputs.name, inputs.frame, inputs.in, {}, {}};
  for (const auto& triangle : inputs.in) {
    spec::SetupPrim prim;
    result.drops.push_back(core::setup(c, inputs.frame, triangle, &prim));
    if (result.drops.back() == core::Drop::kNone) result.out.push_back(prim);
  }
  return result;
}

TraversalCase run_model(const Contract& c, const TraversalCase& inputs) {
  TraversalCase result{inputs.name, inputs.frame, inputs.in, {}};
  for (const auto& prim : inputs.in) {
    core::for_each_stamp(c, prim, [&](const spec::Stamp& stamp) { result.out.push_back(stamp); });
  }
  return result;
}

InterpZtestCase run_model(const Contract& c, const InterpZtestCase& inputs) {
  InterpZtestCase result{inputs.name, inputs.frame, inputs.in, {}, {}};
  const bool test = core::tests_depth(c, inputs.frame);
  core::FrameBuffer memory(c, inputs.frame);
  for (const auto& stamp : inputs.in) {
    spec::Fragment fragment;
    core::interpolate(c, stamp, &fragment);
    const auto stored = memory.read(c, stamp.x, stamp.y, stamp.mask);
    const uint32_t passed =
        core::depth_test(c, inputs.frame.depth, stamp.mask, fragment.z, stored.z);
    if (passed == 0) continue;
    if (test && inputs.frame.depth_write) {
      result.depth.push_back(core::depth_write(c, stamp, fragment, passed));
      memory.write(c, result.depth.back());
    }
    result.color.push_back(core::color_write(c, stamp, fragment, passed));
  }
  return result;
}

FrameCase run_model(const Contract& c, const FrameCase& inputs) {
  core::Renderer renderer(c, inputs.frame);
  for (const auto& triangle : inputs.in) renderer.draw(triangle);
  return {inputs.name, inputs.frame, inputs.in, renderer.buffer(), renderer.counters()};
}

}  // namespace pineda::vectors
