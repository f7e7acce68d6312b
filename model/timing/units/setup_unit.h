// Triangle setup in time.
#pragma once

#include <deque>

#include "model/timing/units/frame.h"
#include "model/timing/units/stream.h"

namespace pineda::timing {

/// Triangle setup: one triangle in, three edge functions and the planes out.
///
/// Bits     core::setup() defines every output bit; this class adds only time.
/// In       tri_i: vertices sQ14.8 px, snapped, inside the guard band; y down.
/// Out      prim_o: edges and planes at the first sample of the box's first tile.
/// Rate     1 triangle every width.setup_interval_cycles, a dropped one every
///          width.setup_drop_cycles; latency width.setup_latency_cycles.
/// Drops    area2 = 0, culled by facing, box without a sample or outside the frame: accepted,
///          counted, not sent.
/// Errors   a stream left unbound: SC_REPORT_FATAL "pineda/setup/unbound".
/// Twin     rtl/setup/setup_unit.sv, same ports. Source: Pineda, SIGGRAPH 1988.
///
/// Timing. An output that is offered and not taken freezes the whole unit. So the unit has a time
/// of its own, its steps: a step is a cycle without such a freeze, and
///   cycle(step) = step + the cycles frozen at steps up to and including it.
/// In steps, triangle n is accepted in the least accept[n] with
///   accept[n] >= accept[n-1] + (dropped[n-1] ? drop : interval),  cycle(accept[n]) >= offered[n],
/// with style stepped also a multiple of the interval after accept[n-1], as long as any triangle is
/// inside; until then the unit counts as starved. Its output is offered in
///   output[n] = accept[n] + latency.
/// If the FIFO takes the output k cycles later than cycle(output[n]), the unit freezes for k cycles
/// at step output[n]. The freezes of earlier outputs, which cycle() needs, are all known when
/// output n is handed over. Later triangles may be accepted before step output[n], so a freeze
/// waits in a list until triangles are accepted after its step.
class SetupUnit final : public sc_core::sc_module, public StreamIn<spec::Triangle> {
 public:
  sc_core::sc_export<StreamIn<spec::Triangle>> tri_i{"tri_i"};
  Port<StreamOut<spec::SetupPrim>> prim_o{"prim_o"};

  SetupUnit(sc_core::sc_module_name name, const spec::Contract& contract);

  void begin_frame(Frame* frame);
  Cycle take(const spec::Triangle& triangle, Cycle offered) override;
  /// All triangles are through.
  void drain();
  /// The first cycle in which the unit is idle, once all triangles are through.
  Cycle idle_from() const;
  /// `drained`: the cycle in which the frame has drained.
  UnitCycles cycles(Cycle drained) const;

 private:
  struct Freeze {
    Cycle step;
    Cycle cycles;
    uint32_t id;  // the triangle whose output is not taken
  };

  void end_of_elaboration() override;
  core::Drop set_up(const spec::Triangle& triangle);
  Cycle in_turn(Cycle step) const;
  Cycle accept(Cycle offered);  // the cycle in which a triangle offered from then on is accepted
  void send(Cycle accepted_step);
  void report_work(Cycle interval, uint32_t id) const;
  void report(const Freeze& freeze) const;

  spec::Contract contract_;
  Frame* frame_ = nullptr;
  spec::SetupPrim prim_;
  Cycle next_step_ = 0;         // the first step in which a triangle can be accepted
  Cycle empty_step_ = 0;        // the first step in which the last triangle, if dropped, is gone
  Cycle last_step_ = 0;         // in which a triangle was accepted
  Cycle inside_until_ = 0;      // the first step in which no triangle is inside
  Cycle busy_ = 0;              // steps spent on triangles
  Cycle frozen_ = 0;            // cycles frozen at steps before next_step_
  Cycle total_frozen_ = 0;      // frozen_ and the freezes that are still listed
  std::deque<Freeze> freezes_;  // at steps that no acceptance has reached yet
  Cycle last_output_ = -1;      // the cycle in which the last output was taken
};

}  // namespace pineda::timing
