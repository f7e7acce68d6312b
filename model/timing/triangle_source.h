// The triangles of a frame as a stream.
#pragma once

#include <exception>
#include <functional>

#include "model/timing/memory.h"
#include "model/timing/stream.h"

namespace pineda::timing {

/// Fills in the next triangle of the frame; false at the end.
using Pull = std::function<bool(spec::Triangle*)>;

/// Offers triangles from a function: one is offered from the first cycle on in which its port is
/// ready after the triangle before it is taken, and until it is taken itself; the first one from
/// cycle 0 on.
/// Errors   an exception from the function ends the frame; take_failure() hands it over.
class TriangleSource final : public sc_core::sc_object, public StreamIn<spec::Triangle> {
 public:
  explicit TriangleSource(const char* name) : sc_object(name) {}

  void set_ready(Ready ready) { ready_ = std::move(ready); }
  /// No triangle can be taken before `run_from`.
  void begin_frame(Pull pull, Cycle run_from);
  std::exception_ptr take_failure();

  const spec::Triangle& front(Cycle* visible) override;
  void pop(Cycle cycle) override;

 private:
  bool fetch();

  Ready ready_;
  Pull pull_;
  spec::Triangle triangle_;
  bool held_ = false;  // triangle_ is not taken yet
  Cycle offered_ = 0;  // not offered before
  Cycle run_from_ = 0;
  std::exception_ptr failure_;
  sc_core::sc_event begun_;
};

}  // namespace pineda::timing
