// Who watches a frame being drawn: by the SystemC model, or by the RTL on a bench of tb. Knows no
// SystemC.
#pragma once

#include "model/spec/structs.h"
#include "model/timing/counted/cycles.h"

namespace pineda::timing {

/// Hears of each token at the output of its unit, with the cycle of its handshake, and of what the
/// cycles are spent on. The RTL reports tokens alone: its cycles are counted inside of it.
///
/// In       cycles of the frame from the model; from a bench cycles since its reset, in which its
///          first frame begins.
/// Rate     tokens of one kind come in order, and so do spans of one unit and slots of one FIFO.
///          Between two kinds there is no order but that of their cycles.
/// Errors   must not throw.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual void prim(Cycle, const spec::SetupPrim&) {}
  virtual void stamp(Cycle, const spec::Stamp&) {}
  virtual void depth(Cycle, const spec::DepthWrite&) {}
  virtual void color(Cycle, const spec::ColorWrite&) {}
  /// The unit spent the cycles [from, until) so, on triangle `id`. Cycles in which it has nothing
  /// to work on are not reported.
  virtual void spent(Unit, Cause, Cycle /*from*/, Cycle /*until*/, uint32_t /*id*/) {}
  /// A slot of the FIFO was taken in the cycle `inserted` and freed in `freed`.
  virtual void slot(Fifo, Cycle /*inserted*/, Cycle /*freed*/) {}
};

}  // namespace pineda::timing
