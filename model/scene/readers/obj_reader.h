// Reader of Wavefront .obj.
#pragma once

#include <string>
#include <vector>

#include "model/scene/mesh.h"

namespace pineda::scene {

/// In       v X Y Z [1] and v X Y Z R G B [A] (colours 0 to 1, used if each vertex has one), vn,
///          f with corners V, V/VT, V//VN and V/VT/VN of positive or negative indices, of which VT
///          and VN may be left out behind their slash. '#' begins a comment, a '\' at a line's end
///          outside of comments continues it. Materials, groups and texture coordinates are left
///          out.
/// Out      polygons cut by triangulate(); normals from the file where a face names one that it
///          has, else the area-weighted mean of the faces around the vertex. *warnings: one line
///          for each thing that could not be used, or is no triangle.
/// Errors   InputError with the line: a word that is no number, an index of a vertex out of range,
///          no faces.
Mesh read_obj(const std::string& file, std::vector<std::string>* warnings);

}  // namespace pineda::scene
