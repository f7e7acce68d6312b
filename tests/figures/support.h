// Areas and sides of figures, and a pen to draw them with.
#pragma once

#include "model/figures/pen.h"

namespace pineda::figures {

inline int64_t cross(Point p, Point q) { return p.x * q.y - p.y * q.x; }

/// Doubled and signed, in subpixels^2.
inline int64_t area2(const Corners& t) { return cross(t[1] - t[0], t[2] - t[0]); }

/// Is the point inside, or on the border?
inline bool holds(const Corners& t, Point p) {
  bool left = true, right = true;
  for (size_t i = 0; i < 3; ++i) {
    const int64_t side = area2({t[i], t[(i + 1) % 3], p});
    left = left && side >= 0;
    right = right && side <= 0;
  }
  return left || right;
}

inline Pen pen() { return Pen(spec::kHighTile, 1); }

}  // namespace pineda::figures
