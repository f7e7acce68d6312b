// Reader of glTF 2.0 and its binary form GLB.
#pragma once

#include <string>
#include <vector>

#include "model/scene/mesh.h"

namespace pineda::scene {

/// In       the default scene, else the first, else all root nodes; triangles, strips and fans,
///          indexed (u8, u16, u32) or not; POSITION float VEC3, NORMAL float VEC3, COLOR_0 VEC3 or
///          VEC4 (float, or normalized u8 or u16); materials' baseColorFactor; nodes' transforms.
/// Out      triangles in world space, depth first through the nodes, each in the order of the file;
///          a mirroring transform turns them, so that the outside stays outside. Without NORMAL the
///          normals are made as read_obj() makes them, per primitive.
///          Colours: baseColorFactor times COLOR_0, both linear (3.9.2), as sRGB, since that is
///          what 8 bits of a picture mean; alpha stays linear. With COLOR_0 in some primitive the
///          colours are final; with materials alone they are lit. When all is white there are none.
///          *warnings: one line for each thing that could not be used.
/// Errors   InputError with the place in the file: what load_gltf() finds; an index, an offset or a
///          count out of range; a wrong type; a cycle of nodes; no triangles; more than 2^25.
/// Source   Khronos glTF 2.0 specification, 3.5 to 3.9; sRGB as in IEC 61966-2-1.
Mesh read_gltf(const std::string& file, std::vector<std::string>* warnings);

}  // namespace pineda::scene
