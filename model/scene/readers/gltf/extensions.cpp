#include "model/scene/readers/gltf/extensions.h"

#include <cstring>

namespace pineda::scene {
namespace {

constexpr const char* kSurface = "how surfaces reflect light";
constexpr const char* kTexture = "textures are not drawn";
constexpr const char* kLamp = "the light is the renderer's own";
constexpr const char* kMetadata = "says something about the file, draws nothing";
constexpr const char* kBehaviour = "nothing moves and nobody selects";
constexpr const char* kSound = "sounds are not played";
constexpr const char* kCompressed = "compressed triangles are not read";
constexpr const char* kInstances = "instances are left out";

struct Row {
  const char* name;  // a trailing '*' stands for any ending: "KHR_materials_*"
  GltfEffect effect;
  const char* reason;
};

constexpr GltfEffect kRead = GltfEffect::kRead;
constexpr GltfEffect kIgnored = GltfEffect::kIgnored;
constexpr GltfEffect kRefused = GltfEffect::kRefused;

constexpr Row kExtensions[] = {
    {"KHR_mesh_quantization", kRead, "positions and normals as integers"},
    {"KHR_node_visibility", kRead, "hidden nodes are not drawn"},

    {"KHR_materials_*", kIgnored, kSurface},
    {"ADOBE_materials_*", kIgnored, kSurface},
    {"KHR_texture_*", kIgnored, kTexture},
    {"EXT_texture_*", kIgnored, kTexture},
    {"MSFT_texture_dds", kIgnored, kTexture},
    {"MSFT_packing_*", kIgnored, kTexture},
    {"KHR_lights_punctual", kIgnored, kLamp},
    {"EXT_lights_*", kIgnored, kLamp},
    {"KHR_xmp_json_ld", kIgnored, kMetadata},
    {"KHR_xmp", kIgnored, kMetadata},
    {"EXT_mesh_features", kIgnored, kMetadata},
    {"EXT_structural_metadata", kIgnored, kMetadata},
    {"EXT_mesh_manifold", kIgnored, kMetadata},
    {"FB_geometry_metadata", kIgnored, kMetadata},
    {"KHR_animation_pointer", kIgnored, kBehaviour},
    {"KHR_node_selectability", kIgnored, kBehaviour},
    {"KHR_node_hoverability", kIgnored, kBehaviour},
    {"KHR_audio_emitter", kIgnored, kSound},
    {"MSFT_audio_emitter", kIgnored, kSound},
    {"MSFT_lod", kIgnored, "the finest level is drawn"},

    {"KHR_draco_mesh_compression", kRefused, kCompressed},
    {"EXT_meshopt_compression", kRefused, kCompressed},
    {"KHR_meshopt_compression", kRefused, kCompressed},
    {"EXT_mesh_gpu_instancing", kRefused, kInstances},
    {"EXT_instance_features", kRefused, kInstances},
    {"KHR_gaussian_splatting*", kRefused, "splats are not drawn"},
    {"KHR_technique*", kRefused, "a file's own shaders are not run"},
    {"CESIUM_RTC", kRefused, "moves the triangles"},
};

bool matches(const char* pattern, const std::string& name) {
  const size_t length = std::strlen(pattern);
  if (pattern[length - 1] != '*') return name == pattern;
  return name.compare(0, length - 1, pattern, length - 1) == 0;
}

}  // namespace

GltfExtension gltf_extension(const std::string& name) {
  for (const Row& row : kExtensions) {
    if (matches(row.name, name)) return {row.effect, row.reason};
  }
  return {kRefused, "not known"};
}

}  // namespace pineda::scene
