#include "model/scene/obj_reader.h"

#include <gtest/gtest.h>

#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";  // lines 1 to 4

struct Refusal {
  const char* name;
  std::string text;
  const char* message;
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.name; }

class ObjRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(ObjRefusal, NamesTheLineAndWhatWasExpected) {
  const Scratch scratch;
  const auto path = scratch.write("bad.obj", GetParam().text);
  EXPECT_TRUE(is_one_line_with(error_of(path), path + GetParam().message));
}

const std::vector<Refusal> kRefusals = {
    {"Empty", "", ":1: expected faces"},
    {"NoFaces", kVertices, ":4: expected faces"},
    {"IndexTooGreat", kVertices + "f 1 2 5\nf 1 2 3\n",
     ":5: expected an index of 4 vertices, got 5"},
    {"IndexZero", kVertices + "f 0 1 2\n", ":5: expected an index from 1 on, or from -4 to -1"},
    {"IndexTooNegative", kVertices + "f -1 -2 -5\n", ":5: expected an index from 1 on, or from -4"},
    {"IndexMissing", kVertices + "f 1 2 /1\n", ":5: expected a corner V, V/VT, V//VN or V/VT/VN"},
    {"IndexNotAnInteger", kVertices + "f 1 2 3.5\n", ":5: expected a corner"},
    {"IndexBeyondAnInt", kVertices + "f 1 2 99999999999\n", ":5: expected a corner"},
    {"CornerWithTail", kVertices + "f 1 2 3/4/5/6\n", ":5: expected a corner"},
    {"CornerOpen", kVertices + "vn 0 0 1\nf 1//1 2//1 3//\n", ":6: expected a corner"},
    {"NormalTooGreat", kVertices + "vn 0 0 1\nf 1//1 2//1 3//2\n",
     ":6: expected an index of 1 normals, got 2"},
    {"NormalMissing", kVertices + "f 1//-1 2//-1 3//-1\n", ":5: expected an index from 1 on"},
    {"TwoCorners", kVertices + "f 1 2\n", ":5: expected a face of three or more corners"},
    {"TwoCoordinates", "v 1 2\n", ":1: expected 4 words 'v X Y Z', got 3"},
    {"BadNumber", "v 1 2 x\n", ":1: expected a number, got 'x'"},
    {"BadW", "v 1 2 3 2\n", ":1: expected W = 1, got '2'"},
    {"BadColour", "v 1 2 3 0 0 1.5\n", ":1: expected a colour from 0 to 1, got '1.5'"},
    {"BadNormal", "vn 1 0\n", ":1: expected 4 words 'vn X Y Z', got 3"},
    {"NormalNan", "vn 1 0 nan\n", ":1: expected a finite normal"},
};

INSTANTIATE_TEST_SUITE_P(Obj, ObjRefusal, testing::ValuesIn(kRefusals),
                         [](const auto& row) { return row.param.name; });

Mesh read_text(const std::string& text, std::vector<std::string>* warnings = nullptr) {
  const Scratch scratch;
  std::vector<std::string> unread;
  return read_obj(scratch.write("a.obj", text), warnings != nullptr ? warnings : &unread);
}

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangle) {
    const Vec3 &a = mesh.position[t[0]], &b = mesh.position[t[1]], &c = mesh.position[t[2]];
    area += cross(b - a, c - a)[2] / 2;
  }
  return area;
}

TEST(ObjReader, PolygonsPositiveAndNegativeIndicesGiveTheSameTriangles) {
  for (const char* face : {"f 1 2 3 4", "f -4 -3 -2 -1", "f 1/9 2/9 3/9 4/9"}) {
    const Mesh mesh = read_text(kVertices + "vt 0 0\n" + face + "\n");
    EXPECT_EQ(mesh.triangle.size(), 2u) << face;
    EXPECT_EQ(mesh.position.size(), 4u) << face;
    EXPECT_DOUBLE_EQ(area_of(mesh), 1) << face;
    for (const Vec3& n : mesh.normal) EXPECT_EQ(n, (Vec3{0, 0, 1})) << face;
    EXPECT_TRUE(mesh.color.empty()) << face;
  }
}

TEST(ObjReader, ConcavePolygonKeepsItsArea) {
  // An arrow head: a fan from the first corner would cover what lies outside.
  const Mesh mesh = read_text("v 0 0 0\nv 2 -2 0\nv 0 3 0\nv -2 -2 0\nf 2 3 4 1\nf 3 4 1 2\n");
  EXPECT_EQ(mesh.triangle.size(), 4u);
  EXPECT_NEAR(area_of(mesh), 2 * 6, 1e-6);
}

TEST(ObjReader, NormalsOfTheFileWinOverComputedOnes) {
  const Mesh mesh = read_text(kVertices + "vn 3 0 0\nf 1//1 2//1 3//1\nf 1 3 4\n");
  ASSERT_EQ(mesh.triangle.size(), 2u);
  for (const uint32_t i : mesh.triangle[0]) EXPECT_EQ(mesh.normal[i], (Vec3{1, 0, 0}));
  for (const uint32_t i : mesh.triangle[1]) EXPECT_EQ(mesh.normal[i], (Vec3{0, 0, 1}));
}

TEST(ObjReader, ComputedNormalsAreWeightedByArea) {
  // At vertex 1 a face of area 8 (normal z) meets one of area 1/2 (normal x).
  const Mesh mesh = read_text("v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 1\nv 0 1 0\nf 1 2 3\nf 1 5 4\n");
  const Vec3 expected = normalized({1, 0, 16});
  for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(mesh.normal[0][i], expected[i], 1e-12);
}

TEST(ObjReader, ColoursAreUsedWhenEveryVertexHasOne) {
  const std::string face = "f 1 2 3\n";
  std::vector<std::string> warnings;
  const Mesh all = read_text("v 0 0 0 1 0 .5\nv 1 0 0 0 0 0\nv 0 1 0 .2 .4 1\n" + face, &warnings);
  ASSERT_EQ(all.color.size(), 3u);
  EXPECT_EQ(all.color[0], (Rgba{255, 0, 128, 255}));
  EXPECT_EQ(all.color[2], (Rgba{51, 102, 255, 255}));
  EXPECT_TRUE(warnings.empty());
  EXPECT_TRUE(read_text("v 0 0 0 1 0 .5\nv 1 0 0\nv 0 1 0\n" + face, &warnings).color.empty());
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(is_one_line_with(warnings[0], "only 1 of 3 vertices"));
}

TEST(ObjReader, NanAndInfiniteVerticesDropTheirTrianglesOnly) {
  const Scratch scratch;
  const auto opened =
      open_scene(kContract,
                 scratch.write("a.obj", kVertices + "v nan 0 0\nv 0 -inf 0\nf 1 2 3\nf 1 2 5\n"
                                                    "f 2 3 6\nf 1 3 4\n"),
                 {});
  const auto drawn = all_triangles(opened.source.get());
  ASSERT_EQ(drawn.size(), 2u);
  EXPECT_EQ(drawn[1].id, 3u);
  EXPECT_EQ(opened.source->counters().triangles, 4u);
  EXPECT_EQ(opened.source->counters().nan_dropped, 2u);
}

TEST(ObjReader, OtherLinesAndLineEndsAreLeftOut) {
  const Mesh mesh = read_text(
      "# comment\r\nmtllib none.mtl\r\no thing\r\ng part\r\nusemtl red\r\ns 1\r\nv 0 0 0 1.0\r\n"
      "v 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\nl 1 2\r\n");
  EXPECT_EQ(mesh.triangle.size(), 1u);
}

}  // namespace
}  // namespace pineda::scene
