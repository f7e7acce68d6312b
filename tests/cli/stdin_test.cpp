// A .ptrb on standard input.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string_view>

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
      json->erase("stream");  // seconds, too
      json->erase("sides");   // hold seconds too
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

/// Writes `count` triangles without area, which every model drops at once. Written piece by piece:
/// memory of this process would count for its children, too.
std::string write_long_scene(const Scratch& scratch, uint64_t count) {
  constexpr uint64_t kPiece = 1000;
  Scene scene{8, 8, Cull::kNone, Depth::kLess, {}};
  scene.triangles.assign(kPiece, {Vertex{1, 1}, Vertex{2, 2}, Vertex{3, 3}});
  std::string bytes = ptrb_bytes(scene);
  const size_t header = bytes.size() - kPiece * 48;
  for (size_t i = 0; i < 8; ++i) bytes[header - 8 + i] = static_cast<char>(count >> 8 * i & 0xff);
  const std::string path = scratch.write("long.ptrb", bytes);
  std::ofstream file(path, std::ios::binary | std::ios::app);
  for (uint64_t i = 1; i < count / kPiece; ++i) file << std::string_view(bytes).substr(header);
  return path;
}

TEST(StandardInput, NeedsNoMoreMemoryForMoreTriangles) {
  const Scratch scratch;
  for (const char* command : {"render", "time"}) {
    const auto peak_kib = [&](uint64_t triangles) {
      Surroundings surroundings;
      surroundings.in = write_long_scene(scratch, triangles);
      const Outcome run = pineda({command, "-", "--json", "-", "--quiet"}, surroundings);
      EXPECT_EQ(run.json().at("triangles"), triangles);
      return run.peak_kib;
    };
    // The file grows by 19 MB, so a program that held it would need more.
    EXPECT_LT(peak_kib(400000), peak_kib(5000) + 4000) << command;
  }
}

/// Many small triangles, some of which hide others; several chunks of them.
Scene many_triangles() {
  Scene scene{64, 48, Cull::kNone, Depth::kLess, {}};
  for (uint32_t i = 0; i < 10000; ++i) {
    const auto of = [i](uint32_t step, uint32_t range) {
      return static_cast<float>(i * step % (range * 16)) / 16;
    };
    const Vertex a{of(7, 64), of(11, 48), of(13, 1)};
    scene.triangles.push_back({a, Vertex{a.x + of(3, 5), a.y, a.z}, Vertex{a.x, a.y + 4, a.z}});
    for (Vertex& v : scene.triangles.back()) v.rgba = {static_cast<uint8_t>(i), 0, 9, 255};
  }
  return scene;
}

// With --bench all triangles are read before the first one is drawn.
TEST(StandardInput, DrawnWhileItIsReadIsTheFrameOfTheWhole) {
  const Scratch scratch;
  const std::string bytes = ptrb_bytes(many_triangles());
  const std::string file = scratch.write("scene.ptrb", bytes);
  const auto frame_of = [&](Arguments arguments, Json* json) {
    arguments.insert(arguments.begin(), "render");
    arguments.insert(arguments.end(), {"--dump", scratch.path("dump")});
    *json = figures(arguments, piped(bytes));
    return read_bytes(scratch.path("dump/hits.u16")) + read_bytes(scratch.path("dump/depth.u32")) +
           read_bytes(scratch.path("dump/color.rgba"));
  };
  Json whole_json;
  const std::string whole = frame_of({file, "--bench", "1"}, &whole_json);
  EXPECT_FALSE(whole_json.contains("stream"));
  for (const Arguments& arguments :
       {Arguments{file}, Arguments{"-"}, Arguments{"-", "--threads", "2"}}) {
    Json json;
    EXPECT_TRUE(frame_of(arguments, &json) == whole) << testing::PrintToString(arguments);
    EXPECT_EQ(json.at("counters"), whole_json.at("counters"));
    EXPECT_EQ(json.at("input"), whole_json.at("input"));
    const Json& stream = json.at("stream");
    EXPECT_GE(stream.at("seconds"), json.at("seconds"));
    EXPECT_NEAR(stream.at("megabytes_per_second").get<double>(),
                static_cast<double>(bytes.size()) * 1e-6 / stream.at("seconds").get<double>(),
                1e-3);
  }
}

TEST(StandardInput, OfManyChunksIsRefusedWhereItIsCut) {
  const std::string bytes = ptrb_bytes(many_triangles());
  for (const char* command : {"render", "time"}) {
    const Outcome cut =
        pineda({command, "-", "--quiet"}, piped(bytes.substr(0, bytes.size() - 48 * 2000 - 1)));
    EXPECT_EQ(cut.exit_code, 2);
    EXPECT_EQ(cut.err, "pineda: standard input: expected 10000 triangles, got 7999\n");
    const Outcome trailing = pineda({command, "-", "--quiet"}, piped(bytes + "x"));
    EXPECT_EQ(trailing.exit_code, 2);
    EXPECT_EQ(trailing.err,
              "pineda: standard input: expected 10000 triangles, got bytes after them\n");
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
      const Outcome run =
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
