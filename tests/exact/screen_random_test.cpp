// The judge from floats on, compared with the rationals of reference.h.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

#include "model/exact/exact.h"
#include "model/spec/random.h"
#include "tests/exact/reference.h"

namespace exact {
namespace {

constexpr int kSize = 1024;  // px, of the frame

class Random : public pineda::spec::Random {
 public:
  using RandomFrom::RandomFrom;
  double real(double low, double high) { return low + (high - low) * unit(); }
};

using Positions = std::array<std::array<double, 2>, 3>;

// Corners in a square of `side` px around a place of the frame, on a lattice where a step is given.
Positions square(Random* random, double side, double step = 0) {
  const std::array<double, 2> centre{random->real(0, kSize), random->real(0, kSize)};
  Positions p{};
  for (auto& corner : p) {
    for (size_t i = 0; i < 2; ++i) {
      corner[i] = centre[i] + random->real(-side / 2, side / 2);
      if (step != 0) corner[i] = std::round(corner[i] / step) * step;
    }
  }
  return p;
}

Positions px16(Random* random) { return square(random, 16); }
Positions px256(Random* random) { return square(random, 256); }
Positions px8192(Random* random) { return square(random, 8192); }
Positions half_pixels(Random* random) { return square(random, 16, .5); }
Positions ties(Random* random) { return square(random, 16, 1 / 512.); }  // at 8 subpixel bits

// Corners at the border of the guard band, anywhere in it and a little outside.
Positions guard_band(Random* random) {
  Positions p{};
  for (auto& corner : p) {
    for (double& c : corner) {
      c = random->between(0, 2) == 0 ? random->between(0, 1) * 32768 - 16384
                                     : random->real(-17000, 17000);
    }
  }
  return p;
}

// 100 to 8000 px long, 1/16 to 2 px wide.
Positions needle(Random* random) {
  const double x = random->real(0, kSize);
  const double y = random->real(0, kSize);
  const double angle = random->real(0, 6.28318);
  const double half_length = random->real(50, 4000);
  const double width = random->real(.0625, 2);
  const double dx = std::cos(angle);
  const double dy = std::sin(angle);
  return {{{x - dx * half_length, y - dy * half_length},
           {x + dx * half_length, y + dy * half_length},
           {x - dy * width, y + dx * width}}};
}

// With cross(d, e) = 1, the corners c - d - e, c + d and c + e have a doubled area of 3 and the
// middle c: a pixel's centre, covered however thin. In units of 1/16 px.
Positions sliver(Random* random) {
  int dx = 0;
  int dy = 0;
  do {
    dx = random->between(1, 8000);
    dy = random->between(-8000, 8000);
  } while (std::gcd(dx, dy) != 1);
  int ex = 0;
  while ((1 + dy * ex) % dx != 0) ++ex;
  const int ey = (1 + dy * ex) / dx;
  const double x = random->between(0, kSize - 1) + .5;
  const double y = random->between(0, kSize - 1) + .5;
  return {{{x - (dx + ex) / 16., y - (dy + ey) / 16.},
           {x + dx / 16., y + dy / 16.},
           {x + ex / 16., y + ey / 16.}}};
}

// Close together, up to 1e6 apart, powers of two, anything that a normal float can be.
float random_w(Random* random, int kind) {
  if (kind == 0) return static_cast<float>(random->real(1, 2));
  if (kind == 1) return static_cast<float>(std::exp(random->real(0, std::log(1e6))));
  if (kind == 2) return std::ldexp(1.0f, random->between(-3, 3));
  return std::ldexp(static_cast<float>(random->between(1 << 23, (1 << 24) - 1)),
                    random->between(-126, 127) - 23);
}

ScreenTriangle random_triangle(Random* random, Positions (*shape)(Random*), int w_kind) {
  const Positions p = shape(random);
  ScreenTriangle t;
  for (size_t i = 0; i < 3; ++i) {
    t[i].x = static_cast<float>(p[i][0]);
    t[i].y = static_cast<float>(p[i][1]);
    t[i].z = static_cast<float>(random->real(-.1, 1.1));
    t[i].w = random_w(random, w_kind);
    for (int& c : t[i].rgba) c = random->between(0, 255);
  }
  return t;
}

bool equals(const Value& value, const Rational& exact) {
  const Integer whole = floor_of(exact);
  const Rational off = Rational(value.fraction) - (exact - whole);
  return value.whole == whole && value.nearest == floor_of(exact + Rational(1, 2)) &&
         value.fraction >= 0 && value.fraction < 1 && abs(off) <= Rational(0x1p-53);
}

// How many samples were compared, and how many differ.
struct Tally {
  int covered = 0;
  int outside = 0;
  int coverage_differs = 0;
  int z_differs = 0;
  int affine_differs = 0;
  int perspective_differs = 0;
};

void compare_values(const Sample& s, const Reference& reference, Tally* tally) {
  tally->z_differs += equals(s.z, reference.z(s.x, s.y)) ? 0 : 1;
  for (size_t a = 0; a < 4; ++a) {
    tally->affine_differs += equals(s.affine[a], reference.affine(s.x, s.y, a)) ? 0 : 1;
    tally->perspective_differs +=
        equals(s.perspective[a], reference.perspective(s.x, s.y, a)) ? 0 : 1;
  }
}

// Compares both ends of the span, the samples beside them, some around `middle` and random ones.
void compare_row(const ScreenJudge& judge, const Reference& reference, int y, int middle,
                 Random* random, Tally* tally) {
  std::vector<Sample> row;
  judge.row(y, true, &row);
  std::vector<int> places{middle - 1, middle, middle + 1, random->between(0, kSize - 1)};
  if (!row.empty()) {
    for (const int x : {row.front().x, row.back().x}) {
      places.insert(places.end(), {x - 1, x, x + 1});
    }
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  for (const int x : places) {
    if (x < 0 || x >= kSize) continue;
    const auto at = std::find_if(row.begin(), row.end(), [x](const Sample& s) { return s.x == x; });
    const bool covered = reference.covers(x, y);
    ++(covered ? tally->covered : tally->outside);
    if (covered != (at != row.end())) {
      ++tally->coverage_differs;
    } else if (covered) {
      ASSERT_EQ(at->y, y);
      compare_values(*at, reference, tally);
    }
  }
}

void compare(const ScreenTriangle& t, const Format& format, const Frame& frame, Fault fault,
             Random* random, Tally* tally) {
  const ScreenJudge judge(t, format, frame);
  const Reference reference(t, format, frame, fault);
  ASSERT_EQ(judge.culled(), reference.doubled_area() >= 0);
  if (judge.culled()) return;
  const float middle_x = (t[0].x + t[1].x + t[2].x) / 3;
  const float middle_y = (t[0].y + t[1].y + t[2].y) / 3;
  const Span rows = judge.rows();
  const std::array<int, 4> places{static_cast<int>(std::floor(middle_y)), rows.first,
                                  (rows.first + rows.last) / 2, rows.last};
  for (const int y : places) {
    if (y < 0 || y >= kSize) continue;  // the frame cuts
    compare_row(judge, reference, y, static_cast<int>(std::floor(middle_x)), random, tally);
  }
}

constexpr Frame kPlain{kSize, kSize, Cull::kBack};

Tally compare_random(Positions (*shape)(Random*), const Format& format, Fault fault, int count,
                     const Frame& frame = kPlain) {
  Tally tally;
  Random random{static_cast<uint64_t>(format.subpixel_bits)};
  for (int n = 0; n < count; ++n) {
    const ScreenTriangle t = random_triangle(&random, shape, n % 4);
    compare(t, format, frame, fault, &random, &tally);
    compare({{t[0], t[2], t[1]}}, format, frame, fault, &random, &tally);
  }
  return tally;
}

struct Case {
  const char* name;
  Positions (*shape)(Random*);
  Format format;
  Frame frame = kPlain;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

constexpr Format kDefault{};
constexpr Format kNarrow{1, 14, 16, 2, 10};
constexpr Format kCoarse{4, 10, 16, 4, 8};
constexpr Format kFine{12, 14, 32, 4, 16};
constexpr Frame kCut{kSize, kSize, Cull::kBack, 100, 300, 901, 702};
constexpr Frame kFlat{kSize, kSize, Cull::kBack, 0, 0, kSize, kSize, true};
// The greatest and the least slope, and in between; constants near the ends of the codes.
constexpr Frame biased(int64_t constant, int slope) {
  return {kSize, kSize, Cull::kBack, 0, 0, kSize, kSize, false, constant, slope};
}
constexpr Case kCases[] = {
    {"Px16", px16, kDefault},
    {"Px256", px256, kDefault},
    {"Px8192", px8192, kDefault},
    {"GuardBand", guard_band, kDefault},
    {"Needles", needle, kDefault},
    {"Slivers", sliver, kDefault},
    {"HalfPixels", half_pixels, kDefault},
    {"Ties", ties, kDefault},
    {"Px16Fine", px16, kFine},
    {"GuardBandFine", guard_band, kFine},
    {"NeedlesFine", needle, kFine},
    {"SliversFine", sliver, kFine},
    {"Px8192Coarse", px8192, kCoarse},
    {"SliversCoarse", sliver, kCoarse},
    {"Px256Narrow", px256, kNarrow},
    {"Px8192Cut", px8192, kDefault, kCut},
    {"Px16Flat", px16, kDefault, kFlat},
    {"Px8192BiasedUp", px8192, kDefault, biased(7, 1)},
    {"Px8192BiasedDown", px8192, kDefault, biased(-7, -300)},
    {"Px256BiasedFar", px256, kDefault, biased(5000000, 256)},
    {"NeedlesBiased", needle, kDefault, biased(-1000, 32767)},
    {"SliversBiased", sliver, kDefault, biased(1000, -32768)},
    {"GuardBandFineBiased", guard_band, kFine, biased(-(int64_t{1} << 31), 32767)},
    {"Px8192CoarseBiased", px8192, kCoarse, biased(65535, -32768)},
};

class ScreenRandom : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Shapes, ScreenRandom, testing::ValuesIn(kCases),
                         [](const auto& c) { return std::string(c.param.name); });

TEST_P(ScreenRandom, CoverageAndValuesEqualRationals) {
  const Tally tally =
      compare_random(GetParam().shape, GetParam().format, Fault::kNone, 60, GetParam().frame);
  EXPECT_EQ(tally.coverage_differs, 0);
  EXPECT_EQ(tally.z_differs, 0);
  EXPECT_EQ(tally.affine_differs, 0);
  EXPECT_EQ(tally.perspective_differs, 0);
  EXPECT_GE(tally.covered, 40);
  EXPECT_GE(tally.outside, 40);
}

// Each planted fault is seen where it has an effect, and nowhere else.
TEST(ScreenRandomMutant, InclusiveEdges) {
  const Tally tally = compare_random(half_pixels, kDefault, Fault::kInclusiveEdges, 40);
  EXPECT_GT(tally.coverage_differs, 10);
  EXPECT_EQ(tally.z_differs + tally.affine_differs + tally.perspective_differs, 0);
}

TEST(ScreenRandomMutant, TiesUp) {
  EXPECT_GT(compare_random(ties, kDefault, Fault::kTiesUp, 10).z_differs, 10);
}

TEST(ScreenRandomMutant, TruncatedDepth) {
  const Tally tally = compare_random(px16, kDefault, Fault::kTruncatedDepth, 10);
  EXPECT_GT(tally.z_differs, 10);
  EXPECT_EQ(tally.coverage_differs + tally.affine_differs + tally.perspective_differs, 0);
}

TEST(ScreenRandomMutant, WNotInverted) {
  const Tally tally = compare_random(px16, kDefault, Fault::kWNotInverted, 10);
  EXPECT_GT(tally.perspective_differs, 10);
  EXPECT_EQ(tally.coverage_differs + tally.z_differs + tally.affine_differs, 0);
}

TEST(ScreenRandomMutant, SlopesSummed) {
  const Tally tally = compare_random(px8192, kDefault, Fault::kSlopesSummed, 10, biased(0, 256));
  EXPECT_GT(tally.z_differs, 10);
  EXPECT_EQ(tally.coverage_differs + tally.affine_differs + tally.perspective_differs, 0);
}

}  // namespace
}  // namespace exact
