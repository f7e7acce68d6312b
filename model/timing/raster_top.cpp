#include "model/timing/raster_top.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace pineda::timing {

RasterTop::RasterTop(sc_core::sc_module_name name, const spec::Contract& contract)
    : sc_module(name),
      contract_(contract),
      triangles_("triangles"),
      setup_("setup", contract),
      prims_("prims", contract.design.prim_fifo_depth),
      traversal_("traversal", contract),
      stamps_("stamps", contract.design.stamp_fifo_depth),
      interp_ztest_("interp_ztest", contract),
      memory_("memory", contract),
      hierarchical_z_(contract) {
  setup_.tri_i(triangles_);
  setup_.prim_o(prims_);
  traversal_.prim_i(prims_);
  traversal_.stamp_o(stamps_);
  interp_ztest_.stamp_i(stamps_);
  if (contract.design.depth_test) interp_ztest_.depth_io(memory_);
  interp_ztest_.color_wr_o(memory_);
}

void RasterTop::set_ready(const Ready& ready) {
  ready_ = ready;
  triangles_.set_ready(ready);
  memory_.set_ready(ready);
}

FrameResult RasterTop::run(const spec::FrameState& state, Pull pull, Listener* listener) {
  const int largest = 1 << contract_.design.guard_bits;
  if (std::min(state.width, state.height) < 1 || std::max(state.width, state.height) > largest) {
    throw std::invalid_argument("frame: expected 1 to " + std::to_string(largest) + " px, got " +
                                std::to_string(state.width) + "x" + std::to_string(state.height));
  }
  Listener deaf;
  begin_frame(state, std::move(pull), listener != nullptr ? listener : &deaf);
  sc_core::sc_start();
  frame_.listener = nullptr;
  if (const auto failure = triangles_.take_failure()) std::rethrow_exception(failure);
  return result();
}

void RasterTop::begin_frame(const spec::FrameState& state, Pull pull, Listener* listener) {
  frame_ = {};
  frame_.state = state;
  frame_.listener = listener;
  hierarchical_z_.begin_frame(state);
  if (contract_.design.hierarchical_z) frame_.hierarchical_z = &hierarchical_z_;
  memory_.begin_frame(state);
  prims_.begin_frame();
  stamps_.begin_frame();
  setup_.begin_frame(&frame_);
  traversal_.begin_frame(&frame_);
  interp_ztest_.begin_frame(&frame_);
  run_from_ = first_ready(ready_, ExternalPort::kClear, kClearOffered) + 1;
  triangles_.begin_frame(std::move(pull), run_from_);
}

FrameResult RasterTop::result() const {
  FrameResult result;
  result.cycles = std::max(interp_ztest_.last_write() + 1, run_from_);
  result.drained_cycles =
      std::max({run_from_, setup_.idle_from(), traversal_.idle_from(), interp_ztest_.idle_from()});
  result.counters = frame_.counters;
  result.setup = setup_.cycles(result.drained_cycles);
  result.tiles = traversal_.tile_cycles(result.drained_cycles);
  result.stamps = traversal_.stamp_cycles(result.drained_cycles);
  result.interp_ztest = interp_ztest_.cycles(result.drained_cycles);
  return result;
}

}  // namespace pineda::timing
