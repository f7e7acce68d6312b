// Meshes judged from clip space: the front end draws them right, and its former faults are seen.
#include "studies/judge/mesh_judge.h"

#include <gtest/gtest.h>

#include "model/judge/truth.h"
#include "studies/judge/front_end.h"
#include "tests/studies/error/shot.h"
#include "tests/studies/judge/closed_meshes.h"

namespace pineda::studies {
namespace {

using scene::ClipMesh;
using scene::Mesh;

// The first corner, red, lies behind the eye.
Shot near_shot() {
  Mesh mesh = mesh_of({{0, -1, 9}, {-3, -1, -5}, {3, -1, -5}},
                      {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}});
  mesh.triangle = {{0, 1, 2}};
  Shot shot = shot_of(mesh, 64, 64);
  shot.frame.shade = spec::Shade::kFlat;
  return shot;
}

TEST(MeshJudge, FlatColourIsTheFirstVertexsAlsoWhereClippingCutsItAway) {
  const MeshJudgement j = judged(near_shot());
  EXPECT_EQ(what(j), "");
  EXPECT_GT(j.samples, 500u);
}

// The mutant: each clipped piece is coloured by its own first vertex, since the shading is not
// stated.
TEST(MeshJudge, SeesFlatColoursOfCutCorners) {
  const Shot shot = near_shot();
  Shot smooth = shot;
  smooth.frame.shade = spec::Shade::kSmooth;
  const ClipMesh seen = shot.seen();
  const auto j = judge_front_end(seen, shot.frame, pieces_of(smooth, seen), shot.design);
  EXPECT_EQ(j.wrong, j.samples);
  EXPECT_EQ(what(j).substr(0, 9), "colour 0:");
}

Mesh wall() {
  Mesh mesh = mesh_of({{-9000, -9000, 0}, {9000, -9000, 0}, {9000, 9000, 0}, {-9000, 9000, 0}},
                      std::vector<scene::Rgba>(4, {1, 2, 3, 4}));
  mesh.triangle = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(MeshJudge, FrameAsLargeAsTheGuardBandIsDrawnToItsBorders) {
  for (int guard_bits = 8; guard_bits <= 14; ++guard_bits) {
    Shot shot = shot_of(wall(), 1 << guard_bits, 4);
    shot.design.guard_bits = guard_bits;
    const MeshJudgement j = judged(shot);
    EXPECT_EQ(what(j), "") << guard_bits;
    EXPECT_EQ(j.samples, uint64_t{4} << guard_bits);
    EXPECT_LE(j.banded, 8u);  // on the diagonal
    shot.frame.width = 4;
    shot.frame.height = 1 << guard_bits;
    EXPECT_EQ(judged(shot).samples, uint64_t{4} << guard_bits);
  }
}

// The mutant: clip planes a pixel inside of the guard band lose the last column.
TEST(MeshJudge, SeesAGuardBandThatIsAPixelTooNarrow) {
  Shot shot = shot_of(wall(), 256, 4);
  shot.design.guard_bits = 8;
  const ClipMesh seen = shot.seen();
  spec::FrameState narrow = shot.frame;
  narrow.scissor_x1 = 255;
  const auto pieces = pieces_of(shot, seen);
  MeshJudge judge(seen, spec::contract(shot.design), shot.frame);
  judge::ScreenTruth truth;
  for (const SceneTriangle& t : pieces) {
    truth.judge({t.screen, judge::format_of(shot.design), judge::exact_frame(narrow)});
    for (const auto& s : truth.samples()) {
      judge.hit({s.x, s.y, t.snapped.id, static_cast<uint32_t>(s.z.nearest), {1, 2, 3, 4}});
    }
  }
  const MeshJudgement j = judge.finish();
  EXPECT_EQ(j.wrong, 4u);
  EXPECT_EQ(what(j), "hits: 0, expected 1");
  EXPECT_EQ(j.first->x, 255);
}

// A wide angle at a small guard band: after snapping, one piece of the clipped polygon turns over.
Shot turned_shot() {
  Mesh mesh =
      mesh_of({{1, -1, -1}, {1, 1, 1}, {1, -1, 1}}, std::vector<scene::Rgba>(3, {9, 9, 9, 255}));
  mesh.triangle = {{0, 1, 2}};
  Shot shot = shot_of(mesh, 96, 72);
  shot.camera = {{.9999, .5, .5}, {-.45, -.572, -.172}, {0, 1, 0}, 178};
  return shot;
}

/// The clipped polygons as plain fans, whatever snapping does to their pieces.
std::vector<SceneTriangle> plain_fans(const Shot& shot, const ClipMesh& seen) {
  const auto contract = spec::contract(shot.design);
  const scene::ClipVolume volume(shot.frame.width, shot.frame.height, shot.design, seen.depth);
  std::vector<scene::ScreenTriangle> fans;
  for (uint32_t id = 0; id < seen.triangle.size(); ++id) {
    const auto& t = seen.triangle[id];
    const auto polygon = volume.clip({seen.vertex[t[0]], seen.vertex[t[1]], seen.vertex[t[2]]});
    const auto project = [&](size_t i) {
      const auto& p = polygon.v[i].position;
      scene::ScreenVertex v;
      v.x = static_cast<float>((p[0] / p[3] + 1) * shot.frame.width / 2);
      v.y = static_cast<float>((1 - p[1] / p[3]) * shot.frame.height / 2);
      v.z = static_cast<float>(std::max(0., p[2] / p[3]));
      v.w = static_cast<float>(p[3]);
      for (size_t k = 0; k < 4; ++k) v.rgba[k] = static_cast<uint8_t>(polygon.v[i].rgba[k]);
      return v;
    };
    for (size_t i = 1; i + 1 < polygon.size; ++i) {
      fans.push_back({id, {project(0), project(i), project(i + 1)}});
    }
  }
  return snapped(contract, std::make_unique<scene::ListReader>(std::move(fans)));
}

TEST(MeshJudge, NoSampleOfATriangleIsHitTwiceWhateverSnappingTurnsOver) {
  const Shot shot = turned_shot();
  const MeshJudgement j = judged(shot);
  EXPECT_EQ(what(j), "");
  EXPECT_GT(j.samples, 30u);
  // The mutant: the plain fan.
  const ClipMesh seen = shot.seen();
  const auto fan = judge_front_end(seen, shot.frame, plain_fans(shot, seen), shot.design);
  ASSERT_EQ(fan.wrong, 1u);
  EXPECT_EQ(what(fan), "hits: 2, expected at most 1");
  EXPECT_EQ(fan.first->x, 24);
  EXPECT_EQ(fan.first->y, 56);
}

// The mutant: cut as a fan, a concave polygon hits samples outside, some of them twice.
TEST(MeshJudge, TakesTheFilesPolygonNotTheReadersTriangles) {
  const std::vector<scene::Vec3> arrow = {
      {-1.2, -1.3, 0}, {0, -.4, 0}, {1.2, -1.3, 0}, {0, 1.5, 0}};
  const std::vector<scene::Vec3> u = {{-1.5, 1.5, 0}, {-1.5, -1.5, 0}, {1.5, -1.5, 0},
                                      {1.5, 1.5, 0},  {.9, 1.5, 0},    {.9, -.9, 0},
                                      {-.9, -.9, 0},  {-.9, 1.5, 0}};
  for (const auto& position : {arrow, u}) {
    Shot shot = shot_of(polygon_mesh(position), 64, 48);
    const MeshJudgement right = judged(shot);
    EXPECT_EQ(what(right), "");
    EXPECT_EQ(right.faces, 1u);
    EXPECT_GT(right.samples, 200u);
    for (uint32_t i = 0; i < shot.mesh.triangle.size(); ++i)
      shot.mesh.triangle[i] = {0, i + 1, i + 2};
    const MeshJudgement fan = judged(shot);
    EXPECT_GT(fan.wrong, 50u);
    EXPECT_EQ(what(fan).substr(0, 5), "hits:");
  }
}

// The mutant: a polygon's triangles each have their own flat colour.
TEST(MeshJudge, PolygonHasOneFlatColourAlsoInTrianglesThatDoNotTouchItsFirstVertex) {
  Shot shot = shot_of(polygon_mesh({{-1.5, 1.5, 0},
                                    {-1.5, -1.5, 0},
                                    {1.5, -1.5, 0},
                                    {1.5, 1.5, 0},
                                    {.9, 1.5, 0},
                                    {.9, -.9, 0},
                                    {-.9, -.9, 0},
                                    {-.9, 1.5, 0}}),
                      64, 48);
  shot.frame.shade = spec::Shade::kFlat;
  shot.mesh.color[0] = {255, 0, 0, 255};
  EXPECT_EQ(what(judged(shot)), "");
  shot.mesh.provoking.clear();
  EXPECT_EQ(what(judged(shot)).substr(0, 9), "colour 0:");
}

// The mutant: a fan's triangles coloured by its hub.
TEST(MeshJudge, FansAndStripsHaveTheProvokingVertexOfTheirFormat) {
  Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                      {{1, 0, 0, 0}, {2, 0, 0, 0}, {3, 0, 0, 0}, {4, 0, 0, 0}});
  mesh.triangle = {{0, 1, 2}, {0, 2, 3}};
  mesh.corner = {0, 1, 2, 3};
  mesh.polygon = {{0, 4, 0, 2, scene::MeshPolygon::Kind::kFan, false}};
  mesh.provoking = {1, 2};
  Shot shot = shot_of(mesh, 64, 48);
  shot.frame.shade = spec::Shade::kFlat;
  EXPECT_EQ(what(judged(shot)), "");
  shot.mesh.provoking.clear();
  EXPECT_EQ(what(judged(shot)), "colour 0: 1, expected 2.0 to 2.0");

  shot.mesh.triangle = {{0, 1, 2}, {1, 3, 2}};
  shot.mesh.polygon[0].kind = scene::MeshPolygon::Kind::kStrip;
  EXPECT_EQ(what(judged(shot)), "");
  shot.mesh.triangle[1] = {2, 1, 3};  // the same triangle, another first vertex
  EXPECT_EQ(what(judged(shot)), "colour 0: 3, expected 2.0 to 2.0");
}

TEST(MeshJudge, SeesADepthAColourATriangleAndASampleThatAreWrong) {
  Shot shot = shot_of(closed_meshes()[2].mesh, 64, 48);
  shot.design.perspective = true;
  const ClipMesh seen = shot.seen();
  const auto pieces = pieces_of(shot, seen);
  const auto judge_with = [&](auto change) {
    auto changed = pieces;
    change(&changed);
    return what(judge_front_end(seen, shot.frame, changed, shot.design));
  };
  EXPECT_EQ(judge_with([](auto*) {}), "");
  EXPECT_EQ(judge_with([](auto* all) { all->erase(all->begin() + 7); }), "hits: 0, expected 1");
  EXPECT_EQ(judge_with([](auto* all) {
              for (auto& v : (*all)[7].screen) v.x += 3;
            }).substr(0, 5),
            "hits:");
  EXPECT_EQ(judge_with([](auto* all) { (*all)[7].screen[1].z += .01f; }).substr(0, 6), "depth:");
  EXPECT_EQ(judge_with([](auto* all) { (*all)[7].screen[2].rgba[1] ^= 128; }).substr(0, 9),
            "colour 1:");
}

}  // namespace
}  // namespace pineda::studies
