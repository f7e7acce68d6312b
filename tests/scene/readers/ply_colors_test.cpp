#include "model/scene/readers/ply_colors.h"

#include <gtest/gtest.h>

#include "model/scene/readers/ply_reader.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

using Lines = std::vector<std::string>;

Mesh read_text(const std::string& bytes, Lines* warnings = nullptr) {
  const Scratch scratch;
  Lines unread;
  return read_ply(scratch.write("a.ply", bytes), warnings != nullptr ? warnings : &unread);
}

const std::string kAscii = "ply\nformat ascii 1.0\n";
const std::string kVertex =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFace = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kCorners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

using Triangles = std::vector<std::array<uint32_t, 3>>;

// A triangle whose vertices have the properties of type uchar.
std::string with_properties(const std::vector<std::string>& names) {
  std::string text = kAscii + "element vertex 3\nproperty float x\nproperty float y\n";
  for (const auto& name : names) text += "property uchar " + name + "\n";
  text += "property float z\n" + kFace + "end_header\n";
  for (int i = 0; i < 3; ++i) {
    text += std::to_string(i % 2) + " " + std::to_string(i / 2);
    for (size_t k = 0; k < names.size(); ++k) text += " " + std::to_string(10 * i + k);
    text += " 0\n";
  }
  return text + "3 0 1 2\n";
}

TEST(PlyColors, ColoursHaveAnyOfThreeNames) {
  for (const Lines& names :
       {Lines{"red", "green", "blue", "alpha"}, Lines{"r", "g", "b", "a"},
        Lines{"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}}) {
    Lines warnings;
    const Mesh mesh = read_text(with_properties(names), &warnings);
    EXPECT_EQ(mesh.color, (std::vector<Rgba>{{0, 1, 2, 3}, {10, 11, 12, 13}, {20, 21, 22, 23}}));
    EXPECT_EQ(read_text(with_properties({names[2], names[0], names[1]}), &warnings).color[1],
              (Rgba{11, 12, 10, 255}));
    EXPECT_TRUE(warnings.empty());
  }
}

TEST(PlyColors, WhatLooksLikeAColourAndIsNotUsedIsSaid) {
  const std::vector<std::pair<Lines, const char*>> unused = {
      {{"red"}, "colours not used: 'vertex' has 'red', expected red, green and blue"},
      {{"alpha"}, "colours not used: 'vertex' has 'alpha'"},
      {{"r", "g"}, "colours not used: 'vertex' has 'r', 'g'"},
      {{"ambient_red", "ambient_green", "ambient_blue"}, "'vertex' has 'ambient_red', 'amb"},
      {{"Red", "Green", "Blue"}, "colours not used: 'vertex' has 'Red', 'Green', 'Blue'"},
      {{"f_dc_0", "f_dc_1", "f_dc_2"}, "colours not used: 'vertex' has 'f_dc_0'"},
      {{"red", "green", "blue", "red"}, "colours not used: 'vertex' has 'red'"},
      {{"c1_red", "c2_red", "c3_red", "c4_red", "c5_red"}, "'c4_red' and 1 more, expected"},
  };
  for (const auto& [names, message] : unused) {
    Lines warnings;
    EXPECT_TRUE(read_text(with_properties(names), &warnings).color.empty()) << message;
    ASSERT_EQ(warnings.size(), 1u) << message;
    EXPECT_TRUE(is_one_line_with(warnings[0], message));
  }
  const std::vector<std::pair<Lines, const char*>> beside = {
      {{"red", "green", "blue", "specular_red"}, "beside the colours of 'vertex': 'specular_red'"},
      {{"r", "g", "b", "red"}, "beside the colours of 'vertex': 'red'"},
      {{"red", "green", "blue", "r", "g", "b"}, "beside the colours of 'vertex': 'r', 'g', 'b'"},
  };
  for (const auto& [names, message] : beside) {
    Lines warnings;
    EXPECT_EQ(read_text(with_properties(names), &warnings).color[1], (Rgba{10, 11, 12, 255}));
    ASSERT_EQ(warnings.size(), 1u) << message;
    EXPECT_TRUE(is_one_line_with(warnings[0], message));
  }
  Lines warnings;
  read_text(with_properties({"red", "green", "blue", "a", "b", "quality"}), &warnings);
  EXPECT_TRUE(warnings.empty());
}

const std::string kFaceColors =
    "property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n";

TEST(PlyColors, AFaceWithAColourHasVerticesOfItsOwn) {
  Lines warnings;
  const Mesh mesh =
      read_text(kAscii + kVertex + "element face 2\nproperty list uchar int vertex_indices\n" +
                    kFaceColors + "end_header\n" + kCorners + "4 0 1 2 3 9 8 7\n3 2 1 0 1 2 3\n",
                &warnings);
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(mesh.position,
            (std::vector<Vec3>{
                {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}}));
  EXPECT_EQ(mesh.triangle, (Triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(mesh.corner, (std::vector<uint32_t>{0, 1, 2, 3}));
  ASSERT_EQ(mesh.color.size(), 7u);
  for (size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(mesh.color[i], i < 4 ? (Rgba{9, 8, 7, 255}) : (Rgba{1, 2, 3, 255}));
  }
  ASSERT_EQ(mesh.normal.size(), 7u);
  EXPECT_FALSE(mesh.is_lit);
}

TEST(PlyColors, ColoursOfVerticesComeBeforeThoseOfFaces) {
  const std::string red = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  std::string vertices;
  for (int i = 0; i < 4; ++i) vertices += "0 " + std::to_string(i) + " 0 5 6 7\n";
  Lines warnings;
  const Mesh mesh = read_text(
      kAscii + kVertex + red + kFace + kFaceColors + "end_header\n" + vertices + "3 0 1 2 9 8 7\n",
      &warnings);
  EXPECT_EQ(mesh.color, std::vector<Rgba>(4, Rgba{5, 6, 7, 255}));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(
      is_one_line_with(warnings[0], "colours of faces not used: the vertices have colours"));
  // Of two kinds of faces one has colours.
  warnings.clear();
  const Mesh mixed =
      read_text(kAscii + kVertex + kFace + kFaceColors +
                    "element tristrips 1\nproperty list uchar int vertex_indices\nend_header\n" +
                    kCorners + "3 0 1 2 9 8 7\n3 0 1 2\n",
                &warnings);
  EXPECT_TRUE(mixed.color.empty());
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(is_one_line_with(warnings[0], "colours of faces not used: faces or tristrips have"));
}

}  // namespace
}  // namespace pineda::scene
