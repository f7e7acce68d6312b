#include "model/timing/triangle_source.h"

#include <algorithm>

namespace pineda::timing {

void TriangleSource::draw(const Pull& pull, Cycle run_from) {
  spec::Triangle triangle;
  for (Cycle offered = 0; pull(&triangle); ++offered) {
    offered = first_ready(ready_, ExternalPort::kTriangle, offered);
    offered = tri_o->take(triangle, std::max(offered, run_from));
  }
}

}  // namespace pineda::timing
