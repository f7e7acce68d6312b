// Meshes judged from clip space, from many camera positions.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

#include "studies/judge/mesh_judge.h"
#include "tests/studies/error/shot.h"
#include "tests/studies/judge/closed_meshes.h"

namespace pineda::studies {
namespace {

using scene::cross;
using scene::normalized;
using scene::operator*;
using scene::operator+;

/// A concave polygon in any plane, its coordinates cut to so many decimal digits.
std::vector<scene::Vec3> rounded_star(spec::Random* random, double digits) {
  const auto number = [&] { return static_cast<double>(random->uniform(-1, 1)); };
  const scene::Vec3 u = normalized({number(), number(), number()});
  const scene::Vec3 v = normalized(cross(u, {number(), number(), number()}));
  std::vector<scene::Vec3> star;
  for (int i = 0; i < 12; ++i) {
    const double radius = i % 2 == 0 ? 1.5 : .7;
    star.push_back(radius * std::cos(M_PI * i / 6) * u + radius * std::sin(M_PI * i / 6) * v);
    for (double& x : star.back()) x = std::nearbyint(x * digits) / digits;
  }
  return star;
}

TEST(MeshJudge, PolygonsOfRoundedCoordinatesAreStillJudgedAsPolygonsAlsoAlmostFromTheSide) {
  spec::Random random(7);
  uint64_t fans_seen = 0;
  for (int n = 0; n < 60; ++n) {
    Shot shot = shot_of(polygon_mesh(rounded_star(&random, n % 2 == 0 ? 1e4 : 1e7)), 128, 96);
    if (n % 4 < 2) {  // the eye near the polygon's plane
      const auto& p = shot.mesh.position;
      shot.camera.eye = 3. * p[0] + 1e-6 * p[3];
      shot.camera.up = {.1, 1, .2};
    }
    const MeshJudgement right = judged(shot);
    ASSERT_EQ(what(right), "") << n << " (" << right.first->x << ", " << right.first->y << ")";
    ASSERT_EQ(right.bent, 0u) << n;
    for (uint32_t i = 0; i < shot.mesh.triangle.size(); ++i) {
      shot.mesh.triangle[i] = {0, i + 1, i + 2};
    }
    fans_seen += judged(shot).holds() ? 0 : 1;
  }
  EXPECT_GT(fans_seen, 25u);
}

TEST(MeshJudge, PolygonsThatAreNotPlaneAreJudgedByTheirTrianglesAndCounted) {
  const Shot shot =
      shot_of(polygon_mesh({{-1, -1, 0}, {1, -1, .5}, {1, 1, 0}, {-1, 1, .5}}), 64, 48);
  const MeshJudgement j = judged(shot);
  EXPECT_EQ(what(j), "");
  EXPECT_EQ(j.bent, 1u);
  EXPECT_EQ(j.faces, 2u);
}

// Snapping can turn a thin triangle of a polygon over: samples on its diagonals may then be hit
// twice.
TEST(MeshJudge, SamplesOnADiagonalOfAPolygonMayBeHitByBothOfItsTrianglesAndNoOthers) {
  const Shot shot = shot_of(polygon_mesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}), 97, 97);
  const scene::ClipMesh seen = shot.seen();
  const auto pieces = pieces_of(shot, seen);
  ASSERT_EQ(pieces.size(), 2u);
  const auto judge_with = [&](int x, int y) {  // a sample hit once more
    MeshJudge judge(seen, spec::contract(shot.design), shot.frame);
    judge::ScreenTruth truth;
    for (const SceneTriangle& piece : pieces) {
      truth.judge({piece.screen, judge::format_of(shot.design), judge::exact_frame(shot.frame)});
      for (const auto& s : truth.samples()) {
        const MeshHit hit{
            s.x, s.y, piece.snapped.id, static_cast<uint32_t>(s.z.nearest), {50, 100, 150, 255}};
        judge.hit(hit);
        if (s.x == x && s.y == y) judge.hit(hit);
      }
    }
    return what(judge.finish());
  };
  EXPECT_EQ(judge_with(-1, -1), "");
  EXPECT_EQ(judge_with(48, 48), "");  // the middle, on the diagonal
  EXPECT_EQ(judge_with(48, 40), "hits: 2, expected 1");
}

/// The number of random cameras: 50, or as PINEDA_CAMERAS says.
int cameras() {
  const char* wanted = std::getenv("PINEDA_CAMERAS");
  return wanted != nullptr ? std::atoi(wanted) : 50;
}

Shot random_shot(uint64_t seed) {
  spec::Random random(seed);
  auto meshes = closed_meshes();
  Shot shot = shot_of(std::move(meshes[random.bits() % meshes.size()].mesh), 0, 0);
  shot.camera = random_camera(&random);
  shot.design.guard_bits = random.between(8, 14);
  shot.design.subpixel_bits = random.between(0, 1) == 1 ? 8 : random.between(4, 12);
  const int widest = random.between(0, 9) == 0 ? 1 << shot.design.guard_bits : 128;
  shot.frame.width = random.between(1, widest);
  shot.frame.height = random.between(
      1, std::min(1 << shot.design.guard_bits, std::max(1, 8192 / shot.frame.width)));
  shot.frame.cull = static_cast<spec::Cull>(random.between(0, 2));
  shot.frame.shade = static_cast<spec::Shade>(random.between(0, 1));
  return shot;
}

TEST(MeshJudge, ClosedMeshesAreHitAsRaysCrossThemFromRandomCameras) {
  uint64_t samples = 0, banded = 0, faces = 0;
  for (int seed = 1; seed <= cameras(); ++seed) {
    const MeshJudgement j = judged(random_shot(static_cast<uint64_t>(seed)));
    ASSERT_EQ(what(j), "") << "seed " << seed << ": (" << j.first->x << ", " << j.first->y
                           << ") of triangle " << j.first->triangle << ", " << j.wrong << " wrong";
    samples += j.samples;
    banded += j.banded;
    faces += j.faces;
  }
  std::cout << cameras() << " cameras, " << faces << " faces, " << samples << " hits, " << banded
            << " of them in bands\n";
  EXPECT_GT(samples, 1000u * static_cast<uint64_t>(cameras()));
  EXPECT_LT(banded, samples / 10);
}

}  // namespace
}  // namespace pineda::studies
