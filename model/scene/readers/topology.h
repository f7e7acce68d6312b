// Converts lists of corners to triangles.
#pragma once

#include <array>
#include <cstddef>

namespace pineda::scene {

enum class Topology { kTriangles, kStrip, kFan };

/// The number of triangles of `corners` corners. The caller must reject kTriangles with a
/// remainder.
inline size_t triangle_count(Topology topology, size_t corners) {
  if (topology == Topology::kTriangles) return corners / 3;
  return corners < 3 ? 0 : corners - 2;
}

/// The corners of triangle `i`. Two corners of every second triangle of a strip are swapped, so
/// that all have the same winding.
inline std::array<size_t, 3> triangle_corners(Topology topology, size_t i) {
  switch (topology) {
    case Topology::kTriangles:
      return {3 * i, 3 * i + 1, 3 * i + 2};
    case Topology::kStrip:
      return {i, i + 1 + i % 2, i + 2 - i % 2};
    case Topology::kFan:
      return {0, i + 1, i + 2};
  }
  return {};
}

}  // namespace pineda::scene
