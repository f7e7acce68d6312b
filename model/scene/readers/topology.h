// How a list of corners becomes triangles.
#pragma once

#include <array>
#include <cstddef>

namespace pineda::scene {

enum class Topology { kTriangles, kStrip, kFan };

/// The triangles of `corners` corners; what is left over of kTriangles is the caller's to refuse.
inline size_t triangle_count(Topology topology, size_t corners) {
  if (topology == Topology::kTriangles) return corners / 3;
  return corners < 3 ? 0 : corners - 2;
}

/// The corners of triangle `i`. Every second one of a strip is turned, so that all face the same
/// way.
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
