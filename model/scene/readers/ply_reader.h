// Reader of PLY, the Stanford polygon format.
#pragma once

#include <string>
#include <vector>

#include "model/scene/mesh.h"

namespace pineda::scene {

/// In       ascii, binary_little_endian or binary_big_endian. Element `vertex`: x y z; nx ny nz, if
///          all are there; colours by the names that PlyColors knows. Element `face`: the list
///          vertex_indices or vertex_index; colours, if the vertices have none. Element
///          `tristrips`: the same, -1 begins a new strip. Other properties are left out.
/// Out      triangles in the order of the file, polygons cut by triangulate(); a strip's triangle
///          has its own first corner as its provoking one. A face with a colour has vertices of its
///          own. Normals as read_obj() makes them where there are none. *warnings: one line for
///          each thing that could not be used.
/// Errors   InputError with the line, or in a binary file the element: a truncated file, an index
///          out of range, a face of less than three corners, no faces.
Mesh read_ply(const std::string& file, std::vector<std::string>* warnings);

}  // namespace pineda::scene
