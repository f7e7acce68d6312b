// Clipping in homogeneous coordinates, before the divide.
#pragma once

#include <array>
#include <cstddef>

namespace pineda::scene {

/// A vertex in clip space with its straight colour, 0 to 255.
struct ClipVertex {
  std::array<double, 4> position{};
  std::array<double, 4> rgba{};
};

/// A triangle cut by five planes has at most eight corners in exact arithmetic. Rounding may see a
/// straight side cross a plane more than once; each plane adds half of the corners at the most.
struct Polygon {
  std::array<ClipVertex, 19> v;  // 3, 4, 6, 9, 13, 19
  size_t size = 0;
};

/// The volume that vertices must lie in: in front of the near plane, inside the guard band. The
/// frame's borders are not clipped against: the rasterizer's box does that.
class ClipVolume {
 public:
  static constexpr size_t kPlanes = 5;

  ClipVolume(int width, int height, int guard_bits);

  /// Bit i: the vertex lies outside plane i.
  unsigned outside(const ClipVertex& vertex) const;

  /// Clips a triangle; an empty polygon when nothing is left.
  ///
  /// Bits     a cut always runs from the inside vertex to the outside one, so that the two
  ///          triangles at an edge get the same new vertex, bit for bit, though they walk the edge
  ///          in opposite directions.
  Polygon clip(const std::array<ClipVertex, 3>& triangle) const;

 private:
  using Plane = std::array<double, 4>;  // inside: dot(plane, position) >= 0

  static double distance(const Plane& plane, const ClipVertex& vertex);
  static Polygon clip(const Plane& plane, const Polygon& polygon);

  std::array<Plane, kPlanes> planes_;
};

}  // namespace pineda::scene
