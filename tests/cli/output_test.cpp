// Files that the program writes, and places where it cannot.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/cli/frames.h"
#include "tests/cli/program.h"

namespace pineda::test {
namespace {

bool is_png_of(const std::string& bytes, uint32_t width, uint32_t height) {
  if (bytes.size() < 24 || bytes.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0) return false;
  const auto number = [&](size_t at) {  // big-endian
    uint32_t value = 0;
    for (size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<uint8_t>(bytes[at + i]);
    return value;
  };
  return number(16) == width && number(20) == height;
}

TEST(Pictures, HaveTheSizeOfTheFrame) {
  const Scratch scratch;
  const std::string text = scratch.write("scene.tri", tri_text(frame("TileBorders")));
  for (const char* command : {"render", "rtl", "check"}) {
    const std::string folder = std::string("new/") + command;
    EXPECT_TRUE(ended_silently(pineda({command, text, "-o", scratch.path(folder)})));
    for (const char* name : {"/color.png", "/depth.png"}) {
      EXPECT_TRUE(is_png_of(read_bytes(scratch.path(folder + name)), 41, 27)) << command << name;
    }
  }
}

TEST(Report, HoldsTheFiguresAndNoMarkupOfTheScene) {
  const Scratch scratch;
  const std::string text = scratch.write("<b>&scene.tri", tri_text(frame("TileBorders")));
  EXPECT_TRUE(ended_silently(pineda({"check", text, "-o", scratch.path("out")})));
  const std::string page = read_bytes(scratch.path("out/report.html"));
  EXPECT_NE(page.find("&lt;b&gt;&amp;scene"), std::string::npos);
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_NE(page.find("41 x 27"), std::string::npos);
  EXPECT_EQ(page.substr(page.size() - 8), "</html>\n");
  const Json json = Json::parse(read_bytes(scratch.path("out/check.json")));
  EXPECT_EQ(json.at("mismatches"), 0);
}

TEST(Trace, IsAWaveformUnderItsNameAlone) {
  const Scratch scratch;
  const std::string wave = scratch.path("wave.fst");
  EXPECT_TRUE(ended_silently(pineda({"rtl", "triangle", "--size", "16x16", "--trace", wave})));
  EXPECT_EQ(scratch.files(), Arguments{"wave.fst"});
  const std::string bytes = read_bytes(wave);
  EXPECT_GT(bytes.size(), 1000);
  // An FST file starts with a header block: type 0, length 329.
  EXPECT_EQ(bytes.substr(0, 9), std::string("\0\0\0\0\0\0\0\x01\x49", 9));
}

TEST(Trace, ChangesNoBit) {
  const Scratch scratch;
  const std::string text = scratch.write("scene.tri", tri_text(frame("TileBorders")));
  const Json plain = figures({"rtl", text, "--dump", scratch.path("plain")});
  const Json traced =
      figures({"rtl", text, "--dump", scratch.path("traced"), "--trace", scratch.path("wave.fst")});
  EXPECT_EQ(plain.at("cycles"), traced.at("cycles"));
  EXPECT_TRUE(read_bytes(scratch.path("plain/color.rgba")) ==
              read_bytes(scratch.path("traced/color.rgba")));
}

struct BadPlace {
  std::string name;
  Arguments arguments;
};
std::ostream& operator<<(std::ostream& to, const BadPlace& bad) { return to << bad.name; }

class UnwritablePlace : public testing::TestWithParam<BadPlace> {};

// In the scratch folder "file" is a file, "folder" and "folder.fst" are folders.
TEST_P(UnwritablePlace, IsNamedInOneLine) {
  const Scratch scratch;
  scratch.write("file", "older");
  std::filesystem::create_directory(scratch.path("folder"));
  std::filesystem::create_directory(scratch.path("folder.fst"));
  Arguments arguments = GetParam().arguments;
  arguments.emplace_back("--quiet");
  const Outcome run = pineda(arguments, inside(scratch.path(".")));
  EXPECT_TRUE(is_refused(run, GetParam().arguments.back()));
  EXPECT_EQ(scratch.files(), Arguments{"file"});
  EXPECT_EQ(read_bytes(scratch.path("file")), "older");
}

INSTANTIATE_TEST_SUITE_P(
    Cli, UnwritablePlace,
    testing::Values(BadPlace{"RenderPictures", {"render", "triangle", "-o", "file"}},
                    BadPlace{"RenderDump", {"render", "triangle", "--dump", "file"}},
                    BadPlace{"RenderJson", {"render", "triangle", "--json", "folder"}},
                    BadPlace{"RtlPictures", {"rtl", "triangle", "-o", "file"}},
                    BadPlace{"RtlDump", {"rtl", "triangle", "--dump", "file"}},
                    BadPlace{"RtlTrace", {"rtl", "triangle", "--trace", "folder.fst"}},
                    BadPlace{"RtlTraceBelowAFile", {"rtl", "triangle", "--trace", "file/a.fst"}},
                    BadPlace{"CheckReport", {"check", "triangle", "-o", "file"}},
                    BadPlace{"CheckJson", {"check", "triangle", "--json", "folder"}},
                    BadPlace{"TimeJson", {"time", "triangle", "--json", "folder"}},
                    BadPlace{"DesignsJson", {"designs", "--json", "folder"}}),
    [](const auto& param) { return param.param.name; });

class BelowAFile : public testing::TestWithParam<BadPlace> {};

TEST_P(BelowAFile, IsRefusedInOneLine) {
  const Scratch scratch;
  scratch.write("file", "older");
  Arguments arguments = GetParam().arguments;
  arguments.insert(arguments.end(), {"file/below", "--quiet"});
  EXPECT_TRUE(is_refused(pineda(arguments, inside(scratch.path("."))), "file"));
  EXPECT_EQ(scratch.files(), Arguments{"file"});
  EXPECT_EQ(read_bytes(scratch.path("file")), "older");
}

INSTANTIATE_TEST_SUITE_P(Cli, BelowAFile,
                         testing::Values(BadPlace{"RenderPictures", {"render", "triangle", "-o"}},
                                         BadPlace{"RenderDump", {"render", "triangle", "--dump"}},
                                         BadPlace{"RtlDump", {"rtl", "triangle", "--dump"}},
                                         BadPlace{"CheckReport", {"check", "triangle", "-o"}},
                                         BadPlace{"TimeJson", {"time", "triangle", "--json"}}),
                         [](const auto& param) { return param.param.name; });

TEST(StandardOutput, ThatIsFullIsNotSilentlyLost) {
  Surroundings full;
  full.out = "/dev/full";
  const std::vector<Arguments> prints{{"render", "triangle"},
                                      {"render", "triangle", "--json", "-"},
                                      {"check", "triangle", "--json", "-", "--quiet"},
                                      {"designs"}};
  for (const auto& arguments : prints) {
    const Outcome run = pineda(arguments, full);
    EXPECT_EQ(run.exit_code, 2) << testing::PrintToString(arguments);
    EXPECT_NE(run.err.find("standard output"), std::string::npos) << run.err;
  }
}

/// A pipe or a link is written to, not replaced by a file.
TEST(Json, GoesIntoAPipe) {
  const Scratch scratch;
  const std::string pipe = scratch.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  // Open at both ends from the start, so that neither side blocks while it waits for the other.
  const int ends = open(pipe.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(ends, 0);
  EXPECT_TRUE(ended_silently(pineda({"render", "triangle", "--quiet", "--json", pipe})));
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  std::string received(1 << 16, '\0');
  const ssize_t count = read(ends, received.data(), received.size());
  close(ends);
  ASSERT_GT(count, 0);
  received.resize(static_cast<size_t>(count));
  EXPECT_EQ(Json::parse(received).at("triangles"), 1);
}

TEST(Json, GoesWhereALinkLeads) {
  const Scratch scratch;
  scratch.write("target.json", "older");
  std::filesystem::create_symlink("target.json", scratch.path("link.json"));
  EXPECT_TRUE(ended_silently(
      pineda({"render", "triangle", "--quiet", "--json", scratch.path("link.json")})));
  EXPECT_TRUE(std::filesystem::is_symlink(scratch.path("link.json")));
  EXPECT_EQ(Json::parse(read_bytes(scratch.path("target.json"))).at("triangles"), 1);
}

}  // namespace
}  // namespace pineda::test
