// Reader of PLY, the Stanford polygon format.
#pragma once

#include <string>
#include <vector>

#include "model/scene/mesh.h"

namespace pineda::scene {

/// In       ascii, binary_little_endian or binary_big_endian. Element `vertex`: x y z; nx ny nz and
///          red green blue [alpha], if all are there (8 or 16 bits unsigned, or floats 0 to 1).
///          Element `face`: the list vertex_indices or vertex_index, cut as a fan, so it should be
///          convex. Element `tristrips`: the same list, -1 begins a new strip. Other properties are
///          left out.
/// Out      triangles in the order of the file; normals as read_obj() makes them if there are none.
///          *warnings: one line for each thing that could not be used.
/// Errors   InputError with the line, or in a binary file the element: a truncated file, an index
///          out of range, a face of less than three corners, no faces.
Mesh read_ply(const std::string& file, std::vector<std::string>* warnings);

}  // namespace pineda::scene
