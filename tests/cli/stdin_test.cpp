// A .ptrb on standard input.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/frames.h"
#include "tests/cli/program.h"

namespace pineda::test {
namespace {

Surroundings piped(const std::string& bytes) {
  Surroundings surroundings;
  surroundings.input = bytes;
  return surroundings;
}

TEST(StandardInput, GivesTheFiguresOfTheFile) {
  const Scratch scratch;
  const std::string bytes = ptrb_bytes(frame("JitteredMesh"), true);
  const std::string file = scratch.write("scene.ptrb", bytes);
  for (const auto& command : kSceneCommands) {
    Json from_file = figures({command, file});
    Json from_pipe = figures({command, "-"}, piped(bytes));
    for (Json* json : {&from_file, &from_pipe}) {
      json->erase("scene");  // its name
      json->erase("seconds");
      json->erase("sides");  // hold seconds too
    }
    EXPECT_EQ(from_file, from_pipe) << command;
  }
}

TEST(StandardInput, GivesTheDumpsOfTheFile) {
  const Scratch scratch;
  const std::string bytes = ptrb_bytes(frame("CullBackDepthLequal"));
  const std::string file = scratch.write("scene.ptrb", bytes);
  for (const char* command : {"render", "rtl"}) {
    const auto dump = [&](const std::string& scene, const Arguments& more) {
      Arguments arguments{command, scene, "--quiet", "--dump", scratch.path("dump")};
      arguments.insert(arguments.end(), more.begin(), more.end());
      EXPECT_TRUE(ended_silently(pineda(arguments, piped(bytes))))
          << command << " " << testing::PrintToString(more);
      return read_bytes(scratch.path("dump/hits.u16")) +
             read_bytes(scratch.path("dump/depth.u32")) +
             read_bytes(scratch.path("dump/color.rgba"));
    };
    const std::string expected = dump(file, {});
    EXPECT_TRUE(dump("-", {}) == expected) << command;
    EXPECT_TRUE(dump("-", {"--bench", "2"}) == expected) << command;
  }
}

TEST(StandardInput, NeedsNoMoreMemoryForMoreTriangles) {
  const Scene few = pile(8, 8, 1, 71);
  Scene many = few;
  // All but one are without area: dropped at once.
  many.triangles.resize(400000, {Vertex{1, 1}, Vertex{2, 2}, Vertex{3, 3}});
  const std::string bytes = ptrb_bytes(many);
  for (const char* command : {"render", "time"}) {
    const Run short_run = pineda({command, "-", "--quiet"}, piped(ptrb_bytes(few)));
    const Run long_run = pineda({command, "-", "--quiet"}, piped(bytes));
    EXPECT_TRUE(ended_silently(short_run));
    EXPECT_TRUE(ended_silently(long_run));
    // One chunk of triangles may lie in memory; all of them are 19 MB as a file alone.
    EXPECT_LT(long_run.peak_kib, short_run.peak_kib + 6000) << command;
  }
}

TEST(Perspective, IsWarnedOfOnce) {
  Scene scene = frame("TileBorders");
  const Scratch scratch;
  for (const auto& command : kSceneCommands) {
    EXPECT_TRUE(ended_silently(pineda({command, "-", "--quiet"}, piped(ptrb_bytes(scene, true)))))
        << command;
  }
  scene.triangles[3][1].w = 2;
  scene.triangles[5][0].w = .5f;
  const std::string text = scratch.write("scene.tri", tri_text(scene));
  for (const auto& command : kSceneCommands) {
    for (const std::string& from : {text, std::string("-")}) {
      const Run run =
          pineda({command, from, "--quiet", "--json", "-"}, piped(ptrb_bytes(scene, true)));
      EXPECT_EQ(run.exit_code, 0) << command;
      EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << command << run.err;
      EXPECT_NE(run.err.find("2 vertices with W"), std::string::npos) << command << run.err;
      EXPECT_EQ(run.json().at("input").at("perspective"), 2) << command;
    }
  }
}

}  // namespace
}  // namespace pineda::test
