// The triangles of a frame as a stream.
#pragma once

#include <exception>
#include <functional>
#include <string>

#include "model/spec/triangle_range.h"
#include "model/timing/ports/memory.h"
#include "model/timing/units/stream.h"

namespace pineda::timing {

/// Fills in the next triangle of the frame; false at the end.
using Pull = std::function<bool(spec::Triangle*)>;
/// Triangles behind each other in memory.
struct Triangles {
  const spec::Triangle* first = nullptr;
  size_t count = 0;
};
/// The next triangles of the frame, at most fast::kGroup, good until the next call; none at the end.
using Next = std::function<Triangles()>;

/// Offers the triangles that a function gives, one after the other. The first one is offered from
/// cycle 0 on, any other after the one before it is taken: from the first cycle on in which the
/// port is ready, until it is taken.
///
/// Errors   tri_o left unbound: SC_REPORT_FATAL "pineda/triangles/unbound". A triangle out of range
///          and what next throws end the stream before that triangle; draw() says which.
class TriangleSource final : public sc_core::sc_module {
 public:
  Port<StreamIn<spec::Triangle>> tri_o{"tri_o"};

  /// Why the stream ended before its end: neither if it did not.
  struct Failure {
    std::exception_ptr thrown;  // by next
    std::string out_of_range;   // the triangle, and which number of it
  };

  TriangleSource(sc_core::sc_module_name name, const spec::Contract& contract)
      : sc_module(name), range_(contract) {}

  void set_ready(Ready ready) { ready_ = std::move(ready); }
  /// Sends all of them through the units. None is taken before `run_from`.
  Failure draw(const Next& next, Cycle run_from, Frame* frame);

 private:
  void end_of_elaboration() override { require_bound(tri_o, "pineda/triangles/unbound"); }

  size_t legal(const Triangles& triangles, Failure* failure) const;

  Ready ready_;
  spec::TriangleRange range_;
};

}  // namespace pineda::timing
