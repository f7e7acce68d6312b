#include "model/scene/readers/lines.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

#include "model/spec/random.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

// Compares bits, so that signs and NaNs count.
template <class T, class Strto>
void expect_as_strto(const std::string& word, Strto strto) {
  T value = 0;
  char* end = nullptr;
  const T expected = strto(word.c_str(), &end);
  const bool is_number = end != word.c_str() && *end == '\0';
  ASSERT_EQ(parse_number(word.c_str(), word.c_str() + word.size(), &value), is_number) << word;
  if (is_number) {
    ASSERT_EQ(std::memcmp(&value, &expected, sizeof value), 0) << word;
  }
}

void expect_as_strto(const std::string& word) {
  expect_as_strto<float>(word, std::strtof);
  expect_as_strto<double>(word, std::strtod);
}

constexpr const char* kWords[] = {"0",
                                  "-0",
                                  "+0",
                                  "1.",
                                  ".5",
                                  "-.5",
                                  "+.5",
                                  ".",
                                  "-",
                                  "+",
                                  "e5",
                                  "1e",
                                  "1e+",
                                  "1e5",
                                  "1E-5",
                                  "0x1p3",
                                  "-0x1.8p-149",
                                  "0x",
                                  "0x.p1",
                                  "inf",
                                  "-inf",
                                  "+INFINITY",
                                  "infinit",
                                  "nan",
                                  "-nan",
                                  "NAN(7)",
                                  "-nan(0x12)",
                                  "nan(",
                                  "1e39",
                                  "-1e39",
                                  "1e-46",
                                  "1e-400",
                                  "1e400",
                                  "1.17549435e-38",
                                  "1.4e-45",
                                  "7e-46",
                                  "16777217",
                                  "16777217.0000000001",
                                  "3.4028235677973366e38",
                                  "1,5",
                                  "1.5f",
                                  "1_000",
                                  "--1",
                                  "1-",
                                  "0.1e1e1",
                                  "00012",
                                  "1e0005",
                                  "4.9406564584124654e-324"};

TEST(ParseNumber, EveryFormOfANumberIsReadAsStrtofAndStrtodReadIt) {
  for (const char* word : kWords) expect_as_strto(word);
}

TEST(ParseNumber, RandomLettersAreReadAsStrtofAndStrtodReadThem) {
  spec::Random random(1);
  const std::string letters = "0123456789.-+eExpnaif";
  for (int trial = 0; trial < 100000; ++trial) {
    std::string word;
    const size_t length = 1 + random.bits() % 12;
    for (size_t i = 0; i < length; ++i) {
      word += letters[random.bits() % (trial % 2 == 0 ? letters.size() : size_t{14})];
    }
    expect_as_strto(word);
  }
}

TEST(ParseNumber, RandomNumbersAreReadAsStrtofAndStrtodReadThem) {
  spec::Random random(2);
  for (int trial = 0; trial < 100000; ++trial) {
    double value = 0;
    const uint64_t bits = random.bits();
    std::memcpy(&value, &bits, sizeof value);
    char text[64];
    std::snprintf(text, sizeof text, trial % 2 == 0 ? "%.9g" : "%.17g",
                  trial % 3 == 0 ? value : static_cast<double>(static_cast<float>(bits) * 1e-30F));
    expect_as_strto(text);
  }
}

TEST(LineReader, LinesAndWordsAreWholeAcrossBlocks) {
  // Lengths that are coprime to any block size.
  std::string text;
  std::vector<std::string> expected;
  for (int i = 0; i < 3000; ++i) {
    expected.push_back(
        std::string(static_cast<size_t>(1 + i % 97), static_cast<char>('a' + i % 26)));
    text += expected.back() + (i % 3 == 0 ? " # comment\r\n" : "\n");
  }
  const Scratch scratch;
  const auto path = scratch.write("a", text);
  LineReader lines(path, open_file(path));
  for (int pass = 0; pass < 2; ++pass) {
    for (size_t i = 0; i < expected.size(); ++i) {
      ASSERT_TRUE(lines.next());
      ASSERT_EQ(lines.line(), i + 1);
      ASSERT_EQ(lines.words().size(), 1u);
      ASSERT_EQ(lines.words()[0], expected[i]);
    }
    EXPECT_FALSE(lines.next());
    lines.rewind();
  }
}

}  // namespace
}  // namespace pineda::scene
