// Frames must be right by themselves, not only the same in both models.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/frames.h"
#include "tests/cli/program.h"
#include "tests/cli/verdict.h"

namespace pineda::test {
namespace {

/// The dump that one command makes of a scene.
Dump dump_of(const Scene& scene, const std::string& command = "render") {
  const Scratch scratch;
  const std::string file = scratch.write("scene.ptrb", ptrb_bytes(scene));
  const Outcome run = pineda({command, file, "--quiet", "--dump", scratch.path("dump")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return read_dump(scratch.path("dump"), scene);
}

TEST(Verdict, OneWrongSampleIsFound) {
  const Scene scene = frame("CullNoneDepthLess");
  const Dump right = dump_of(scene);
  ASSERT_TRUE(judge(scene, right).holds());
  const size_t drawn = static_cast<size_t>(
      std::find_if(right.hits.begin(), right.hits.end(), [](uint16_t hits) { return hits > 0; }) -
      right.hits.begin());
  Dump wrong = right;
  ++wrong.hits.at(drawn);
  EXPECT_EQ(judge(scene, wrong).wrong_hits, 1);
  wrong = right;
  wrong.depth.at(drawn) += 2;
  EXPECT_EQ(judge(scene, wrong).wrong_depths, 1);
  wrong = right;
  wrong.color.at(drawn)[2] ^= 2;
  EXPECT_EQ(judge(scene, wrong).wrong_colors, 1);
}

TEST(SharedEdges, JitteredMeshHitsEverySampleOnce) {
  for (const char* name : {"JitteredMesh", "OddFrame"}) {
    for (const uint16_t hits : dump_of(frame(name)).hits) ASSERT_EQ(hits, 1) << name;
  }
}

TEST(SharedEdges, HalfPixelMeshHitsEverySampleOnce) {
  for (const char* command : {"render", "rtl"}) {
    for (const uint16_t hits : dump_of(frame("HalfPixelMesh"), command).hits) {
      ASSERT_EQ(hits, 1) << command;
    }
  }
}

TEST(Slivers, OfOneUnitDrawTheSamplesTheyCover) {
  const Verdict verdict = judge(frame("Slivers"), dump_of(frame("Slivers")));
  EXPECT_TRUE(verdict.holds()) << verdict;
  // About half of them own the sample they touch; none can own two.
  EXPECT_GT(verdict.covered, 100);
  EXPECT_LT(verdict.covered, 200);
}

TEST(GuardBand, CoordinatesBeyondItSaturateAndAreCounted) {
  for (const char* name : {"GuardBand", "BeyondTheGuardBand"}) {
    const Scene scene = frame(name);
    const uint64_t outside = saturated_coordinates(scene);
    EXPECT_EQ(outside > 0, std::string(name) == "BeyondTheGuardBand");
    const Scratch scratch;
    const std::string file = scratch.write("scene.tri", tri_text(scene));
    for (const auto& command : kSceneCommands) {
      EXPECT_EQ(figures({command, file}).at("input").at("saturated"), outside) << command;
    }
  }
}

TEST(DepthOff, DepthStaysClearedAndTheLastTriangleShows) {
  const Dump dump = dump_of(frame("CullNoneDepthOff"));
  for (const uint32_t code : dump.depth) ASSERT_EQ(code, kClearedDepth);
  EXPECT_TRUE(judge(frame("CullNoneDepthOff"), dump).holds());
}

TEST(EmptyFrame, IsCleared) {
  for (const char* name : {"NoTriangles", "NoTrianglesOff"}) {
    for (const char* command : {"render", "rtl"}) {
      const Dump dump = dump_of(frame(name), command);
      EXPECT_EQ(dump.covered(), 0);
      for (const uint32_t code : dump.depth) ASSERT_EQ(code, kClearedDepth);
      for (const auto& color : dump.color) ASSERT_EQ(color, (std::array<uint8_t, 4>{}));
    }
  }
}

/// A sloped triangle twice, the second in another order of vertices and another colour.
Scene twice(Depth depth) {
  Scene scene = pile(64, 48, 1, 51);
  scene.depth = depth;
  Triangle first = scene.triangles[0];
  for (auto& v : first) v.rgba = {10, 20, 30, 40};
  Triangle second{first[2], first[1], first[0]};
  for (auto& v : second) v.rgba = {200, 190, 180, 170};
  scene.triangles = {first, second};
  return scene;
}

TEST(EqualDepth, LessKeepsTheFirstAndLequalTakesTheLast) {
  for (const char* command : {"render", "rtl"}) {
    const Dump less = dump_of(twice(Depth::kLess), command);
    const Dump lequal = dump_of(twice(Depth::kLequal), command);
    ASSERT_GT(less.covered(), 200);
    EXPECT_EQ(less.depth, lequal.depth);
    for (size_t i = 0; i < less.hits.size(); ++i) {
      if (less.hits[i] == 0) continue;
      ASSERT_EQ(less.hits[i], 2);
      ASSERT_EQ(less.color[i], (std::array<uint8_t, 4>{10, 20, 30, 40})) << command;
      ASSERT_EQ(lequal.color[i], (std::array<uint8_t, 4>{200, 190, 180, 170})) << command;
    }
  }
}

TEST(Cull, FrontAndBackPartTheFrameBetweenThem) {
  const Dump none = dump_of(frame("CullNoneDepthLess"));
  const Dump back = dump_of(frame("CullBackDepthLess"));
  const Dump front = dump_of(frame("CullFrontDepthLess"));
  ASSERT_GT(back.covered(), 0);
  ASSERT_GT(front.covered(), 0);
  for (size_t i = 0; i < none.hits.size(); ++i) {
    ASSERT_EQ(none.hits[i], back.hits[i] + front.hits[i]);
  }
}

TEST(Cull, CounterClockwiseOnScreenIsTheFront) {
  Scene scene{8, 8, Cull::kBack, Depth::kLess, {}};
  // Down, then right: counter-clockwise where y points down.
  scene.triangles = {{Vertex{0, 0}, Vertex{0, 8}, Vertex{8, 8}}};
  EXPECT_GT(dump_of(scene).covered(), 0);
  scene.cull = Cull::kFront;
  EXPECT_EQ(dump_of(scene).covered(), 0);
}

TEST(Hits, SaturateAndDoNotWrap) {
  Scene scene{1, 1, Cull::kNone, Depth::kLess, {}};
  scene.triangles.assign(65537, {Vertex{0, 0}, Vertex{2, 0}, Vertex{0, 2}});
  for (const char* command : {"render", "rtl"}) {
    EXPECT_EQ(dump_of(scene, command).hits, std::vector<uint16_t>{65535}) << command;
  }
}

struct LoneClass {
  std::string name;
  std::vector<Scene> (*scenes)();
};
std::ostream& operator<<(std::ostream& to, const LoneClass& c) { return to << c.name; }

class LoneTriangle : public testing::TestWithParam<LoneClass> {};

TEST_P(LoneTriangle, ErrsLessThanTheBoundsInBothModels) {
  uint64_t covered = 0;
  for (const Scene& scene : GetParam().scenes()) {
    for (const char* command : {"render", "rtl"}) {
      const Verdict verdict = judge(scene, dump_of(scene, command));
      ASSERT_TRUE(verdict.holds()) << command << ": " << verdict << "\n" << tri_text(scene);
      covered += verdict.covered;
    }
  }
  EXPECT_GT(covered, 8);
}

INSTANTIATE_TEST_SUITE_P(Cli, LoneTriangle,
                         testing::Values(LoneClass{"Needle", lone_needles},
                                         LoneClass{"Sliver", lone_slivers},
                                         LoneClass{"Giant", lone_giants},
                                         LoneClass{"Midget", lone_midgets}),
                         [](const auto& param) { return param.param.name; });

}  // namespace
}  // namespace pineda::test
