// The triangles of a polygon that is not convex.
#pragma once

#include <array>
#include <vector>

#include "model/scene/polygons/planar.h"

namespace pineda::scene {

enum class EarCut {
  kDone,
  kImpossible,  // it crosses itself at a corner
  kUnknown      // not found among the ways that are tried
};

constexpr uint64_t kMostEarSteps = uint64_t{1} << 31;  // some 20 seconds

/// Cuts ears: corners whose triangle with both neighbours lies inside.
///
/// In       a polygon that winds_once().
/// Out      n - 2 triangles for n corners are added, none of which turns right in the plane. Their
///          windings sum up to the polygon's, so they cover the inside once and nothing else.
///          Nothing is added otherwise. Of up to 256 corners every way is tried; of more, some that
///          touch each other may be missed, and no more is tried after so many steps.
/// Rate     O(n^2) for n corners; a step looks at a corner.
/// Source   G. Meisters, "Polygons have ears", 1975.
EarCut cut_ears(const PlanarPolygon& polygon, std::vector<std::array<uint32_t, 3>>* triangles,
                uint64_t most_steps = kMostEarSteps);

}  // namespace pineda::scene
