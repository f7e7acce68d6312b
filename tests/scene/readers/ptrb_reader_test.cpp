#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <streambuf>

#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

struct Vertex {
  float x, y, z, w;
  uint8_t r, g, b, a;
};

const std::vector<Vertex> kTriangle = {
    {1, 1, 0, 1, 255, 0, 0, 255}, {5, 1, .5, 2, 0, 255, 0, 255}, {1, 5, 1, .5, 0, 0, 255, 9}};

void put(std::string* bytes, uint64_t value, int count) {
  for (int i = 0; i < count; ++i) bytes->push_back(static_cast<char>(value >> 8 * i));
}

void put(std::string* bytes, float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  put(bytes, bits, 4);
}

std::string header(uint32_t width, uint32_t height, uint32_t flags, uint64_t triangles) {
  std::string bytes = "PTRB";
  put(&bytes, 1, 4);
  put(&bytes, width, 4);
  put(&bytes, height, 4);
  put(&bytes, flags, 4);
  put(&bytes, triangles, 8);
  return bytes;
}

std::string body(const std::vector<Vertex>& vertices, bool has_w) {
  std::string bytes;
  for (const Vertex& v : vertices) {
    for (const float value : {v.x, v.y, v.z}) put(&bytes, value);
    if (has_w) put(&bytes, v.w);
    for (const uint8_t value : {v.r, v.g, v.b, v.a}) put(&bytes, value, 1);
  }
  return bytes;
}

std::string with_byte(std::string bytes, size_t at, char value) {
  bytes[at] = value;
  return bytes;
}

std::string with_w(float w) {
  auto vertices = kTriangle;
  vertices[1].w = w;
  return header(8, 8, 1, 1) + body(vertices, true);
}

const std::string kGood = header(8, 8, 1, 1) + body(kTriangle, true);

struct Refusal {
  const char* name;
  std::string bytes;
  const char* message;
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.name; }

class PtrbRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(PtrbRefusal, FromAFileSaysWhatWasExpected) {
  const Scratch scratch;
  const auto path = scratch.write("bad.ptrb", GetParam().bytes);
  EXPECT_TRUE(is_one_line_with(error_of(path), path + ": " + GetParam().message));
}

const std::vector<Refusal> kRefusals = {
    {"Empty", "", "expected a header of 28 bytes, got 0"},
    {"ShortHeader", kGood.substr(0, 27), "expected a header of 28 bytes, got 27"},
    {"Magic", with_byte(kGood, 3, 'b'), "expected the bytes 'PTRB' at the start"},
    {"Version", with_byte(kGood, 4, 2), "expected version 1, got 2"},
    {"WidthZero", header(0, 8, 0, 0), "expected a size of 1x1 to 16384x16384, got 0x8"},
    {"HeightTooGreat", header(8, 16385, 0, 0),
     "expected a size of 1x1 to 16384x16384, got 8x16385"},
    {"UnknownFlag", header(8, 8, 32, 0), "expected flags with bits 0-4 only"},
    {"HighestFlag", header(8, 8, 1u << 31, 0), "expected flags with bits 0-4 only"},
    {"ReservedCull", header(8, 8, 3 << 1, 0), "expected flags with bits 0-4 only, cull 0-2"},
    {"ReservedDepth", header(8, 8, 3 << 3, 0), "expected flags with bits 0-4 only, cull 0-2"},
    {"Truncated", kGood.substr(0, kGood.size() - 1), "expected 88 bytes for 1 triangles, got 87"},
    {"Trailing", kGood + "x", "expected 88 bytes for 1 triangles, got 89"},
    {"CountBeyondNumbers", header(8, 8, 0, (uint64_t{1} << 32) + 1), "expected at most 2^32"},
    {"CountOverflows", header(8, 8, 0, ~uint64_t{0}), "expected at most 2^32 triangles"},
    {"WZero", with_w(0), "triangle 0 vertex 1: expected W > 0"},
    {"WNegative", with_w(-1), "triangle 0 vertex 1: expected W > 0"},
    {"WDenormal", with_w(1e-40f), "triangle 0 vertex 1: expected W > 0"},
    {"WInfinite", with_w(INFINITY), "triangle 0 vertex 1: expected W > 0"},
};

INSTANTIATE_TEST_SUITE_P(Ptrb, PtrbRefusal, testing::ValuesIn(kRefusals),
                         [](const auto& row) { return row.param.name; });

Options from(std::istream* stream, bool multi_pass = false) {
  Options options;
  options.input = stream;
  options.multi_pass = multi_pass;
  return options;
}

TEST(PtrbReader, FileAndPipeAndTextGiveTheSameTriangles) {
  const Scratch scratch;
  const auto file = open_scene(kContract, scratch.write("a.ptrb", kGood), {});
  std::istringstream stream(kGood);
  const auto pipe = open_scene(kContract, "-", from(&stream));
  const auto text = open_scene(kContract,
                               scratch.write("a.tri",
                                             "pineda-tri 1\nsize 8 8\nv 1 1 0 1 255 0 0 255\n"
                                             "v 5 1 .5 2 0 255 0 255\nv 1 5 1 .5 0 0 255 9\n"),
                               {});
  const auto expected = all_triangles(text.source.get());
  ASSERT_EQ(expected.size(), 1u);
  EXPECT_TRUE(same(expected, all_triangles(file.source.get())));
  EXPECT_TRUE(same(expected, all_triangles(pipe.source.get())));
  EXPECT_EQ(file.source->counters().perspective, 2u);
  file.source->rewind();
  EXPECT_EQ(file.source->counters().perspective, 0u);
  EXPECT_TRUE(same(expected, all_triangles(file.source.get())));
}

TEST(PtrbReader, FlagsChooseWAndCullAndDepth) {
  const Scratch scratch;
  const auto bytes = header(8, 9, 2 << 1 | 2 << 3, 1) + body(kTriangle, false);
  const auto opened = open_scene(kContract, scratch.write("a.ptrb", bytes), {});
  EXPECT_EQ(opened.frame.height, 9);
  EXPECT_EQ(opened.frame.cull, spec::Cull::kFront);
  EXPECT_EQ(opened.frame.depth, spec::DepthFunc::kOff);
  ASSERT_EQ(all_triangles(opened.source.get()).size(), 1u);
  EXPECT_EQ(opened.source->counters().perspective, 0u);
}

TEST(PtrbReader, NanInWDropsTheTriangle) {
  const Scratch scratch;
  const auto opened = open_scene(kContract, scratch.write("a.ptrb", with_w(NAN)), {});
  EXPECT_TRUE(all_triangles(opened.source.get()).empty());
  EXPECT_EQ(opened.source->counters().nan_dropped, 1u);
}

TEST(PtrbReader, PipeIsFoundTruncatedOrTooLongAtItsEnd) {
  std::istringstream cut(header(8, 8, 1, 2) + body(kTriangle, true) + "abc");
  EXPECT_TRUE(
      is_one_line_with(error_of("-", from(&cut)), "standard input: expected 2 triangles, got 1"));
  std::istringstream trailing(kGood + "x");
  EXPECT_TRUE(is_one_line_with(error_of("-", from(&trailing)),
                               "standard input: expected 1 triangles, got bytes after them"));
}

// The number is the triangle's, wherever it lies in what is read at once.
TEST(PtrbReader, NamesTheTriangleWhoseWIsRefused) {
  for (const uint64_t bad : {0u, 63u, 64u, 1023u, 1024u, 2999u}) {
    std::string bytes = header(8, 8, 1, 3000);
    for (uint64_t i = 0; i < 3000; ++i)
      bytes += i == bad ? with_w(-1).substr(28) : kGood.substr(28);
    std::istringstream stream(bytes);
    const auto opened = open_scene(kContract, "-", from(&stream));
    std::vector<spec::Triangle> all(3000);
    try {
      opened.source->next_many(all.data(), all.size());
      FAIL() << "expected an exception";
    } catch (const InputError& error) {
      EXPECT_TRUE(is_one_line_with(
          error.what(), "standard input: triangle " + std::to_string(bad) + " vertex 1"));
    }
  }
}

TEST(PtrbReader, ManyAtOnceFindATruncatedOrTooLongPipe) {
  const auto error_of_many = [](const std::string& bytes) {
    std::istringstream stream(bytes);
    const auto opened = open_scene(kContract, "-", from(&stream));
    std::vector<spec::Triangle> all(5);
    try {
      while (opened.source->next_many(all.data(), all.size()) > 0) continue;
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(error_of_many(kGood), "");
  EXPECT_TRUE(is_one_line_with(error_of_many(header(8, 8, 1, 2) + body(kTriangle, true) + "abc"),
                               "standard input: expected 2 triangles, got 1"));
  EXPECT_TRUE(is_one_line_with(error_of_many(kGood + "x"),
                               "standard input: expected 1 triangles, got bytes after them"));
}

TEST(PtrbReader, PipeRewindsOnlyWithMultiPass) {
  std::istringstream once(kGood);
  const auto single = open_scene(kContract, "-", from(&once));
  EXPECT_EQ(all_triangles(single.source.get()).size(), 1u);
  EXPECT_THROW(single.source->rewind(), InputError);

  std::istringstream spooled(kGood);
  const auto multi = open_scene(kContract, "-", from(&spooled, true));
  const auto first = all_triangles(multi.source.get());
  multi.source->rewind();
  EXPECT_TRUE(same(first, all_triangles(multi.source.get())));
}

TEST(PtrbReader, SpooledPipeIsCheckedBeforeAnythingIsDrawn) {
  for (const std::string& bytes : {kGood + "x", kGood.substr(0, kGood.size() - 1)}) {
    std::istringstream stream(bytes);
    EXPECT_THROW(open_scene(kContract, "-", from(&stream, true)), InputError);
  }
}

// An endless stream without storage: the header, then the same triangle again and again.
class EndlessBuffer : public std::streambuf {
 public:
  explicit EndlessBuffer(uint64_t triangles)
      : next_(header(8, 8, 0, triangles)), triangle_(body(kTriangle, false)), left_(triangles) {}

 protected:
  int_type underflow() override {
    if (sent_ && left_ == 0) return traits_type::eof();
    if (sent_) {
      --left_;
      next_ = triangle_;
    }
    sent_ = true;
    setg(next_.data(), next_.data(), next_.data() + next_.size());
    return traits_type::to_int_type(next_[0]);
  }

 private:
  std::string next_;
  std::string triangle_;
  uint64_t left_;
  bool sent_ = false;
};

int64_t peak_kilobytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST(PtrbReader, LongPipesTakeNoMoreMemoryThanShortOnes) {
  constexpr uint64_t kTriangles = 1000000;  // 48 MB
  for (const bool multi_pass : {false, true}) {
    EndlessBuffer buffer(kTriangles);
    std::istream stream(&buffer);
    const int64_t before = peak_kilobytes();
    const auto opened = open_scene(kContract, "-", from(&stream, multi_pass));
    spec::Triangle last;
    uint64_t count = 0;
    while (opened.source->next(&last)) ++count;
    EXPECT_EQ(count, kTriangles);
    EXPECT_EQ(last.id, kTriangles - 1);
    EXPECT_LT(peak_kilobytes() - before, 4096);
  }
}

}  // namespace
}  // namespace pineda::scene
