// What holds of the coverage of any triangle and any mesh.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>

#include "tests/properties/generators.h"

namespace pineda::properties {
namespace {

bool same_places(const std::vector<Sample>& a, const std::vector<Sample>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_place);
}

// The properties below are not vacuous: triangles of each class often cover samples.
TEST(Generator, ReachesEveryClassWithSamples) {
  for (const bool in_window : {false, true}) {
    std::array<int, 6> drawn{};
    EXPECT_TRUE(rc::check([&] {
      const Figure f = in_window ? *figure_in_window() : *figure();
      drawn.at(static_cast<size_t>(f.shape)) += samples(f.frame, f.t).empty() ? 0 : 1;
    }));
    for (size_t i = 0; i < drawn.size(); ++i) EXPECT_GT(drawn[i], 5) << "class " << i;
  }
}

RC_GTEST_PROP(Coverage, WindingAndFirstVertexDoNotMatter, ()) {
  const Figure f = *figure();
  const auto expected = samples(f.frame, f.t);
  constexpr std::array<std::array<size_t, 3>, 5> kOrders{
      {{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (const auto& order : kOrders) {
    const spec::Triangle turned{f.t.id, {f.t.v[order[0]], f.t.v[order[1]], f.t.v[order[2]]}};
    RC_ASSERT(same_places(samples(f.frame, turned), expected));
  }
}

RC_GTEST_PROP(Coverage, MovesWithATriangleThatMovesByWholePixels, ()) {
  const Figure f = *figure();
  const int dx = *offset(40);
  const int dy = *offset(40);
  const Moved moved = move(f, dx, dy);
  RC_ASSERT(same_places(moved.before, moved.after));
}

// Slivers are left out: hardly one has a point of the lattice inside.
RC_GTEST_PROP(Coverage, IsPartitionedWhereATriangleIsSplitInside, ()) {
  const Figure f = *rc::gen::suchThat(
      figure(), [](const Figure& any) { return any.shape != test::Shape::kSliver; });
  const auto weight = [] { return int64_t{*rc::gen::inRange(1, 1000)}; };
  const std::array<int64_t, 3> w{weight(), weight(), weight()};
  const int64_t sum = w[0] + w[1] + w[2];
  spec::Vertex p;
  p.x = static_cast<int>((w[0] * f.t.v[0].x + w[1] * f.t.v[1].x + w[2] * f.t.v[2].x) / sum);
  p.y = static_cast<int>((w[0] * f.t.v[0].y + w[1] * f.t.v[1].y + w[2] * f.t.v[2].y) / sum);
  RC_PRE(side(f.t, {p.x, p.y}) >= 0);
  std::vector<Sample> whole = samples(f.frame, f.t);
  std::vector<Sample> parts;
  for (size_t i = 0; i < 3; ++i) {
    const auto part = samples(f.frame, spec::Triangle{0, {f.t.v[i], f.t.v[(i + 1) % 3], p}});
    parts.insert(parts.end(), part.begin(), part.end());
  }
  sort(&whole);
  sort(&parts);
  RC_ASSERT(same_places(whole, parts));
}

bool hits_each_sample_once(const Mesh& mesh, test::Rule rule) {
  test::HitMap hits(test::kWindow);
  for (const spec::Triangle& t : mesh.triangles) hits.draw(t, rule);
  return hits.count(1) == test::kWindow.width * test::kWindow.height;
}

RC_GTEST_PROP(ClosedMesh, HitsEachSampleOnce, ()) {
  RC_ASSERT(hits_each_sample_once(*mesh(), test::Rule::kTopLeft));
}

// The property can fail: it falsifies other rules for samples on edges.
TEST(ClosedMeshMutant, InclusiveAndStrictRulesAreFalsified) {
  for (const auto rule : {test::Rule::kInclusive, test::Rule::kStrict}) {
    EXPECT_FALSE(rc::check("a mutant, to be falsified",
                           [rule] { RC_ASSERT(hits_each_sample_once(*mesh(), rule)); }));
  }
}

}  // namespace
}  // namespace pineda::properties
