// The judge of a mesh's faces against rays in rational arithmetic.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <stdexcept>

#include "model/exact/mesh.h"
#include "model/spec/random.h"

namespace exact {
namespace {

using Rational = boost::multiprecision::cpp_rational;
constexpr int kWidth = 32, kHeight = 16;

using Point = std::array<Rational, 3>;  // x, y, w

Rational determinant(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Point point(const ClipCorner& c) { return {Rational(c.x), Rational(c.y), Rational(c.w)}; }

Point ray(int x, int y) {
  return {Rational(2 * x + 1, kWidth) - 1, 1 - Rational(2 * y + 1, kHeight), Rational(1)};
}

// Where a sample's ray meets a triangle's plane: the corners' weights there, and the place along
// the ray.
struct Crossing {
  bool exists = false;
  std::array<Rational, 3> weight;  // they sum to 1
  Rational along;
};

Crossing crossing(const std::vector<ClipCorner>& t, int x, int y) {
  const Point a = point(t[0]), b = point(t[1]), c = point(t[2]), s = ray(x, y);
  const std::array<Rational, 3> part = {determinant(s, b, c), determinant(a, s, c),
                                        determinant(a, b, s)};
  const Rational sum = part[0] + part[1] + part[2];
  Crossing result;
  if (sum == 0) return result;
  for (size_t i = 0; i < 3; ++i) result.weight[i] = part[i] / sum;
  result.along = determinant(a, b, c) / sum;
  result.exists = true;
  return result;
}

// 1 inside, 0 outside, FaceJudge::kEither on an edge or a plane of depth.
int hits(const std::vector<ClipCorner>& t, const MeshFrame& frame, int x, int y) {
  const Crossing at = crossing(t, x, y);
  if (!at.exists || at.along <= 0) return 0;
  Rational z = 0;
  std::vector<Rational> least(at.weight.begin(), at.weight.end());
  for (size_t i = 0; i < 3; ++i) z += at.weight[i] * Rational(t[i].z);
  if (frame.low_cuts) least.push_back(z);
  if (frame.high_cuts) least.push_back(at.along - z);
  const Rational worst = *std::min_element(least.begin(), least.end());
  return worst > 0 ? 1 : worst < 0 ? 0 : FaceJudge::kEither;
}

std::vector<int> judged(const FaceJudge& judge) {
  std::vector<int> all(kWidth * kHeight);
  std::vector<int8_t> row;
  for (int y = judge.rows().first; y <= judge.rows().last; ++y) {
    judge.row(y, &row);
    for (size_t i = 0; i < row.size(); ++i) {
      all[static_cast<size_t>(y * kWidth + judge.columns().first) + i] = row[i];
    }
  }
  return all;
}

class Corners {
 public:
  explicit Corners(uint64_t seed) : random_(seed) {}

  // Corners in front of the eye and behind it, near and far; now and then on a coarse grid, so that
  // edges run through samples and corners coincide.
  ClipCorner next() {
    if (random_.bits() % 3 == 0) {
      const auto grid = [&] { return static_cast<int>(random_.bits() % 9) - 4; };
      return {grid() / 4., grid() / 4., grid() / 2., random_.bits() % 4 == 0 ? -1. : 1.};
    }
    const double w = std::ldexp(number(), static_cast<int>(random_.bits() % 7) - 3);
    return {2 * number(), 2 * number(), w - .25 * number(),
            random_.bits() % 4 == 0 ? -w : std::abs(w)};
  }
  double number() { return 2 * random_.unit() - 1; }
  uint32_t bits() { return static_cast<uint32_t>(random_.bits()); }

 private:
  pineda::spec::Random random_;
};

TEST(FaceJudge, TrianglesInFrontOfTheEyeAndBehindItAreHitWhereTheRayHits) {
  Corners corners(1);
  int inside = 0, crossing_eye = 0, on_edge = 0;
  for (int n = 0; n < 100; ++n) {
    MeshFrame frame{kWidth, kHeight};
    frame.low_cuts = n % 2 == 0;
    frame.high_cuts = n % 3 == 0;
    const std::vector<ClipCorner> t = {corners.next(), corners.next(), corners.next()};
    const FaceJudge judge(t, frame);
    const auto all = judged(judge);
    const Rational area = determinant(point(t[0]), point(t[1]), point(t[2]));
    ASSERT_EQ(judge.facing(), area.sign());
    if (area == 0) continue;  // a sample on its line may be hit; see below
    const bool crosses = std::any_of(t.begin(), t.end(), [](const auto& c) { return c.w <= 0; });
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const int wanted = hits(t, frame, x, y);
        ASSERT_EQ(all[static_cast<size_t>(y * kWidth + x)], wanted) << n << " " << x << " " << y;
        inside += wanted == 1 ? 1 : 0;
        crossing_eye += wanted == 1 && crosses ? 1 : 0;
        on_edge += wanted == FaceJudge::kEither ? 1 : 0;
      }
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(crossing_eye, 100);
  EXPECT_GT(on_edge, 10);
}

TEST(FaceJudge, ValuesAreThoseWhereTheRayHits) {
  Corners corners(2);
  int compared = 0;
  for (int n = 0; n < 300; ++n) {
    const MeshFrame frame{kWidth, kHeight};
    const std::vector<ClipCorner> t = {corners.next(), corners.next(), corners.next()};
    const std::array<double, 3> value = {255 * corners.number(), 0, 255};
    const FaceValues values({t[0], t[1], t[2]}, frame);
    for (int k = 0; k < 20; ++k) {
      const int x = static_cast<int>(corners.bits() % kWidth);
      const int y = static_cast<int>(corners.bits() % kHeight);
      if (hits(t, frame, x, y) != 1) continue;
      const Crossing at = crossing(t, x, y);
      Rational z = 0, v = 0;
      for (size_t i = 0; i < 3; ++i) {
        z += at.weight[i] * Rational(t[i].z);
        v += at.weight[i] * Rational(value[i]);
      }
      const Range depth = values.depth(x, y), attribute = values.attribute(x, y, value);
      ASSERT_NEAR(depth.low, static_cast<double>(Rational(z / at.along)), 1e-9);
      ASSERT_NEAR(depth.high, depth.low, 1e-9);
      ASSERT_NEAR(attribute.low, static_cast<double>(v), 1e-7);
      ASSERT_NEAR(attribute.high, attribute.low, 1e-7);
      ++compared;
    }
  }
  EXPECT_GT(compared, 300);
}

// A star in a random plane through three points.
std::vector<ClipCorner> star(Corners* random, size_t corners) {
  const ClipCorner o{.2 * random->number(), .2 * random->number(), .5, 1 + .2 * random->number()};
  const auto direction = [&] {
    return ClipCorner{random->number(), random->number(), 0, 2 * random->number()};
  };
  const ClipCorner u = direction(), v = direction();
  std::vector<ClipCorner> polygon;
  for (size_t i = 0; i < corners; ++i) {
    // Multiples of 2^-10, so that all lies in one plane to the last bit.
    const auto round = [](double x) { return std::round(std::ldexp(x, 10)) / 1024; };
    const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(corners);
    const double radius = i % 2 == 0 ? 1.5 : .3;
    const double p = round(radius * std::cos(angle)), q = round(radius * std::sin(angle));
    polygon.push_back({round(o.x) + p * round(u.x) + q * round(v.x),
                       round(o.y) + p * round(u.y) + q * round(v.y), .25,
                       round(o.w) + p * round(u.w) + q * round(v.w)});
  }
  return polygon;
}

// The signed hits of the fan's triangles add up to a polygon's winding number, also where it is
// concave and where a part of it lies behind the eye.
TEST(FaceJudge, ConcavePolygonIsHitAsItsSignedTrianglesSay) {
  Corners random(3);
  int inside = 0, behind = 0, hollow = 0;
  for (int n = 0; n < 60; ++n) {
    const MeshFrame frame{kWidth, kHeight};
    const auto polygon = star(&random, 10);
    ASSERT_EQ(flattened(polygon, frame).moved_px, 0);
    const auto all = judged(FaceJudge(polygon, frame));
    std::vector<int> wanted(all.size()), any(all.size());
    bool on_edge = false;
    for (size_t i = 1; i + 1 < polygon.size(); ++i) {
      const std::vector<ClipCorner> t = {polygon[0], polygon[i], polygon[i + 1]};
      const FaceJudge judge(t, frame);
      const auto part = judged(judge);
      for (size_t k = 0; k < part.size(); ++k) {
        on_edge = on_edge || part[k] == FaceJudge::kEither;
        wanted[k] += judge.facing() * part[k];
        any[k] += part[k];
      }
    }
    if (on_edge) continue;
    for (size_t k = 0; k < all.size(); ++k) {
      ASSERT_EQ(all[k], std::abs(wanted[k])) << n << " " << k;
      inside += all[k] == 1 ? 1 : 0;
      hollow += all[k] == 0 && any[k] > 0 ? 1 : 0;
    }
    behind += std::any_of(polygon.begin(), polygon.end(), [](auto& c) { return c.w < 0; }) ? 1 : 0;
  }
  EXPECT_GT(inside, 2000);
  EXPECT_GT(hollow, 200);
  EXPECT_GT(behind, 10);
}

// A corner at a position in px, on a frame whose sides are powers of two: without rounding.
ClipCorner at_px(double x, double y) { return {2 * x / kWidth - 1, 1 - 2 * y / kHeight, .5, 1}; }

TEST(FaceJudge, SamplesInTheBandOfAnEdgeMayBeHitOrNotAndNoOthers) {
  MeshFrame frame{kWidth, kHeight};
  frame.band = 1 << (MeshFrame::kBandFractionBits - 2);  // a quarter of a px
  // The edge's band is a quarter of a px: samples .5 px beside the diagonal lie outside, those .2
  // px beside it inside.
  for (const double shift : {.2, .8}) {
    const FaceJudge judge({at_px(-40, -40 + shift), at_px(80, 80 + shift), at_px(-40, 80)}, frame);
    const auto all = judged(judge);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const double above = x + shift - y;  // distance from the edge, in px down
        const int wanted = std::abs(above) <= .5 ? FaceJudge::kEither : above < 0 ? 1 : 0;
        ASSERT_EQ(all[static_cast<size_t>(y * kWidth + x)], wanted) << x << " " << y;
      }
    }
  }
}

TEST(FaceJudge, BandsEndAtASharpCornerAndAFaceSeenFromItsSideHasNothingElse) {
  MeshFrame frame{kWidth, kHeight};
  frame.band = 1 << (MeshFrame::kBandFractionBits - 4);
  // A needle along the samples of row 8 that ends at x = 10.
  const auto needle = judged(FaceJudge({at_px(2, 8.5), at_px(10, 8.5), at_px(2, 8.501)}, frame));
  const auto line = judged(FaceJudge({at_px(2, 8.5), at_px(10, 8.5), at_px(6, 8.5)}, frame));
  for (int x = 0; x < kWidth; ++x) {
    const int wanted = x >= 2 && x < 10 ? FaceJudge::kEither : 0;
    EXPECT_EQ(needle[static_cast<size_t>(8 * kWidth + x)], wanted) << x;
    EXPECT_EQ(line[static_cast<size_t>(8 * kWidth + x)], wanted) << x;
  }
  EXPECT_EQ(std::count(line.begin(), line.end(), FaceJudge::kEither), 8);
}

TEST(FaceJudge, CulledFacesAreHitNowhereAndTheScissorEndsAll) {
  MeshFrame frame{kWidth, kHeight, Cull::kBack, 4, 5, 9, 7};
  const std::vector<ClipCorner> front = {at_px(-64, 100), at_px(64, 100), at_px(8, -100)};
  const auto all = judged(FaceJudge(front, frame));
  EXPECT_EQ(std::count(all.begin(), all.end(), 1), 5 * 2);
  EXPECT_EQ(all[5 * kWidth + 4], 1);
  EXPECT_EQ(all[6 * kWidth + 8], 1);
  frame.cull = Cull::kFront;
  const auto none = judged(FaceJudge(front, frame));
  EXPECT_EQ(std::count(none.begin(), none.end(), 0), kWidth * kHeight);
}

TEST(FaceJudge, CornersOfAnyExponentAreDecidedExactly) {
  // Scaling all four coordinates of a corner moves nothing: the edge through sample centres stays
  // there.
  for (const int exponent : {-900, -300, 0, 300}) {
    std::vector<ClipCorner> t = {at_px(.5, .5), at_px(15.5, 15.5), at_px(.5, 15.5)};
    for (size_t i = 0; i < t.size(); ++i) {
      const double scale = std::ldexp(1, i == 1 ? exponent : -exponent / 2);
      t[i] = {t[i].x * scale, t[i].y * scale, t[i].z * scale, t[i].w * scale};
    }
    const auto all = judged(FaceJudge(t, {kWidth, kHeight}));
    for (int i = 0; i < 16; ++i) {
      EXPECT_EQ(all[static_cast<size_t>(i * kWidth + i)], FaceJudge::kEither) << exponent;
    }
    EXPECT_EQ(std::count(all.begin(), all.end(), 1), 14 * 13 / 2);
  }
}

TEST(Flattened, MovesCornersIntoThePlaneAndSaysHowFarThatIsSeen) {
  const MeshFrame frame{kWidth, kHeight};
  std::vector<ClipCorner> quad = {{0, 0, 0, 1}, {1, 0, 0, 2}, {1, 1, 0, 3}, {0, 1, 0, 2}};
  EXPECT_EQ(flattened(quad, frame).moved_px, 0);
  quad[2].w += 1e-3;
  const FlatPolygon flat = flattened(quad, frame);
  EXPECT_GT(flat.moved_px, 1e-4);
  EXPECT_LT(flat.moved_px, 1e-2);
  EXPECT_LT(flattened(flat.corner, frame).moved_px, 1e-12);
  // With all corners behind the eye no distance can be given, unless the polygon is planar.
  for (ClipCorner& c : quad) c.w -= 2;
  EXPECT_TRUE(std::isinf(flattened(quad, frame).moved_px));
  quad[2].w -= 1e-3;
  EXPECT_EQ(flattened(quad, frame).moved_px, 0);
  // Without a normal.
  EXPECT_TRUE(std::isinf(flattened({{0, 0, 0, 1}, {1, 0, 0, 1}, {2, 0, 0, 1}}, frame).moved_px));
}

TEST(FaceJudge, CornersThatAreNoNumbersAreRefused) {
  EXPECT_THROW(FaceJudge({{}, {}}, {kWidth, kHeight}), std::out_of_range);
  EXPECT_THROW(FaceJudge({{NAN, 0, 0, 1}, {}, {}}, {kWidth, kHeight}), std::out_of_range);
}

}  // namespace
}  // namespace exact
