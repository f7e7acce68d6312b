// Streams between units: temporally decoupled FIFOs whose slots carry cycles.
#pragma once

#include <algorithm>
#include <cstddef>
#include <systemc>
#include <vector>

#include "model/timing/counted/fifo_levels.h"
#include "model/timing/standard.h"
#include "model/timing/units/frame.h"

namespace pineda::timing {

/// The consumer's end of a stream.
template <class T>
class StreamIn : public virtual sc_core::sc_interface {
 public:
  /// Takes a token that is visible from the cycle `visible` on. Returns the cycle in which it is
  /// taken, which is later than that of the token before. When it returns, all that the token
  /// causes further down the pipeline has been computed.
  virtual Cycle take(const T& token, Cycle visible) = 0;
};

/// The producer's end of a stream.
template <class T>
class StreamOut : public virtual sc_core::sc_interface {
 public:
  /// Hands over a token that is offered from the cycle `earliest` on; returns the cycle in which it
  /// is taken.
  virtual Cycle push(const T& token, Cycle earliest) = 0;
};

/// Ports of a unit. They may stay unbound as far as SystemC is concerned, so that require_bound()
/// can say which unit it is.
template <class Interface>
using Port = sc_core::sc_port<Interface, 1, sc_core::SC_ZERO_OR_MORE_BOUND>;

/// Reports `type` ("pineda/UNIT/unbound") as fatal if nothing is bound to the port.
template <class Interface>
void require_bound(const Port<Interface>& port, const char* type) {
  if (port.size() == 0) SC_REPORT_FATAL(type, port.name());
}

/// A FIFO between two units, each of which runs in its own local time.
///
/// In       push(): the producer's tokens.
/// Out      out_o: the consumer.
/// Rate     as rtl/lib/stream_fifo.sv. Slot n % depth serves token n, hence the recurrences
///            push[n]    = max(offered[n], pop[n - depth] + 1)   a slot freed in t is there in t+1
///            visible[n] = push[n] + 1                           pushed in t, seen in t+1
///          Depth 0 is a wire: a token is taken in the cycle in which it is handed over.
///          A slot keeps the cycle of its last release. The consumer of token n is called before
///          token n + 1 exists, so every pop that a push waits for is known when it is pushed:
///          nobody ever waits, there is no context switch, and back-pressure is exact.
/// Errors   out_o left unbound: SC_REPORT_FATAL "pineda/fifo/unbound".
/// Twin     rtl/lib/stream_fifo.sv. Source: slots that carry times are those of Helmstetter et al.,
///          "Fast and accurate TLM simulations using temporal decoupling for FIFO-based
///          communications", DATE 2013.
template <class T, class Consumer = StreamIn<T>, class Producer = StreamOut<T>>
class TimedFifo : public sc_core::sc_module, public Producer {
 public:
  Port<Consumer> out_o{"out_o"};

  TimedFifo(sc_core::sc_module_name name, Fifo fifo, int depth)
      : sc_module(name), fifo_(fifo), levels_(depth) {}

  /// Forgets the cycles of the last frame.
  void begin_frame(Listener* listener) {
    listener_ = listener;
    levels_.begin_frame();
  }

  /// The cycles of the frame by level, 0 to depth.
  std::vector<Cycle> levels(Cycle drained) const { return levels_.cycles(drained); }

  Cycle push(const T& token, Cycle earliest) override {
    if (levels_.depth() == 0) return consumer_->take(token, earliest);
    const Cycle inserted = std::max(earliest, levels_.slot_freed() + 1);
    const Cycle freed = consumer_->take(token, inserted + 1);
    levels_.slot(inserted, freed);
    if (listener_ != nullptr) listener_->slot(fifo_, inserted, freed);
    return inserted;
  }

 protected:
  void end_of_elaboration() override {
    require_bound(out_o, "pineda/fifo/unbound");
    consumer_ = out_o[0];
  }

  Fifo fifo_;
  Consumer* consumer_ = nullptr;
  Listener* listener_ = nullptr;
  FifoLevels levels_;
};

}  // namespace pineda::timing
