// Reader of Wavefront .obj.
#pragma once

#include <string>
#include <vector>

#include "model/scene/mesh.h"

namespace pineda::scene {

/// In       v X Y Z [1] and v X Y Z R G B [A] (colours 0 to 1, used if each vertex has one), vn,
///          f with corners V, V/VT, V//VN and V/VT/VN of positive or negative indices, where VT and
///          VN may be missing after their slash. '#' begins a comment; a '\' at the end of a line
///          continues it, except in comments. Materials, groups and texture coordinates are
///          ignored.
/// Out      polygons are cut by triangulate(). Normals are the file's where a face names a valid
///          one, else the area-weighted mean of the faces around the vertex. *warnings: one line
///          for each kind of statement that could not be used, or that makes no triangles.
/// Errors   InputError with the line: a word that is no number, an index of a vertex out of range,
///          no faces.
Mesh read_obj(const std::string& file, std::vector<std::string>* warnings);

}  // namespace pineda::scene
