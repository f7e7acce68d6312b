// The triangles of a polygon that is not convex.
#pragma once

#include <array>
#include <vector>

#include "model/scene/planar.h"

namespace pineda::scene {

/// Cuts ears: corners whose triangle with both neighbours lies inside.
///
/// In       a polygon that winds_once().
/// Out      n - 2 triangles for n corners are added, none of which turns right in the plane. Their
///          windings sum up to the polygon's, so they cover the inside once and nothing else.
///          False, and nothing is added, if no such triangles were found.
/// Rate     O(n^2) for n corners.
/// Source   G. Meisters, "Polygons have ears", 1975.
bool cut_ears(const PlanarPolygon& polygon, std::vector<std::array<uint32_t, 3>>* triangles);

}  // namespace pineda::scene
