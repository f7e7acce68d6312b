// Does a polygon have an inside that it surrounds once?
#pragma once

#include "model/scene/polygons/planar.h"

namespace pineda::scene {

/// True if no two edges cross, and the polygon winds around every place beside its edges once
/// (counter-clockwise in its plane) or not at all. It may touch itself, at corners and along edges:
/// a bridge to a hole that is passed to and fro does not count.
///
/// Rate     O(n log n) questions to the polygon for n corners, and moves of up to n edges for each.
/// Source   M. Shamos, D. Hoey, "Geometric intersection problems", 1976.
bool winds_once(const PlanarPolygon& polygon);

}  // namespace pineda::scene
