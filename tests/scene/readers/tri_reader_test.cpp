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

// A scene whose third line is `line`.
std::string state(const std::string& line) { return scene("size 8 8\n" + line + "\n"); }

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
    {"CommentFirst", "# a\n\npineda-tri 2\n", ":3: expected the first line"},
    {"FirstLineWithABlank", "pineda-tri 1 \nsize 8 8\n", ":1: expected the first line"},
    {"FirstLineWithAComment", "pineda-tri 1 # 1\nsize 8 8\n", ":1: expected the first line"},
    {"FirstLineOfThree", "pineda-tri 1 1\n", ":1: expected the first line"},
    {"FirstLineOfTwelve", "pineda-tri 12\n", ":1: expected the first line"},
    {"OldMacLineEnds", "pineda-tri 1\rsize 8 8\r", ":1: expected the first line"},
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
    {"DepthUnknown", scene("size 8 8\ndepth deep\n"),
     ":3: expected depth less, lequal, off, never, "
     "equal, greater, notequal, gequal or always"},
    {"StateAfterVertex", scene("size 8 8\n", kTriangle + "cull none\n" + kTriangle),
     ":6: expected state lines before the first v"},
    {"SizeAfterVertex", scene("size 8 8\n", kTriangle + "size 8 8\n" + kTriangle),
     ":6: expected state lines before the first v"},
    {"UnknownKeyword", scene("size 8 8\ncolour red\n"),
     ":3: expected size, cull, depth, "
     "scissor, depthwrite, depthbias, cleardepth, shade, or v"},
    {"UnknownKeywordAfterVertex", scene("size 8 8\n", kTriangle + "triangle\n"),
     ":6: expected a vertex 'v X Y Z W R G B A'"},
    {"ScissorTwice", state("scissor 0 0 4 4\nscissor 0 0 4 4"),
     ":4: expected each state line once"},
    {"ScissorOfThree", state("scissor 0 0 4"), ":3: expected 5 words 'scissor X Y WIDTH HEIGHT'"},
    {"ScissorBeyondAnInt", state("scissor -2147483649 0 4 4"),
     ":3: expected a column from -2147483648 to 2147483647"},
    {"ScissorOfNegativeWidth", state("scissor -9 0 -4 4"), ":3: expected a width from 0 to"},
    {"ScissorOfNegativeHeight", state("scissor 0 0 4 -4"), ":3: expected a height from 0 to"},
    {"ScissorNotAnInteger", state("scissor 0 0 4.5 4"),
     ":3: expected a width from 0 to 2147483647"},
    {"DepthWriteUnknown", state("depthwrite yes"), ":3: expected depthwrite off or on"},
    {"DepthWriteTwice", state("depthwrite on\ndepthwrite on"), ":4: expected each state line once"},
    {"DepthBiasOfOne", state("depthbias 1"), ":3: expected 3 words 'depthbias CONSTANT SLOPE'"},
    {"DepthBiasTwice", state("depthbias 1 1\ndepthbias 1 1"), ":4: expected each state line once"},
    {"BiasConstantNotWhole", state("depthbias 1.5 0"), ":3: expected a bias in whole depth codes"},
    {"BiasConstantOfAllCodes", state("depthbias 16777216 0"),
     ":3: expected a bias in whole depth codes from -16777215 to 16777215, got '16777216'"},
    {"BiasConstantTooNegative", state("depthbias -16777216 0"), ":3: expected a bias in whole"},
    {"BiasConstantBeyondAnInt64", state("depthbias 99999999999999999999 0"), ":3: expected a bias"},
    {"BiasSlopeTooGreat", state("depthbias 0 128"),
     ":3: expected a slope factor from -128 to less than 128, got '128'"},
    {"BiasSlopeTooNegative", state("depthbias 0 -128.001"), ":3: expected a slope factor"},
    {"BiasSlopeNan", state("depthbias 0 nan"), ":3: expected a slope factor"},
    {"BiasSlopeInfinite", state("depthbias 0 -inf"), ":3: expected a slope factor"},
    {"BiasSlopeNoNumber", state("depthbias 0 1,5"), ":3: expected a slope factor"},
    {"ClearDepthOfTwo", state("cleardepth 0 1"), ":3: expected 2 words 'cleardepth Z', got 3"},
    {"ClearDepthTwice", state("cleardepth 0\ncleardepth 0"), ":4: expected each state line once"},
    {"ClearDepthTooGreat", state("cleardepth 1.0000001"),
     ":3: expected a clear depth from 0 to 1, got '1.0000001'"},
    {"ClearDepthNegative", state("cleardepth -1e-30"), ":3: expected a clear depth from 0 to 1"},
    {"ClearDepthNan", state("cleardepth nan"), ":3: expected a clear depth from 0 to 1"},
    {"ClearDepthInfinite", state("cleardepth inf"), ":3: expected a clear depth from 0 to 1"},
    {"ClearDepthNoNumber", state("cleardepth 0x"), ":3: expected a clear depth from 0 to 1"},
    {"ClearDepthAfterVertex", scene("size 8 8\n", kTriangle + "cleardepth 0\n"),
     ":6: expected state lines before the first v"},
    {"ShadeUnknown", state("shade gouraud"), ":3: expected shade smooth or flat"},
    {"ShadeTwice", state("shade flat\nshade smooth"), ":4: expected each state line once"},
    {"ShadeAfterVertex", scene("size 8 8\n", kTriangle + "shade flat\n"),
     ":6: expected state lines before the first v"},
    {"ScissorInsideTriangle", scene("size 8 8\n", "v 1 1 0 1 0 0 0 0\nscissor 0 0 1 1\n"),
     ":4: expected state lines before the first v"},
    {"TooFewNumbers", with_vertex("v 1 1 0 1 0 0 0"), ":3: expected 9 words 'v X Y Z W R G B A'"},
    {"TooManyNumbers", with_vertex("v 1 1 0 1 0 0 0 0 0"), ":3: expected 9 words"},
    {"CommentInsteadOfValues", with_vertex("v 1 1 0 1 0 0 0 # 0"), ":3: expected 9 words"},
    {"ContinuedLine", with_vertex("v 1 1 0 1 0 0 0 0 \\"), ":3: expected 9 words"},
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

TEST(TriReader, CommentsByteOrderMarksAndStrayCarriageReturnsChangeNothing) {
  const Scratch scratch;
  const auto plain = all_triangles(open_text(scratch, scene("size 8 8\ncull back\n")).source.get());
  for (const std::string& text :
       {"\xef\xbb\xbf" + scene("size 8 8\ncull back\n"),
        "# made by hand\n\n  # and by foot\n" + scene("size 8 8\ncull back\n"),
        "\xef\xbb\xbf#\n" + scene("size 8 8\ncull back\n"),
        scene("# x\rcull front\n\rsize\r8 8\r\r\ncull back\r\n"),
        "pineda-tri 1\nsize 8 8# px\ncull back\t# none, back, front\n" + kTriangle +
            "# v 1 1 0 1 0 0 0 0"}) {
    auto opened = open_text(scratch, text);
    EXPECT_EQ(opened.frame.cull, spec::Cull::kBack);
    EXPECT_TRUE(same(plain, all_triangles(opened.source.get())));
    opened.source->rewind();
    EXPECT_TRUE(same(plain, all_triangles(opened.source.get())));
  }
}

// The defaults as README.md states them, with its indentation.
TEST(TriReader, TheReadmesBlockOfStateIsRead) {
  const Scratch scratch;
  const auto opened = open_text(
      scratch,
      scene("    size 64 64\n"
            "    cull none               # none, back, front; front = counter-clockwise on screen\n"
            "    depth less              # less, lequal, equal, greater, notequal, gequal, always\n"
            "    depthwrite on           # on, off: of the samples that pass\n"
            "    depthbias 0 0           # CONSTANT + SLOPE*max(|dz/dx|, |dz/dy|), codes\n"
            "    scissor 0 0 64 64       # X Y WIDTH HEIGHT, px; it may reach beyond the frame\n"
            "    shade smooth            # smooth, flat: the first vertex gives the colour\n"));
  EXPECT_EQ(unusual_state(opened.frame), "");
  EXPECT_EQ(all_triangles(opened.source.get()).size(), 1u);
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

TEST(TriReader, EveryDepthFunctionHasItsWord) {
  const Scratch scratch;
  using F = spec::DepthFunc;
  const std::vector<std::pair<const char*, F>> functions{
      {"less", F::kLess},         {"lequal", F::kLequal}, {"off", F::kOff},
      {"never", F::kNever},       {"equal", F::kEqual},   {"greater", F::kGreater},
      {"notequal", F::kNotequal}, {"gequal", F::kGequal}, {"always", F::kAlways}};
  for (const auto& [word, function] : functions) {
    const auto opened = open_text(scratch, state(std::string("depth ") + word));
    EXPECT_EQ(opened.frame.depth, function) << word;
  }
}

TEST(TriReader, ReadsTheWholeState) {
  const Scratch scratch;
  const auto opened = open_text(
      scratch, state("shade flat\ndepthwrite off\nscissor 1 2 3 4\ndepthbias -16777215 -1.5"));
  for (int pass = 0; pass < 2; ++pass) {
    const spec::FrameState& f = opened.frame;
    EXPECT_EQ(f.shade, spec::Shade::kFlat);
    EXPECT_FALSE(f.depth_write);
    EXPECT_EQ(f.scissor_x0, 1);
    EXPECT_EQ(f.scissor_y0, 2);
    EXPECT_EQ(f.scissor_x1, 4);
    EXPECT_EQ(f.scissor_y1, 6);
    EXPECT_EQ(f.bias_constant, -16777215);
    EXPECT_EQ(f.bias_slope, -384);
    EXPECT_EQ(opened.source->counters().rounded_slope, 0u);
    EXPECT_EQ(all_triangles(opened.source.get()).size(), 1u);
    opened.source->rewind();
  }
  EXPECT_EQ(unusual_state(opened.frame),
            "scissor 1,2,3,4 px, depth write off, depth bias -16777215,-1.5, shade flat");
  EXPECT_EQ(unusual_state(open_text(scratch, state("depth off")).frame), "");
}

TEST(TriReader, ClearDepthIsABinary32InAnyFormOfStrtof) {
  const Scratch scratch;
  const auto depth = [&](const std::string& z) {
    const auto opened = open_text(scratch, state("cleardepth " + z));
    opened.source->rewind();
    return opened.frame.clear_depth;
  };
  EXPECT_EQ(depth("0x.8p0"), .5);
  EXPECT_EQ(depth("1e0"), 1);
  EXPECT_EQ(depth("1.00000001"), 1);  // the binary32 is 1
  EXPECT_EQ(depth("0.1"), 0.1f);
  EXPECT_EQ(depth("1e-99"), 0);  // underflow is taken
  EXPECT_FALSE(std::signbit(depth("-0")));
  EXPECT_EQ(unusual_state(open_text(scratch, state("cleardepth 0.1")).frame), "clear depth 0.1");
  EXPECT_EQ(unusual_state(open_text(scratch, state("cleardepth 0")).frame), "clear depth 0");
  EXPECT_EQ(unusual_state(open_text(scratch, state("cleardepth 1")).frame), "");
  EXPECT_EQ(open_text(scratch, state("cull none")).frame.clear_depth, 1);
}

TEST(TriReader, AScissorBeyondTheFrameIsClipped) {
  const Scratch scratch;
  const auto clip = [&](const std::string& line) {
    const spec::FrameState f = open_text(scratch, state("scissor " + line)).frame;
    return std::array<int, 4>{f.clip_x0(), f.clip_y0(), f.clip_x1(), f.clip_y1()};
  };
  using Box = std::array<int, 4>;
  EXPECT_EQ(clip("0 0 2147483647 2147483647"), (Box{0, 0, 8, 8}));
  EXPECT_EQ(clip("2147483647 5 2147483647 2147483647"), (Box{8, 5, 8, 8}));
  EXPECT_EQ(clip("7 8 9 1"), (Box{7, 8, 8, 8}));
  EXPECT_EQ(clip("3 3 0 5"), (Box{3, 3, 3, 8}));
  EXPECT_EQ(clip("-3 -5 6 9"), (Box{0, 0, 3, 4}));
  EXPECT_EQ(clip("-3 2 3 3"), (Box{0, 2, 0, 5}));  // all of it left of the frame
  EXPECT_EQ(clip("-2147483648 -2147483648 2147483647 0"), (Box{0, 0, 0, 0}));
  EXPECT_EQ(clip("-5 -5 2147483647 2147483647"), (Box{0, 0, 8, 8}));
}

TEST(TriReader, SlopeFactorsGoToTheNearestMultipleAndThatIsCounted) {
  const Scratch scratch;
  const auto bias = [&](const std::string& slope, bool rounded) {
    const auto opened = open_text(scratch, state("depthbias 0 " + slope));
    all_triangles(opened.source.get());
    EXPECT_EQ(opened.source->counters().rounded_slope, rounded ? 1u : 0u) << slope;
    EXPECT_EQ(notes(opened).size(), rounded ? 1u : 0u) << slope;
    opened.source->rewind();
    EXPECT_EQ(opened.source->counters().rounded_slope, rounded ? 1u : 0u) << slope;
    return opened.frame.bias_slope;
  };
  EXPECT_EQ(bias("-128", false), -32768);
  EXPECT_EQ(bias("127.99609375", false), 32767);
  EXPECT_EQ(bias("1e-9", true), 0);
  EXPECT_EQ(bias("0.1", true), 26);    // 25.6
  EXPECT_EQ(bias("0x1p-9", true), 0);  // halves to even
  EXPECT_EQ(bias("-0x3p-9", true), -2);
  EXPECT_EQ(bias("127.999", true), 32767);  // below 128 it stays
  EXPECT_EQ(bias("-127.999", true), -32768);
}

TEST(TriReader, CountsVerticesWhoseColoursWouldNeedPerspective) {
  const Scratch scratch;
  const auto path = scratch.write("w.tri", with_vertex("v 1 1 0 2 0 0 0 0"));
  const auto opened = open_scene(kContract, path, {});
  all_triangles(opened.source.get());
  EXPECT_EQ(opened.source->counters().perspective, 1u);
  ASSERT_EQ(notes(opened).size(), 1u);
  EXPECT_NE(notes(opened)[0].find("1 vertices with W"), std::string::npos);
  // No note where the design interpolates with perspective, or does not interpolate.
  const auto corrected = open_scene(spec::contract(*spec::find_design("persp")), path, {});
  all_triangles(corrected.source.get());
  EXPECT_EQ(corrected.source->counters().perspective, 1u);
  EXPECT_TRUE(notes(corrected).empty());
}

}  // namespace
}  // namespace pineda::scene
