// Files that must be refused, each with its message of one line.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/spec/names.h"
#include "tests/vectors/samples.h"

namespace pineda::vectors {
namespace {

// The text with the first `from` replaced by `to`.
std::string changed(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

// Line `number` (from 1) of the text.
std::string line(const std::string& text, int number) {
  size_t from = 0;
  for (int i = 1; i < number; ++i) from = text.find('\n', from) + 1;
  return text.substr(from, text.find('\n', from) - from);
}

// Number of the line in which `part` begins; a part that begins with a line's end counts as there.
int line_of(const std::string& text, const std::string& part) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(text.find(part));
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

template <class Case>
std::string refusal(const std::string& text) {
  try {
    read_text<Case>("f.txt", text);
  } catch (const Refused& error) {
    return error.what();
  }
  return "taken";
}

void expect_refusal(const std::string& got, int number, const std::string& part) {
  EXPECT_EQ(got.find(fmt::format("f.txt:{}: expected ", number)), 0u) << got;
  EXPECT_NE(got.find(part), std::string::npos) << got;
  EXPECT_EQ(got.find('\n'), std::string::npos) << got;
}

class Refusal : public testing::Test {
 protected:
  const std::string setup_ = write_text(sample_file<SetupCase>());
  const std::string traversal_ = write_text(sample_file<TraversalCase>());
  const std::string interp_ = write_text(sample_file<InterpZtestCase>());
  const std::string frame_ = write_text(sample_file<FrameCase>());

  // The line with the hash of the content in setup_, the last one.
  int content_line() const { return line_of(setup_, "\ncontent") + 1; }
};

TEST_F(Refusal, UnchangedFileIsTaken) {
  EXPECT_EQ(refusal<SetupCase>(setup_), "taken");
  EXPECT_EQ(refusal<TraversalCase>(traversal_), "taken");
  EXPECT_EQ(refusal<InterpZtestCase>(interp_), "taken");
  EXPECT_EQ(refusal<FrameCase>(frame_), "taken");
}

TEST_F(Refusal, OtherVersion) {
  expect_refusal(refusal<SetupCase>(changed(setup_, "vectors 2", "vectors 3")), 1,
                 "'pineda-vectors 2', got 'pineda-vectors 3'");
}

TEST_F(Refusal, EmptyFile) { expect_refusal(refusal<SetupCase>(""), 1, "the end of the file"); }

TEST_F(Refusal, OtherUnit) {
  expect_refusal(refusal<SetupCase>(traversal_), 2, "the unit setup, got traversal");
}

TEST_F(Refusal, UnknownUnit) {
  expect_refusal(refusal<SetupCase>(changed(setup_, "unit setup", "unit rop")), 2, "got rop");
}

TEST_F(Refusal, UnknownDesign) {
  expect_refusal(refusal<SetupCase>(changed(setup_, "high_tile", "high_tide")), 3, "got high_tide");
}

TEST_F(Refusal, SeedThatIsNoNumber) {
  expect_refusal(refusal<SetupCase>(changed(setup_, "seed 5", "seed 5x")), 5, "got '5x'");
}

TEST_F(Refusal, StaleFormatsHash) {
  const std::string present = line(setup_, 6).substr(8);
  const std::string stale = "0123456789abcdef";
  const std::string got = refusal<SetupCase>(changed(setup_, present, stale));
  expect_refusal(got, 6, present);
  EXPECT_NE(got.find("got " + stale), std::string::npos) << got;
}

TEST_F(Refusal, WrongCount) {
  expect_refusal(refusal<SetupCase>(changed(setup_, "cases 2", "cases 3")),
                 line_of(setup_, "\ncases") + 1, "'cases 2', as the file holds, got 'cases 3'");
}

TEST_F(Refusal, WrongContentHash) {
  const int number = content_line();
  const std::string hash = line(setup_, number).substr(8);
  const std::string got = refusal<SetupCase>(changed(setup_, hash, "fedcba9876543210"));
  expect_refusal(got, number, hash);
}

TEST_F(Refusal, SomethingBehindTheEnd) {
  expect_refusal(refusal<SetupCase>(setup_ + "case more.0\n"), content_line() + 1,
                 "the end of the file, got 'case more.0'");
}

TEST_F(Refusal, OneDigitOfAnOutputChanged) {
  std::string text = setup_;
  char& digit = text[text.rfind("setup_prim") + 30];
  ASSERT_NE(digit, ' ');
  digit = digit == '0' ? '1' : '0';
  expect_refusal(refusal<SetupCase>(text), content_line(), "the hash");
}

TEST_F(Refusal, ColumnsOfOtherNames) {
  expect_refusal(refusal<SetupCase>(changed(setup_, "width height", "height width")), 7,
                 "'columns frame width height cull depth depth_write");
}

TEST_F(Refusal, CutInsideALine) {
  const std::string cut = setup_.substr(0, setup_.rfind("setup_prim") + 22);
  const int last = 1 + static_cast<int>(std::count(cut.begin(), cut.end(), '\n'));
  expect_refusal(refusal<SetupCase>(cut), last, "4 hex digits of setup_prim x0, got '00'");
}

TEST_F(Refusal, CutBetweenTwoLinesOfACase) {
  const std::string cut = setup_.substr(0, setup_.rfind("end\n"));
  const int last = static_cast<int>(std::count(cut.begin(), cut.end(), '\n'));
  expect_refusal(refusal<SetupCase>(cut), last + 1,
                 "'end' of case sample.0, got the end of the file");
}

TEST_F(Refusal, CutBetweenTwoCases) {
  const std::string cut = setup_.substr(0, setup_.rfind("\ncase "));
  const int last = static_cast<int>(std::count(cut.begin(), cut.end(), '\n'));
  expect_refusal(refusal<SetupCase>(cut), last + 1, "'case' and its name, got the end of the file");
}

TEST_F(Refusal, BadHex) {
  const int number = line_of(setup_, "\ntriangle") + 1;
  expect_refusal(refusal<SetupCase>(changed(setup_, "triangle 00000000", "triangle 0000000G")),
                 number, "8 hex digits of triangle id, got '0000000G'");
  expect_refusal(refusal<SetupCase>(changed(setup_, "triangle 00000000", "triangle 0000000")),
                 number, "8 hex digits of triangle id, got '0000000'");
  expect_refusal(refusal<SetupCase>(changed(setup_, "triangle 00000000", "triangle  00000000")),
                 number, "got ''");
}

TEST_F(Refusal, ValueWiderThanItsField) {
  // x has 23 bits in six digits: the top bit of the first digit must be 0.
  expect_refusal(
      refusal<SetupCase>(changed(setup_, "triangle 00000000 000080", "triangle 00000000 800080")),
      line_of(setup_, "\ntriangle") + 1, "a value of 23 bits for triangle x[0], got '800080'");
}

TEST_F(Refusal, ColumnTooMany) {
  expect_refusal(refusal<SetupCase>(changed(setup_, "drop zero_area", "drop zero_area 0")),
                 line_of(setup_, "drop"), "'drop' and zero_area");
  const int number = line_of(setup_, "\nframe") + 1;
  const std::string frame = line(setup_, number);
  expect_refusal(refusal<SetupCase>(changed(setup_, frame, frame + " 0")), number,
                 "12 columns of frame, got 13");
}

TEST_F(Refusal, UnknownCauseOfADrop) {
  expect_refusal(refusal<SetupCase>(changed(setup_, "drop zero_area", "drop kept")),
                 line_of(setup_, "drop"), "got 'drop kept'");
}

TEST_F(Refusal, TriangleWithoutAnOutcome) {
  expect_refusal(refusal<SetupCase>(changed(setup_, "drop zero_area\n", "")),
                 line_of(setup_, "\nend"), "for triangle 2, got 'end'");
}

TEST_F(Refusal, StateThatMeansNothing) {
  const int number = line_of(setup_, "\nframe") + 1;
  const auto with = [&](const char* state) {
    return refusal<SetupCase>(changed(setup_, "frame 0007 0006 0 0", state));
  };
  expect_refusal(with("frame 0000 0006 0 0"), number, "a frame of 1 x 1 to 16384 x 16384 px");
  expect_refusal(with("frame 0007 0006 3 0"), number, "cull 0, 1 or 2");
  expect_refusal(with("frame 0007 0006 0 9"), number, "depth 0 to 8");
}

// The line follows the frame's. The greatest code is never written, so that a case has one form
// only.
TEST_F(Refusal, ClearDepthThatIsNone) {
  const int number = line_of(setup_, "\nframe") + 2;
  const std::string frame = line(setup_, number - 1);
  const auto with = [&](const char* text) {
    return refusal<SetupCase>(changed(setup_, frame + "\n", frame + "\n" + text + "\n"));
  };
  expect_refusal(with("clear_depth ffffff"), number, "a code less than the greatest");
  expect_refusal(with("clear_depth 000000 1"), number, "a code less than the greatest");
  expect_refusal(with("clear_depth 00000"), number, "6 hex digits of clear_depth, got '00000'");
  expect_refusal(with("clear_depth"), number, "clear_depth");
  expect_refusal(with("clear_depth 000000"), content_line() + 1, "the hash");  // valid but for that
}

// The line follows the frame's; ports that do not stall have none.
TEST_F(Refusal, StallsThatAreNone) {
  const int number = line_of(setup_, "\nframe") + 2;
  const std::string frame = line(setup_, number - 1);
  const auto with = [&](const char* text) {
    return refusal<SetupCase>(changed(setup_, frame + "\n", frame + "\n" + text + "\n"));
  };
  const char* expected = "'stalls', source, sink or both, and a seed";
  expect_refusal(with("stalls none 0000000000000000"), number, expected);
  expect_refusal(with("stalls all 0000000000000000"), number, expected);
  expect_refusal(with("stalls sink"), number, expected);
  expect_refusal(with("stalls sink 12"), number, "16 hex digits of stalls, got '12'");
  expect_refusal(with("stalls sink 0000000000000000"), content_line() + 1, "the hash");
}

TEST_F(Refusal, ResetThatIsNone) {
  const int number = line_of(frame_, "\ncounters") + 1;
  const auto with = [&](const char* text) {
    return refusal<FrameCase>(
        changed(frame_, "\ncounters ", std::string("\n") + text + "\ncounters "));
  };
  expect_refusal(with("reset"), number, "reset");
  expect_refusal(with("reset soon"), number, "a decimal number for reset, got 'soon'");
  expect_refusal(with("reset 9 9"), number, "'reset' and a cycle");
}

TEST_F(Refusal, StampOutsideTheFrame) {
  const std::string address = "stamp 00000000 0000 0000 ";
  const int number = line_of(interp_, address);
  for (const char* moved : {"stamp 00000000 0004 0000 ", "stamp 00000000 0000 0003 "}) {
    expect_refusal(refusal<InterpZtestCase>(changed(interp_, address, moved)), number,
                   "a stamp that covers samples of the frame, and no others");
  }
}

TEST_F(Refusal, SampleOfNoFrame) {
  const int number = line_of(frame_, "\nsample ") + 1;
  const std::string first = line(frame_, number), second = line(frame_, number + 1);
  const auto with = [&](const std::string& text) {
    return refusal<FrameCase>(changed(frame_, first + "\n", text + "\n"));
  };
  const std::string behind_place = first.substr(std::string("sample 0000 0000").size());
  expect_refusal(with("sample 0007 0000" + behind_place), number, "samples of the frame");
  expect_refusal(with("sample 0000 0006" + behind_place), number, "samples of the frame");
  expect_refusal(with(first + "\n" + first), number + 1, "samples of the frame, row by row");
  expect_refusal(with(first + " 0"), number, "5 columns of sample");
  expect_refusal(with(first.substr(0, first.size() - 5)), number, "sample hits");
  expect_refusal(with("sample 0000 0000 ffffff 00 0001"), number,
                 "8 hex digits of sample color, got '00'");
}

TEST(RefusalOfAPath, FileThatDoesNotExist) {
  for (const auto read_it : {+[] { read<SetupCase>("absent.txt"); },
                             +[] { static_cast<void>(read_header("absent.txt")); }}) {
    try {
      read_it();
      FAIL() << "taken";
    } catch (const Refused& error) {
      EXPECT_EQ(std::string(error.what()).find("absent.txt: expected "), 0u) << error.what();
    }
  }
}

TEST(Names, OfUnitsAndDropsAreWholeAndInOrder) {
  EXPECT_EQ(spec::fault(kUnitNames, Unit::kFrame), "");
  EXPECT_EQ(spec::fault(core::kDropNames, core::Drop::kOutside), "");
  EXPECT_EQ(spec::alternatives<Unit>(), "setup, traversal, interp_ztest or frame");
}

}  // namespace
}  // namespace pineda::vectors
