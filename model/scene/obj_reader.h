// Reader of Wavefront .obj.
#pragma once

#include <string>
#include <vector>

#include "model/scene/mesh.h"

namespace pineda::scene {

/// In       v X Y Z [1] or v X Y Z R G B (colours 0 to 1, used if each vertex has one), vn, f with
///          positive or negative indices; polygons become triangles. All other lines are left out.
/// Out      normals from the file where a face names them, else the area-weighted mean of the faces
///          around the vertex. *warnings: one line for each thing that could not be used.
/// Errors   InputError with the line: a word that is no number, an index out of range, no faces.
Mesh read_obj(const std::string& file, std::vector<std::string>* warnings);

}  // namespace pineda::scene
