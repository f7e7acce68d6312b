// The cameras of a glTF file: where they stand and what they project.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "model/scene/readers/gltf/reader.h"
#include "tests/scene/readers/gltf/files.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

const Json kPerspective = {
    {"type", "perspective"},
    {"perspective", {{"yfov", M_PI / 2}, {"znear", 1}, {"zfar", 9}, {"aspectRatio", 3}}}};
const Json kOrthographic = {
    {"type", "orthographic"},
    {"orthographic", {{"xmag", 7}, {"ymag", 4}, {"znear", 1}, {"zfar", 9}}}};

// A triangle, and a node for each camera, before the triangle's parent.
GltfFile seen_by(const std::vector<Json>& cameras) {
  GltfFile file = one_triangle();
  for (size_t i = 0; i < cameras.size(); ++i) {
    file.json["cameras"].push_back(cameras[i]);
    file.json["nodes"].push_back({{"camera", i}});
  }
  return file;
}

Mesh read(const GltfFile& file) {
  const Scratch scratch;
  std::vector<std::string> warnings;
  return read_gltf(scratch.write("a.gltf", file.text()), &warnings);
}

View view_with(const Json& camera, const Json& node = Json::object(), int width = 200,
               int height = 100) {
  GltfFile file = seen_by({camera});
  file.json["nodes"][1].update(node);
  return file_view(read(file).camera.at(0), width, height);
}

void expect_clip(const View& view, const Vec3& world, const std::array<double, 4>& expected) {
  const auto clip = view.clip(world);
  for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(clip[i], expected[i], 1e-12) << i;
}

const Json kAtFive = {{"translation", {0, 0, 5}}};

// (1 2 3) lies 2 before the eye. With 90 degrees y / w = 2 / 2; the frame is twice as wide as high.
TEST(GltfCamera, PerspectiveWithNearAndFarIsAsByHand) {
  const View view = view_with(kPerspective, kAtFive);
  expect_clip(view, {1, 2, 3}, {.5, 2, 9 / 8., 2});
  expect_clip(view, {0, 0, 4}, {0, 0, 0, 1});        // near: z = 0
  expect_clip(view, {0, 0, -4}, {0, 0, 9, 9});       // far: z = w
  expect_clip(view, {8, 4, 1}, {4, 4, 27 / 8., 4});  // the frame's upper right corner
  EXPECT_TRUE(view.far_cuts);
}

TEST(GltfCamera, WithoutFarTheProjectionIsInfinite) {
  Json camera = kPerspective;
  camera["perspective"].erase("zfar");
  const View view = view_with(camera, kAtFive);
  expect_clip(view, {1, 2, 3}, {.5, 2, 1, 2});  // z / w = 1 - near / w
  expect_clip(view, {0, 0, 4}, {0, 0, 0, 1});
  const auto far = view.clip({0, 0, -1e9});
  EXPECT_LT(far[2], far[3]);
  EXPECT_FALSE(view.far_cuts);
}

TEST(GltfCamera, OrthographicKeepsItsHeightAndTheFramesAspectWins) {
  const View view = view_with(kOrthographic, kAtFive);
  expect_clip(view, {1, 2, 3}, {.125, .5, .125, 1});
  expect_clip(view, {8, 4, 4}, {1, 1, 0, 1});
  expect_clip(view, {8, 4, -4}, {1, 1, 1, 1});
  EXPECT_TRUE(view.far_cuts);
  Json at_the_eye = kOrthographic;
  at_the_eye["orthographic"]["znear"] = 0;
  expect_clip(view_with(at_the_eye, kAtFive), {0, 0, 5}, {0, 0, 0, 1});
}

TEST(GltfCamera, TheAngleStaysWhateverTheFrame) {
  for (const auto& [width, height] : {std::pair{100, 200}, std::pair{300, 100}}) {
    const View view = view_with(kPerspective, kAtFive, width, height);
    const double aspect = static_cast<double>(width) / height;
    expect_clip(view, {2 * aspect, 2, 3}, {2, 2, 9 / 8., 2});
  }
}

// A quarter turn about y: -Z becomes -X, and X becomes -Z.
TEST(GltfCamera, ItLooksAlongTheNodesMinusZWithItsPlusYAbove) {
  const double half = std::sqrt(.5);
  expect_clip(view_with(kPerspective, {{"rotation", {0, half, 0, half}}}), {-2, 1, -.5},
              {.25, 1, 9 / 8., 2});
  // The same by a matrix, column by column, and moved.
  expect_clip(
      view_with(kPerspective, {{"matrix", {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 3, 4, 5, 1}}}),
      {1, 5, 4.5}, {.25, 1, 9 / 8., 2});
}

TEST(GltfCamera, ParentsTurnItAndScaleMirrorsAndShearDoNotChangeThePicture) {
  const double half = std::sqrt(.5);
  GltfFile file = seen_by({kPerspective});
  file.json["nodes"].push_back({{"children", {1}},
                                {"rotation", {0, half, 0, half}},
                                {"translation", {10, 0, 0}},
                                {"scale", {2, 3, 4}}});
  file.json["nodes"][1]["translation"] = {0, 0, 5};  // 5 * 4 along the parent's z, world x
  const View view = file_view(read(file).camera.at(0), 200, 100);
  expect_clip(view, {28, 1, -.5}, {.25, 1, 9 / 8., 2});
  const Vec3 seen = {1, 2, -2};
  const std::array<double, 4> expected = {.5, 2, 9 / 8., 2};
  expect_clip(view_with(kPerspective, {{"scale", {.5, 7, 1e-3}}}), seen, expected);
  expect_clip(view_with(kPerspective, {{"scale", {-1, 1, 1}}}), seen, expected);
  // +Y is tilted along the view direction, which is taken out; +X is skewed, which has no effect.
  expect_clip(
      view_with(kPerspective, {{"matrix", {9, 1, 0, 0, 0, 1, 5, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}), seen,
      expected);
}

TEST(GltfCamera, TheyAreNumberedDepthFirstByTheirNodes) {
  GltfFile file = one_triangle();
  file.json["cameras"] = {kPerspective, kOrthographic};
  // The roots are 3 and 0; 3 has 1 and 2.
  file.json["nodes"] = {{{"mesh", 0}},
                        {{"camera", 1}, {"translation", {1, 0, 0}}},
                        {{"camera", 0}, {"translation", {2, 0, 0}}},
                        {{"camera", 1}, {"translation", {3, 0, 0}}, {"children", {2, 1}}}};
  file.json["scenes"] = {{{"nodes", {3, 0}}}};
  std::vector<double> x;
  const Mesh mesh = read(file);
  for (const auto& camera : mesh.camera) x.push_back(camera.eye[0]);
  EXPECT_EQ(x, (std::vector<double>{3, 5, 4}));
  EXPECT_TRUE(mesh.camera[0].is_orthographic);
  EXPECT_FALSE(mesh.camera[1].is_orthographic);
}

struct Wrong {
  const char* place;  // a pointer into the file
  Json value;
  const char* message;
};

TEST(GltfCamera, AWrongOneIsAnErrorWhenItIsAskedForAndOnlyThen) {
  const Scratch scratch;
  const Json none;
  const std::vector<Wrong> all = {
      {"/cameras/0/perspective/yfov", 0, "cameras[0].perspective.yfov: expected an angle"},
      {"/cameras/0/perspective/yfov", M_PI, "yfov: expected an angle between 0 and pi, got 3.14"},
      {"/cameras/0/perspective/yfov", "wide", "between 0 and pi, got 'wide'"},
      {"/cameras/0/perspective/yfov", none, "between 0 and pi, got none"},
      {"/cameras/0/perspective/znear", 0, "znear: expected a distance above 0, got 0"},
      {"/cameras/0/perspective/zfar", 1, "zfar: expected a distance beyond znear, got 1"},
      {"/cameras/0/perspective", 5, "cameras[0].perspective.yfov: expected an angle"},
      {"/cameras/0/perspective/yfov", 1e-320, "expected a camera that sees more than a point"},
      {"/cameras/0/type", "fisheye", "cameras[0].type: expected perspective or orthographic, got"},
      {"/cameras/0", 5, "cameras[0].type: expected perspective or orthographic, got none"},
      {"/cameras", 5, "cameras[0]: expected one of 0"},
      {"/nodes/1/camera", 2, "cameras[2]: expected one of 2"},
      {"/nodes/1/scale", {1, 0, 1}, "nodes[1]: expected a transform that keeps a camera's -Z and"},
      {"/nodes/1/scale", {1, 1, 0}, "nodes[1]: expected a transform that keeps a camera's -Z and"},
      {"/nodes/1/matrix",
       {1, 0, 0, 0, 0, 0, 3, 0, 0, 0, 1, 0, 0, 0, 0, 1},
       "nodes[1]: expected a transform that keeps a camera's -Z and +Y apart, got a singular"},
      {"/cameras/1/orthographic/xmag", 0, "xmag: expected a number above 0, got 0"},
      {"/cameras/1/orthographic/ymag", 0, "ymag: expected a number above 0, got 0"},
      {"/cameras/1/orthographic/ymag", -1, "ymag: expected a number above 0, got -1"},
      {"/cameras/1/orthographic/znear", -1, "znear: expected 0 or above, got -1"},
      {"/cameras/1/orthographic/zfar", none, "zfar: expected a distance beyond znear, got none"},
  };
  for (const Wrong& wrong : all) {
    GltfFile file = seen_by({kPerspective, kOrthographic});
    file.json[Json::json_pointer(wrong.place)] = wrong.value;
    const auto path = scratch.write("a.gltf", file.text());
    EXPECT_EQ(error_of(path), "") << wrong.message;
    Options options;
    options.camera_number = std::string(wrong.place).find("cameras/1") == 1 ? 1 : 0;
    const std::string error = error_of(path, options);
    EXPECT_TRUE(is_one_line_with(error, wrong.message));
    EXPECT_EQ(error.find(path), error.rfind(path)) << error;  // the file is named once
  }
}

TEST(GltfCamera, OnlyOneThatTheFileHasCanBeAskedFor) {
  const Scratch scratch;
  const auto path = scratch.write("a.gltf", seen_by({kPerspective, kOrthographic}).text());
  const auto with = [](const std::string& file, int number) {
    Options options;
    options.camera_number = number;
    return error_of(file, options);
  };
  EXPECT_EQ(with(path, 0), "");
  EXPECT_EQ(with(path, 1), "");
  EXPECT_TRUE(is_one_line_with(with(path, 2), path + ": expected one of 2 cameras, got 2"));
  EXPECT_TRUE(is_one_line_with(with(path, -1), "expected one of 2 cameras, got -1"));
  const auto none = scratch.write("none.glb", one_triangle().glb());
  EXPECT_TRUE(is_one_line_with(with(none, 0), none + ": expected one of 0 cameras, got 0"));
  const auto obj = scratch.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const auto& name : {obj, std::string("teapot"), std::string("grid")}) {
    EXPECT_TRUE(is_one_line_with(with(name, 0), "expected no camera of the file: only .gltf"));
  }
  Options both;
  both.camera_number = 0;
  both.camera = Camera{};
  EXPECT_TRUE(is_one_line_with(error_of(path, both), "expected no camera of the file: another"));
}

TEST(GltfCamera, ThoseThatNobodyAskedForAreCountedAndSaid) {
  const Scratch scratch;
  const auto path = scratch.write("a.gltf", seen_by({kPerspective, kOrthographic}).text());
  Options options;
  const auto warnings = open_scene(kContract, path, options).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(is_one_line_with(warnings[0], path + ": 2 cameras not used (--camera N takes one)"));
  options.camera_number = 1;
  EXPECT_TRUE(open_scene(kContract, path, options).warnings.empty());
}

// The triangle (0 0 0), (1 0 0), (0 1 0) from 2 above its plane.
TEST(GltfCamera, ThePictureIsThatOfTheSameCameraByHand) {
  const Scratch scratch;
  GltfFile file = seen_by({kPerspective, kOrthographic});
  for (size_t i = 1; i < 3; ++i) file.json["nodes"][i]["translation"] = {0, 0, 2};
  const auto path = scratch.write("a.gltf", file.text());
  const auto corners = [&](const Options& options) {
    std::vector<std::array<int, 2>> all;
    for (const auto& t : all_triangles(open_scene(kContract, path, options).source.get())) {
      for (const auto& v : t.v) all.push_back({v.x, v.y});
    }
    return all;
  };
  Options by_hand, perspective, orthographic;
  by_hand.camera = Camera{{0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 90};
  perspective.camera_number = 0;
  orthographic.camera_number = 1;
  EXPECT_EQ(corners(perspective), corners(by_hand));
  // 1 of a half height of 4 is 60 of 480 px, at 256 steps each.
  EXPECT_EQ(corners(orthographic),
            (std::vector<std::array<int, 2>>{
                {320 * 256, 240 * 256}, {380 * 256, 240 * 256}, {320 * 256, 180 * 256}}));
  // The mutant: another angle is another picture.
  by_hand.camera->fovy_deg = 80;
  EXPECT_NE(corners(perspective), corners(by_hand));
}

}  // namespace
}  // namespace pineda::scene
