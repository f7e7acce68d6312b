// Reader of glTF 2.0 and its binary form GLB.
#pragma once

#include <string>
#include <vector>

#include "model/scene/mesh.h"

namespace pineda::scene {

/// In       the default scene, else the first, else all root nodes; triangles, strips and fans,
///          indexed (u8, u16, u32) or not; POSITION and NORMAL as float VEC3, or the integers of
///          KHR_mesh_quantization; COLOR_0 VEC3 or VEC4 (float, or normalized u8 or u16); sparse
///          accessors and those without bytes; materials' baseColorFactor; nodes' transforms and
///          KHR_node_visibility. gltf_extensions.h says of every other extension what becomes of
///          it.
/// Out      triangles in world space, depth first through the nodes, each in the order of the file;
///          a mirroring transform turns them, so that the outside stays outside. A fan's triangle
///          i is provoked by its vertex i + 1 (3.7.2.1), every other one by its first corner.
///          Without NORMAL the normals are made as read_obj() makes them, per primitive; so are
///          those that are no directions.
///          Colours: baseColorFactor times COLOR_0, both linear (3.9.2), as sRGB, since that is
///          what 8 bits of a picture mean; alpha stays linear. With COLOR_0 in some primitive the
///          colours are final; with materials alone they are lit. When all is white there are none.
///          The nodes' cameras as place_camera() makes them, in the order of the triangles.
///          *warnings: one line for each thing that could not be used, cameras left out.
/// Errors   InputError with the place in the file: what GltfData finds; an index, an offset or a
///          count out of range; a wrong type; a cycle of nodes; no triangles; more than 2^25, or
///          than 2^18 of accessors without bytes.
/// Source   Khronos glTF 2.0 specification, 3.5 to 3.10; sRGB as in IEC 61966-2-1.
Mesh read_gltf(const std::string& file, std::vector<std::string>* warnings);

}  // namespace pineda::scene
