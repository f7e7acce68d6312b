// A glTF or GLB file and the bytes of its buffers.
#pragma once

#include <tiny_gltf.h>

#include <string>

namespace pineda::scene {

/// In       glTF 2.0 as text or GLB (told apart by their first bytes), of less than 4 GiB; buffers
///          in the file, as data URI or in files beside it. Images are not decoded.
/// Out      the file as tinygltf holds it; indices between its parts are not checked.
/// Errors   InputError: what guard_gltf() finds, chunks that do not fill the GLB, a buffer that is
///          not there or shorter than it says.
/// Source   Khronos glTF 2.0 specification, 4.4 for GLB.
tinygltf::Model load_gltf(const std::string& file);

}  // namespace pineda::scene
