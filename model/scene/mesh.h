// A triangle mesh in world space: right-handed, y up, outside counter-clockwise.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/scene/vec.h"

namespace pineda::scene {

using Rgba = std::array<uint8_t, 4>;

/// A list of corners as the file states it, and the triangles that were made from it: a polygon of
/// more than three corners, or a strip or fan as glTF 2.0 defines them (section 3.7.2.1).
struct MeshPolygon {
  enum class Kind : uint8_t { kPolygon, kStrip, kFan };

  uint32_t first_corner = 0;  // index in Mesh::corner
  uint32_t corners = 0;
  uint32_t first_triangle = 0;  // index in Mesh::triangle
  uint32_t triangles = 0;
  Kind kind = Kind::kPolygon;
  bool is_mirrored = false;  // a node's transform mirrors it, so its triangles' winding is reversed
};

/// A camera from the mesh's file. Its aspect ratio is not kept: the frame's is used.
struct FileCamera {
  Vec3 eye{0, 0, 0};
  Vec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};  // orthonormal; it looks along -back
  bool is_orthographic = false;
  double yfov = 1;  // radians, the full vertical angle of a perspective one
  double ymag = 1;  // half the height of an orthographic one's view
  double near = 1;
  std::optional<double> far;  // the far plane, which clips; none: infinite
  std::string wrong;          // why it cannot be used, with its place in the file; else empty
};

struct Mesh {
  std::vector<Vec3> position;
  std::vector<Vec3> normal;  // unit length, one a position
  std::vector<Rgba> color;   // one a position; empty: one colour, shaded by the normals
  bool is_lit = false;       // the colours are of materials and are shaded by the normals too
  std::vector<std::array<uint32_t, 3>> triangle;
  // The provoking vertex of each triangle, which gives its colour with flat shading; empty: the
  // first corner. It need not be a corner of the triangle, if a polygon was cut.
  std::vector<uint32_t> provoking;
  // Polygons, strips and fans in the order of their triangles, except polygons for which a fan was
  // only a guess; and the vertices of all their corners.
  std::vector<MeshPolygon> polygon;
  std::vector<uint32_t> corner;
  std::vector<FileCamera> camera;  // all cameras of the file; the caller chooses one, or none

  /// False if a coordinate of the triangle is NaN or infinite, so that it cannot be projected.
  bool is_finite(const std::array<uint32_t, 3>& t) const {
    return scene::is_finite(position[t[0]]) && scene::is_finite(position[t[1]]) &&
           scene::is_finite(position[t[2]]);
  }
};

}  // namespace pineda::scene
