// Triangulation of a polygon that is not convex, by cutting ears.
#pragma once

#include <array>
#include <vector>

#include "model/scene/polygons/planar.h"

namespace pineda::scene {

enum class EarCut {
  kDone,
  kImpossible,  // there is no triangulation: the polygon crosses itself at a corner
  kUnknown      // none was found, but not all ways were tried
};

constexpr uint64_t kMostEarSteps = uint64_t{1} << 31;  // some 20 seconds

/// Cuts ears: corners whose triangle with both neighbours lies inside the polygon.
///
/// In       a polygon that winds_once().
/// Out      kDone: n - 2 triangles are added for n corners, none of which turns right in the plane.
///          Their windings add up to the polygon's, so they cover the inside once and nothing else.
///          Otherwise nothing is added. Up to 256 corners all ways are tried. For more, polygons
///          that touch themselves may not be solved, and ear cutting stops after `most_steps`.
/// Rate     O(n^2) steps for n corners; a step visits one cell or one corner.
/// Source   G. Meisters, "Polygons have ears", 1975.
EarCut cut_ears(const PlanarPolygon& polygon, std::vector<std::array<uint32_t, 3>>* triangles,
                uint64_t most_steps = kMostEarSteps);

}  // namespace pineda::scene
