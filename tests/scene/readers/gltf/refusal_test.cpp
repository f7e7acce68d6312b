// What read_gltf() must refuse, in one line and without a crash.
#include <gtest/gtest.h>

#include <functional>

#include "tests/scene/readers/gltf/files.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

// A square of two triangles with everything that can be wrong: indices, normals, colours, material.
GltfFile square() {
  GltfFile file;
  const int position = file.vectors({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  const int normal = file.vectors({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  const int color =
      file.accessor(kU8, "VEC4", 4, packed<uint8_t>(std::vector<uint8_t>(16, 200)), true);
  Json& primitive = file.mesh({{"POSITION", position}, {"NORMAL", normal}, {"COLOR_0", color}});
  primitive["indices"] = file.accessor(kU16, "SCALAR", 6, packed<uint16_t>({0, 1, 2, 0, 2, 3}));
  primitive["material"] = 0;
  file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {1, .5, 0, 1}}}}}};
  file.json["scenes"] = {{{"nodes", {0}}}};
  return file;
}

struct Refusal {
  const char* name;
  const char* place;  // a pointer into the square's JSON
  Json value;         // put there
  const char* message;
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.name; }

class GltfRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(GltfRefusal, NamesThePlaceAndWhatWasExpected) {
  const Scratch scratch;
  GltfFile file = square();
  ASSERT_EQ(error_of(scratch.write("good.gltf", file.text())), "");
  ASSERT_EQ(error_of(scratch.write("good.glb", file.glb())), "");
  file.json[Json::json_pointer(GetParam().place)] = GetParam().value;
  for (const auto& path :
       {scratch.write("bad.gltf", file.text()), scratch.write("bad.glb", file.glb())}) {
    EXPECT_TRUE(is_one_line_with(error_of(path), path + ": " + GetParam().message));
  }
}

const std::vector<Refusal> kRefusals = {
    {"NoAsset", "/asset", 5, "asset: expected an object"},
    {"OtherVersion", "/asset/version", "1.0", "asset.version: expected \"2.0\""},
    {"RequiredExtension",
     "/extensionsRequired",
     {"KHR_draco_mesh_compression"},
     "extensionsRequired: expected none that changes what is drawn, got "
     "'KHR_draco_mesh_compression' (compressed triangles are not read)"},
    {"MeshesNoArray", "/meshes", 5, "meshes: expected an array"},
    {"NodeNoObject", "/nodes/0", 7, "nodes[0]: expected an object"},
    {"NoNodes", "/scenes/0/nodes", Json::array(), "expected triangles, got none"},
    {"SceneTooGreat", "/scene", 1, "scene: expected one of 1, got 1"},
    {"SceneNoIndex", "/scene", "first", "scene: expected an integer"},
    {"SceneNodeTooGreat", "/scenes/0/nodes", {0, 9}, "nodes[9]: expected one of 1 nodes"},
    {"SceneNodeNoIndex", "/scenes/0/nodes", {"a"}, "scenes[0].nodes: expected an array, each"},
    {"NodeTwice", "/scenes/0/nodes", {0, 0}, "nodes[0]: expected a tree, got a node that is"},
    {"NodeItsOwnChild", "/nodes/0/children", {0}, "nodes[0]: expected a tree"},
    {"ChildNegative", "/nodes/0/children", {-1}, "nodes[0].children: expected an array, each"},
    {"MeshTooGreat", "/nodes/0/mesh", 1, "meshes[1]: expected one of 1"},
    {"MeshBeyondAnInt", "/nodes/0/mesh", 4294967296, "nodes[0].mesh: expected an integer"},
    {"MatrixOfTwelve",
     "/nodes/0/matrix",
     {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0},
     "nodes[0].matrix: expected 16 numbers"},
    {"MatrixPerspective",
     "/nodes/0/matrix",
     {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1},
     "nodes[0]: expected an affine matrix"},
    {"ScaleANumber", "/nodes/0/scale", 2, "nodes[0].scale: expected 3 numbers"},
    {"RotationZero", "/nodes/0/rotation", {0, 0, 0, 0}, "nodes[0]: expected a rotation of length"},
    {"NoAttributes", "/meshes/0/primitives/0/attributes", nullptr,
     "meshes[0].primitives[0].attributes: expected an object"},
    {"NoPosition", "/meshes/0/primitives/0/attributes", Json::object(),
     "meshes[0].primitives[0]: expected an attribute POSITION"},
    {"PositionTooGreat", "/meshes/0/primitives/0/attributes/POSITION", 99,
     "accessors[99]: expected one of 4"},
    {"PositionNoFloat", "/meshes/0/primitives/0/attributes/POSITION", 2,
     "accessors[2]: expected POSITION as float VEC3"},
    {"NormalFewer", "/accessors/1/count", 3,
     "meshes[0].primitives[0]: expected as many values as POSITION has, 4, got 3"},
    {"ColourNotNormalized", "/accessors/2/normalized", false,
     "accessors[2]: expected COLOR_0 as VEC3 or VEC4, float or normalized"},
    {"ColourScalar", "/accessors/2/type", "SCALAR", "accessors[2]: expected COLOR_0 as VEC3"},
    {"ModeTooGreat", "/meshes/0/primitives/0/mode", 7,
     "meshes[0].primitives[0].mode: expected 0 to 6"},
    {"ModeNegative", "/meshes/0/primitives/0/mode", -1, "meshes[0].primitives[0].mode: expected"},
    {"MaterialTooGreat", "/meshes/0/primitives/0/material", 1, "materials[1]: expected one of 1"},
    {"BaseColourOfThree",
     "/materials/0/pbrMetallicRoughness/baseColorFactor",
     {1, 1, 1},
     "materials[0].pbrMetallicRoughness.baseColorFactor: expected 4 numbers"},
    {"BaseColourTooGreat",
     "/materials/0/pbrMetallicRoughness/baseColorFactor",
     {1, 1, 2, 1},
     "materials[0]: expected a baseColorFactor from 0 to 1"},
    {"IndicesTooFew", "/accessors/3/count", 5,
     "meshes[0].primitives[0]: expected whole triangles, got 5 corners"},
    {"IndicesOutOfRange", "/accessors/0/count", 3,
     "meshes[0].primitives[0]: expected as many values"},
    {"IndicesFloat", "/meshes/0/primitives/0/indices", 0, "accessors[0]: expected indices as u8"},
    {"IndicesTooGreat", "/meshes/0/primitives/0/indices", 4, "accessors[4]: expected one of 4"},
    {"CountTooGreat", "/accessors/0/count", 5,
     "accessors[0]: expected 5 values inside of the 48 bytes of bufferView 0"},
    {"CountHuge", "/accessors/0/count", 2147483647, "accessors[0]: expected 2147483647 values"},
    {"CountZero", "/accessors/0/count", 0, "accessors[0]: expected a count above 0"},
    {"CountNegative", "/accessors/0/count", -4, "accessors[0].count: expected an integer"},
    {"CountFraction", "/accessors/0/count", 3.5, "accessors[0].count: expected an integer"},
    {"OffsetNegative", "/accessors/0/byteOffset", -4, "accessors[0].byteOffset: expected an"},
    {"OffsetTooGreat", "/accessors/0/byteOffset", 4, "accessors[0]: expected 4 values inside of"},
    {"OffsetHuge", "/accessors/0/byteOffset", 2147483647, "accessors[0]: expected 4 values"},
    {"ComponentSigned", "/accessors/0/componentType", 5122,
     "accessors[0]: expected POSITION as float VEC3"},
    {"ComponentUnknown", "/accessors/0/componentType", 9,
     "accessors[0]: expected i8, u8, i16, u16, u32 or float, got type 9"},
    {"TypeUnknown", "/accessors/0/type", "VEC5", "accessors[0]: expected a type from SCALAR to"},
    {"ViewTooGreat", "/accessors/0/bufferView", 4, "bufferViews[4]: expected one of 4"},
    {"ViewBeyondAnInt", "/accessors/0/bufferView", 4294967296, "accessors[0].bufferView: expected"},
    {"ViewTooLong", "/bufferViews/0/byteLength", 200,
     "bufferViews[0]: expected bytes inside of the 124 of buffer 0"},
    {"ViewTooFar", "/bufferViews/0/byteOffset", 125, "bufferViews[0]: expected bytes inside of"},
    {"ViewOffsetNegative", "/bufferViews/0/byteOffset", -4, "bufferViews[0].byteOffset: expected"},
    {"StrideTooSmall", "/bufferViews/0/byteStride", 4,
     "accessors[0]: expected a stride of 12 bytes"},
    {"StrideTooGreat", "/bufferViews/0/byteStride", 16,
     "accessors[0]: expected 4 values inside of"},
    {"BufferTooGreat", "/bufferViews/0/buffer", 1, "buffers[1]: expected one of 1"},
};

INSTANTIATE_TEST_SUITE_P(Gltf, GltfRefusal, testing::ValuesIn(kRefusals),
                         [](const auto& row) { return row.param.name; });

TEST(GltfRefused, AnIndexOutOfRangeIsNamed) {
  const Scratch scratch;
  GltfFile file = square();
  file.bytes.replace(file.bytes.size() - 2, 2, packed<uint16_t>({65535}));
  EXPECT_TRUE(is_one_line_with(error_of(scratch.write("a.glb", file.glb())),
                               "accessors[3]: expected an index of 4 vertices, got 65535"));
}

TEST(GltfRefused, WhatIsNoJsonNamesTheLine) {
  const Scratch scratch;
  const auto path = scratch.write("a.gltf", "{\"asset\": {\"version\": \"2.0\"},\n\"nodes\": ?}");
  EXPECT_TRUE(is_one_line_with(error_of(path), path + ":2: expected JSON, got '?}'"));
  const auto infinite = scratch.write("b.gltf", "{\"a\": 1e999}");
  EXPECT_TRUE(is_one_line_with(error_of(infinite), "expected JSON with numbers in the range"));
}

// The library recurses once for each level of nesting.
TEST(GltfRefused, DeepValuesDoNotReachTheLibrary) {
  const Scratch scratch;
  const auto nested = [&](size_t depth) {
    GltfFile file = square();
    std::string text = file.text();
    text.insert(1, "\"extras\":" + std::string(depth, '[') + std::string(depth, ']') + ",");
    return error_of(scratch.write("deep.gltf", text));
  };
  EXPECT_EQ(nested(40), "");
  EXPECT_TRUE(is_one_line_with(nested(100000), "expected values nested at most 64 deep"));
}

TEST(GltfRefused, ChainsOfNodesAreFollowedAndCyclesAreNot) {
  const Scratch scratch;
  GltfFile file = square();
  constexpr int kNodes = 8000;
  for (int i = 1; i < kNodes; ++i) file.json["nodes"].push_back({{"children", {i + 1}}});
  file.json["nodes"].push_back({{"mesh", 0}});
  file.json["nodes"][0] = {{"children", {1}}};
  EXPECT_EQ(error_of(scratch.write("chain.gltf", file.text())), "");
  file.json["nodes"].back()["children"] = {1};
  EXPECT_TRUE(is_one_line_with(error_of(scratch.write("cycle.gltf", file.text())),
                               "nodes[1]: expected a tree"));
}

TEST(GltfRefused, AFewBytesCannotAskForBillionsOfTriangles) {
  const Scratch scratch;
  GltfFile file;
  constexpr size_t kVertices = 30000;
  file.mesh({{"POSITION", file.accessor(kF32, "VEC3", kVertices, std::string(12 * kVertices, 0))}});
  file.json["meshes"][0]["primitives"][0]["mode"] = 5;
  auto& primitives = file.json["meshes"][0]["primitives"];
  const Json one = primitives[0];
  const int count = (1 << 25) / (kVertices - 2) + 1;
  for (int i = 1; i < count; ++i) primitives.push_back(one);
  EXPECT_TRUE(is_one_line_with(error_of(scratch.write("bomb.glb", file.glb())),
                               "expected at most 33554432 triangles"));
}

// A few bytes cannot ask for billions of primitives, of any kind: each costs a step for each node.
TEST(GltfRefused, AFewBytesCannotAskForBillionsOfPrimitives) {
  const Scratch scratch;
  GltfFile file = square();
  constexpr int kEach = 6000;
  Json points = file.json["meshes"][0]["primitives"][0];
  points["mode"] = 0;
  for (int i = 1; i < kEach; ++i) file.json["meshes"][0]["primitives"].push_back(points);
  EXPECT_EQ(error_of(scratch.write("one.glb", file.glb())), "");
  Json& nodes = file.json["nodes"];
  for (int i = 1; i < kEach; ++i) {
    nodes.push_back(nodes[0]);
    file.json["scenes"][0]["nodes"].push_back(i);
  }
  EXPECT_TRUE(is_one_line_with(error_of(scratch.write("many.glb", file.glb())),
                               "expected at most 33554432 primitives"));
}

// The file is sparse; nothing of it is read.
TEST(GltfRefused, AFileOfFourGibibytes) {
  const Scratch scratch;
  const auto path = scratch.write("large.glb", square().glb());
  std::filesystem::resize_file(path, uint64_t{1} << 32);
  EXPECT_TRUE(is_one_line_with(error_of(path), "large.glb: expected less than 4 GiB"));
}

TEST(GlbRefused, HeadersAndChunksMustFillTheFile) {
  const Scratch scratch;
  const std::string good = square().glb();
  const auto with = [&](size_t at, uint32_t value) {
    std::string bytes = good;
    bytes.replace(at, 4, packed<uint32_t>({value}));
    return error_of(scratch.write("a.glb", bytes));
  };
  const auto size = static_cast<uint32_t>(good.size());
  EXPECT_TRUE(is_one_line_with(with(4, 1), "expected GLB version 2, got 1"));
  EXPECT_TRUE(is_one_line_with(with(8, size + 4), "as the header of the GLB says"));
  EXPECT_TRUE(is_one_line_with(with(12, 0xfffffff0), "byte 12: expected a chunk inside"));
  EXPECT_TRUE(is_one_line_with(with(16, 0), "expected a first chunk of JSON"));
  EXPECT_TRUE(is_one_line_with(error_of(scratch.write("a.glb", good + "more")),
                               "as the header of the GLB says"));
}

// Each under a new name, since some file systems write an overwritten file to the disk at once.
// A file cut anywhere is refused; one with a byte changed is refused or read. Neither crashes.
TEST(GltfFuzz, EveryPrefixIsRefusedInOneLine) {
  const Scratch scratch;
  const GltfFile file = square();
  const std::string text = file.text(), glb = file.glb();
  for (size_t n = 0; n < text.size(); ++n) {
    const auto path = scratch.write(std::to_string(n) + ".gltf", text.substr(0, n));
    ASSERT_TRUE(is_one_line_with(error_of(path), path)) << n;
  }
  for (size_t n = 0; n < glb.size(); ++n) {
    const auto path = scratch.write(std::to_string(n) + ".glb", glb.substr(0, n));
    ASSERT_TRUE(is_one_line_with(error_of(path), path)) << n;
  }
}

TEST(GltfFuzz, EveryChangedByteIsRefusedInOneLineOrRead) {
  const Scratch scratch;
  const std::string glb = square().glb();
  size_t refused = 0, tried = 0;
  for (size_t n = 0; n < glb.size(); ++n) {
    for (const char c : {'\0', '9', '-', '"'}) {
      std::string bytes = glb;
      bytes[n] = c;
      const std::string error = error_of(scratch.write(std::to_string(++tried) + ".glb", bytes));
      ASSERT_EQ(error.find('\n'), std::string::npos) << n;
      refused += error.empty() ? 0 : 1;
    }
  }
  EXPECT_GT(refused, tried / 3);
  EXPECT_LT(refused, tried);
}

}  // namespace
}  // namespace pineda::scene
