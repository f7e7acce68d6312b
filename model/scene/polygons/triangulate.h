// How polygons become triangles, for every reader of meshes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/scene/mesh.h"

namespace pineda::scene {

/// What a polygon is, seen along its Newell normal.
enum class PolygonShape {
  kConvex,    // no right turn, and around once
  kSimple,    // it may touch itself, but has an inside that it surrounds once
  kCrossing,  // it crosses itself, or surrounds something twice
  kUnknown,   // kSimple or kCrossing: there are more ways to cut it than are tried
  kFlat,      // its Newell normal is zero: no direction to see it from
  kUnbounded  // a coordinate is NaN or infinite
};

/// Cuts the polygon of three or more corners into n - 2 triangles of numbers of corners, which it
/// adds.
///
/// Bits     every decision is exact, whatever the exponents of the coordinates.
/// Out      kSimple: triangles that cover the inside once and turn as the polygon does, some maybe
///          without area in its plane. All others: the fan from the first corner.
PolygonShape triangulate(const std::vector<Vec3>& corner,
                         std::vector<std::array<uint32_t, 3>>* triangles);

/// Builds a mesh's triangles from polygons of its vertices.
class PolygonCutter {
 public:
  explicit PolygonCutter(Mesh* mesh) : mesh_(mesh) {}

  /// Adds a polygon of `count` >= 3 vertices, whose positions the mesh has: its triangles, their
  /// provoking vertex, which is the first one, and, of more than three corners and if it does not
  /// cross itself, the polygon.
  void add(const uint32_t* vertex, size_t count);

  /// One line each for polygons that were cut as fans though a fan may be wrong.
  void warn(const std::string& file, std::vector<std::string>* warnings) const;

 private:
  void add_provoking(uint32_t vertex, size_t first_triangle);

  Mesh* mesh_;
  uint64_t crossing_ = 0;
  uint64_t unknown_ = 0;
  uint64_t flat_ = 0;
  std::vector<Vec3> corner_;  // kept for their memory
  std::vector<std::array<uint32_t, 3>> cut_;
};

}  // namespace pineda::scene
