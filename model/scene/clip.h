// Clipping in homogeneous coordinates, before the divide.
#pragma once

#include <array>
#include <cstddef>

#include "model/spec/design.h"

namespace pineda::scene {

/// A vertex in clip space with its straight colour, 0 to 255.
struct ClipVertex {
  std::array<double, 4> position{};
  std::array<double, 4> rgba{};
};

/// A triangle cut by six planes has at most nine corners in exact arithmetic. Rounding may see a
/// straight side cross a plane more than once; each plane adds half of the corners at the most.
struct Polygon {
  static constexpr size_t kMost = 28;  // 3, 4, 6, 9, 13, 19, 28
  std::array<ClipVertex, kMost> v;
  size_t size = 0;
};

/// Which planes of depth cut.
struct DepthPlanes {
  bool low = true;    // 0 <= z
  bool high = false;  // z <= w
};

/// The volume that vertices must lie in: between the planes of depth that cut, inside the guard
/// band. The frame's borders are not clipped against: the rasterizer's box does that.
///
/// Bits     the guard band reaches from -2^guard_bits px to the last multiple of a subpixel below
///          2^guard_bits, all that a coordinate can state: a frame as large as the band loses
///          nothing.
class ClipVolume {
 public:
  static constexpr size_t kPlanes = 6;

  ClipVolume(int width, int height, const spec::Design& design, DepthPlanes depth = {});

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
