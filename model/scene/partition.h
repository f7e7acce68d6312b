// Cuts a clipped polygon into triangles after its vertices are snapped.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pineda::scene {

/// x, y in units of 2^-S px.
using GridPoint = std::array<int32_t, 2>;
/// Indices of three of the polygon's points.
using Piece = std::array<uint8_t, 3>;

/// Cuts a clipped triangle into triangles of one orientation that do not overlap. A plain fan is
/// not enough: snapping can make a convex polygon concave or reverse a piece of it.
///
/// In       the corners, at most 255, of a polygon that was convex before each was moved to the
///          nearest grid point; whether it was clockwise before that, with y pointing down.
///          |x|, |y| <= 2^26.
/// Out      the fan from the first point if its triangles have one orientation; else triangles that
///          cover the snapped polygon and keep its sides. If the snapped polygon crosses itself (it
///          is then no wider than a grid step somewhere): triangles of its convex hull, with the
///          orientation before snapping. Never empty: if no area is left, one triangle without
///          area.
void partition(const std::vector<GridPoint>& polygon, bool clockwise, std::vector<Piece>* pieces);

}  // namespace pineda::scene
