// The triangles of a clipped polygon, once its vertices are snapped.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pineda::scene {

/// x, y in units of 2^-S px.
using GridPoint = std::array<int32_t, 2>;
/// Indices of three of the polygon's points.
using Piece = std::array<uint8_t, 3>;

/// Cuts a clipped triangle into triangles of one orientation that do not overlap: snapping may have
/// bent a convex polygon inwards, or turned a piece of it over.
///
/// In       the corners of a polygon that was convex before each was moved to the nearest grid
///          point, at most 255; whether x then ran clockwise into y, as it does on a screen whose y
///          points down. |x|, |y| <= 2^26.
/// Out      the fan from the first point where its triangles turn the same way; else triangles that
///          cover the snapped polygon and keep its sides; of one that crosses itself, which is as
///          thin as a grid step somewhere, those of its convex hull, turned as before snapping.
///          Never empty: where no area is left, a triangle without area.
void partition(const std::vector<GridPoint>& polygon, bool clockwise, std::vector<Piece>* pieces);

}  // namespace pineda::scene
