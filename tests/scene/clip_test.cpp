#include "model/scene/clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/judge/exact_terms.h"
#include "model/scene/snap.h"
#include "model/spec/random.h"
#include "studies/judge/stated.h"
#include "tests/scene/mesh_source.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

class Vertices {
 public:
  // A vertex in front of or behind the near plane, and far beyond the guard band or not.
  ClipVertex next(double spread, bool in_front) {
    ClipVertex v;
    const double z = (in_front ? 1 : -1) * number(.01, 9);
    v.position = {number(-spread, spread), number(-spread, spread), z, z + 1};  // near plane: w = 1
    for (double& channel : v.rgba) channel = number(0, 255);
    return v;
  }

 private:
  double number(double low, double high) { return low + (high - low) * random_.unit(); }

  spec::Random random_{1};
};

bool same(const ClipVertex& a, const ClipVertex& b) {
  return a.position == b.position && a.rgba == b.rgba;
}

bool holds(const Polygon& polygon, const ClipVertex& vertex) {
  return std::any_of(polygon.v.begin(), polygon.v.begin() + static_cast<int>(polygon.size),
                     [&](const ClipVertex& v) { return same(v, vertex); });
}

TEST(Clip, SharedEdgeAcrossTheNearPlaneGetsOneVertexWhicheverWayItIsWalked) {
  Vertices vertices;
  const ClipVolume volume(640, 480, kContract.design);
  for (int i = 0; i < 10000; ++i) {
    const auto in = vertices.next(3, true), out = vertices.next(3, false);
    const auto left = volume.clip({in, out, vertices.next(3, false)});
    const auto right = volume.clip({out, in, vertices.next(3, true)});
    // The left side's triangle has three vertices: `in` and the two cuts.
    ASSERT_EQ(left.size, 3u);
    ASSERT_TRUE(same(left.v[0], in));
    ASSERT_TRUE(holds(right, left.v[1])) << i;
    ASSERT_NEAR(left.v[1].position[2], 0, 1e-14);
  }
}

// The mutant: an edge cut in the direction in which the triangle is walked often gets other bits.
TEST(Clip, CuttingInTheDirectionOfTheWalkWouldSplitSharedVertices) {
  Vertices vertices;
  int split = 0;
  for (int i = 0; i < 10000; ++i) {
    const auto a = vertices.next(3, true).position, b = vertices.next(3, false).position;
    const double forward = a[0] + a[2] / (a[2] - b[2]) * (b[0] - a[0]);
    const double backward = b[0] + b[2] / (b[2] - a[2]) * (a[0] - b[0]);
    split += forward != backward ? 1 : 0;
  }
  EXPECT_GT(split, 900);
}

TEST(Clip, WhatIsLeftLiesInsideAllPlanesAndKeepsItsColoursInRange) {
  Vertices vertices;
  const ClipVolume volume(641, 479, kContract.design);
  int whole = 0, cut = 0, gone = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::array<ClipVertex, 3> t = {vertices.next(300, true), vertices.next(300, i % 2 == 0),
                                         vertices.next(300, i % 3 == 0)};
    const auto polygon = volume.clip(t);
    const unsigned outside = volume.outside(t[0]) | volume.outside(t[1]) | volume.outside(t[2]);
    gone += polygon.size == 0 ? 1 : 0;
    whole += outside == 0 ? 1 : 0;
    cut += outside != 0 && polygon.size != 0 ? 1 : 0;
    EXPECT_TRUE(outside != 0 || polygon.size == 3);
    for (size_t k = 0; k < polygon.size; ++k) {
      const auto& p = polygon.v[k].position;
      EXPECT_GE(p[3], 1 - 1e-12);
      EXPECT_LE(std::abs(p[0] / p[3] + 1) * 320.5, 16384 + 1e-6);
      EXPECT_LE(std::abs(1 - p[1] / p[3]) * 239.5, 16384 + 1e-6);
      for (const double channel : polygon.v[k].rgba) {
        EXPECT_GE(channel, -.4);
        EXPECT_LE(channel, 255.4);
      }
    }
  }
  EXPECT_GT(whole, 1000);
  EXPECT_GT(cut, 1000);
  EXPECT_GT(gone, 10);
}

// A plain, ten by ten squares, that reaches behind the eye and far beyond the guard band.
Mesh plain(double extent) {
  constexpr uint32_t kSide = 11;
  Mesh mesh;
  for (uint32_t i = 0; i < kSide; ++i) {
    for (uint32_t j = 0; j < kSide; ++j) {
      // Sheared, so that no edge runs along the view direction.
      const double x = extent * (j / 5.0 - 1), z = extent * (i / 5.0 - 1);
      mesh.position.push_back({x + .3 * z, 0, z - .2 * x});
      mesh.normal.push_back({0, 1, 0});
      if (i == 0 || j == 0) continue;
      const uint32_t k = i * kSide + j;
      mesh.triangle.push_back({k, k - 1, k - kSide});
      mesh.triangle.push_back({k - kSide - 1, k - kSide, k - 1});
    }
  }
  return mesh;
}

TEST(Clip, EverySampleOfAClippedPlainIsHitExactlyOnce) {
  constexpr int kWidth = 160, kHeight = 121;
  const Mesh mesh = plain(40);
  const Camera camera{{.1, .05, .2}, {.15, 0, .15}, {0, 1, 0}, 60};
  const View view = camera_view(camera, mesh, kWidth, kHeight);
  SnappedSource source(kContract, mesh_reader(mesh, view, kWidth, kHeight));
  std::vector<int> hits(kWidth * kHeight);
  for (spec::Triangle t; source.next(&t);) {
    const exact::Judge judge = judge::exact_judge(kContract.design, {kWidth, kHeight}, t);
    for (int y = 0; y < kHeight; ++y) {
      const auto span = judge.span(y);
      for (int x = span.first; x <= span.last; ++x) ++hits[static_cast<size_t>(y * kWidth + x)];
    }
  }
  EXPECT_EQ(std::count(hits.begin(), hits.end(), 1), kWidth * kHeight);
  const Counters& c = source.counters();
  EXPECT_EQ(c.triangles, 200u);
  EXPECT_GT(c.clipped, 2u);
  EXPECT_GT(c.clipped_away, 20u);
  EXPECT_EQ(c.saturated, 0u);
}

TEST(Clip, PiecesShareTheNumberOfTheirTriangle) {
  const Mesh mesh = plain(40);
  const Camera camera{{.1, .05, .2}, {.15, 0, .15}, {0, 1, 0}, 60};
  const View view = camera_view(camera, mesh, 64, 64);
  SnappedSource source(kContract, mesh_reader(mesh, view, 64, 64));
  const auto first = all_triangles(&source);
  std::vector<int> pieces(200);
  for (const auto& t : first) ++pieces.at(t.id);
  const auto drawn = std::count_if(pieces.begin(), pieces.end(), [](int n) { return n > 0; });
  EXPECT_EQ(static_cast<uint64_t>(drawn) + source.counters().clipped_away, 200u);
  EXPECT_GT(*std::max_element(pieces.begin(), pieces.end()), 1);
  EXPECT_TRUE(std::is_sorted(first.begin(), first.end(),
                             [](const auto& a, const auto& b) { return a.id < b.id; }));
  source.rewind();
  EXPECT_TRUE(scene::same(first, all_triangles(&source)));
}

// A triangle from behind the eye to far in front of it: red on the left, blue in the distance.
Mesh long_triangle() {
  Mesh mesh;
  mesh.position = {{-3, -1, 2}, {4, -1, -1}, {-1, -1, -40}};
  mesh.normal.assign(3, {0, 1, 0});
  mesh.color = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}};
  mesh.triangle = {{0, 1, 2}};
  return mesh;
}

// The barycentric weights, in the world, of the point of the plane y = -1 that a sample shows: by
// the eye's ray, without clip space and without w.
std::array<double, 3> weights_seen(const Mesh& mesh, double tangent, int size, int x, int y) {
  const double dx = tangent * ((x + .5) * 2 / size - 1);
  const double dy = tangent * (1 - (y + .5) * 2 / size);
  const double distance = -1 / dy;
  const double px = dx * distance, pz = -distance;
  const auto area = [&](size_t i, size_t j) {
    const Vec3 &a = mesh.position[i], &b = mesh.position[j];
    return (a[0] - px) * (b[2] - pz) - (b[0] - px) * (a[2] - pz);
  };
  const double sum = area(0, 1) + area(1, 2) + area(2, 0);
  return {area(1, 2) / sum, area(2, 0) / sum, area(0, 1) / sum};
}

TEST(MeshReader, WOfClippedPiecesGivesTheColoursOfTheWholeTriangle) {
  constexpr int kSize = 96;
  const Mesh mesh = long_triangle();
  const Camera camera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 60};
  const auto reader = mesh_reader(mesh, camera_view(camera, mesh, kSize, kSize), kSize, kSize);
  Counters counters;
  int samples = 0;
  double worst = 0, worst_affine = 0;
  for (ScreenTriangle t; reader->read(&t, &counters);) {
    for (const ScreenVertex& v : t.v) EXPECT_GT(v.w, 0);
    const exact::ScreenJudge judge(studies::stated(t), {}, {kSize, kSize});
    std::vector<exact::Sample> row;
    for (int y = judge.rows().first; y <= judge.rows().last; ++y) judge.row(y, true, &row);
    for (const exact::Sample& s : row) {
      const auto weights = weights_seen(mesh, std::tan(M_PI / 6), kSize, s.x, s.y);
      ++samples;
      for (size_t k = 0; k < 3; ++k) {
        const double seen = 255 * weights[k];
        const auto error = [&](const exact::Value& v) {
          return std::abs(static_cast<double>(v.whole) + v.fraction - seen);
        };
        worst = std::max(worst, error(s.perspective[k]));
        worst_affine = std::max(worst_affine, error(s.affine[k]));
      }
    }
  }
  EXPECT_EQ(counters.clipped, 1u);
  EXPECT_GT(samples, 1000);
  EXPECT_LT(worst, 1.5);  // the colours of cut vertices are whole numbers, positions are snapped
  EXPECT_GT(worst_affine, 50);
}

}  // namespace
}  // namespace pineda::scene
