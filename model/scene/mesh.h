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

/// A list of corners as its file states it, and the triangles that it became: a polygon of more
/// than three corners, or a strip or fan as glTF defines them (2.0, section 3.7.2.1).
struct MeshPolygon {
  enum class Kind : uint8_t { kPolygon, kStrip, kFan };

  uint32_t first_corner = 0;  // of Mesh::corner
  uint32_t corners = 0;
  uint32_t first_triangle = 0;  // of Mesh::triangle
  uint32_t triangles = 0;
  Kind kind = Kind::kPolygon;
  bool is_mirrored = false;  // a node's transform turns it over, so its triangles go the other way
};

/// A camera that came with the mesh. The frame's aspect is not its own business.
struct FileCamera {
  Vec3 eye{0, 0, 0};
  Vec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};  // orthonormal; it looks along -back
  bool is_orthographic = false;
  double yfov = 1;  // radians, the full vertical angle of a perspective one
  double ymag = 1;  // half of the height that an orthographic one sees
  double near = 1;
  std::optional<double> far;  // what lies beyond is cut; none: nothing is
  std::string wrong;          // why it cannot be used, with its place in the file; empty: it can
};

struct Mesh {
  std::vector<Vec3> position;
  std::vector<Vec3> normal;  // unit length, one a position
  std::vector<Rgba> color;   // one a position; empty: shaded from the normals
  bool is_lit = false;       // the colours are materials', shaded from the normals too
  std::vector<std::array<uint32_t, 3>> triangle;
  // A vertex for each triangle, whose colour is that of flat shading; empty: the first corners. It
  // need not be one of the triangle's.
  std::vector<uint32_t> provoking;
  // In the order of their triangles, without polygons cut as fans that may be wrong; their
  // vertices.
  std::vector<MeshPolygon> polygon;
  std::vector<uint32_t> corner;
  std::vector<FileCamera> camera;  // of the file; which is used, if any, is the caller's choice

  /// A triangle with a coordinate that is NaN or infinite cannot be projected.
  bool is_finite(const std::array<uint32_t, 3>& t) const {
    return scene::is_finite(position[t[0]]) && scene::is_finite(position[t[1]]) &&
           scene::is_finite(position[t[2]]);
  }
};

}  // namespace pineda::scene
