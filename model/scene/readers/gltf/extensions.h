// How the reader treats each glTF extension.
#pragma once

#include <string>

namespace pineda::scene {

enum class GltfEffect {
  kRead,     // supported
  kIgnored,  // does not change the positions of triangles
  kRefused,  // changes what is drawn, or may change it
};

struct GltfExtension {
  GltfEffect effect;
  const char* reason;  // text for a note or an error message
};

/// How an extension is treated; one that is not in the table is kRefused.
GltfExtension gltf_extension(const std::string& name);

}  // namespace pineda::scene
