// Streams between units: temporally decoupled FIFOs whose slots carry cycles.
#pragma once

#include <algorithm>
#include <cstddef>
#include <systemc>
#include <vector>

#include "model/timing/local_time.h"

namespace pineda::timing {

/// The consumer's end of a stream.
template <class T>
class StreamIn : public virtual sc_core::sc_interface {
 public:
  /// The oldest token and the first cycle in which it can be taken. Suspends the calling thread
  /// while there is none; valid until pop().
  virtual const T& front(Cycle* visible) = 0;

  /// Takes the oldest token in `cycle`: not before it is visible, later than the one before.
  virtual void pop(Cycle cycle) = 0;
};

/// The producer's end of a stream.
template <class T>
class StreamOut : public virtual sc_core::sc_interface {
 public:
  /// Hands over a token that is offered from the cycle `earliest` on; returns the cycle in which it
  /// is taken. Suspends the calling thread while that cycle cannot be known.
  virtual Cycle push(const T& token, Cycle earliest) = 0;
};

/// A FIFO between two units, each of which runs in its own local time.
///
/// Rate     as rtl/lib/stream_fifo.sv. Slot n % depth serves token n, hence the recurrences
///            push[n]    = max(offered[n], pop[n - depth] + 1)   a slot freed in t is there in t+1
///            visible[n] = push[n] + 1                           pushed in t, seen in t+1
///          A slot keeps the cycle of its last insertion and of its last release, so both ends
///          find their cycles whatever the order in which the threads run. A thread waits only
///          where it has to: the consumer for a token, the producer for a release.
/// Errors   none.
/// Twin     rtl/lib/stream_fifo.sv. Source: Helmstetter et al., "Fast and accurate TLM simulations
///          using temporal decoupling for FIFO-based communications", DATE 2013.
template <class T>
class TimedFifo final : public sc_core::sc_object, public StreamIn<T>, public StreamOut<T> {
 public:
  TimedFifo(const char* name, int depth) : sc_object(name), slots_(static_cast<size_t>(depth)) {}

  /// Forgets the cycles of the last frame; the FIFO is empty then.
  void begin_frame() {
    sc_assert(pushed_ == popped_);
    for (Slot& slot : slots_) slot.freed = kNever;
  }

  const T& front(Cycle* visible) override {
    while (pushed_ == popped_) sc_core::wait(insertion_);
    const Slot& slot = slots_[popped_ % slots_.size()];
    *visible = slot.inserted + 1;
    return slot.token;
  }

  void pop(Cycle cycle) override {
    slots_[popped_++ % slots_.size()].freed = cycle;
    release_.notify();
  }

  Cycle push(const T& token, Cycle earliest) override {
    while (pushed_ - popped_ == slots_.size()) sc_core::wait(release_);
    Slot& slot = slots_[pushed_++ % slots_.size()];
    slot.token = token;
    slot.inserted = std::max(earliest, slot.freed + 1);
    insertion_.notify();
    return slot.inserted;
  }

 private:
  static constexpr Cycle kNever = -1;

  struct Slot {
    T token{};
    Cycle inserted = kNever;
    Cycle freed = kNever;
  };

  std::vector<Slot> slots_;
  size_t pushed_ = 0;
  size_t popped_ = 0;
  sc_core::sc_event insertion_;
  sc_core::sc_event release_;
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

}  // namespace pineda::timing
