// Planes: wrapping does not show at covered samples; codes stay when a triangle moves by whole
// tiles.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

#include "model/core/reciprocal.h"
#include "tests/core/support.h"

namespace pineda::test {
namespace {

using spec::int128_t;

// One plane evaluated at full width: what the units compute, but nothing ever wraps.
struct WidePlane {
  int128_t dx;
  int128_t dy;
  int128_t ref;
  int x;  // reference sample, px
  int y;
};

// `early_bits`: the mutant wraps the gradients to so many bits before the reference is formed; 0:
// never.
WidePlane wide_plane(const spec::Triangle& t, const spec::SetupPrim& prim,
                     const std::array<int64_t, 3>& value, int fraction_bits, int early_bits = 0) {
  const spec::Design& d = kContract.design;
  std::array<size_t, 3> v{0, 1, 2};  // topmost, then leftmost first; then clockwise
  std::sort(v.begin(), v.end(), [&](size_t i, size_t j) {
    return std::pair(t.v[i].y, t.v[i].x) < std::pair(t.v[j].y, t.v[j].x);
  });
  const auto x = [&](size_t i) { return int64_t{t.v[v[i]].x} - t.v[v[0]].x; };
  const auto y = [&](size_t i) { return int64_t{t.v[v[i]].y} - t.v[v[0]].y; };
  if (x(1) * y(2) - x(2) * y(1) < 0) std::swap(v[1], v[2]);
  const auto r = core::reciprocal(kContract, x(1) * y(2) - x(2) * y(1));
  const int64_t d1 = value[v[1]] - value[v[0]];
  const int64_t d2 = value[v[2]] - value[v[0]];
  const int shift =
      d.reciprocal_bits + r.length - 1 - d.gradient_fraction_bits - d.subpixel_bits + fraction_bits;
  const auto gradient = [&](int64_t numerator) {
    const int128_t g = spec::round_half_up(int128_t{numerator} * r.mantissa, shift);
    return early_bits == 0 ? g : int128_t{spec::wrap(g, early_bits)};
  };
  WidePlane p{gradient(d1 * y(2) - d2 * y(1)), gradient(d2 * x(1) - d1 * x(2)), 0, prim.x0 & ~7,
              prim.y0 & ~7};
  const int128_t at_ref =
      (int128_t{value[v[0]]} << (d.gradient_fraction_bits - fraction_bits + d.subpixel_bits)) +
      p.dx * (int64_t{p.x} * kPx + kHalfPx - t.v[v[0]].x) +
      p.dy * (int64_t{p.y} * kPx + kHalfPx - t.v[v[0]].y);
  p.ref = spec::round_half_up(at_ref, d.subpixel_bits);
  return p;
}

int64_t code(const WidePlane& p, int x, int y, int out_bits) {
  const spec::Design& d = kContract.design;
  const int shift = d.gradient_fraction_bits - d.tile_fraction_bits;
  const int128_t at_tile = p.ref + p.dx * ((x & ~7) - p.x) + p.dy * ((y & ~7) - p.y);
  const int128_t value = spec::round_half_up(at_tile, shift) +
                         spec::round_half_up(p.dx, shift) * (x & 7) +
                         spec::round_half_up(p.dy, shift) * (y & 7);
  const int128_t rounded = spec::round_half_up(value, d.tile_fraction_bits);
  return static_cast<int64_t>(std::clamp<int128_t>(rounded, 0, (int128_t{1} << out_bits) - 1));
}

struct Comparison {
  int samples = 0;
  int different = 0;
  int steep = 0;  // planes whose gradient does not fit its width
};

void compare(const spec::FrameState& frame, const spec::Triangle& t, int early_bits,
             Comparison* result) {
  spec::SetupPrim prim;
  if (core::setup(kContract, frame, t, &prim) != core::Drop::kNone) return;
  const WidePlane z = wide_plane(t, prim, {t.v[0].z, t.v[1].z, t.v[2].z},
                                 spec::kDepthInputFractionBits, early_bits);
  const WidePlane red = wide_plane(t, prim, {t.v[0].attr[0], t.v[1].attr[0], t.v[2].attr[0]}, 0);
  result->steep += z.dx != prim.planes.z.dx || z.dy != prim.planes.z.dy ? 1 : 0;
  core::for_each_stamp(kContract, prim, [&](const spec::Stamp& stamp) {
    spec::Fragment fragment;
    core::interpolate(kContract, stamp, &fragment);
    for_each_sample(stamp, [&](int x, int y, size_t lane) {
      ++result->samples;
      const bool same =
          fragment.z[lane] == code(z, x, y, 24) && fragment.attr[lane][0] == code(red, x, y, 8);
      result->different += same ? 0 : 1;
    });
  });
}

// A sliver that owns the pixel centre on its corner, and needles: the steepest planes.
Comparison compare_steep(int early_bits) {
  Random random(81);
  Comparison result;
  for (int n = 0; n < 12000; ++n) {
    const auto shape = n % 3 == 0 ? Shape::kNeedle : n % 3 == 1 ? Shape::kSliver : Shape::k16Px;
    spec::Triangle t = random_triangle(random, shape);
    if (n % 6 == 2) {  // a few subpixels wide
      t.v[2].x = t.v[1].x + random.between(-9, 9);
      t.v[2].y = t.v[1].y + random.between(-9, 9);
    }
    randomize_values(random, &t);
    compare(frame_of(shape), t, early_bits, &result);
  }
  return result;
}

TEST(PlaneWrap, StepsEqualEvaluationAtFullWidth) {
  const Comparison result = compare_steep(0);
  EXPECT_GT(result.samples, 50000);
  EXPECT_GT(result.steep, 500);  // these wrap
  EXPECT_EQ(result.different, 0);
}

// The mutant: the reference lies a fraction of a pixel from the anchor, so gradients that wrap to
// the plane's width before the reference is formed give other codes.
TEST(PlaneWrap, MutantThatWrapsBeforeTheReferenceIsCaught) {
  EXPECT_GT(compare_steep(kContract.width.depth_plane).different, 50);
}

// Codes by stamp, relative to a corner.
std::map<std::pair<int, int>, spec::Fragment> codes(const spec::Triangle& t, int x0, int y0) {
  std::map<std::pair<int, int>, spec::Fragment> result;
  spec::SetupPrim prim;
  if (core::setup(kContract, kHugeFrame, t, &prim) != core::Drop::kNone) return result;
  core::for_each_stamp(kContract, prim, [&](const spec::Stamp& stamp) {
    core::interpolate(kContract, stamp, &result[{stamp.x * 2 - x0, stamp.y * 2 - y0}]);
  });
  return result;
}

bool equal(const spec::Fragment& a, const spec::Fragment& b) {
  bool same = a.z == b.z;
  for (size_t lane = 0; lane < 4; ++lane) {
    same &= std::equal(a.attr[lane].begin(), a.attr[lane].begin() + 4, b.attr[lane].begin());
  }
  return same;
}

// Stamps whose codes change when triangles move by multiples of `step_px`.
Comparison translate(int step_px) {
  Random random(82);
  Comparison result;
  for (int n = 0; n < 1500; ++n) {
    spec::Triangle t = random_triangle(random, Shape::k16Px);
    for (auto& v : t.v) {  // well inside the frame, so that the box is not clipped
      v.x = v.x % (4096 * kPx) + 4096 * kPx;
      v.y = v.y % (4096 * kPx) + 4096 * kPx;
    }
    randomize_values(random, &t);
    const int dx = random.between(-400, 400) * step_px;
    const int dy = random.between(-400, 400) * step_px;
    spec::Triangle moved = t;
    for (auto& v : moved.v) {
      v.x += dx * kPx;
      v.y += dy * kPx;
    }
    const auto before = codes(t, 0, 0);
    const auto after = codes(moved, dx, dy);
    if (before.size() != after.size()) ++result.different;
    for (const auto& [place, fragment] : before) {
      const auto other = after.find(place);
      ++result.samples;
      result.different += other != after.end() && equal(fragment, other->second) ? 0 : 1;
    }
  }
  return result;
}

TEST(Translation, ByWholeTilesLeavesEveryCodeUnchanged) {
  const Comparison result = translate(8);
  EXPECT_GT(result.samples, 10000);
  EXPECT_EQ(result.different, 0);
}

// The comparison can fail: other shifts change some codes, which is known and accepted.
TEST(Translation, ByTwoPixelsChangesSomeCodes) {
  const Comparison result = translate(2);
  EXPECT_GT(result.different, 0);
  EXPECT_LT(result.different, result.samples / 10);
}

}  // namespace
}  // namespace pineda::test
