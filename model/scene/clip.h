// Clipping in homogeneous coordinates, before the divide.
#pragma once

#include <array>
#include <cstddef>

#include "model/spec/design.h"

namespace pineda::scene {

/// A vertex in clip space with its colour, 0 to 255, not premultiplied.
struct ClipVertex {
  std::array<double, 4> position{};
  std::array<double, 4> rgba{};
};

/// A triangle cut by six planes has at most nine corners in exact arithmetic. With rounding errors
/// a side may seem to cross a plane several times; each plane adds at most half as many corners as
/// there are.
struct Polygon {
  static constexpr size_t kMost = 28;  // 3, 4, 6, 9, 13, 19, 28
  std::array<ClipVertex, kMost> v;
  size_t size = 0;
};

/// Which depth planes clip.
struct DepthPlanes {
  bool low = true;    // 0 <= z
  bool high = false;  // z <= w
};

/// The volume that triangles are clipped to: the guard band and the active depth planes. There is
/// no clipping at the frame's borders, since setup clips the bounding box.
///
/// Bits     the guard band reaches from -2^guard_bits px to 2^guard_bits px minus one subpixel, the
///          full range of a coordinate, so that even a frame as large as the band is complete.
class ClipVolume {
 public:
  static constexpr size_t kPlanes = 6;

  ClipVolume(int width, int height, const spec::Design& design, DepthPlanes depth = {});

  /// Bit i: the vertex lies outside plane i.
  unsigned outside(const ClipVertex& vertex) const;

  /// Clips a triangle; the polygon has fewer than three corners when nothing is left.
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
