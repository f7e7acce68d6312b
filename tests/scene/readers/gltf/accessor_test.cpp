// Sparse accessors, accessors without bytes, and positions and normals as integers.
#include <gtest/gtest.h>

#include "model/scene/readers/gltf/reader.h"
#include "tests/scene/readers/gltf/files.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

Mesh read(const GltfFile& file) {
  const Scratch scratch;
  std::vector<std::string> warnings;
  const Mesh mesh = read_gltf(scratch.write("a.gltf", file.text()), &warnings);
  EXPECT_TRUE(warnings.empty()) << warnings.front();
  return mesh;
}

std::string error_with(const GltfFile& file) {
  const Scratch scratch;
  return error_of(scratch.write("a.glb", file.glb()));
}

TEST(GltfSparse, ValuesStandInPlaceOfThoseBelow) {
  const auto with = [](int type, auto row) {
    GltfFile file = one_triangle();
    file.sparse<decltype(row)>(0, type, {row}, packed<float>({0, 7, 8}));
    return read(file).position;
  };
  const std::vector<Vec3> expected = {{0, 0, 0}, {1, 0, 0}, {0, 7, 8}};
  EXPECT_EQ(with(kU8, uint8_t{2}), expected);
  EXPECT_EQ(with(kU16, uint16_t{2}), expected);
  EXPECT_EQ(with(kU32, uint32_t{2}), expected);
}

TEST(GltfSparse, OverNothingTheRestIsZero) {
  GltfFile file;
  file.json["accessors"] = {{{"componentType", kF32}, {"type", "VEC3"}, {"count", 6}}};
  file.sparse<uint8_t>(0, kU8, {1, 2, 5}, packed<float>({1, 0, 0, 0, 1, 0, 9, 9, 9}));
  file.mesh({{"POSITION", 0}});
  EXPECT_EQ(read(file).position,
            (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 0}, {9, 9, 9}}));
}

TEST(GltfSparse, EveryRowOfManyIsFoundAndNoOther) {
  GltfFile file = numbered(300);
  std::vector<uint16_t> rows;
  std::vector<float> values;
  for (uint16_t i = 1; i < 300; i = static_cast<uint16_t>(i + 7)) {
    rows.push_back(i);
    values.insert(values.end(), {-1.F, static_cast<float>(i), 0.F});
  }
  file.sparse(0, kU16, rows, packed(values));
  const Mesh mesh = read(file);
  for (size_t i = 0; i < 300; ++i) {
    EXPECT_EQ(mesh.position[i][0], i % 7 == 1 ? -1. : static_cast<double>(i));
  }
}

TEST(GltfSparse, IndicesAndColoursMayBeSparseToo) {
  GltfFile file = numbered(4);
  const int indices = file.accessor(kU8, "SCALAR", 3, packed<uint8_t>({0, 1, 1}));
  primitive(&file)["indices"] = indices;
  file.sparse<uint8_t>(indices, kU8, {2}, packed<uint8_t>({3}));
  const int colors = file.accessor(kF32, "VEC3", 4, packed(std::vector<float>(12, 1)));
  file.sparse<uint8_t>(colors, kU8, {3}, packed<float>({0, 0, 1}));
  primitive(&file)["attributes"]["COLOR_0"] = colors;
  const Mesh mesh = read(file);
  EXPECT_EQ(mesh.position[mesh.triangle[0][2]][0], 3);
  EXPECT_EQ(mesh.color[mesh.triangle[0][1]], (Rgba{255, 255, 255, 255}));
  EXPECT_EQ(mesh.color[mesh.triangle[0][2]], (Rgba{0, 0, 255, 255}));
}

TEST(GltfSparse, WhatIsWrongIsNamed) {
  const auto with = [](const std::vector<uint8_t>& rows, const char* place, const Json& value) {
    GltfFile file = one_triangle();
    file.sparse(0, kU8, rows, packed(std::vector<float>(3 * rows.size(), 0)));
    if (*place != '\0') {
      file.json[Json::json_pointer("/accessors/0/sparse" + std::string(place))] = value;
    }
    return error_with(file);
  };
  const auto is = [](const std::string& message, const std::string& part) {
    return is_one_line_with(message, "accessors[0].sparse." + part);
  };
  EXPECT_EQ(with({0, 2}, "", {}), "");
  EXPECT_TRUE(is(with({2, 0}, "", {}), "indices: expected indices that rise, got 0 after 2"));
  EXPECT_TRUE(is(with({1, 1}, "", {}), "indices: expected indices that rise, got 1 after 1"));
  EXPECT_TRUE(is(with({0, 3}, "", {}), "indices: expected indices of 3 values, got 3"));
  EXPECT_TRUE(is(with({0}, "/count", 0), "count: expected 1 to 3, got 0"));
  EXPECT_TRUE(is(with({0}, "/count", 4), "count: expected 1 to 3, got 4"));
  EXPECT_TRUE(is(with({0}, "/count", 2), "indices: expected 2 values inside of the 1 bytes"));
  EXPECT_TRUE(is(with({0}, "/count", "1"), "count: expected an integer"));
  EXPECT_TRUE(is(with({0, 1}, "/values/byteOffset", 4), "values: expected 2 values inside of"));
  EXPECT_TRUE(is(with({0}, "/indices/componentType", kF32), "indices: expected u8, u16 or u32"));
  EXPECT_TRUE(is(with({0}, "/indices", nullptr), "indices: expected an object"));
  EXPECT_TRUE(is(with({0}, "/values", {}), "values: expected an object"));
  EXPECT_TRUE(is_one_line_with(with({0}, "/values/bufferView", 9), "bufferViews[9]: expected one"));
}

TEST(GltfZeros, AHugeAccessorWithoutBytesCostsNothingUntilItIsUsed) {
  GltfFile file;
  file.json["accessors"] = {{{"componentType", kF32}, {"type", "VEC3"}, {"count", 2147483647}}};
  file.sparse<uint32_t>(0, kU32, {1, 2147483646}, packed<float>({1, 0, 0, 0, 1, 0}));
  file.mesh({{"POSITION", 0}})["indices"] =
      file.accessor(kU32, "SCALAR", 3, packed<uint32_t>({1000000000, 1, 2147483646}));
  EXPECT_EQ(read(file).position, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(GltfZeros, AFewBytesCannotAskForMillionsOfTriangles) {
  const auto with = [](size_t count, size_t primitives) {
    GltfFile file;
    file.json["accessors"] = {{{"componentType", kF32}, {"type", "VEC3"}, {"count", count}}};
    file.sparse<uint8_t>(0, kU8, {1}, packed<float>({1, 0, 0}));
    for (size_t i = 0; i < primitives; ++i) file.mesh({{"POSITION", 0}});
    return error_with(file);
  };
  EXPECT_EQ(with(3000, 1), "");
  EXPECT_TRUE(is_one_line_with(with(2147483646, 1), "expected at most 33554432 triangles"));
  EXPECT_TRUE(is_one_line_with(with(3000000, 1), "expected at most 262144 triangles of accessors"));
  EXPECT_TRUE(is_one_line_with(with(3000, 300), "expected at most 262144 triangles of accessors"));
}

GltfFile quantized(int type, const std::string& values, bool normalized) {
  GltfFile file;
  file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  file.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  file.mesh({{"POSITION", file.accessor(type, "VEC3", 3, values, normalized)}});
  return file;
}

TEST(GltfQuantization, PositionsOfEachTypeAreWholeNumbersOrFractions) {
  const auto i8 = packed<int8_t>({-128, -127, 0, 127, 64, 1, 0, 0, 0});
  const auto u8 = packed<uint8_t>({255, 51, 0, 1, 128, 0, 0, 0, 0});
  const auto i16 = packed<int16_t>({-32768, -32767, 0, 32767, 1, 2, 0, 0, 0});
  const auto u16 = packed<uint16_t>({65535, 13107, 0, 1, 2, 3, 0, 0, 0});
  const auto first = [](int type, const std::string& values, bool normalized) {
    const Mesh mesh = read(quantized(type, values, normalized));
    return std::vector<Vec3>(mesh.position.begin(), mesh.position.begin() + 2);
  };
  using Two = std::vector<Vec3>;
  EXPECT_EQ(first(kI8, i8, false), (Two{{-128, -127, 0}, {127, 64, 1}}));
  EXPECT_EQ(first(kI8, i8, true), (Two{{-1, -1, 0}, {1, 64 / 127., 1 / 127.}}));
  EXPECT_EQ(first(kU8, u8, false), (Two{{255, 51, 0}, {1, 128, 0}}));
  EXPECT_EQ(first(kU8, u8, true), (Two{{1, .2, 0}, {1 / 255., 128 / 255., 0}}));
  EXPECT_EQ(first(kI16, i16, false), (Two{{-32768, -32767, 0}, {32767, 1, 2}}));
  EXPECT_EQ(first(kI16, i16, true), (Two{{-1, -1, 0}, {1, 1 / 32767., 2 / 32767.}}));
  EXPECT_EQ(first(kU16, u16, false), (Two{{65535, 13107, 0}, {1, 2, 3}}));
  EXPECT_EQ(first(kU16, u16, true), (Two{{1, .2, 0}, {1 / 65535., 2 / 65535., 3 / 65535.}}));
}

TEST(GltfQuantization, PaddedNormalsOfBytesAndShortsAreDirections) {
  GltfFile file = one_triangle();
  file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const int normals = file.accessor(
      kI8, "VEC3", 3, packed<int8_t>({0, 0, 127, 9, 0, -128, 0, 9, 127, 0, 0, 9}), true);
  file.json["bufferViews"].back()["byteStride"] = 4;
  primitive(&file)["attributes"]["NORMAL"] = normals;
  EXPECT_EQ(read(file).normal, (std::vector<Vec3>{{0, 0, 1}, {0, -1, 0}, {1, 0, 0}}));
  primitive(&file)["attributes"]["NORMAL"] = file.accessor(
      kI16, "VEC3", 3, packed<int16_t>({0, 0, 32767, 0, -32768, 0, 32767, 0, 0}), true);
  EXPECT_EQ(read(file).normal, (std::vector<Vec3>{{0, 0, 1}, {0, -1, 0}, {1, 0, 0}}));
}

TEST(GltfQuantization, OtherTypesAndFilesThatDoNotNameItAreRefused) {
  const auto nine = packed(std::vector<int16_t>(9, 1));
  GltfFile unnamed = quantized(kI16, nine, false);
  unnamed.json.erase("extensionsUsed");
  unnamed.json.erase("extensionsRequired");
  EXPECT_TRUE(
      is_one_line_with(error_with(unnamed), "accessors[0]: expected POSITION as float VEC3"));
  EXPECT_TRUE(
      is_one_line_with(error_with(quantized(kU32, packed(std::vector<uint32_t>(9, 1)), false)),
                       "accessors[0]: expected POSITION as VEC3 of float, or i8, u8, i16 or u16"));
  GltfFile file = quantized(kI16, nine, false);
  const int wrong[] = {file.accessor(kI16, "VEC3", 3, nine, false),
                       file.accessor(kU16, "VEC3", 3, nine, true)};
  for (const int normal : wrong) {
    primitive(&file)["attributes"]["NORMAL"] = normal;
    EXPECT_TRUE(is_one_line_with(error_with(file), "NORMAL as VEC3 of float, or normalized i8"));
  }
  primitive(&file)["attributes"].erase("NORMAL");
  primitive(&file)["attributes"]["COLOR_0"] = file.accessor(kI16, "VEC3", 3, nine, true);
  EXPECT_TRUE(is_one_line_with(error_with(file), "expected COLOR_0 as VEC3 or VEC4, float or"));
  primitive(&file)["attributes"].erase("COLOR_0");
  primitive(&file)["indices"] = file.accessor(kI16, "SCALAR", 9, nine);
  EXPECT_TRUE(is_one_line_with(error_with(file), "expected indices as u8, u16 or u32 scalars"));
}

// One figure of five vertices in every way to store it, and as text.
TEST(GltfFile, TheSameFigureStoredInEveryWayIsTheSameMesh) {
  const std::vector<float> positions = {-1, -1, 0, 1,     -1, .25F,  1,  1,
                                        0,  -1, 1, -.25F, 0,  1.75F, .5F};
  const auto indices = packed<uint16_t>({0, 1, 2, 0, 2, 3, 3, 2, 4});
  const auto add_mesh = [&](int position, GltfFile* file) {
    const int corners = file->accessor(kU16, "SCALAR", 9, indices);
    file->mesh({{"POSITION", position}})["indices"] = corners;
  };
  GltfFile plain;
  add_mesh(plain.vectors(positions), &plain);
  GltfFile sparse;
  sparse.json["accessors"] = {{{"componentType", kF32}, {"type", "VEC3"}, {"count", 5}}};
  sparse.sparse<uint8_t>(0, kU8, {0, 1, 2, 3, 4}, packed(positions));
  add_mesh(0, &sparse);
  GltfFile quarters;  // in steps of .25, as bytes
  std::vector<int8_t> bytes;
  for (const float x : positions) bytes.push_back(static_cast<int8_t>(4 * x));
  add_mesh(quarters.accessor(kI8, "VEC3", 5, packed(bytes)), &quarters);
  quarters.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  quarters.json["nodes"][0]["scale"] = {.25, .25, .25};
  const Scratch scratch;
  const auto triangles = [&](const char* name, const std::string& content) {
    const auto scene = open_scene(kContract, scratch.write(name, content), {});
    EXPECT_TRUE(scene.warnings.empty()) << name;
    return all_triangles(scene.source.get());
  };
  const auto expected = triangles(
      "a.obj",
      "v -1 -1 0\nv 1 -1 .25\nv 1 1 0\nv -1 1 -.25\nv 0 1.75 .5\nf 1 2 3\nf 1 3 4\nf 4 3 5\n");
  ASSERT_EQ(expected.size(), 3u);
  EXPECT_TRUE(same(expected, triangles("plain.gltf", plain.text())));
  EXPECT_TRUE(same(expected, triangles("plain.glb", plain.glb())));
  EXPECT_TRUE(same(expected, triangles("sparse.gltf", sparse.text())));
  EXPECT_TRUE(same(expected, triangles("quarters.gltf", quarters.text())));
  // The mutant: one sparse value left out.
  sparse.json["accessors"][0]["sparse"]["count"] = 4;
  EXPECT_FALSE(same(expected, triangles("mutant.gltf", sparse.text())));
}

}  // namespace
}  // namespace pineda::scene
