// The derived bounds against the worst triangles that a directed search finds: never exceeded, and
// approached, so that they say something.
#include "model/spec/bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/core/support.h"

namespace pineda::test {
namespace {

struct Pixel {
  int x = 0;
  int y = 0;
};

/// The planes at the first sample of a pixel's tile, as traversal hands them on, without walking
/// there: steps of whole tiles are exact modulo the planes' widths.
std::optional<spec::PlaneSet> planes_at(const spec::Contract& c, const spec::Triangle& t, Pixel p) {
  spec::SetupPrim prim;
  if (core::setup(c, kHugeFrame, t, &prim) != core::Drop::kNone) return std::nullopt;
  const int log2 = c.design.tile_log2;
  if (!core::clip_rows(c, p.y >> log2, p.y >> log2, &prim)) return std::nullopt;
  const int64_t columns = int64_t{(p.x >> log2) - (prim.x0 >> log2)} << log2;
  if (columns < 0 || p.x > prim.x1) return std::nullopt;
  prim.x0 = p.x >> log2 << log2;
  for (auto& edge : prim.edge) edge.e += edge.a * columns;
  const auto across = [columns](spec::Plane* plane, int bits) {
    plane->ref = spec::wrap(plane->ref + plane->dx * columns, bits);
  };
  across(&prim.planes.z, c.width.depth_plane);
  for (size_t i = 0; i < static_cast<size_t>(c.design.attributes); ++i) {
    across(&prim.planes.attr[i], c.width.attr_plane);
  }
  core::TileWalk walk(c, prim);
  core::Tile tile;
  if (walk.next(&tile) != core::TileWalk::Test::kKept) return std::nullopt;
  return tile.planes;
}

/// A plane's value at a pixel of the tile before its final rounding, in 2^-F' units.
int64_t unrounded(const spec::Plane& plane, int i, int j, int bits) {
  return spec::wrap(plane.ref + i * plane.dx + j * plane.dy, bits);
}

enum class What { kDepth, kColor };

/// |value before rounding - exact| at a covered sample, in codes; less than 0 if it is not covered.
double error_at(const spec::Contract& c, What what, const spec::Triangle& t, Pixel p) {
  const exact::Judge exact = judge(kHugeFrame, t);
  if (exact.culled() || !exact.covers(p.x, p.y)) return -1;
  const auto planes = planes_at(c, t, p);
  if (!planes) return -1;
  const int mask = (1 << c.design.tile_log2) - 1;
  const int f = c.design.tile_fraction_bits;
  const int i = p.x & mask;
  const int j = p.y & mask;
  const int64_t value = what == What::kDepth
                            ? unrounded(planes->z, i, j, c.width.depth_tile_plane)
                            : unrounded(planes->attr[0], i, j, c.width.attr_tile_plane);
  const int64_t code = value >> f;
  const double fraction = std::ldexp(static_cast<double>(value & ((int64_t{1} << f) - 1)), -f);
  return std::abs((what == What::kDepth ? exact.depth_error(p.x, p.y, code)
                                        : exact.attribute_error(p.x, p.y, 0, code)) +
                  fraction);
}

struct Candidate {
  spec::Triangle t;
  Pixel p;
  double error = -1;
};

int nudge(Random& random, int value, int low, int high) {
  const int reach = 1 << random.in(0, 14);
  return static_cast<int>(
      std::clamp<int64_t>(value + random.in(-reach, reach), int64_t{low}, int64_t{high}));
}

/// A triangle as large as the guard band, its sample in the corner opposite to the anchor and in
/// the last corner of a tile: where each term of the bound is largest.
Candidate start(Random& random) {
  const auto near = [&](int corner) {
    return std::clamp(corner + random.coordinate(-200 * kPx, 200 * kPx), kGuardLow, kGuardHigh);
  };
  Candidate c;
  const Point first{near(kGuardLow), near(kGuardLow)};
  const Point far{near(kGuardHigh), near(kGuardHigh)};
  c.t = triangle(first, far, {near(random.in(0, 1) != 0 ? 0 : kGuardHigh), near(kGuardHigh)});
  c.p = {16383 - 8 * random.coordinate(0, 6), 16383 - 8 * random.coordinate(0, 6)};
  // From one end of the range at the anchor to the other: the reciprocal's error counts in full.
  const bool up = random.in(0, 1) != 0;
  for (size_t i = 0; i < 3; ++i) {
    const bool top = (i != 0) == up;
    c.t.v[i].z = top ? kMaxDepthInput : 0;
    c.t.v[i].attr[0] = top ? 255 : 0;
  }
  return c;
}

Candidate changed(Random& random, Candidate c, What what) {
  auto& v = c.t.v[static_cast<size_t>(random.in(0, 2))];
  switch (random.in(0, 2)) {
    case 0:
      v.x = nudge(random, v.x, kGuardLow, kGuardHigh);
      break;
    case 1:
      v.y = nudge(random, v.y, kGuardLow, kGuardHigh);
      break;
    default:
      if (what == What::kDepth) {
        const int64_t reach = int64_t{1} << random.in(0, 31);
        v.z = std::clamp<int64_t>(v.z + random.in(-reach, reach), 0, kMaxDepthInput);
      } else {
        v.attr[0] = nudge(random, v.attr[0], 0, 255);
      }
  }
  return c;
}

constexpr int kStarts = 24;
constexpr int kSteps = 6000;

/// Hill climbing from several starts.
Candidate search(const spec::Contract& contract, What what) {
  Random random(71);
  Candidate best;
  for (int s = 0; s < kStarts; ++s) {
    Candidate at = start(random);
    at.error = error_at(contract, what, at.t, at.p);
    for (int n = 0; n < kSteps; ++n) {
      Candidate next = changed(random, at, what);
      next.error = error_at(contract, what, next.t, next.p);
      if (next.error > at.error) at = next;
    }
    if (at.error > best.error) best = at;
  }
  return best;
}

class Bound : public testing::TestWithParam<spec::Design> {};
INSTANTIATE_TEST_SUITE_P(Designs, Bound, testing::ValuesIn(spec::designs()),
                         [](const auto& d) { return std::string(d.param.name); });

void expect_close_below(double error, double bound, const char* unit) {
  testing::Test::RecordProperty(std::string("max_before_rounding_") + unit, std::to_string(error));
  testing::Test::RecordProperty(std::string("bound_") + unit, std::to_string(bound));
  EXPECT_LE(error, bound) << unit;
  EXPECT_GE(error, bound / 4) << unit << ": the bound is never approached";
}

TEST_P(Bound, BeforeTheRoundingHoldsAndIsApproached) {
  const spec::Design& d = GetParam();
  if (d.reciprocal_scheme == spec::ReciprocalScheme::kNone) {
    const auto bounds = spec::error_bounds_before_rounding(d);
    EXPECT_EQ(bounds.depth_ulp, 0);  // ExactPlanes.EveryCodeIsTheNearest shows that it holds
    EXPECT_EQ(bounds.attribute_lsb, 0);
    return;
  }
  const spec::Contract c = spec::contract(d);
  const auto bounds = spec::error_bounds_before_rounding(d);
  expect_close_below(search(c, What::kDepth).error, bounds.depth_ulp, "depth_ulp");
  expect_close_below(search(c, What::kColor).error, bounds.attribute_lsb, "color_lsb");
}

// The search is worth its name: it finds far more than as many random triangles of the same size.
TEST(BoundSearch, FindsMoreThanChanceDoes) {
  Random random(72);
  double by_chance = 0;
  for (int n = 0; n < kStarts * kSteps; ++n) {
    Candidate c = start(random);
    const auto anywhere = [&] { return random.coordinate(kGuardLow, kGuardHigh); };
    for (auto& v : c.t.v) {
      v.x = anywhere();
      v.y = anywhere();
      v.z = random.in(0, kMaxDepthInput);
    }
    c.p = {random.coordinate(0, 16383), random.coordinate(0, 16383)};
    by_chance = std::max(by_chance, error_at(kContract, What::kDepth, c.t, c.p));
  }
  EXPECT_GT(by_chance, 0);
  EXPECT_GT(search(kContract, What::kDepth).error, 1.1 * by_chance);
}

// A bound that is too tight is refuted: two fraction bits less than the formula takes.
TEST(BoundSearch, RefutesTheBoundOfAFinerDesign) {
  spec::Design finer = spec::kHighTile;
  finer.gradient_fraction_bits += 2;
  finer.tile_fraction_bits += 2;
  EXPECT_GT(search(kContract, What::kDepth).error,
            spec::error_bounds_before_rounding(finer).depth_ulp);
}

TEST(BoundFormula, GivesTheDocumentedFigures) {
  const auto depth = [](const char* name) {
    return spec::error_bounds(*spec::find_design(name)).depth_ulp;
  };
  EXPECT_NEAR(depth("high"), .65, .005);
  EXPECT_NEAR(depth("high_tile"), .68, .005);
  EXPECT_NEAR(depth("exact"), .5, .002);
  EXPECT_NEAR(spec::error_bounds(spec::kHighTile).attribute_lsb, .66, .01);
}

}  // namespace
}  // namespace pineda::test
