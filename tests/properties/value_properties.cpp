// What holds of the values of any triangle.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>

#include "model/core/frame.h"
#include "tests/properties/generators.h"

namespace pineda::properties {
namespace {

bool all_same(const std::vector<Sample>& a, const std::vector<Sample>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

// The anchor does not depend on vertex order, so coverage, depths and colours all stay.
RC_GTEST_PROP(Values, WindingAndFirstVertexDoNotMatter, ()) {
  const Figure f = *figure();
  const auto expected = samples(f.frame, f.t);
  spec::Triangle turned = f.t;
  std::rotate(turned.v.begin(), turned.v.begin() + *rc::gen::inRange(0, 3), turned.v.end());
  if (*rc::gen::arbitrary<bool>()) std::swap(turned.v[0], turned.v[1]);
  RC_ASSERT(all_same(samples(f.frame, turned), expected));
}

// Moved by whole tiles, every code stays; `step` in px.
void check_moves_by(int step) {
  const Figure f = *figure_in_window();
  const int dx = step * *offset(3);
  const int dy = step * *offset(3);
  const Moved moved = move(f, dx, dy);
  RC_ASSERT(all_same(moved.before, moved.after));
}

RC_GTEST_PROP(Values, MoveWithATriangleThatMovesByWholeTiles, ()) {
  check_moves_by(1 << test::kContract.design.tile_log2);
}

// The property can fail: steps inside a tile have few fraction bits, so a shift by less than a tile
// changes some codes.
TEST(ValuesMutant, MovesByPixelsAreFalsified) {
  EXPECT_FALSE(rc::check("a mutant, to be falsified", [] { check_moves_by(1); }));
}

// The same triangle again, its vertices in another order: less passes none of its samples, lequal
// all of them, and no depth changes.
RC_GTEST_PROP(Values, DepthsOfEqualTrianglesAreBitIdentical, ()) {
  const Figure f = *figure_in_window();
  spec::Triangle again = f.t;
  std::rotate(again.v.begin(), again.v.begin() + *rc::gen::inRange(0, 3), again.v.end());
  if (*rc::gen::arbitrary<bool>()) std::swap(again.v[1], again.v[2]);
  for (const auto func : {spec::DepthFunc::kLess, spec::DepthFunc::kLequal}) {
    spec::FrameState frame = f.frame;
    frame.depth = func;
    core::Renderer renderer(test::kContract, frame);
    renderer.draw(f.t);
    const auto depth = renderer.buffer().depth;
    const uint64_t passed = renderer.counters().passed;
    const uint64_t fragments = renderer.counters().fragments;
    renderer.draw(again);
    const uint64_t more = func == spec::DepthFunc::kLess ? 0 : fragments;
    RC_ASSERT(renderer.counters().passed == passed + more);
    RC_ASSERT(renderer.buffer().depth == depth);
  }
}

}  // namespace
}  // namespace pineda::properties
