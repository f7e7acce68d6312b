// Reader of PLY, the Stanford polygon format.
#pragma once

#include <string>
#include <vector>

#include "model/scene/mesh.h"

namespace pineda::scene {

/// In       ascii, binary_little_endian or binary_big_endian. Element `vertex`: x y z; nx ny nz, if
///          all three are there; colours, see PlyColors. Element `face`: the list vertex_indices or
///          vertex_index; colours, if the vertices have none. Element `tristrips`: the same, where
///          -1 begins a new strip. Other properties are ignored.
/// Out      triangles in the order of the file, polygons cut by triangulate(). The provoking vertex
///          of a strip's triangle is its first corner. Faces with colours do not share vertices.
///          Missing normals are computed as in read_obj(). *warnings: one line for each thing that
///          could not be used.
/// Errors   InputError with the line, or in a binary file the element: a truncated file, an index
///          out of range, a face of less than three corners, no faces.
Mesh read_ply(const std::string& file, std::vector<std::string>* warnings);

}  // namespace pineda::scene
