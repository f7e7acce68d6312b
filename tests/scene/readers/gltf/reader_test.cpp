#include "model/scene/readers/gltf/reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/scene/readers/gltf/files.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

using Corners = std::vector<std::array<Vec3, 3>>;
using Lines = std::vector<std::string>;

Mesh read(const GltfFile& file, Lines* warnings = nullptr) {
  const Scratch scratch;
  Lines unread;
  return read_gltf(scratch.write("a.gltf", file.text()), warnings != nullptr ? warnings : &unread);
}

Corners corners_of(const Mesh& mesh) {
  Corners all;
  for (const auto& t : mesh.triangle) {
    all.push_back({mesh.position[t[0]], mesh.position[t[1]], mesh.position[t[2]]});
  }
  return all;
}

std::vector<std::array<int, 3>> numbers_of(const Mesh& mesh) {
  std::vector<std::array<int, 3>> all;
  for (const auto& t : corners_of(mesh)) {
    all.push_back(
        {static_cast<int>(t[0][0]), static_cast<int>(t[1][0]), static_cast<int>(t[2][0])});
  }
  return all;
}

TEST(GltfReader, TrianglesStripsAndFansAreCutAsTheSpecificationSays) {
  using Expected = std::vector<std::array<int, 3>>;
  const std::vector<std::pair<int, Expected>> modes = {
      {4, {{0, 1, 2}, {3, 4, 5}}},
      {5, {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}}},
      {6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}}};
  for (const auto& [mode, expected] : modes) {
    GltfFile file = numbered(6);
    primitive(&file)["mode"] = mode;
    EXPECT_EQ(numbers_of(read(file)), expected) << mode;
  }
}

// The provoking vertices, whose colours flat triangles have; if none are stated, the first corners.
std::vector<int> provoking_of(const Mesh& mesh) {
  std::vector<int> all;
  for (const uint32_t i : mesh.provoking) all.push_back(static_cast<int>(mesh.position[i][0]));
  return all;
}

TEST(GltfReader, FansTakeTheirColourFromTheVertexBehindTheHubMirroredOrNot) {
  GltfFile file = numbered(6);
  primitive(&file)["mode"] = 6;
  const std::vector<int> expected = {1, 2, 3, 4};
  EXPECT_EQ(provoking_of(read(file)), expected);
  file.json["nodes"][0]["scale"] = {1, 1, -1};
  const Mesh mirrored = read(file);
  EXPECT_EQ(numbers_of(mirrored)[1], (std::array<int, 3>{0, 3, 2}));
  EXPECT_EQ(provoking_of(mirrored), expected);
}

TEST(GltfReader, StripsAndListsTakeItFromTheirFirstCornerMirroredOrNot) {
  for (const int mode : {4, 5}) {
    for (const int z : {1, -1}) {
      GltfFile file = numbered(6);
      primitive(&file)["mode"] = mode;
      file.json["nodes"][0]["scale"] = {1, 1, z};
      const Mesh mesh = read(file);
      EXPECT_TRUE(mesh.provoking.empty());
      for (size_t i = 0; i < mesh.triangle.size(); ++i) {
        EXPECT_EQ(static_cast<size_t>(numbers_of(mesh)[i][0]), mode == 4 ? 3 * i : i);
      }
    }
  }
}

TEST(GltfReader, AFanBetweenListsLeavesTheirFirstCorners) {
  GltfFile file = numbered(6);
  const Json attributes = primitive(&file)["attributes"];
  file.mesh(attributes)["mode"] = 6;
  file.mesh(attributes);
  EXPECT_EQ(provoking_of(read(file)), (std::vector<int>{0, 3, 1, 2, 3, 4, 0, 3}));
}

TEST(GltfReader, NormalsThatAreNoDirectionsAreMadeAndCounted) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  GltfFile file;
  const int normals = file.vectors({nan, 0, 1, .6F, 0, .8F, 0, 0, 0});
  file.mesh({{"POSITION", file.vectors({0, 0, 0, 1, 0, 0, 0, 1, 0})}, {"NORMAL", normals}});
  Lines warnings;
  const Mesh mesh = read(file, &warnings);
  EXPECT_EQ(mesh.normal[0], (Vec3{0, 0, 1}));
  EXPECT_NEAR(mesh.normal[1][0], .6, 1e-7);
  EXPECT_EQ(mesh.normal[2], (Vec3{0, 0, 1}));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(is_one_line_with(warnings[0], "2 normals that are no directions"));
}

TEST(GltfReader, IndicesOfEachWidthGiveTheSameTrianglesAndOnlyUsedVerticesAreKept) {
  const auto with = [](int type, const std::string& bytes) {
    GltfFile file = numbered(300);
    primitive(&file)["indices"] = file.accessor(type, "SCALAR", 6, bytes);
    return read(file);
  };
  const std::vector<std::array<int, 3>> expected = {{7, 200, 3}, {3, 200, 255}};
  for (const Mesh& mesh : {with(kU8, packed<uint8_t>({7, 200, 3, 3, 200, 255})),
                           with(kU16, packed<uint16_t>({7, 200, 3, 3, 200, 255})),
                           with(kU32, packed<uint32_t>({7, 200, 3, 3, 200, 255}))}) {
    EXPECT_EQ(numbers_of(mesh), expected);
    EXPECT_EQ(mesh.position.size(), 4u);
    EXPECT_EQ(mesh.normal.size(), 4u);
  }
}

TEST(GltfReader, InterleavedAttributesAreReadByStrideAndOffset) {
  GltfFile file;
  const int positions =
      file.accessor(kF32, "VEC3", 3,
                    packed<float>({9, 0, 0, 0, 1, 0, 0, 9, 5, 0, 0, 1, 0, 0, 9, 0, 5, 0, 1, 0, 0}));
  const Json view = file.json["accessors"][0]["bufferView"];
  file.json["bufferViews"][0]["byteStride"] = 28;
  file.json["accessors"][0]["byteOffset"] = 4;
  file.json["accessors"][0]["count"] = 3;
  file.json["accessors"].push_back(file.json["accessors"][0]);
  file.json["accessors"][1]["byteOffset"] = 16;
  file.json["accessors"][1]["count"] = 3;
  file.mesh({{"POSITION", positions}, {"NORMAL", 1}});
  const Mesh mesh = read(file);
  EXPECT_EQ(corners_of(mesh), (Corners{{{{0, 0, 0}, {5, 0, 0}, {0, 5, 0}}}}));
  EXPECT_EQ(mesh.normal[0], (Vec3{1, 0, 0}));
}

TEST(GltfReader, ScaleThenRotationThenTranslationThenTheParent) {
  GltfFile file = one_triangle();
  const double half = std::sqrt(.5);  // a quarter turn about z
  file.json["nodes"][0]["scale"] = {2, 3, 4};
  file.json["nodes"][0]["rotation"] = {0, 0, half, half};
  file.json["nodes"][0]["translation"] = {1, 2, 3};
  // A parent given as a matrix, column by column: (x, y, z) -> (z, x, y) + (10, 20, 30)
  file.json["nodes"].push_back(
      {{"children", {0}}, {"matrix", {0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 10, 20, 30, 1}}});
  const Corners expected = {{{{13, 21, 32}, {13, 21, 34}, {13, 18, 32}}}};
  const Mesh mesh = read(file);
  ASSERT_EQ(mesh.triangle.size(), 1u);
  for (size_t i = 0; i < 3; ++i) {
    const Vec3 p = mesh.position[mesh.triangle[0][i]];
    for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(p[k], expected[0][i][k], 1e-12) << i << k;
  }
}

TEST(GltfReader, MirroredNodesKeepTheirOutsideOutside) {
  GltfFile file;
  const int normals = file.vectors({0, 0, 1, 0, 0, 1, .6F, 0, .8F});
  file.mesh({{"POSITION", file.vectors({0, 0, 0, 1, 0, 0, 0, 1, 0})}, {"NORMAL", normals}});
  file.json["nodes"][0]["scale"] = {-2, 1, 1};
  const Mesh mesh = read(file);
  EXPECT_EQ(corners_of(mesh), (Corners{{{{0, 0, 0}, {0, 1, 0}, {-2, 0, 0}}}}));
  EXPECT_EQ(mesh.normal[mesh.triangle[0][0]], (Vec3{0, 0, 1}));
  // The slope is halved where x is stretched to the double: (-.3, 0, .8), of unit length.
  const Vec3 slanted = mesh.normal[mesh.triangle[0][1]];
  const Vec3 expected = normalized({-.3, 0, .8});
  for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(slanted[k], expected[k], 1e-7);
  // Two mirrorings cancel.
  file.json["nodes"][0]["scale"] = {-2, -1, 1};
  EXPECT_EQ(corners_of(read(file)), (Corners{{{{0, 0, 0}, {-2, 0, 0}, {0, -1, 0}}}}));
}

TEST(GltfReader, NodesAreDrawnDepthFirstAndMeshesMayBeUsedTwice) {
  GltfFile file = one_triangle();
  auto& nodes = file.json["nodes"];
  nodes = Json::array();
  // 3 is the root; then 1 with its child 2, then 0.
  for (int x = 0; x < 4; ++x) nodes.push_back({{"mesh", 0}, {"translation", {x * 10, 0, 0}}});
  nodes[3]["children"] = {1, 0};
  nodes[1]["children"] = {2};
  std::vector<double> x;
  for (const auto& t : corners_of(read(file))) x.push_back(t[0][0]);
  EXPECT_EQ(x, (std::vector<double>{30, 40, 60, 30}));
}

TEST(GltfReader, TheDefaultSceneElseTheFirstElseAllRootsAreDrawn) {
  GltfFile file = one_triangle();
  file.json["nodes"] = {{{"mesh", 0}, {"translation", {5, 0, 0}}},
                        {{"mesh", 0}, {"translation", {6, 0, 0}}}};
  EXPECT_EQ(read(file).triangle.size(), 2u);
  file.json["scenes"] = {{{"nodes", {1}}}, {{"nodes", {0}}}};
  Lines warnings;
  EXPECT_EQ(corners_of(read(file, &warnings))[0][0], (Vec3{6, 0, 0}));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(is_one_line_with(warnings[0], "1 further scenes left out"));
  file.json["scene"] = 1;
  EXPECT_EQ(corners_of(read(file))[0][0], (Vec3{5, 0, 0}));
}

double linear_of(int code) {
  const double c = code / 255.0;
  return c <= .04045 ? c / 12.92 : std::pow((c + .055) / 1.055, 2.4);
}

TEST(GltfReader, LinearColoursBecomeTheirSrgbCodes) {
  for (int code = 0; code < 255; code += 3) {
    GltfFile file = one_triangle();
    std::vector<float> colors;
    for (int i = 0; i < 3; ++i) {
      colors.insert(colors.end(), 3, static_cast<float>(linear_of(code + i)));
    }
    primitive(&file)["attributes"]["COLOR_0"] = file.vectors(colors);
    const Mesh mesh = read(file);
    for (int i = 0; i < 3; ++i) {
      const auto c = static_cast<uint8_t>(code + i);
      ASSERT_EQ(mesh.color[static_cast<size_t>(i)], (Rgba{c, c, c, 255}));
    }
    EXPECT_FALSE(mesh.is_lit);
  }
}

TEST(GltfReader, VertexColoursOfEachTypeAreTimesTheBaseColour) {
  const auto with = [](int type, const std::string& bytes, bool normalized) {
    GltfFile file = one_triangle();
    file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {.5, 1, 0, .5}}}}}};
    primitive(&file)["material"] = 0;
    primitive(&file)["attributes"]["COLOR_0"] = file.accessor(type, "VEC4", 3, bytes, normalized);
    return read(file);
  };
  // .5 linear is code 188; 51/255 = .2 is 124, half of it 89.
  const std::vector<Rgba> expected = {{188, 255, 0, 128}, {89, 124, 0, 26}, {0, 0, 0, 0}};
  const std::string floats = packed<float>({1, 1, 1, 1, .2F, .2F, .2F, .2F, 0, 0, 0, 0});
  EXPECT_EQ(with(kF32, floats, false).color, expected);
  EXPECT_EQ(
      with(kU8, packed<uint8_t>({255, 255, 255, 255, 51, 51, 51, 51, 0, 0, 0, 0}), true).color,
      expected);
  const uint16_t one = 65535, fifth = 13107;
  EXPECT_EQ(
      with(kU16, packed<uint16_t>({one, one, one, one, fifth, fifth, fifth, fifth, 0, 0, 0, 0}),
           true)
          .color,
      expected);
}

TEST(GltfReader, MaterialsAloneAreLitAndWhiteOnesAreNoColours) {
  GltfFile file = one_triangle();
  file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 1}}}}},
                            {{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}}}}};
  primitive(&file)["material"] = 0;
  EXPECT_TRUE(read(file).color.empty());
  file.mesh(primitive(&file)["attributes"])["material"] = 1;
  const Mesh mesh = read(file);
  ASSERT_EQ(mesh.color.size(), 6u);
  EXPECT_EQ(mesh.color[0], (Rgba{255, 255, 255, 255}));
  EXPECT_EQ(mesh.color[3], (Rgba{255, 0, 0, 255}));
  EXPECT_TRUE(mesh.is_lit);
}

TEST(GltfReader, WhatIsNotDrawnIsSaid) {
  GltfFile file = one_triangle();
  const Json attributes = primitive(&file)["attributes"];
  for (int mode = 0; mode < 4; ++mode) file.mesh(attributes)["mode"] = mode;
  primitive(&file)["targets"] = {attributes};
  primitive(&file)["material"] = 0;
  primitive(&file)["attributes"]["COLOR_0"] =
      file.vectors({1.5, -1, std::numeric_limits<float>::quiet_NaN(), 0, 0, 0, 1, 1, 1});
  file.json["images"] = {{{"uri", "none.png"}}};
  file.json["textures"] = {{{"source", 0}}};
  file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  file.json["nodes"][0]["skin"] = 0;
  file.json["nodes"][0]["camera"] = 0;
  file.json["extensionsUsed"] = {"KHR_materials_unlit"};
  Lines warnings;
  const Mesh mesh = read(file, &warnings);
  EXPECT_EQ(mesh.triangle.size(), 1u);
  EXPECT_EQ(mesh.color[0], (Rgba{255, 0, 0, 255}));
  const char* expected[] = {"4 primitives left out: points or lines",
                            "1 primitives without their base colour's texture",
                            "1 nodes with a skin",
                            "1 primitives with morph targets",
                            "3 components of colours outside",
                            "extension 'KHR_materials_unlit' not used"};
  ASSERT_EQ(warnings.size(), std::size(expected));
  for (size_t i = 0; i < warnings.size(); ++i) {
    EXPECT_TRUE(is_one_line_with(warnings[i], expected[i]));
  }
}

TEST(GltfReader, NanVerticesDropTheirTrianglesOnly) {
  const Scratch scratch;
  GltfFile file = numbered(6);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  file.bytes.replace(12, 4, packed<float>({nan}));
  const auto scene = open_scene(kContract, scratch.write("a.glb", file.glb()), {});
  ASSERT_EQ(all_triangles(scene.source.get()).size(), 1u);
  EXPECT_EQ(scene.source->counters().nan_dropped, 1u);
}

}  // namespace
}  // namespace pineda::scene
