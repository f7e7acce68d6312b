#include "model/scene/readers/obj_reader.h"

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
    {"CornerOfFour", kVertices + "f 1 2 3/4//\n", ":5: expected a corner"},
    {"TextureBeyondAnInt", kVertices + "f 1 2 3/99999999999\n", ":5: expected a corner"},
    {"TextureNoIndex", kVertices + "f 1 2 3/a\n", ":5: expected a corner"},
    {"NormalNoIndex", kVertices + "f 1 2 3//a\n", ":5: expected a corner"},
    {"TwoCorners", kVertices + "f 1 2\n", ":5: expected a face of three or more corners"},
    {"TwoCoordinates", "v 1 2\n",
     ":1: expected 'v X Y Z [W]' or 'v X Y Z R G B [A]', got 2 numbers in"},
    {"BadNumber", "v 1 2 x\n", ":1: expected a number, got 'x'"},
    {"BadW", "v 1 2 3 2\n", ":1: expected W = 1, got '2'"},
    {"BadColour", "v 1 2 3 0 0 1.5\n", ":1: expected a colour from 0 to 1, got '1.5'"},
    {"BadNormal", "vn 1 0\n", ":1: expected 4 words 'vn X Y Z', got 3"},
    {"NormalNoNumber", "vn 1 0 up\n", ":1: expected a number, got 'up'"},
    {"FiveNumbers", "v 1 2 3 4 5\n",
     ":1: expected 'v X Y Z [W]' or 'v X Y Z R G B [A]', got 5 numbers in"},
    {"EightNumbers", "v 1 2 3 1 0 0 0 1\n",
     ":1: expected 'v X Y Z [W]' or 'v X Y Z R G B [A]', got 8 numbers in"},
    {"BadAlpha", "v 1 2 3 0 0 0 -1\n", ":1: expected a colour from 0 to 1, got '-1'"},
    {"ContinuedLineIsItsFirst", kVertices + "f 1 \\\n2 \\\nx\n", ":5: expected a corner"},
    {"LinesAreCountedBehindAContinuedOne", kVertices + "f 1 \\\n2 3\nf 1 2 x\n",
     ":7: expected a corner"},
    {"OldMacLineEnds", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
     ":1: expected 'v X Y Z [W]' or 'v X Y Z R G B [A]', got 15 numbers in"},
    {"NulByte", std::string("v 1 2\0 3\n", 9), ":1: expected text"},
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

TEST(ObjReader, OtherLinesAndLineEndsAreLeftOutAndMaterialsAreSaid) {
  std::vector<std::string> warnings;
  const Mesh mesh = read_text(
      "# comment\r\nmtllib none.mtl\r\no thing\r\ng part\r\nusemtl red\r\ns 1\r\nv 0 0 0 1.0\r\n"
      "v 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\nvt 0 0\r\n",
      &warnings);
  EXPECT_EQ(mesh.triangle.size(), 1u);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("materials not used (1 lines 'usemtl ...')"), std::string::npos);
}

// Everything but the polygons, which may be cut or not.
bool are_same(const Mesh& a, const Mesh& b) {
  return a.position == b.position && a.normal == b.normal && a.color == b.color &&
         a.triangle == b.triangle;
}

TEST(ObjReader, WhatSaysTheSameGivesTheSameMesh) {
  const std::string plain = kVertices + "f 1 2 3\nf 1 3 4\n";
  const Mesh expected = read_text(plain);
  const std::vector<std::pair<const char*, std::string>> same = {
      {"continued", kVertices + "f 1 2 \\\n3\nf 1 \\\n 3 \\\n\\\n4\n"},
      {"continued between words", kVertices + "f 1 2\\\n3\nf 1 3 4\n"},
      {"continued with CR LF", kVertices + "f 1 2 \\\r\n3\r\nf 1 3 4\n"},
      {"continued at the end of the file", plain + "\\"},
      {"continued by nothing", kVertices + "f 1 2 3\nf 1 3 4 \\"},
      {"comments behind values",
       "v 0 0 0 # a\nv 1 0 0# b\nv 1 1 0\t#\nv 0 1 0 #d\nf 1 2 3 # face\nf 1 3 4#\n"},
      {"a comment is not continued", kVertices + "# C:\\\nf 1 2 3 # \\\nf 1 3 4\n"},
      {"a comment ends a continued line", kVertices + "f 1 2 \\\n3 # \\\nf 1 3 4\n"},
      {"a byte order mark", "\xef\xbb\xbf" + plain},
      {"a byte order mark before a comment", "\xef\xbb\xbf# a\n" + plain},
      {"a stray CR in a comment", "# x\rv 9 9 9\n" + plain},
      {"stray CRs between words", kVertices + "f 1 2\r3\n\rf 1\r\r 3 4\r\r\n"},
      {"corners without what follows a slash", kVertices + "f 1/ 2// 3/7/\nf 1/7 3/ 4//\n"},
      {"texture coordinates that there are not", kVertices + "f 1/0 2/-9 3/9\nf 1 3 4\n"},
      {"no last line end", kVertices + "f 1 2 3\nf 1 3 4"},
      {"long lines", "#" + std::string(300000, '-') + "\n" + plain + std::string(300000, ' ')},
  };
  for (const auto& [what, text] : same) {
    std::vector<std::string> warnings;
    EXPECT_TRUE(are_same(read_text(text, &warnings), expected)) << what;
    EXPECT_TRUE(warnings.empty()) << what;
  }
}

TEST(ObjReader, AStrayCarriageReturnIsNeverTheEndOfALine) {
  // If the reader had two rules for line ends, the relative indices would count from another
  // vertex.
  const Mesh mesh = read_text("# x\rv 0 0 0\nv -1 -1 0\nv 1 -1 .25\nv 1 1 0\nf -3 -2 -1\n");
  EXPECT_EQ(mesh.position, (std::vector<Vec3>{{-1, -1, 0}, {1, -1, .25}, {1, 1, 0}}));
  EXPECT_EQ(mesh.triangle.size(), 1u);
}

TEST(ObjReader, NormalsThatThereAreNotAreTheMeanAndCounted) {
  const Mesh expected = read_text(kVertices + "f 1 2 3\nf 1 3 4\n");
  const std::vector<std::pair<std::string, const char*>> cases = {
      {"f 1//1 2//2 3//3\nf 1//1 3//3 4//4\n", "6 corners name a normal that there is not"},
      {"f 1//-1 2//0 3\nf 1 3 4\n", "2 corners name a normal that there is not"},
      {"vn nan 0 1\nf 1//1 2//1 3//1\nf 1 3 4\n", "3 corners name a normal that is zero or not"},
      {"vn 0 -0 0\nf 1//1 2//1 3//1\nf 1 3 4\n", "3 corners name a normal that is zero or not"},
      {"vn 0 0 1\nf 1//2147483647 2 3\nf 1 3 4\n", "1 corners name a normal that there is not"},
  };
  for (const auto& [text, message] : cases) {
    std::vector<std::string> warnings;
    EXPECT_TRUE(are_same(read_text(kVertices + text, &warnings), expected)) << text;
    ASSERT_EQ(warnings.size(), 1u) << text;
    EXPECT_TRUE(is_one_line_with(warnings[0], message));
  }
  // No face uses the faulty normals.
  std::vector<std::string> warnings;
  EXPECT_TRUE(
      are_same(read_text("vn nan 0 inf\nvn 0 0 1\nvn 0 0 0\n" + kVertices + "f 1 2 3\nf 1//2 3 4\n",
                         &warnings),
               read_text("vn 0 0 1\n" + kVertices + "f 1 2 3\nf 1//1 3 4\n")));
  EXPECT_TRUE(warnings.empty());
  // A normal may follow its face.
  EXPECT_EQ(read_text(kVertices + "f 1//1 2//1 3//1\nvn 2 0 0\n").normal[0], (Vec3{1, 0, 0}));
}

TEST(ObjReader, ColoursMayHaveAlpha) {
  const Mesh mesh = read_text("v 0 0 0 1 0 .5 .2\nv 1 0 0 0 0 0 1\nv 0 1 0 .2 .4 1\nf 1 2 3\n");
  EXPECT_EQ(mesh.color,
            (std::vector<Rgba>{{255, 0, 128, 51}, {0, 0, 0, 255}, {51, 102, 255, 255}}));
}

TEST(ObjReader, WhatIsNoTriangleIsCountedAndSaid) {
  std::vector<std::string> warnings;
  read_text(kVertices + "p 1 2\np 3\nl 1 2 3\ncstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nend\n" +
                "surf 0 1 0 1 1 2 3 4\nf 1 2 3\ncall other.obj\ncall more.obj\n",
            &warnings);
  ASSERT_EQ(warnings.size(), 4u);
  EXPECT_TRUE(is_one_line_with(warnings[0], "left out 3 points"));
  EXPECT_TRUE(is_one_line_with(warnings[1], "left out 1 polylines"));
  EXPECT_TRUE(is_one_line_with(warnings[2], "left out 2 curves and surfaces"));
  EXPECT_TRUE(is_one_line_with(warnings[3],
                               "left out 2 lines of unknown meaning, first 'call' in line 14"));
}

TEST(ObjReader, PolygonsAreKeptAndTheirFirstVertexProvokes) {
  const std::string u = "v 0 9 0\nv 0 0 0\nv 9 0 0\nv 9 9 0\nv 6 9 0\nv 6 3 0\nv 3 3 0\nv 3 9 0\n";
  std::vector<std::string> warnings;
  const Mesh mesh = read_text(u + "f 2 3 4\nf 2 3 4 1\nf 1 2 3 4 5 6 7 8\nf 2 3 4\n", &warnings);
  EXPECT_TRUE(warnings.empty());
  ASSERT_EQ(mesh.triangle.size(), 1u + 2 + 6 + 1);
  ASSERT_EQ(mesh.polygon.size(), 2u);
  EXPECT_EQ(mesh.polygon[0].corners, 4u);
  EXPECT_EQ(mesh.polygon[0].first_triangle, 1u);
  EXPECT_EQ(mesh.polygon[0].triangles, 2u);
  EXPECT_EQ(mesh.polygon[1].first_corner, 4u);
  EXPECT_EQ(mesh.polygon[1].corners, 8u);
  EXPECT_EQ(mesh.polygon[1].first_triangle, 3u);
  EXPECT_EQ(mesh.polygon[1].triangles, 6u);
  // The mesh's vertices are numbered as they occur: 2 3 4 1 5 6 7 8.
  EXPECT_EQ(mesh.corner, (std::vector<uint32_t>{0, 1, 2, 3, 3, 0, 1, 2, 4, 5, 6, 7}));
  EXPECT_EQ(mesh.provoking, (std::vector<uint32_t>{0, 0, 0, 3, 3, 3, 3, 3, 3, 0}));
  EXPECT_DOUBLE_EQ(area_of(mesh), 40.5 + 81 + 63 + 40.5);
  // Where it is each triangle's first corner, nothing is stated.
  EXPECT_TRUE(read_text(u + "f 1 2 3 4\n").provoking.empty());
}

TEST(ObjReader, PolygonsThatCrossThemselvesAreFansAndCounted) {
  std::vector<std::string> warnings;
  const Mesh mesh =
      read_text("v 0 0 0\nv 9 9 0\nv 9 0 0\nv 0 5 0\nf 1 2 3 4\nf 1 2 3 4\nf 1 1 2 2\n", &warnings);
  EXPECT_EQ(mesh.triangle.size(), 6u);
  EXPECT_TRUE(mesh.polygon.empty());
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_TRUE(is_one_line_with(warnings[0], "2 polygons cross themselves: cut as fans"));
  EXPECT_TRUE(is_one_line_with(warnings[1], "1 polygons have a mean normal of zero: cut as fans"));
}

TEST(ObjReader, ManyNormalsOfOneVertexAreManyVertices) {
  std::string text = kVertices;
  for (int i = 1; i <= 50; ++i) text += "vn " + std::to_string(i) + " 0 1\n";
  for (int i = 1; i <= 50; ++i) {
    text += "f 1//" + std::to_string(i) + " 2 3\nf 1//" + std::to_string(i) + " 3 4\n";
  }
  const Mesh mesh = read_text(text);
  EXPECT_EQ(mesh.position.size(), 53u);
  for (size_t i = 0; i < 50; ++i) {
    const Vec3 expected = normalized({static_cast<double>(i + 1), 0, 1});
    EXPECT_EQ(mesh.normal[mesh.triangle[2 * i][0]], expected);
    EXPECT_EQ(mesh.triangle[2 * i][0], mesh.triangle[2 * i + 1][0]);
  }
}

}  // namespace
}  // namespace pineda::scene
