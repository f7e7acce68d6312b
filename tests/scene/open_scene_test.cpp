#include <gtest/gtest.h>

#include "model/scene/hard_cases.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

TEST(OpenScene, MissingFilesAndFoldersAreNamed) {
  const Scratch scratch;
  for (const char* name :
       {"none.tri", "none.ptrb", "none.obj", "none.ply", "none.gltf", "none.glb"}) {
    const auto path = scratch.path(name);
    EXPECT_TRUE(is_one_line_with(error_of(path), path + ": expected a file to read, got: No such"));
  }
  const auto folder = scratch.path("folder.tri");
  std::filesystem::create_directory(folder);
  EXPECT_TRUE(is_one_line_with(error_of(folder), folder + ": expected a file, got a directory"));
}

TEST(OpenScene, UnknownNamesSayWhatASceneIs) {
  for (const char* name : {"", "teapod", "mesh.stl", "folder/teapot", ".tri"}) {
    EXPECT_TRUE(is_one_line_with(error_of(name), "expected a scene")) << name;
  }
}

TEST(OpenScene, OptionsThatCannotBeHonouredAreRefused) {
  const Scratch scratch;
  const auto tri = scratch.write("a.tri", "pineda-tri 1\nsize 8 8\n");
  Options sized;
  sized.size = Size{8, 8};
  Options culled;
  culled.cull = spec::Cull::kNone;
  Options deep;
  deep.depth = spec::DepthFunc::kLess;
  Options seen;
  seen.camera = Camera{};
  Options fine;
  fine.tessellate = 3;
  EXPECT_EQ(error_of(tri), "");
  EXPECT_TRUE(is_one_line_with(error_of(tri, sized), "expected no size option: the file states"));
  EXPECT_TRUE(is_one_line_with(error_of("-", sized), "expected no size option: the file states"));
  EXPECT_TRUE(is_one_line_with(error_of(tri, culled), "expected no cull option"));
  EXPECT_TRUE(is_one_line_with(error_of("a.ptrb", deep), "expected no depth option"));
  EXPECT_TRUE(is_one_line_with(error_of(tri, seen), "expected no camera"));
  EXPECT_TRUE(is_one_line_with(error_of("grid", seen), "expected no camera"));
  for (const Options& own : {sized, culled, deep}) {
    EXPECT_TRUE(is_one_line_with(error_of("hard/fan", own), "option: the case states its own"));
  }
  EXPECT_TRUE(is_one_line_with(error_of("grid", fine), "expected no tessellation"));
}

TEST(OpenScene, SizesTessellationsAndCamerasOutOfRangeAreRefused) {
  for (const Size size : {Size{0, 8}, Size{8, -1}, Size{16385, 8}}) {
    Options options;
    options.size = size;
    for (const char* name : {"teapot", "triangle", "grid"}) {
      EXPECT_TRUE(is_one_line_with(error_of(name, options), "expected a size of 1x1 to 16384"));
    }
  }
  for (const int n : {-1, 0, 257}) {
    Options options;
    options.tessellate = n;
    EXPECT_TRUE(is_one_line_with(error_of("teapot", options), "expected a tessellation from 1 to"));
  }
  for (const Camera& camera :
       {Camera{{1, 1, 1}, {1, 1, 1}, {0, 1, 0}, 30}, Camera{{0, 5, 0}, {0, 0, 0}, {0, 1, 0}, 30},
        Camera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 180}, Camera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0}}) {
    Options options;
    options.camera = camera;
    EXPECT_TRUE(is_one_line_with(error_of("teapot", options), "teapot: expected a camera"));
  }
}

TEST(OpenScene, UnknownHardCasesListThoseThatExist) {
  for (const char* name : {"hard/", "hard/slivers"}) {
    const std::string error = error_of(name);
    for (const HardCase& known : hard_cases()) EXPECT_TRUE(is_one_line_with(error, known.name));
  }
  // A name that ends like a file is one.
  EXPECT_TRUE(is_one_line_with(error_of("hard/sliver.tri"), "expected a file to read"));
}

TEST(OpenScene, BuiltInScenesRewindToTheSameTriangles) {
  ASSERT_GT(built_in_scenes().size(), 3u);
  for (const BuiltIn& built_in : built_in_scenes()) {
    const std::string& name = built_in.name;
    const auto opened = open_scene(kContract, name, {});
    const auto again = open_scene(kContract, name, {});
    const auto first = all_triangles(opened.source.get());
    const Counters counted = opened.source->counters();
    EXPECT_EQ(opened.name, name);
    EXPECT_FALSE(first.empty());
    // Only the hard cases hold what must be said.
    EXPECT_TRUE(notes(counted).empty() || !built_in.right_answer.empty()) << name;
    EXPECT_FALSE(built_in.summary.empty()) << name;
    opened.source->rewind();
    EXPECT_TRUE(same(first, all_triangles(opened.source.get())));
    EXPECT_TRUE(same(first, all_triangles(again.source.get())));
    EXPECT_EQ(opened.source->counters().triangles, counted.triangles);
  }
}

TEST(OpenScene, SizeStateAndTessellationReachTheScene) {
  Options options;
  options.size = Size{33, 44};
  options.cull = spec::Cull::kBack;
  options.depth = spec::DepthFunc::kLequal;
  options.tessellate = 2;
  const auto opened = open_scene(kContract, "teapot", options);
  EXPECT_EQ(opened.frame.width, 33);
  EXPECT_EQ(opened.frame.height, 44);
  EXPECT_EQ(opened.frame.cull, spec::Cull::kBack);
  EXPECT_EQ(opened.frame.depth, spec::DepthFunc::kLequal);
  EXPECT_EQ(all_triangles(opened.source.get()).size(), 240u);
  EXPECT_EQ(open_scene(kContract, "teapot", {}).frame.width, 640);
  EXPECT_EQ(open_scene(kContract, "triangle", {}).frame.width, 64);
}

}  // namespace
}  // namespace pineda::scene
