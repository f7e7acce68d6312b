// What each extension of glTF means for a reader of triangles.
#pragma once

#include <string>

namespace pineda::scene {

enum class GltfEffect {
  kRead,     // done as it says
  kIgnored,  // leaves the triangles where they are
  kRefused,  // changes what is drawn, or may do so
};

struct GltfExtension {
  GltfEffect effect;
  const char* reason;  // what a note or a refusal says of it
};

/// Of an extension that nobody here knows: kRefused.
GltfExtension gltf_extension(const std::string& name);

}  // namespace pineda::scene
