#include <gtest/gtest.h>

#include <cmath>

#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

const std::string kTriangle =
    "v 1 1 0 1 255 0 0 255\n"
    "v 5 1 0.5 1 0 255 0 255\n"
    "v 1 5 1 1 0 0 255 255\n";

struct Refusal {
  const char* name;
  std::string text;
  const char* message;  // part of it: the line, and what was expected
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.name; }

std::string scene(const std::string& state, const std::string& vertices = kTriangle) {
  return "pineda-tri 1\n" + state + vertices;
}

// A scene whose third line, the first vertex, is `line`.
std::string with_vertex(const std::string& line) {
  return scene("size 8 8\n", line + "\nv 5 1 0 1 0 0 0 0\nv 1 5 0 1 0 0 0 0\n");
}

class TriRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(TriRefusal, NamesTheLineAndWhatWasExpected) {
  const Scratch scratch;
  const auto path = scratch.write("bad.tri", GetParam().text);
  const auto message = error_of(path);
  EXPECT_TRUE(is_one_line_with(message, path + GetParam().message));
}

const std::vector<Refusal> kRefusals = {
    {"Empty", "", ":1: expected the first line 'pineda-tri 1'"},
    {"OtherVersion", "pineda-tri 2\nsize 8 8\n", ":1: expected the first line 'pineda-tri 1'"},
    {"FirstLineIndented", " pineda-tri 1\nsize 8 8\n", ":1: expected the first line"},
    {"CommentFirst", "# a\npineda-tri 1\n", ":1: expected the first line"},
    {"SizeMissingAtVertex", scene(""), ":2: expected a line 'size WIDTH HEIGHT'"},
    {"SizeMissingAtEnd", "pineda-tri 1\ncull none\n", ":2: expected a line 'size WIDTH HEIGHT'"},
    {"SizeZero", scene("size 0 8\n"), ":2: expected a width from 1 to 16384, got '0'"},
    {"SizeNegative", scene("size 8 -8\n"), ":2: expected a height from 1 to 16384, got '-8'"},
    {"SizeTooGreat", scene("size 8 16385\n"), ":2: expected a height from 1 to 16384"},
    {"SizeBeyondAnInt", scene("size 99999999999 8\n"), ":2: expected a width from 1 to 16384"},
    {"SizeNotAnInteger", scene("size 8.5 8\n"), ":2: expected a width from 1 to 16384"},
    {"SizeTooFewWords", scene("size 8\n"), ":2: expected 3 words 'size WIDTH HEIGHT', got 2"},
    {"SizeTooManyWords", scene("size 8 8 8\n"), ":2: expected 3 words 'size WIDTH HEIGHT', got 4"},
    {"SizeTwice", scene("size 8 8\nsize 8 8\n"), ":3: expected each state line once"},
    {"CullTwice", scene("size 8 8\ncull none\n\ncull none\n"), ":5: expected each state line once"},
    {"DepthTwice", scene("size 8 8\ndepth off\ndepth off\n"), ":4: expected each state line once"},
    {"CullUnknown", scene("size 8 8\ncull left\n"), ":3: expected cull none, back or front"},
    {"CullWithoutWord", scene("size 8 8\ncull\n"), ":3: expected 2 words"},
    {"DepthUnknown", scene("size 8 8\ndepth deep\n"), ":3: expected depth less, lequal or off"},
    {"StateAfterVertex", scene("size 8 8\n", kTriangle + "cull none\n" + kTriangle),
     ":6: expected state lines before the first v"},
    {"SizeAfterVertex", scene("size 8 8\n", kTriangle + "size 8 8\n" + kTriangle),
     ":6: expected state lines before the first v"},
    {"UnknownKeyword", scene("size 8 8\ncolour red\n"), ":3: expected size, cull, depth or v"},
    {"UnknownKeywordAfterVertex", scene("size 8 8\n", kTriangle + "triangle\n"),
     ":6: expected a vertex 'v X Y Z W R G B A'"},
    {"Scissor", scene("size 8 8\nscissor 0 0 4 4\n"), ":3: expected no 'scissor' line: this ver"},
    {"DepthWrite", scene("size 8 8\ndepthwrite on\n"), ":3: expected no 'depthwrite' line: this"},
    {"DepthBias", scene("size 8 8\ndepthbias 1 1\n"), ":3: expected no 'depthbias' line: this ve"},
    {"Shade", scene("size 8 8\nshade smooth\n"), ":3: expected no 'shade' line: this version"},
    {"DepthNever", scene("size 8 8\ndepth never\n"), ":3: expected depth less, lequal or off: thi"},
    {"DepthGequal", scene("size 8 8\ndepth gequal\n"), ":3: expected depth less, lequal or off: t"},
    {"DepthAlways", scene("size 8 8\ndepth always\n"), ":3: expected depth less, lequal or off: t"},
    {"TooFewNumbers", with_vertex("v 1 1 0 1 0 0 0"), ":3: expected 9 words 'v X Y Z W R G B A'"},
    {"TooManyNumbers", with_vertex("v 1 1 0 1 0 0 0 0 0"), ":3: expected 9 words"},
    {"InlineComment", with_vertex("v 1 1 0 1 0 0 0 0 # here"), ":3: expected 9 words"},
    {"BadNumber", with_vertex("v 1 one 0 1 0 0 0 0"), ":3: expected a number, got 'one'"},
    {"NumberWithTail", with_vertex("v 1 1.5x 0 1 0 0 0 0"), ":3: expected a number, got '1.5x'"},
    {"NumberWithComma", with_vertex("v 1,5 1 0 1 0 0 0 0"), ":3: expected a number, got '1,5'"},
    {"WZero", with_vertex("v 1 1 0 0 0 0 0 0"), ":3: expected W > 0"},
    {"WNegative", with_vertex("v 1 1 0 -1 0 0 0 0"), ":3: expected W > 0"},
    {"WDenormal", with_vertex("v 1 1 0 1e-40 0 0 0 0"), ":3: expected W > 0"},
    {"WInfinite", with_vertex("v 1 1 0 inf 0 0 0 0"), ":3: expected W > 0"},
    {"WUnderflow", with_vertex("v 1 1 0 1e-99 0 0 0 0"), ":3: expected W > 0"},
    {"WBesideNan", with_vertex("v nan 1 0 0 0 0 0 0"), ":3: expected W > 0"},
    {"ColourTooGreat", with_vertex("v 1 1 0 1 0 0 256 0"), ":3: expected a colour from 0 to 255"},
    {"ColourNegative", with_vertex("v 1 1 0 1 -1 0 0 0"), ":3: expected a colour from 0 to 255"},
    {"ColourNotAnInteger", with_vertex("v 1 1 0 1 0 0 0 1.0"), ":3: expected a colour from 0 to"},
    {"TwoVertices", scene("size 8 8\n", "v 1 1 0 1 0 0 0 0\nv 1 1 0 1 0 0 0 0\n"),
     ":4: expected a multiple of three vertices"},
    {"NulByte", scene(std::string("size 8 8\0 9\n", 12)), ":2: expected text"},
};

INSTANTIATE_TEST_SUITE_P(Tri, TriRefusal, testing::ValuesIn(kRefusals),
                         [](const auto& row) { return row.param.name; });

Scene open_text(const Scratch& scratch, const std::string& text) {
  return open_scene(kContract, scratch.write("scene.tri", text), {});
}

TEST(TriReader, ReadsStateAndTrianglesTwice) {
  const Scratch scratch;
  const auto opened = open_text(
      scratch, scene("# note\n\n  size 8 16\ncull back\ndepth lequal\n", kTriangle + kTriangle));
  EXPECT_EQ(opened.name, "scene");
  EXPECT_EQ(opened.frame.width, 8);
  EXPECT_EQ(opened.frame.height, 16);
  EXPECT_EQ(opened.frame.cull, spec::Cull::kBack);
  EXPECT_EQ(opened.frame.depth, spec::DepthFunc::kLequal);
  const auto first = all_triangles(opened.source.get());
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[1].id, 1u);
  EXPECT_EQ(first[0].v[1].x, 5 * 256);
  EXPECT_EQ(first[0].v[2].z, int64_t{0xffffff} << 8);
  EXPECT_EQ(first[0].v[1].attr, (spec::Attributes{0, 255, 0, 255}));
  opened.source->rewind();
  EXPECT_TRUE(same(first, all_triangles(opened.source.get())));
  EXPECT_EQ(opened.source->counters().triangles, 2u);
}

TEST(TriReader, DefaultsAreNoCullAndLess) {
  const Scratch scratch;
  const auto opened = open_text(scratch, scene("size 8 8\n", ""));
  EXPECT_EQ(opened.frame.cull, spec::Cull::kNone);
  EXPECT_EQ(opened.frame.depth, spec::DepthFunc::kLess);
  EXPECT_TRUE(all_triangles(opened.source.get()).empty());
}

TEST(TriReader, CarriageReturnsAndAMissingLastLineEndChangeNothing) {
  const Scratch scratch;
  std::string text = scene("size 8 8\ncull front\n");
  const auto plain = all_triangles(open_text(scratch, text).source.get());
  std::string dos;
  for (const char c : text) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  dos.resize(dos.size() - 2);
  EXPECT_TRUE(same(plain, all_triangles(open_text(scratch, dos).source.get())));
}

TEST(TriReader, TakesEveryFormThatStrtofReads) {
  const Scratch scratch;
  const auto opened =
      open_text(scratch, scene("size 8 8\n",
                               "v 0x1.8p+1 1e99 1e-99 1 0 0 0 0\nv -inf .5 0 +1 0 0 0 0\n"
                               "v 1e-40 INFINITY 2 0x1p0 0 0 0 0\nv 1 1 nan(7) 1 0 0 0 0\n"
                               "v 1 1 0 NAN 0 0 0 0\nv 1 1 0 1 0 0 0 0\n"));
  const auto all = all_triangles(opened.source.get());
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].v[0].x, 3 * 256);
  EXPECT_EQ(all[0].v[0].y, 4194303);
  EXPECT_EQ(all[0].v[1].x, -4194304);
  const Counters& c = opened.source->counters();
  EXPECT_EQ(c.triangles, 2u);
  EXPECT_EQ(c.nan_dropped, 1u);
  EXPECT_EQ(c.saturated, 3u);
  EXPECT_EQ(c.denormals, 1u);  // 1e-40; 1e-99 is 0
  EXPECT_EQ(c.z_clamped, 1u);
  EXPECT_EQ(c.perspective, 0u);
}

TEST(TriReader, CountsVerticesWhoseColoursWouldNeedPerspective) {
  const Scratch scratch;
  const auto opened = open_text(scratch, with_vertex("v 1 1 0 2 0 0 0 0"));
  all_triangles(opened.source.get());
  EXPECT_EQ(opened.source->counters().perspective, 1u);
  ASSERT_EQ(notes(opened.source->counters()).size(), 1u);
  EXPECT_NE(notes(opened.source->counters())[0].find("1 vertices with W"), std::string::npos);
}

}  // namespace
}  // namespace pineda::scene
