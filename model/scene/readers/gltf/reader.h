// Reader of glTF 2.0 and its binary form GLB.
#pragma once

#include <string>
#include <vector>

#include "model/scene/mesh.h"

namespace pineda::scene {

/// In       the default scene, else the first, else all root nodes; triangles, strips and fans,
///          indexed (u8, u16, u32) or not; POSITION and NORMAL as float VEC3, or the integers of
///          KHR_mesh_quantization; COLOR_0 VEC3 or VEC4 (float, or normalized u8 or u16); sparse
///          accessors and those without a bufferView; materials' baseColorFactor; nodes' transforms
///          and KHR_node_visibility. extensions.cpp lists how all other extensions are treated.
/// Out      triangles in world space, in depth-first order of the nodes, for each node in the order
///          of the file. Where a transform mirrors, the winding is reversed, so that the outside
///          stays outside. The provoking vertex of a fan's triangle i is its vertex i + 1
///          (3.7.2.1), that of any other triangle its first corner. Missing normals, and those that
///          are no directions, are computed per primitive as in read_obj().
///          Colours: baseColorFactor times COLOR_0, both linear (3.9.2), converted to sRGB as usual
///          for 8-bit pictures; alpha stays linear. If some primitive has COLOR_0 the colours are
///          final; if there are only materials they are lit. If all are white there are no colours.
///          Cameras: see place_camera(), in the order of their nodes.
///          *warnings: one line for each thing that could not be used, except cameras.
/// Errors   InputError with the place in the file: from GltfData; an index, an offset or a count
///          out of range; a wrong type; a cycle of nodes; no triangles; more than 2^25 triangles,
///          or more than 2^18 without bytes in the file.
/// Source   Khronos glTF 2.0 specification, 3.5 to 3.10; sRGB as in IEC 61966-2-1.
Mesh read_gltf(const std::string& file, std::vector<std::string>* warnings);

}  // namespace pineda::scene
