#include "model/timing/units/triangle_source.h"

#include <algorithm>

namespace pineda::timing {

namespace {

// The next triangle, null where there is none or next throws.
const spec::Triangle* pulled(const Next& next, TriangleSource::Failure* failure) {
  try {
    return next();
  } catch (const sc_core::sc_unwind_exception&) {
    throw;  // the process is killed or reset, and must not go on
  } catch (...) {
    failure->thrown = std::current_exception();
    return nullptr;
  }
}

}  // namespace

TriangleSource::Failure TriangleSource::draw(const Next& next, Cycle run_from) {
  Failure failure;
  const spec::Triangle* triangle = pulled(next, &failure);
  for (Cycle offered = 0; triangle != nullptr; ++offered, triangle = pulled(next, &failure)) {
    if (!range_.holds(*triangle)) {
      failure.out_of_range =
          "triangle " + std::to_string(triangle->id) + ", " + range_.reason(*triangle);
      break;
    }
    if (ready_) offered = first_ready(ready_, ExternalPort::kTriangle, offered);
    offered = tri_o->take(*triangle, std::max(offered, run_from));
  }
  return failure;
}

}  // namespace pineda::timing
