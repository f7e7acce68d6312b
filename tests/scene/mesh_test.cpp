#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/scene/builtin/builtin.h"
#include "model/scene/snap.h"
#include "tests/scene/mesh_source.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

struct Extent {
  double low_x = 1e9, high_x = -1e9, low_y = 1e9, high_y = -1e9;
  int64_t low_z = int64_t{1} << 40, high_z = -1;

  explicit Extent(const std::vector<spec::Triangle>& triangles) {
    for (const auto& t : triangles) {
      for (const auto& v : t.v) {
        low_x = std::min(low_x, v.x / 256.0);
        high_x = std::max(high_x, v.x / 256.0);
        low_y = std::min(low_y, v.y / 256.0);
        high_y = std::max(high_y, v.y / 256.0);
        low_z = std::min(low_z, v.z);
        high_z = std::max(high_z, v.z);
      }
    }
  }
};

void expect_framed(const Mesh& mesh, int width, int height) {
  SCOPED_TRACE(testing::Message() << width << "x" << height);
  SnappedSource source(kContract,
                       mesh_reader(mesh, framing_view(mesh, width, height), width, height));
  const Extent e(all_triangles(&source));
  EXPECT_GE(e.low_x, 0);
  EXPECT_LE(e.high_x, width);
  EXPECT_GE(e.low_y, 0);
  EXPECT_LE(e.high_y, height);
  const double part_x = (e.high_x - e.low_x) / width, part_y = (e.high_y - e.low_y) / height;
  EXPECT_NEAR(std::max(part_x, part_y), .92, .01 + 1.0 / std::min(width, height));
  EXPECT_NEAR(part_x > part_y ? e.low_x + e.high_x - width : e.low_y + e.high_y - height, 0, .1);
  const Counters& c = source.counters();
  EXPECT_EQ(c.clipped + c.clipped_away + c.z_clamped + c.saturated, 0u);
  EXPECT_LT(e.low_z, e.high_z);
}

Mesh scaled(Mesh mesh, const Vec3& factor, const Vec3& offset) {
  for (Vec3& p : mesh.position) {
    p = Vec3{factor[0] * p[0], factor[1] * p[1], factor[2] * p[2]} + offset;
  }
  return mesh;
}

TEST(FramingView, HoldsTheWholeMeshAndFillsTheFrame) {
  const Mesh pot = teapot(3);
  for (const Size size : {Size{640, 480}, Size{480, 640}, Size{64, 64}, Size{1000, 100},
                          Size{100, 1000}, Size{641, 479}}) {
    expect_framed(pot, size.width, size.height);
    expect_framed(scaled(pot, {1e-3, 1e-3, 1e-3}, {7, 8, 9}), size.width, size.height);
    expect_framed(scaled(pot, {1e6, 1e6, 1e6}, {}), size.width, size.height);
    expect_framed(scaled(pot, {30, 1, 1}, {}), size.width, size.height);
    expect_framed(scaled(pot, {1, 30, 1}, {}), size.width, size.height);
    expect_framed(scaled(pot, {1, 1, 30}, {}), size.width, size.height);
  }
}

TEST(FramingView, MeshWithoutSizeOrWithoutAnythingIsNoTrouble) {
  Mesh point;
  point.position = {{3, 4, 5}};
  point.normal = {{0, 1, 0}};
  point.triangle = {{0, 0, 0}};
  SnappedSource one(kContract, mesh_reader(point, framing_view(point, 64, 48), 64, 48));
  const auto drawn = all_triangles(&one);
  ASSERT_EQ(drawn.size(), 1u);
  EXPECT_NEAR(drawn[0].v[0].x, 32 * 256, 1);
  EXPECT_NEAR(drawn[0].v[0].y, 24 * 256, 1);

  point.position[0][1] = std::numeric_limits<double>::infinity();
  SnappedSource none(kContract, mesh_reader(point, framing_view(point, 64, 48), 64, 48));
  EXPECT_TRUE(all_triangles(&none).empty());
  EXPECT_EQ(none.counters().nan_dropped, 1u);
}

TEST(FramingView, UnusedAndBrokenVerticesDoNotMoveTheCamera) {
  const Mesh pot = teapot(2);
  Mesh more = pot;
  more.position.push_back({1e9, 0, 0});
  more.position.push_back({0, std::numeric_limits<double>::quiet_NaN(), 0});
  more.triangle.push_back({0, 1, static_cast<uint32_t>(more.position.size() - 1)});
  const View a = framing_view(pot, 64, 48), b = framing_view(more, 64, 48);
  EXPECT_EQ(a.eye, b.eye);
  EXPECT_EQ(a.near, b.near);
  EXPECT_EQ(a.far, b.far);
}

TEST(CameraView, RightIsRightUpIsUpNearIsLessAndFrontIsCounterClockwise) {
  // Counter-clockwise seen from +z; the second corner lies nearer to the eye.
  Mesh mesh;
  mesh.position = {{-1, -1, 0}, {1, -1, .5}, {0, 1, 0}};
  mesh.normal = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  mesh.triangle = {{0, 1, 2}};
  const View view = camera_view(Camera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 40}, mesh, 64, 64);
  SnappedSource source(kContract, mesh_reader(mesh, view, 64, 64));
  spec::Triangle t;
  ASSERT_TRUE(source.next(&t));
  const auto& v = t.v;
  EXPECT_LT(v[0].x, v[1].x);
  EXPECT_EQ(v[2].x, 32 * 256);
  EXPECT_LT(v[2].y, v[0].y);
  EXPECT_LT(v[1].z, v[0].z);
  const int64_t area2 =
      int64_t{v[1].x - v[0].x} * (v[2].y - v[0].y) - int64_t{v[2].x - v[0].x} * (v[1].y - v[0].y);
  EXPECT_LT(area2, 0);  // positive would be clockwise
}

TEST(CameraView, AngleSpansTheHeight) {
  Mesh mesh;
  mesh.position = {{0, 1, 0}, {0, -1, 0}, {1, 0, 0}};
  mesh.normal.resize(3);
  mesh.triangle = {{0, 1, 2}};
  const View view = camera_view(Camera{{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, 90}, mesh, 200, 100);
  SnappedSource source(kContract, mesh_reader(mesh, view, 200, 100));
  spec::Triangle t;
  ASSERT_TRUE(source.next(&t));
  EXPECT_EQ(t.v[0].y, 0);
  EXPECT_EQ(t.v[1].y, 100 * 256);
  EXPECT_EQ(t.v[2].x, 150 * 256);  // square pixels
}

TEST(CameraView, LookingAwayClipsEverythingAway) {
  const Mesh pot = teapot(2);
  const View view = camera_view(Camera{{0, 0, 9}, {0, 0, 20}, {0, 1, 0}, 40}, pot, 64, 64);
  SnappedSource source(kContract, mesh_reader(pot, view, 64, 64));
  EXPECT_TRUE(all_triangles(&source).empty());
  EXPECT_EQ(source.counters().clipped_away, pot.triangle.size());
}

TEST(MeshReader, ColoursOfTheMeshStayAndShadedOnesShowTheForm) {
  Mesh pot = teapot(4);
  const View view = framing_view(pot, 64, 64);
  SnappedSource shaded(kContract, mesh_reader(pot, view, 64, 64));
  int darkest = 255, brightest = 0;
  for (const auto& t : all_triangles(&shaded)) {
    darkest = std::min(darkest, t.v[0].attr[0]);
    brightest = std::max(brightest, t.v[0].attr[0]);
  }
  EXPECT_GT(darkest, 30);
  EXPECT_GT(brightest, 3 * darkest);

  pot.color.assign(pot.position.size(), {1, 2, 3, 4});
  SnappedSource colored(kContract, mesh_reader(pot, view, 64, 64));
  for (const auto& t : all_triangles(&colored)) {
    ASSERT_EQ(t.v[2].attr, (spec::Attributes{1, 2, 3, 4}));
  }
}

TEST(MeshReader, LitColoursAreShadedAsTheFormIs) {
  Mesh pot = teapot(2);
  const View view = framing_view(pot, 64, 64);
  SnappedSource clay(kContract, mesh_reader(pot, view, 64, 64));
  pot.color.assign(pot.position.size(), {232, 190, 140, 255});  // clay, as a material's colour
  pot.is_lit = true;
  SnappedSource lit(kContract, mesh_reader(pot, view, 64, 64));
  EXPECT_TRUE(same(all_triangles(&clay), all_triangles(&lit)));
  pot.is_lit = false;
  lit.rewind();
  SnappedSource flat(kContract, mesh_reader(pot, view, 64, 64));
  EXPECT_FALSE(same(all_triangles(&lit), all_triangles(&flat)));
}

}  // namespace
}  // namespace pineda::scene
