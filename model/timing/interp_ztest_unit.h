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
/// Bits     core::interpolate() and core::depth_test() define every output bit; this class adds
///          only time.
/// In       stamp_i.
/// Out      depth_io (reads too), color_wr_o: the covered samples that pass; nothing if none does.
///          With the test off, colour only.
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
///   load[n]   = max(accept[n] + 2, response[n] + 1, retire[p], colored[p])
///               2: the interpolator's register and the fragment FIFO; 1: the response FIFO. Both
///               FIFOs are as deep as the table, so they never push back. The write register is
///               free again in the cycle in which its last write is accepted.
///   retire[n], colored[n] = the cycles in which the two writes, offered from load[n] + 1 on, are
///               accepted; load[n] + 1 if there is nothing to write.
class InterpZtestUnit final : public sc_core::sc_module {
 public:
  Port<StreamIn<spec::Stamp>> stamp_i{"stamp_i"};
  Port<DepthMemory> depth_io{"depth_io"};
  Port<ColorMemory> color_wr_o{"color_wr_o"};

  InterpZtestUnit(sc_core::sc_module_name name, const spec::Contract& contract);

  void begin_frame(Frame* frame);
  /// The first cycle in which the unit is idle, once all stamps are through.
  Cycle idle_from() const { return std::max(time_.now(), write_free_ + 1); }
  /// The cycle of the last write accepted, -1 if there was none.
  Cycle last_write() const { return last_write_; }
  /// `drained`: the cycle in which the frame has drained.
  UnitCycles cycles(Cycle drained) const;

 private:
  void end_of_elaboration() override;
  void run();
  void draw(const spec::Stamp& stamp, Cycle visible);
  Cycle write(const spec::Stamp& stamp, const spec::Fragment& fragment, uint32_t passed,
              Cycle offered);  // returns the cycle in which the stamp retires

  spec::Contract contract_;
  Frame* frame_ = nullptr;
  LocalTime time_;
  int columns_ = 0;                  // stamps in a row of the frame
  std::vector<Cycle> address_free_;  // by stamp of the frame: not in flight from this cycle on
  std::vector<Cycle> slot_free_;     // by slot of the in-flight table
  size_t slot_ = 0;                  // the slot of the next stamp
  Cycle write_free_ = -1;            // the write register can be loaded from this cycle on
  Cycle last_write_ = -1;
};

}  // namespace pineda::timing
