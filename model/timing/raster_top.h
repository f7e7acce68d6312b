// The rasterizer in time: setup -> traversal -> interpolation and depth test.
#pragma once

#include "model/timing/counted/counters.h"
#include "model/timing/ports/frame_memory.h"
#include "model/timing/units/interp_ztest_unit.h"
#include "model/timing/units/setup_unit.h"
#include "model/timing/units/traversal_unit.h"
#include "model/timing/units/triangle_source.h"

namespace pineda::timing {

/// Whose memories a RasterTop draws into.
enum class Memories {
  kInside,   // a FrameMemory of its own, ideal at first
  kOutside,  // what a platform binds to the sockets
};

/// The rasterizer: one frame after the other, each as after a reset.
///
/// Bits     core::Renderer defines every write; the units call the functions that it calls.
/// In       run(): raster state, triangles.
/// Out      depth_socket, color_socket: see MemorySocket. The cycles of the frame; a listener sees
///          each token.
/// Rate     see the units: the cycles are those of the RTL, write by write.
/// Drops    see SetupUnit.
/// Errors   SC_REPORT_ERROR, ids "pineda/raster_top/...": "design", in the constructor, of one that
///          has no cycles; "frame", of a size outside 1 .. 2^guard px; "busy", of a run() within
///          another; "vertex", of a triangle with a number beyond its field, before anything of it
///          is drawn. See MemorySocket for its own. What pull throws, run() throws. Triangles before
///          the fault are drawn, and the next frame starts clean. Where the handler does not throw,
///          the frame ends before the fault, and the constructor throws std::invalid_argument.
/// Twin     rtl/raster_top.sv.
///
/// There is no clock and no process: a triangle goes through all units before the next one is
/// pulled, and carries its cycles with it. Inside a platform run() is called from an SC_THREAD, and
/// returns when the time of the frame has passed. Memories outside are cleared by the platform
/// before that, depth to spec::cleared_depth(). One elaboration a process; frames as many as
/// wanted.
class RasterTop final : public sc_core::sc_module {
 public:
  RasterTop(sc_core::sc_module_name name, const spec::Contract& contract,
            Memories memories = Memories::kInside);

  auto& depth_socket() { return ports_.depth.socket; }
  auto& color_socket() { return ports_.color.socket; }
  /// From the next frame on: the length of a cycle, 1 ns unless set, and where the frame lies.
  /// With memories inside the addresses start at 0.
  void set_memory_map(const sc_core::sc_time& period, uint64_t depth_base, uint64_t color_base);

  // Of memories inside, from the next frame on:
  /// An ideal memory of a latency of 1 .. spec::kMaxDepthLatencyCycles. Beyond the design's
  /// max_depth_latency_cycles the table of stamps in flight fills up, and the frame is slower.
  void set_depth_latency_cycles(int cycles);
  void set_memory(std::shared_ptr<memory::MemoryTiming> timing) {
    memory_->set_timing(std::move(timing));
  }
  /// When the ports of the outside move, from the next frame on. Default: always.
  void set_ready(const Ready& ready);

  /// True: every bit is computed (the default). False: only what time depends on: coverage always;
  /// depth of every stamp with hierarchical z or where the memory is not always ready, else of
  /// those that the last write may belong to, and samples that pass are not counted; attributes
  /// never. There is no frame then. A listener and memories outside want every bit.
  void set_bits(bool bits) { bits_ = bits; }

  /// Draws one frame; of triangles that lie in memory already, none is copied.
  FrameResult run(const spec::FrameState& state, const Pull& pull, Listener* listener = nullptr);
  FrameResult run(const spec::FrameState& state, const std::vector<spec::Triangle>& triangles,
                  Listener* listener = nullptr);
  /// From another process: the frame that is being drawn ends at its next transaction, and run()
  /// throws Stopped there. What is written stays.
  void stop() { ports_.stop(); }

  /// The first cycle in which all units are idle if no triangle comes any more. A pull that asks
  /// gets that of the triangles before; memories that are not always ready may still have writes.
  Cycle idle_from() const;

  /// When cycle 0 of the last frame was.
  const sc_core::sc_time& begun() const { return begun_; }
  /// From a pull that waits in its process: issues the writes that are due before that cycle.
  void write_until(Cycle cycle) { interp_ztest_.advance(cycle); }

  /// Depth and colour of the last frame in memories inside; its hits are not counted.
  core::FrameBuffer buffer() const;

 private:
  void end_of_elaboration() override;
  class Running;
  FrameResult draw(const spec::FrameState& state, const Next& next, Listener* listener);
  bool can_begin(const spec::FrameState& state) const;
  void pass_time(Cycle drained) const;
  void begin_frame(const spec::FrameState& state, Listener* listener);
  void begin_direct();
  void leave_out_bits();
  FrameResult result() const;

  spec::Contract contract_;
  Ready ready_;
  Frame frame_;
  Cycle run_from_ = 0;  // the first cycle in which a triangle can be taken
  TriangleSource triangles_;
  SetupUnit setup_;
  TimedFifo<spec::SetupPrim> prims_;
  TraversalUnit traversal_;
  StampFifo stamps_;
  InterpZtestUnit interp_ztest_;
  MemoryPorts ports_;
  std::unique_ptr<FrameMemory> memory_;  // none outside
  sc_core::sc_time period_{1, sc_core::SC_NS};
  sc_core::sc_time begun_;  // of the frame
  HierarchicalZ hierarchical_z_;
  LastWrite last_write_;
  fast::SmallWalks small_walks_;
  bool bits_ = true;
  bool running_ = false;
  bool is_direct_ = false;    // the last frame was drawn into direct_, memory_ did not see it
  fast::TiledBuffer direct_;  // hits stay 0
};

}  // namespace pineda::timing
