// The rasterizer in time: setup -> traversal -> interpolation and depth test.
#pragma once

#include "model/timing/interp_ztest_unit.h"
#include "model/timing/setup_unit.h"
#include "model/timing/traversal_unit.h"
#include "model/timing/triangle_source.h"

namespace pineda::timing {

struct FrameResult {
  Cycle cycles = 0;          // up to and including the last write accepted, the clear if none
  Cycle drained_cycles = 0;  // until the whole pipeline is empty; the units' cycles add up to it
  core::FrameCounters counters;
  UnitCycles setup;
  UnitCycles tiles;   // traversal: the tile tests
  UnitCycles stamps;  // traversal: the stamp tests
  UnitCycles interp_ztest;
};

/// The rasterizer with ideal memories: one frame after the other, each as after a reset.
///
/// Bits     core::Renderer defines every write; the units call the functions that it calls.
/// In       run(): raster state, triangles.
/// Out      the cycles of the frame; memory(): its buffers; a listener sees each token.
/// Rate     see the units: the cycles are those of the RTL, write by write.
/// Drops    see SetupUnit.
/// Errors   a frame outside 1 .. 2^guard px: std::invalid_argument. What pull throws, run() throws,
///          after the triangles before it are drawn; the next frame starts clean.
/// Twin     rtl/raster_top.sv.
///
/// There is no clock: run() lets the threads go on until all of them wait, which is when all
/// triangles are through. One elaboration a process, so one top a process; frames as many as
/// wanted.
class RasterTop final : public sc_core::sc_module {
 public:
  RasterTop(sc_core::sc_module_name name, const spec::Contract& contract);

  /// Latency of the depth memory from the next frame on: 1 .. design.max_depth_latency_cycles.
  void set_depth_latency_cycles(int cycles) { memory_.set_latency_cycles(cycles); }
  /// When the ports of the outside move, from the next frame on. Default: always.
  void set_ready(const Ready& ready);

  /// Draws one frame. Not to be called from a SystemC process.
  FrameResult run(const spec::FrameState& state, Pull pull, Listener* listener = nullptr);

  /// Depth and colour of the last frame; its hits are not counted.
  const core::FrameBuffer& buffer() const { return memory_.buffer(); }

 private:
  void begin_frame(const spec::FrameState& state, Pull pull, Listener* listener);
  FrameResult result() const;

  spec::Contract contract_;
  Ready ready_;
  Frame frame_;
  Cycle run_from_ = 0;  // the first cycle in which a triangle can be taken
  TriangleSource triangles_;
  SetupUnit setup_;
  TimedFifo<spec::SetupPrim> prims_;
  TraversalUnit traversal_;
  TimedFifo<spec::Stamp> stamps_;
  InterpZtestUnit interp_ztest_;
  IdealMemory memory_;
  HierarchicalZ hierarchical_z_;
};

}  // namespace pineda::timing
