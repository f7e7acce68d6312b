// Tests whether a polygon has an inside that it winds around once.
#pragma once

#include "model/scene/polygons/planar.h"

namespace pineda::scene {

/// True if no two edges cross, and the winding number of every point off the edges is 1 (counter-
/// clockwise in the polygon's plane) or 0. The polygon may touch itself at corners and along edges,
/// as on a bridge to a hole, which it runs along in both directions.
///
/// Rate     O(n log n) orientation tests for n corners, and up to n edges moved for each corner.
/// Source   M. Shamos, D. Hoey, "Geometric intersection problems", 1976.
bool winds_once(const PlanarPolygon& polygon);

}  // namespace pineda::scene
