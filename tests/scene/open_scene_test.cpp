#include <gtest/gtest.h>

#include "model/scene/hard/cases.h"
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
  Options cut, unwritten, biased, cleared, shaded;
  cut.scissor = Scissor{0, 0, 8, 8};
  unwritten.depth_write = true;
  biased.depth_bias = DepthBias{};
  cleared.clear_depth = 1;
  shaded.shade = spec::Shade::kSmooth;
  EXPECT_TRUE(is_one_line_with(error_of(tri, cut), "expected no scissor option: the file states"));
  EXPECT_TRUE(is_one_line_with(error_of("-", unwritten), "expected no depth write option"));
  EXPECT_TRUE(is_one_line_with(error_of(tri, biased), "expected no depth bias option"));
  EXPECT_TRUE(is_one_line_with(error_of("-", cleared), "expected no clear depth option"));
  EXPECT_TRUE(is_one_line_with(error_of("a.ptrb", shaded), "expected no shade option"));
  for (const Options& own : {sized, culled, deep, cut, unwritten, biased, cleared, shaded}) {
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
  // A name that ends like a file is taken for a file.
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
    // Only hard cases may have notes.
    EXPECT_TRUE(notes(opened).empty() || !built_in.right_answer.empty()) << name;
    EXPECT_FALSE(built_in.summary.empty()) << name;
    opened.source->rewind();
    EXPECT_TRUE(same(first, all_triangles(opened.source.get())));
    EXPECT_TRUE(same(first, all_triangles(again.source.get())));
    EXPECT_EQ(opened.source->counters().triangles, counted.triangles);
  }
}

TEST(OpenScene, StateReachesTheScene) {
  Options options;
  options.depth = spec::DepthFunc::kNotequal;
  options.scissor = Scissor{1, 2, 30, 40};
  options.depth_write = false;
  options.depth_bias = DepthBias{-3, {64, true}};
  options.clear_depth = .25f;
  options.shade = spec::Shade::kFlat;
  for (const char* name : {"teapot", "triangle", "grid"}) {
    const auto opened = open_scene(kContract, name, options);
    EXPECT_EQ(opened.frame.depth, spec::DepthFunc::kNotequal);
    EXPECT_EQ(unusual_state(opened.frame),
              "scissor 1,2,30,40 px, depth write off, depth bias -3,0.25, clear depth 0.25, shade "
              "flat");
    EXPECT_EQ(opened.source->counters().rounded_slope, 1u) << name;
  }
}

// Notes where no sample of a cleared frame can pass, or only samples at one end of the depth range;
// no note where some can.
TEST(OpenScene, DepthFunctionsThatNothingPassesAreSaid) {
  using spec::DepthFunc;
  const auto said = [](DepthFunc func, double depth, const spec::Design& design) {
    spec::FrameState frame;
    frame.depth = func;
    frame.clear_depth = depth;
    std::string all;
    for (const auto& note : notes(design, frame, {})) all += note + "\n";
    return all;
  };
  const spec::Design& d = kContract.design;
  EXPECT_EQ(said(DepthFunc::kGreater, 1, d),
            "depth greater: nothing is greater than what depth is cleared to; cleardepth 0 or "
            "--clear-depth 0 clears it to the nearest\n");
  EXPECT_NE(said(DepthFunc::kGequal, 1, d).find("depth gequal: only samples at the far end"),
            std::string::npos);
  EXPECT_NE(said(DepthFunc::kLess, 0, d).find("depth less: nothing is less"), std::string::npos);
  EXPECT_NE(said(DepthFunc::kLequal, 0, d).find("depth lequal: only samples at the near end"),
            std::string::npos);
  // The codes decide: this depth is below 1, but in 16 bits it is the greatest code.
  spec::Design coarse = d;
  coarse.depth_bits = 16;
  EXPECT_NE(said(DepthFunc::kGreater, 1 - 0x1p-20, coarse), "");
  EXPECT_EQ(said(DepthFunc::kGreater, 1 - 0x1p-20, d), "");
  for (int f = 0; f < 9; ++f) {
    const auto func = static_cast<DepthFunc>(f);
    for (const double depth : {0., .5, 1.}) {
      const bool is_never = func == DepthFunc::kNever;
      const bool at_far_end = func == DepthFunc::kGreater || func == DepthFunc::kGequal;
      const bool at_near_end = func == DepthFunc::kLess || func == DepthFunc::kLequal;
      const bool is_said = is_never || (at_far_end && depth == 1) || (at_near_end && depth == 0);
      EXPECT_EQ(said(func, depth, d).empty(), !is_said) << f << " on " << depth;
    }
  }
  const spec::Design* flat = spec::find_design("flat");
  EXPECT_EQ(said(DepthFunc::kGreater, 1, *flat).find("depth greater"), std::string::npos);
}

TEST(OpenScene, AScissorMayBeginLeftOfAndAboveTheFrame) {
  Options options;
  options.scissor = Scissor{-5, -6, 30, 40};
  EXPECT_EQ(unusual_state(open_scene(kContract, "grid", options).frame), "scissor 0,0,25,34 px");
}

TEST(OpenScene, WhatADesignDoesNotDrawIsSaid) {
  const auto said = [](const spec::Design& design, const spec::FrameState& frame) {
    std::string all;
    for (const auto& note : notes(design, frame, {})) all += note + "\n";
    return all;
  };
  const auto holds = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  spec::FrameState frame;
  for (const spec::Design& d : spec::designs()) {
    EXPECT_EQ(said(d, frame).empty(), std::string(d.name) != "flat") << d.name;
  }
  const spec::Design& flat = *spec::find_design("flat");
  EXPECT_TRUE(holds(said(flat, frame), "design flat has no depth"));
  EXPECT_TRUE(holds(said(flat, frame), "design flat shades flat"));
  frame.depth = spec::DepthFunc::kOff;
  frame.shade = spec::Shade::kFlat;
  EXPECT_EQ(said(flat, frame), "");
  spec::Design two = spec::kHighTile;
  two.attributes = 2;
  EXPECT_TRUE(holds(said(two, {}), "draws the first 2 of the colour's 4 channels"));
  two.flat_attributes = 2;
  EXPECT_TRUE(holds(said(two, {}), "shades 2 channels flat"));
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
