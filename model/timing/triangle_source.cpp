#include "model/timing/triangle_source.h"

#include <algorithm>
#include <utility>

namespace pineda::timing {

void TriangleSource::begin_frame(Pull pull, Cycle run_from) {
  pull_ = std::move(pull);
  held_ = false;
  offered_ = 0;
  run_from_ = run_from;
  failure_ = nullptr;
  begun_.notify(sc_core::SC_ZERO_TIME);
}

std::exception_ptr TriangleSource::take_failure() { return std::exchange(failure_, nullptr); }

const spec::Triangle& TriangleSource::front(Cycle* visible) {
  while (!held_ && !(held_ = fetch())) sc_core::wait(begun_);
  offered_ = first_ready(ready_, ExternalPort::kTriangle, offered_);
  *visible = std::max(offered_, run_from_);
  return triangle_;
}

void TriangleSource::pop(Cycle cycle) {
  held_ = false;
  offered_ = cycle + 1;
}

// An exception must not cross the SystemC kernel, so it waits here for the end of the frame.
bool TriangleSource::fetch() {
  if (!pull_) return false;
  try {
    if (pull_(&triangle_)) return true;
  } catch (...) {
    failure_ = std::current_exception();
  }
  pull_ = nullptr;
  return false;
}

}  // namespace pineda::timing
