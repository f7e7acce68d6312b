#include "model/scene/readers/ply_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

using Lines = std::vector<std::string>;

Mesh read_text(const std::string& bytes, Lines* warnings = nullptr) {
  const Scratch scratch;
  Lines unread;
  return read_ply(scratch.write("a.ply", bytes), warnings != nullptr ? warnings : &unread);
}

const std::string kAscii = "ply\nformat ascii 1.0\n";  // lines 1 and 2
const std::string kVertex =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFace = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kHead = kAscii + kVertex + kFace + "end_header\n";  // lines 1 to 9
const std::string kCorners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";          // lines 10 to 13

using Triangles = std::vector<std::array<uint32_t, 3>>;

// The bytes of a value, in the order of the encoding.
template <class T>
std::string raw(T value, bool big) {
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  if (big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

// A square with a property of every type, in each of the three encodings.
std::string square(const std::string& encoding) {
  const bool ascii = encoding == "ascii", big = encoding == "binary_big_endian";
  std::string file = "ply\nformat " + encoding +
                     " 1.0\ncomment a square\nelement vertex 4\nproperty double x\n"
                     "property float y\nproperty char a\nproperty int16 z\nproperty ushort b\n"
                     "property uint32 c\nproperty list int8 int16 d\n"
                     "property uchar red\nproperty uint8 green\nproperty uchar blue\n"
                     "obj_info none\nelement face 1\nproperty float quality\n"
                     "property list uint32 int32 vertex_index\nend_header\n";
  const auto put = [&](auto value) {
    file += ascii ? std::to_string(value) + " " : raw(value, big);
  };
  for (int i = 0; i < 4; ++i) {
    put(i % 3 == 0 ? 0. : 1.5);
    put(i / 2 == 0 ? 0.F : 2.5F);
    put(int8_t{-100});
    put(static_cast<int16_t>(-300));
    put(uint16_t{60000});
    put(uint32_t{4000000000});
    put(static_cast<int8_t>(i));  // a list as long as the vertex' number
    for (int k = 0; k < i; ++k) put(int16_t{7});
    put(uint8_t{255});
    put(static_cast<uint8_t>(i));
    put(uint8_t{128});
    if (ascii) file.back() = '\n';
  }
  put(.25F);
  put(uint32_t{4});
  for (int i = 0; i < 4; ++i) put(i);
  if (ascii) file.back() = '\n';
  return file;
}

const char* const kEncodings[] = {"ascii", "binary_little_endian", "binary_big_endian"};

TEST(PlyReader, EachEncodingAndTypeGivesTheSameMesh) {
  for (const char* encoding : kEncodings) {
    SCOPED_TRACE(encoding);
    Lines warnings;
    const Mesh mesh = read_text(square(encoding), &warnings);
    EXPECT_TRUE(warnings.empty());
    EXPECT_EQ(mesh.position,
              (std::vector<Vec3>{{0, 0, -300}, {1.5, 0, -300}, {1.5, 2.5, -300}, {0, 2.5, -300}}));
    EXPECT_EQ(mesh.triangle, (Triangles{{0, 1, 2}, {0, 2, 3}}));
    for (const Vec3& n : mesh.normal) EXPECT_EQ(n, (Vec3{0, 0, 1}));
    ASSERT_EQ(mesh.color.size(), 4u);
    for (uint8_t i = 0; i < 4; ++i) EXPECT_EQ(mesh.color[i], (Rgba{255, i, 128, 255}));
  }
}

TEST(PlyReader, StripsTurnEverySecondTriangleAndBeginAnewAtMinusOne) {
  const std::string head =
      kAscii +
      "element vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n";
  const Triangles expected = {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {1, 3, 2}};
  EXPECT_EQ(read_text(head + vertices + "9 0 1 2 3 4 -1 1 3 2\n").triangle, expected);
  EXPECT_EQ(read_text(head + vertices + "10 0 1 2 3 4 -1 1 3 2 -1\n").triangle, expected);
}

TEST(PlyReader, NormalsAndColoursOfTheFileAreUsedAsTheyAre) {
  const std::string head =
      kAscii + "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string faces = kFace + "end_header\n";
  const Mesh mesh = read_text(
      head + "property float nx\nproperty float ny\nproperty float nz\nproperty float red\n" +
      "property double green\nproperty ushort blue\nproperty uchar alpha\n" + faces +
      "0 0 0 0 3 4 1 0 65535 7\n1 0 0 0 0 1 .2 .4 257 0\n0 1 0 0 0 1 0 1 32896 255\n3 0 1 2\n");
  EXPECT_EQ(mesh.normal[0], normalized({0, 3, 4}));
  EXPECT_EQ(mesh.color, (std::vector<Rgba>{{255, 0, 255, 7}, {51, 102, 1, 0}, {0, 255, 128, 255}}));
  Lines warnings;
  EXPECT_TRUE(
      read_text(head + "property int red\n" + faces + "0 0 0 1\n1 0 0 2\n0 1 0 3\n3 0 1 2\n",
                &warnings)
          .color.empty());
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(is_one_line_with(warnings[0], "colours not used"));
}

TEST(PlyReader, OtherElementsAndWhatFollowsAreSaid) {
  const std::string edges = "element edge 2\nproperty int vertex1\nproperty int vertex2\n";
  Lines warnings;
  const Mesh mesh = read_text(
      kAscii + edges + kVertex + kFace + "end_header\n0 1\n1 2\n" + kCorners + "3 0 1 2\n3 0 1 2\n",
      &warnings);
  EXPECT_EQ(mesh.triangle.size(), 1u);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_TRUE(is_one_line_with(warnings[0], "left out 2 elements 'edge'"));
  EXPECT_TRUE(is_one_line_with(warnings[1], "left out what follows the last element"));
}

TEST(PlyReader, NanAndInfiniteVerticesDropTheirTrianglesOnly) {
  const Scratch scratch;
  const auto scene = open_scene(
      kContract,
      scratch.write("a.ply", kAscii + "element vertex 5\nproperty float x\nproperty float y\n" +
                                 "property float z\nelement face 3\n" +
                                 "property list uchar int vertex_indices\nend_header\n" +
                                 "0 0 0\n1 0 0\n0 1 0\nnan 0 0\n0 inf 0\n" +
                                 "3 0 1 3\n3 0 1 2\n3 0 4 1\n"),
      {});
  ASSERT_EQ(all_triangles(scene.source.get()).size(), 1u);
  EXPECT_EQ(scene.source->counters().nan_dropped, 2u);
}

TEST(PlyReader, CommentsAndUnknownLinesOfTheHeaderMayStandAnywhere) {
  const Mesh expected = read_text(kHead + kCorners + "4 0 1 2 3\n");
  Lines warnings;
  const Mesh commented =
      read_text("ply\ncomment made by hand\nobj_info a b\nformat ascii 1.0\n" + kVertex +
                    "comment\n" + kFace + "end_header\n" + kCorners + "4 0 1 2 3\n",
                &warnings);
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(commented.position, expected.position);
  EXPECT_EQ(commented.triangle, expected.triangle);
  const Mesh foreign = read_text("ply\nmade by hand\nformat ascii 1.0\n" + kVertex + "texture a\n" +
                                     kFace + "end_header\n" + kCorners + "4 0 1 2 3\n",
                                 &warnings);
  EXPECT_EQ(foreign.triangle, expected.triangle);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(is_one_line_with(
      warnings[0], "left out 2 lines of the header of unknown meaning, first 'made by hand'"));
}

TEST(PlyReader, AByteOrderMarkAndCarriageReturnsChangeNothing) {
  const std::string text = kHead + kCorners + "4 0 1 2 3\n";
  const Mesh expected = read_text(text);
  std::string dos;
  for (const char c : text) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  std::string strays = "\xef\xbb\xbf" + kHead;
  for (const char c : kCorners) strays += c == ' ' ? '\r' : c;
  for (const auto& other : {"\xef\xbb\xbf" + text, dos, strays + "\r4 0\r1 2\r\r3\r\r\n"}) {
    Lines warnings;
    const Mesh mesh = read_text(other, &warnings);
    EXPECT_EQ(mesh.position, expected.position);
    EXPECT_EQ(mesh.triangle, expected.triangle);
    EXPECT_TRUE(warnings.empty());
  }
}

TEST(PlyReader, NormalsThatAreZeroOrNotFiniteAreTheMeanAndCounted) {
  const std::string head = kAscii + kVertex +
                           "property float nx\nproperty float ny\nproperty float nz\n" + kFace +
                           "end_header\n0 0 0 1 0 0\n1 0 0 nan 0 0\n1 1 0 0 inf 0\n0 1 0 ";
  Lines warnings;
  const Mesh mesh = read_text(head + "nan nan nan\n3 0 1 2\n", &warnings);
  EXPECT_EQ(mesh.normal[0], (Vec3{1, 0, 0}));
  EXPECT_EQ(mesh.normal[1], (Vec3{0, 0, 1}));
  EXPECT_EQ(mesh.normal[2], (Vec3{0, 0, 1}));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(is_one_line_with(warnings[0], "2 normals are zero or not finite"));
  warnings.clear();
  EXPECT_EQ(read_text(head + "0 -0 0\n3 0 2 3\n", &warnings).normal[3], (Vec3{0, 0, 1}));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(is_one_line_with(warnings[0], "2 normals are zero or not finite"));
  // No face names the fourth vertex.
  warnings.clear();
  const std::string only_unused =
      kAscii + kVertex + "property float nx\nproperty float ny\nproperty float nz\n" + kFace +
      "end_header\n0 0 0 1 0 0\n1 0 0 1 0 0\n1 1 0 1 0 0\n" + "0 1 0 nan 0 0\n3 0 1 2\n";
  EXPECT_EQ(read_text(only_unused, &warnings).normal[2], (Vec3{1, 0, 0}));
  EXPECT_TRUE(warnings.empty());
  read_text(kAscii + kVertex + "property float nx\n" + kFace + "end_header\n0 0 0 1\n1 0 0 1\n" +
                "1 1 0 1\n0 1 0 1\n3 0 1 2\n",
            &warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(is_one_line_with(warnings[0], "normals not used: not all of nx, ny and nz"));
}

TEST(PlyReader, ConcavePolygonsAreCutInsideAndTheirFirstVertexProvokes) {
  // An arrow whose fan from the first corner lies outside.
  Lines warnings;
  const Mesh mesh =
      read_text(kHead + "-1.2 -1.3 0\n0 -.4 0\n1.2 -1.3 0\n0 1.5 0\n4 0 1 2 3\n", &warnings);
  EXPECT_TRUE(warnings.empty());
  ASSERT_EQ(mesh.triangle.size(), 2u);
  for (const auto& t : mesh.triangle) {
    const Vec3 &a = mesh.position[t[0]], &b = mesh.position[t[1]], &c = mesh.position[t[2]];
    EXPECT_GT(cross(b - a, c - a)[2], 0);
  }
  EXPECT_EQ(mesh.provoking, (std::vector<uint32_t>{0, 0}));
  ASSERT_EQ(mesh.polygon.size(), 1u);
  EXPECT_EQ(mesh.corner, (std::vector<uint32_t>{0, 1, 2, 3}));
}

TEST(PlyReader, ATriangleOfAStripIsProvokedByItsOwnFirstCorner) {
  const Mesh mesh =
      read_text(kAscii + kVertex + kFace +
                "element tristrips 1\nproperty list uchar int vertex_indices\nend_header\n" +
                "-1.2 -1.3 0\n0 -.4 0\n1.2 -1.3 0\n0 1.5 0\n4 0 1 2 3\n4 0 1 2 3\n");
  ASSERT_EQ(mesh.triangle.size(), 4u);
  EXPECT_EQ(mesh.provoking, (std::vector<uint32_t>{0, 0, 0, 1}));
}

TEST(PlyReader, BinaryValuesAcrossBlocksAreRead) {
  // With 13 bytes a vertex, values straddle the borders of the reader's blocks in every way.
  constexpr uint32_t kVertices = 40000;
  for (const bool big : {false, true}) {
    std::string text = std::string("ply\nformat ") +
                       (big ? "binary_big_endian" : "binary_little_endian") + " 1.0\n" +
                       "element vertex " + std::to_string(kVertices) +
                       "\nproperty uchar a\nproperty float x\nproperty float y\n" +
                       "property float z\n" + kFace + "end_header\n";
    for (uint32_t i = 0; i < kVertices; ++i) {
      text += raw(uint8_t{1}, big);
      for (uint32_t k = 0; k < 3; ++k) text += raw(static_cast<float>(3 * i + k), big);
    }
    text += raw(uint8_t{3}, big) + raw(7, big) + raw(8, big) + raw(39999, big);
    const Mesh mesh = read_text(text);
    ASSERT_EQ(mesh.position.size(), kVertices);
    for (uint32_t i = 0; i < kVertices; ++i) {
      ASSERT_EQ(mesh.position[i], (Vec3{3. * i, 3. * i + 1, 3. * i + 2}));
    }
    EXPECT_EQ(mesh.triangle, (Triangles{{7, 8, 39999}}));
  }
}

struct Refusal {
  const char* name;
  std::string bytes;
  const char* message;
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.name; }

class PlyRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(PlyRefusal, NamesTheLineAndWhatWasExpected) {
  const Scratch scratch;
  ASSERT_EQ(error_of(scratch.write("good.ply", kHead + kCorners + "4 0 1 2 3\n")), "");
  const auto path = scratch.write("bad.ply", GetParam().bytes);
  EXPECT_TRUE(is_one_line_with(error_of(path), path + GetParam().message));
}

/// A header with an element before the vertices.
std::string odd(const std::string& name, int count) {
  return kAscii + "element " + name + " " + std::to_string(count) + "\nproperty int b\n" + kVertex +
         kFace + "end_header\n";
}

std::string face(const std::string& corners) { return kHead + kCorners + corners + "\n"; }

// A little-endian file of one vertex of 12 bytes, then a face.
std::string binary(const std::string& body) {
  return "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
         "property float y\nproperty float z\nelement face 1\nproperty list int int vertex_index\n"
         "end_header\n" +
         body;
}

const std::vector<Refusal> kRefusals = {
    {"Empty", "", ":1: expected 'ply'"},
    {"OtherFormat", "solid a\n", ":1: expected 'ply', got 'solid a'"},
    {"NoFormat", "ply\nelement vertex 1\n", ":2: expected a line 'format ...'"},
    {"UnknownEncoding", "ply\nformat text 1.0\n", ":2: expected ascii, binary_little_endian or"},
    {"OtherVersion", "ply\nformat ascii 2.0\n", ":2: expected version 1.0, got '2.0'"},
    {"HeaderEnds", kAscii + kVertex, ":6: expected end_header"},
    {"NoFormatAtAll", "ply\ncomment a\nend_header\n", ":3: expected a line 'format ...'"},
    {"FormatTwice", kAscii + "format ascii 1.0\n", ":3: expected one line 'format ...'"},
    {"OldMacLineEnds", "ply\rformat ascii 1.0\relement vertex 1\r",
     ":1: expected 'ply' alone in a line that ends with LF, got 'ply?format"},
    {"UnknownLinesOnly", kAscii + "elements vertex 1\n", ":3: expected end_header"},
    {"MisspeltProperty", kAscii + kVertex + "propety float w\n" + kFace + "end_header\n0 0 0 1\n",
     ":11: expected the 3 words of a vertex"},
    {"PropertyFirst", kAscii + "property float x\n",
     ":3: expected an element before its properties"},
    {"UnknownType", kAscii + "element vertex 1\nproperty half x\n", ":4: expected a type from"},
    {"ListOfFloatLength", kAscii + "element face 1\nproperty list float int vertex_index\n",
     ":4: expected an integer type, got 'float'"},
    {"CountNoNumber", kAscii + "element vertex many\n", ":3: expected a count, got 'many'"},
    {"CountNegative", kAscii + "element vertex -1\n", ":3: expected a count, got '-1'"},
    {"CountTooGreat", kAscii + "element vertex 99999999999999999999\n", ":3: expected a count"},
    {"ElementTwice", kAscii + kVertex + kVertex + "end_header\n",
     ":11: expected elements of different names, got 'vertex'"},
    {"NoProperty", kAscii + "element vertex 99999999999\nend_header\n",
     ":4: expected a property first"},
    {"NoVertex", kAscii + kFace + "end_header\n", ": expected an element vertex with x, y and z"},
    {"NoZ",
     kAscii + "element vertex 1\nproperty float x\nproperty float y\n" + kFace + "end_header\n",
     ": expected an element vertex with x, y and z"},
    {"NoFace", kAscii + kVertex + "end_header\n", ": expected an element face or tristrips"},
    {"NoList", kAscii + kVertex + "element face 1\nproperty int vertex_index\nend_header\n",
     ": expected one list vertex_indices in face"},
    {"VerticesHuge",
     kAscii + "element vertex 4294967295\nproperty float x\nproperty float y\nproperty float z\n" +
         kFace + "end_header\n",
     ": expected less than 2^32 - 1 vertices, got 4294967295"},
    {"NoFaces",
     kAscii + kVertex + "element face 0\nproperty list uchar int vertex_index\nend_header\n" +
         kCorners,
     ": expected faces, got none"},
    {"FewerVertices", kHead + "0 0 0\n1 0 0\n", ":11: expected vertex 2 of 4"},
    {"FewerFaces", kHead + kCorners, ":13: expected face 0 of 1"},
    {"ElementWithAnUnprintableName", odd("a\x10\xff", 2) + "1\n", ":12: expected a?? 1 of 2"},
    {"ElementWithALongName", odd(std::string(50, 'n'), 1) + "1 2\n",
     ":12: expected the 1 words of a 'nnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnn...'"},
    {"TwoCoordinates", kHead + "0 0\n", ":10: expected more words of a vertex, got '0 0'"},
    {"FourCoordinates", kHead + "0 0 0 1\n", ":10: expected the 3 words of a vertex"},
    {"BadNumber", kHead + "0 0 z\n", ":10: expected a number, got 'z'"},
    {"IndexTooGreat", face("3 0 1 4"), ":14: expected an index of 4 vertices, got '4'"},
    {"IndexNegative", face("3 0 1 -1"), ":14: expected an index of 4 vertices, got '-1'"},
    {"IndexFraction", face("3 0 1 2.5"), ":14: expected a number of type int, got '2.5'"},
    {"IndexNan", face("3 0 1 nan"), ":14: expected a number of type int, got 'nan'"},
    {"LengthTooGreat", face("256 0 1 2"), ":14: expected a number of type uchar, got '256'"},
    {"LengthBeyondTheLine", face("4 0 1 2"), ":14: expected more words of a face"},
    {"TwoCorners", face("2 0 1"), ":14: expected three or more corners, got '2'"},
    {"NoCorners", face("0"), ":14: expected three or more corners, got '0'"},
    {"BadColour",
     kAscii + "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n" +
         "property float red\nproperty float green\nproperty float blue\n" + kFace +
         "end_header\n0 0 0 0 0 1.5\n",
     ":13: expected a colour from 0 to 1, got '1.5'"},
    {"BadColourOfAFace",
     kAscii + kVertex + kFace + "property float r\nproperty float g\nproperty float b\n" +
         "end_header\n" + kCorners + "3 0 1 2 0 nan 0\n",
     ":17: expected a colour from 0 to 1, got 'nan'"},
    {"BinaryVertexCut", binary(std::string(11, 0)), ": 'vertex' 0: expected more bytes, 0 of 1"},
    {"BinaryIndex", binary(std::string(12, 0) + raw(3, false) + raw(1, false)),
     ": 'face' 0: expected an index of 1 vertices, got '1'"},
    {"BinaryLengthNegative", binary(std::string(12, 0) + raw(-1, false)),
     ": 'face' 0: expected the length of a list, got '-1'"},
    {"BinaryLengthHuge", binary(std::string(12, 0) + raw(2147483647, false)),
     ": 'face' 0: expected more bytes"},
};

INSTANTIATE_TEST_SUITE_P(Ply, PlyRefusal, testing::ValuesIn(kRefusals),
                         [](const auto& row) { return row.param.name; });

TEST(PlyFuzz, EveryPrefixIsRefusedInOneLine) {
  const Scratch scratch;
  for (const char* encoding : kEncodings) {
    const std::string whole = square(encoding);
    // An ASCII file is whole without its last line end; without its last digit it is another file.
    const size_t longest = whole.size() - (std::strcmp(encoding, "ascii") == 0 ? 2 : 0);
    for (size_t n = 0; n < longest; ++n) {
      const auto path = scratch.write(encoding + std::to_string(n) + ".ply", whole.substr(0, n));
      ASSERT_TRUE(is_one_line_with(error_of(path), path)) << encoding << n;
    }
  }
}

TEST(PlyFuzz, EveryChangedByteIsRefusedInOneLineOrRead) {
  const Scratch scratch;
  size_t refused = 0, tried = 0;
  for (const char* encoding : kEncodings) {
    const std::string whole = square(encoding);
    for (size_t n = 0; n < whole.size(); ++n) {
      for (const char c : {'9', '\xff'}) {
        std::string bytes = whole;
        bytes[n] = c;
        const std::string error = error_of(scratch.write(std::to_string(tried++) + ".ply", bytes));
        ASSERT_EQ(error.find('\n'), std::string::npos) << encoding << n;
        refused += error.empty() ? 0 : 1;
      }
    }
  }
  EXPECT_GT(refused, tried / 3);
  EXPECT_LT(refused, tried);
}

}  // namespace
}  // namespace pineda::scene
