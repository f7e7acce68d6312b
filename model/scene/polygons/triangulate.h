// How polygons become triangles, for every reader of meshes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/scene/mesh.h"

namespace pineda::scene {

/// The shape of a polygon, seen along its Newell normal.
enum class PolygonShape {
  kConvex,    // no right turn, and goes around once
  kSimple,    // has an inside that it winds around once; it may touch itself
  kCrossing,  // it crosses itself, or winds around something twice
  kUnknown,   // kSimple or kCrossing: not all ways to cut it were tried
  kFlat,      // its Newell normal is zero, so it has no plane
  kUnbounded  // a coordinate is NaN or infinite
};

/// Cuts a polygon of n >= 3 corners into n - 2 triangles, and appends the numbers of their corners.
///
/// Bits     every decision is exact, whatever the exponents of the coordinates.
/// Out      kSimple: triangles that cover the inside once and have the polygon's orientation; some
///          may have no area in its plane. All other shapes: the fan from the first corner.
PolygonShape triangulate(const std::vector<Vec3>& corner,
                         std::vector<std::array<uint32_t, 3>>* triangles);

/// Builds a mesh's triangles from polygons of its vertices.
class PolygonCutter {
 public:
  explicit PolygonCutter(Mesh* mesh) : mesh_(mesh) {}

  /// Adds a polygon of `count` >= 3 vertices of the mesh: its triangles, with the first vertex as
  /// provoking vertex; and to Mesh::polygon, if it has more than three corners and is convex or
  /// simple.
  void add(const uint32_t* vertex, size_t count);

  /// One line for each kind of polygon for which the fan may be wrong.
  void warn(const std::string& file, std::vector<std::string>* warnings) const;

 private:
  void add_provoking(uint32_t vertex, size_t first_triangle);

  Mesh* mesh_;
  uint64_t crossing_ = 0;
  uint64_t unknown_ = 0;
  uint64_t flat_ = 0;
  std::vector<Vec3> corner_;  // members only to reuse their memory
  std::vector<std::array<uint32_t, 3>> cut_;
};

}  // namespace pineda::scene
