// What tinygltf takes without a word, found before it sees the file.
#pragma once

#include <string>

namespace pineda::scene {

/// tinygltf 2.7 recurses into nested values without a limit, cuts integers to 32 bits, and takes a
/// negative offset, a property of another type or an array of another length for an absent one.
///
/// In       the JSON of a glTF 2.0 file.
/// Errors   InputError: no JSON (with the line), nested too deep, another version, a required
///          extension (none is supported), or a property the reader uses that is not of its type.
void guard_gltf(const std::string& file, const std::string& json);

}  // namespace pineda::scene
