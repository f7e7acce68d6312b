// Which extensions a glTF file may require, and what is said of those it uses.
#include <gtest/gtest.h>

#include <algorithm>

#include "model/scene/readers/gltf/reader.h"
#include "tests/scene/readers/gltf/files.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

using Lines = std::vector<std::string>;

Mesh read(const GltfFile& file, Lines* warnings) {
  const Scratch scratch;
  return read_gltf(scratch.write("a.gltf", file.text()), warnings);
}

std::string error_with(const char* key, const Json& names) {
  const Scratch scratch;
  GltfFile file = one_triangle();
  file.json[key] = names;
  return error_of(scratch.write("a.gltf", file.text()));
}

TEST(GltfExtension, ThoseThatLeaveTheGeometryAloneMayBeRequiredAndAreSaid) {
  Lines none;
  const auto plain = read(one_triangle(), &none).position;
  for (const char* name :
       {"KHR_materials_unlit", "KHR_materials_variants", "KHR_materials_pbrSpecularGlossiness",
        "KHR_texture_transform", "KHR_texture_basisu", "EXT_texture_webp", "EXT_texture_avif",
        "MSFT_texture_dds", "KHR_lights_punctual", "EXT_lights_image_based", "EXT_lights_ies",
        "KHR_xmp_json_ld", "KHR_animation_pointer", "EXT_mesh_features", "KHR_audio_emitter"}) {
    GltfFile file = one_triangle();
    file.json["extensionsUsed"] = {name};
    file.json["extensionsRequired"] = {name};
    Lines warnings;
    EXPECT_EQ(read(file, &warnings).position, plain) << name;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_TRUE(is_one_line_with(warnings[0], "extension '" + std::string(name) + "' not used ("));
  }
}

TEST(GltfExtension, ThoseThatChangeItAndThoseThatNobodyKnowsAreRefusedByName) {
  for (const char* name :
       {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression",
        "EXT_mesh_gpu_instancing", "KHR_gaussian_splatting", "KHR_techniques_webgl", "CESIUM_RTC",
        "KHR_materials", "KHR_texture", "XXX_materials_KHR_materials_", ""}) {
    const std::string part = "extensionsRequired: expected none that changes what is drawn, got '";
    EXPECT_TRUE(is_one_line_with(error_with("extensionsRequired", {name}), part + name + "' ("));
    // Also when it is listed behind a harmless one.
    EXPECT_TRUE(is_one_line_with(error_with("extensionsRequired", {"KHR_materials_unlit", name}),
                                 part + name + "' ("));
    // An extension that is only used, not required, can be ignored by a reader.
    EXPECT_EQ(error_with("extensionsUsed", {name}), "");
  }
}

TEST(GltfExtension, ListsOfOtherThingsAreRefused) {
  EXPECT_TRUE(is_one_line_with(error_with("extensionsRequired", 5), "expected an array"));
  EXPECT_TRUE(is_one_line_with(error_with("extensionsRequired", {5}), "each element a text"));
  EXPECT_TRUE(is_one_line_with(error_with("extensionsUsed", {nullptr}), "each element a text"));
}

TEST(GltfExtension, InstancesThatAreOnlyUsedAreSaidToBeLeftOut) {
  GltfFile file = one_triangle();
  file.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  Lines warnings;
  EXPECT_EQ(read(file, &warnings).triangle.size(), 1u);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(is_one_line_with(warnings[0], "'EXT_mesh_gpu_instancing' not used (instances are"));
}

TEST(GltfExtension, DracoWithoutPlainTrianglesBesideItIsNoTriangleOfZeros) {
  const Scratch scratch;
  GltfFile file = one_triangle();
  file.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  primitive(&file)["extensions"]["KHR_draco_mesh_compression"] = Json::object();
  EXPECT_EQ(error_of(scratch.write("plain.gltf", file.text())), "");
  file.json["accessors"][0].erase("bufferView");
  EXPECT_TRUE(is_one_line_with(
      error_of(scratch.write("zeros.gltf", file.text())),
      "meshes[0].primitives[0]: expected triangles beside those of KHR_draco_mesh_compression"));
}

// 0 shows 1, 1 shows 2; each is drawn at x = 10 times its number.
TEST(GltfExtension, HiddenNodesHideAllBelowThem) {
  const auto drawn_without = [](const std::vector<size_t>& hidden, const char* expected) {
    GltfFile file = one_triangle();
    auto& nodes = file.json["nodes"];
    nodes = Json::array();
    for (int i = 0; i < 4; ++i) nodes.push_back({{"mesh", 0}, {"translation", {10, 0, 0}}});
    for (size_t i = 0; i < 2; ++i) nodes[i]["children"] = {i + 1};
    nodes[3]["translation"] = {40, 0, 0};
    for (size_t i = 0; i < 4; ++i) {
      const bool is_hidden = std::find(hidden.begin(), hidden.end(), i) != hidden.end();
      nodes[i]["extensions"]["KHR_node_visibility"] = {{"visible", !is_hidden}};
    }
    file.json["extensionsRequired"] = {"KHR_node_visibility"};
    Lines warnings;
    std::vector<double> x;
    const Mesh mesh = read(file, &warnings);
    for (const auto& t : mesh.triangle) x.push_back(mesh.position[t[0]][0]);
    EXPECT_EQ(warnings.size(), *expected == '\0' ? 0u : 1u);
    for (const auto& line : warnings) EXPECT_TRUE(is_one_line_with(line, expected));
    return x;
  };
  using Drawn = std::vector<double>;
  EXPECT_EQ(drawn_without({}, ""), (Drawn{10, 20, 30, 40}));
  EXPECT_EQ(drawn_without({1}, "2 nodes with a mesh left out"), (Drawn{10, 40}));
  EXPECT_EQ(drawn_without({0}, "3 nodes with a mesh left out"), (Drawn{40}));
  EXPECT_EQ(drawn_without({3, 2}, "2 nodes with a mesh left out"), (Drawn{10, 20}));
}

TEST(GltfExtension, AVisibilityThatIsNoTruthValueIsRefused) {
  const Scratch scratch;
  GltfFile file = one_triangle();
  file.json["nodes"][0]["extensions"]["KHR_node_visibility"]["visible"] = "no";
  EXPECT_TRUE(
      is_one_line_with(error_of(scratch.write("a.gltf", file.text())),
                       "nodes[0].extensions.KHR_node_visibility.visible: expected true or false"));
}

}  // namespace
}  // namespace pineda::scene
