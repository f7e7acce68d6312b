// Interpolation and depth test in time.
#pragma once

#include <algorithm>
#include <vector>

#include "model/timing/frame.h"
#include "model/timing/memory.h"
#include "model/timing/stream.h"

namespace pineda::timing {

/// Interpolation and depth test: one stamp in, its depth and colour writes out, in order.
///
/// Bits     core::interpolate_depth(), core::depth_test() and core::interpolate_attributes() define
///          every output bit; this class adds only time.
/// In       stamp_i.
/// Out      depth_io (reads too), color_wr_o: the covered samples that pass; nothing if none does.
///          With the test off, or depth not to be written, colour only. A design without depth has
///          no depth_io.
/// Rate     a stamp a cycle at any latency up to width.inflight_stamps - 4, as long as no address
///          is in flight and no port stalls.
/// Drops    samples that fail the test.
/// Errors   a stream or port left unbound: SC_REPORT_FATAL "pineda/interp_ztest/unbound".
/// Twin     rtl/interp_ztest_unit.sv.
///
/// Timing, for stamp n, with p = the stamp before it and T = width.inflight_stamps:
///   accept[n] = the first cycle in which the read port is ready, not before
///               visible[n], accept[p] + 1,
///               retire[m] + 1 for the last m with the same address (not with the test off),
///               retire[n - T] + 1: stamps leave the table in order, so slots are reused in order
///   load[n]   = max(accept[n] + 2, response[n] + 1, retire[p], enter[p])
///               2: the depth interpolator's register and the FIFO behind it; 1: the response FIFO.
///               The FIFOs are as deep as the table, so they never push back. The write register is
///               free again in the cycle in which its depth is written and its colours have left.
///   retire[n] = the cycle in which the depth write, offered from load[n] + 1 on, is accepted;
///               load[n] + 1 if there is nothing to write.
/// A design without depth has neither table nor queues:
///   accept[n] = load[n] = max(visible[n], accept[p] + 1, enter[p])
/// Colours, of the stamps that have a sample that passed, with q = the one before and
/// L = width.attribute_cycles: behind the pipe is room for the L + 1 that can be under way, which a
/// stamp must find free when it enters; so the pipe never stops.
///   enter[n]  = max(load[n] + 1, exit[n - (L + 1)] + 1)
///   exit[n]   = the first cycle in which the colour port is ready, from
///               max(enter[n] + L, exit[q] + 1) on
/// Without interpolated attributes the colour write leaves the write register: enter[n] = exit[n] =
/// the first cycle in which the colour port is ready, from load[n] + 1 on.
class InterpZtestUnit final : public sc_core::sc_module {
 public:
  Port<StreamIn<spec::Stamp>> stamp_i{"stamp_i"};
  Port<DepthMemory> depth_io{"depth_io"};
  Port<ColorMemory> color_wr_o{"color_wr_o"};

  InterpZtestUnit(sc_core::sc_module_name name, const spec::Contract& contract);

  void begin_frame(Frame* frame);
  /// The first cycle in which the unit is idle, once all stamps are through.
  Cycle idle_from() const { return std::max({time_.now(), write_free_ + 1, exit_ + 1}); }
  /// The cycle of the last write accepted, -1 if there was none.
  Cycle last_write() const { return std::max(retired_, exit_); }
  /// `drained`: the cycle in which the frame has drained.
  UnitCycles cycles(Cycle drained) const;

 private:
  void end_of_elaboration() override;
  void run();
  void draw(const spec::Stamp& stamp, Cycle visible);
  void color(const spec::Stamp& stamp, Cycle visible);
  // The cycle in which the stamp, loaded so that its writes are offered from `offered` on, retires.
  Cycle write(const spec::Stamp& stamp, uint32_t passed, const spec::DepthData& stored,
              Cycle offered);
  // The lanes whose depths are read: those covered, for hierarchical z all in the frame.
  uint32_t asked(const spec::Stamp& stamp) const;
  // The cycle in which its colours leave the write register.
  Cycle enter(const spec::Stamp& stamp, uint32_t passed, Cycle offered);

  spec::Contract contract_;
  Frame* frame_ = nullptr;
  LocalTime time_;
  int columns_ = 0;                  // stamps in a row of the frame
  std::vector<Cycle> address_free_;  // by stamp of the frame: not in flight from this cycle on
  std::vector<Cycle> slot_free_;     // by slot of the in-flight table
  size_t slot_ = 0;                  // the slot of the next stamp
  Cycle write_free_ = -1;            // the write register can be loaded from this cycle on
  Cycle retired_ = -1;               // the last depth write accepted
  std::vector<Cycle> exits_;         // of the last L + 1 colour writes
  size_t next_exit_ = 0;
  Cycle exit_ = -1;  // the last of them
  spec::Fragment fragment_;
};

}  // namespace pineda::timing
