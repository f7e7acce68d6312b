#include "model/timing/units/triangle_source.h"

#include <algorithm>

namespace pineda::timing {

void TriangleSource::draw(const Next& next, Cycle run_from) {
  const spec::Triangle* triangle = next();
  for (Cycle offered = 0; triangle != nullptr; ++offered, triangle = next()) {
    if (ready_) offered = first_ready(ready_, ExternalPort::kTriangle, offered);
    offered = tri_o->take(*triangle, std::max(offered, run_from));
  }
}

}  // namespace pineda::timing
