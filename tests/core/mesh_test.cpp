// Closed meshes: every sample inside is hit exactly once, whatever the winding and the order.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "tests/core/support.h"

namespace pineda::test {
namespace {

constexpr int kColumns = 48;
constexpr int kRows = 36;

// A rectangle of quads, each split along either diagonal. Inner corners are jittered by a fifth of
// the spacing; corners on the rim stay, so that the covered rectangle is known.
struct Mesh {
  std::vector<spec::Triangle> triangles;
  int left, top, right, bottom;  // subpixels
};

Mesh make_mesh(Random& random, int spacing, int lattice) {
  Mesh mesh;
  mesh.left = mesh.top = 3 * kHalfPx;
  mesh.right = mesh.left + kColumns * spacing;
  mesh.bottom = mesh.top + kRows * spacing;
  std::vector<Point> corners;
  const auto jitter = [&] { return random.between(-spacing / 5, spacing / 5) / lattice * lattice; };
  for (int j = 0; j <= kRows; ++j) {
    for (int i = 0; i <= kColumns; ++i) {
      const bool rim = i == 0 || j == 0 || i == kColumns || j == kRows;
      corners.push_back({mesh.left + i * spacing + (rim ? 0 : jitter()),
                         mesh.top + j * spacing + (rim ? 0 : jitter())});
    }
  }
  const auto add = [&](Point a, Point b, Point c) {
    for (int64_t turns = random.between(0, 2); turns > 0; --turns) {
      a = std::exchange(b, std::exchange(c, a));
    }
    if (random.between(0, 1) != 0) std::swap(a, b);
    mesh.triangles.push_back(triangle(a, b, c));
  };
  for (int j = 0; j < kRows; ++j) {
    for (int i = 0; i < kColumns; ++i) {
      const auto corner = [&](int di, int dj) {
        return corners[static_cast<size_t>((j + dj) * (kColumns + 1) + i + di)];
      };
      const bool falling = random.between(0, 1) != 0;
      const Point p = falling ? corner(0, 0) : corner(1, 0);
      const Point q = falling ? corner(1, 1) : corner(0, 1);
      add(p, q, falling ? corner(1, 0) : corner(0, 0));
      add(p, q, falling ? corner(0, 1) : corner(1, 1));
    }
  }
  for (size_t i = mesh.triangles.size() - 1; i > 0; --i) {
    std::swap(mesh.triangles[i],
              mesh.triangles[static_cast<size_t>(random.between(0, static_cast<int64_t>(i)))]);
  }
  return mesh;
}

struct Count {
  int doubles = 0;
  int holes = 0;
  int outside = 0;
  int samples = 0;
};

Count count(const Mesh& mesh, Rule rule) {
  const spec::FrameState frame{mesh.right / kPx + 5, mesh.bottom / kPx + 5, spec::Cull::kNone,
                               spec::DepthFunc::kLess};
  HitMap hits(frame);
  for (const auto& t : mesh.triangles) hits.draw(t, rule);
  Count c;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const int cx = x * kPx + kHalfPx;
      const int cy = y * kPx + kHalfPx;
      const bool inside = cx >= mesh.left && cx < mesh.right && cy >= mesh.top && cy < mesh.bottom;
      c.samples += inside ? 1 : 0;
      c.doubles += hits.at(x, y) > 1 ? 1 : 0;
      c.holes += inside && hits.at(x, y) == 0 ? 1 : 0;
      c.outside += !inside && hits.at(x, y) > 0 ? 1 : 0;
    }
  }
  return c;
}

// Spacing and lattice in subpixels.
struct MeshCase {
  const char* name;
  int spacing;
  int lattice;
};
class SharedEdgeMesh : public testing::TestWithParam<MeshCase> {};
INSTANTIATE_TEST_SUITE_P(Grids, SharedEdgeMesh,
                         testing::Values(MeshCase{"Jittered", 1733, 1},
                                         MeshCase{"JitteredMicro", 301, 1},
                                         MeshCase{"HalfPixelLattice", 13 * kHalfPx, kHalfPx}),
                         [](const auto& c) { return std::string(c.param.name); });

TEST_P(SharedEdgeMesh, EverySampleIsHitExactlyOnce) {
  Random random(21);
  const Mesh mesh = make_mesh(random, GetParam().spacing, GetParam().lattice);
  const Count c = count(mesh, Rule::kTopLeft);
  EXPECT_GT(c.samples, 2000);
  EXPECT_EQ(c.doubles, 0);
  EXPECT_EQ(c.holes, 0);
  EXPECT_EQ(c.outside, 0);
}

class SharedEdgeMeshMutant : public testing::Test {
 protected:
  Random random_{21};
  Mesh mesh_ = make_mesh(random_, 13 * kHalfPx, kHalfPx);
};

TEST_F(SharedEdgeMeshMutant, InclusiveRuleHitsTwice) {
  EXPECT_GT(count(mesh_, Rule::kInclusive).doubles, 100);
}

TEST_F(SharedEdgeMeshMutant, StrictRuleLeavesHoles) {
  EXPECT_GT(count(mesh_, Rule::kStrict).holes, 100);
}

TEST(SharedEdgeMeshShift, MutantBiasAfterTheShiftLeavesHoles) {
  Random random(21);
  const Mesh mesh = make_mesh(random, 1733, 1);
  EXPECT_GT(count(mesh, Rule::kShiftFirst).holes, 5);
}

// A corner at the snapped middle of a neighbour's edge lies up to half a subpixel off the edge. The
// crack is legal: it is exactly the triangle between the edge and the corner.
TEST(TJunction, HitsDifferFromOneOnlyInsideTheSliver) {
  constexpr spec::FrameState kFrame{256, 256, spec::Cull::kNone, spec::DepthFunc::kLess};
  Random random(22);
  int cracks = 0;
  for (int n = 0; n < 400; ++n) {
    const auto anywhere = [&] {
      return Point{random.between(0, 256 * kPx), random.between(0, 256 * kPx)};
    };
    const Point p = anywhere();
    const Point q = anywhere();
    const Point m{(p.x + q.x) >> 1, (p.y + q.y) >> 1};
    const Point r = anywhere();
    const Point far{p.x + q.x - r.x, p.y + q.y - r.y};  // across the edge
    HitMap whole(kFrame);
    whole.draw(triangle(p, q, r));
    whole.draw(triangle(p, q, far));
    HitMap split(kFrame);
    split.draw(triangle(p, q, r));
    split.draw(triangle(p, m, far));
    split.draw(triangle(m, q, far));
    HitMap sliver(kFrame);
    sliver.draw(triangle(p, m, q));
    const auto side = [&](Point s) {
      return (int64_t{q.x} - p.x) * (s.y - p.y) - (int64_t{q.y} - p.y) * (s.x - p.x);
    };
    const int sign = (side(m) > 0) == (side(far) > 0) ? -1 : 1;
    for (int y = 0; y < kFrame.height; ++y) {
      for (int x = 0; x < kFrame.width; ++x) {
        ASSERT_EQ(split.at(x, y), whole.at(x, y) + sign * sliver.at(x, y)) << n;
        cracks += sliver.at(x, y);
      }
    }
  }
  EXPECT_GT(cracks, 20);
}

}  // namespace
}  // namespace pineda::test
