#include "model/scene/snap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "model/exact/exact.h"
#include "model/spec/random.h"
#include "tests/scene/scratch.h"

namespace pineda::scene {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

float from_bits(uint32_t bits) {
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

spec::Contract contract_of(int subpixel_bits, int depth_bits) {
  spec::Design design;
  design.subpixel_bits = subpixel_bits;
  design.depth_bits = depth_bits;
  return spec::contract(design);
}

// Values at which the result changes, and the floats next to them.
std::vector<float> interesting() {
  std::vector<float> values;
  for (const float base : {0.0f,
                           from_bits(1),
                           from_bits(0x7fffff),
                           std::numeric_limits<float>::min(),
                           0x1p-60f,
                           0x1p-33f,
                           0x1p-32f,
                           0x1p-25f,
                           0x1p-24f,
                           1 / 1024.f,
                           1 / 512.f,
                           1 / 256.f,
                           3 / 512.f,
                           5 / 512.f,
                           .25f,
                           .5f,
                           1.f,
                           16383.f,
                           16383.99609375f,
                           16383.998046875f,
                           16384.f,
                           16385.f,
                           1e10f,
                           std::numeric_limits<float>::max(),
                           kInf}) {
    for (const float value : {base, std::nextafter(base, 0.0f), std::nextafter(base, kInf)}) {
      values.push_back(value);
      values.push_back(-value);
    }
  }
  return values;
}

void expect_like_exact(const spec::Contract& c, float value) {
  SCOPED_TRACE(testing::Message() << std::hexfloat << value);
  const bool denormal = std::fpclassify(value) == FP_SUBNORMAL;
  bool saturated = false, clamped = false;
  Counters counted;
  const auto x = snap_coordinate(c, value, &counted);
  const auto z = snap_depth(c, value, &counted);
  if (denormal) {
    EXPECT_EQ(x, 0);
    EXPECT_EQ(z, 0);
    EXPECT_EQ(counted.denormals, 2u);
    return;
  }
  EXPECT_EQ(x, exact::snap(value, c.design.subpixel_bits, c.design.guard_bits, &saturated));
  EXPECT_EQ(z, exact::depth_input(value, c.design.depth_bits, &clamped));
  EXPECT_EQ(counted.saturated, saturated ? 1u : 0u);
  EXPECT_EQ(counted.z_clamped, clamped ? 1u : 0u);
  EXPECT_EQ(counted.denormals, 0u);
}

TEST(Snap, EveryBorderRoundsLikeTheJudge) {
  for (const int subpixel_bits : {4, 8, 12}) {
    for (const int depth_bits : {16, 24, 30, 31, 32}) {
      const auto c = contract_of(subpixel_bits, depth_bits);
      for (const float value : interesting()) expect_like_exact(c, value);
    }
  }
}

TEST(Snap, RandomBitPatternsRoundLikeTheJudge) {
  spec::Random random(1);
  for (int i = 0; i < 100000; ++i) {
    const float any = from_bits(static_cast<uint32_t>(random.bits()));
    if (!std::isnan(any)) expect_like_exact(kContract, any);
    // Inside the guard band, where the rounding matters
    expect_like_exact(kContract, static_cast<float>(random.bits() >> 32) * 0x1p-17f - 0x1p14f);
    if (HasFailure()) return;
  }
}

TEST(Snap, HalvesGoToEvenAndTheGuardBandSaturates) {
  Counters counted;
  const auto snap = [&](float value) { return snap_coordinate(kContract, value, &counted); };
  EXPECT_EQ(snap(1 / 512.f), 0);
  EXPECT_EQ(snap(3 / 512.f), 2);
  EXPECT_EQ(snap(-1 / 512.f), 0);
  EXPECT_EQ(snap(-3 / 512.f), -2);
  EXPECT_EQ(snap(-0.0f), 0);
  EXPECT_EQ(snap(-16384.f), -4194304);
  EXPECT_EQ(snap(16383.99609375f), 4194303);
  EXPECT_EQ(counted.saturated, 0u);
  EXPECT_EQ(snap(16384.f), 4194303);
  EXPECT_EQ(snap(-kInf), -4194304);
  EXPECT_EQ(counted.saturated, 2u);
}

// z = m/2^24, so 256*z*(2^24 - 1) = 256*m - m/2^16: computed here without a product or shift that
// the code uses.
TEST(SnapDepth, EveryFloatFromHalfToOneIsRoundedOnce) {
  Counters counted;
  uint64_t wrong = 0, wrong_in_floats = 0;
  for (int32_t m = 1 << 23; m <= 1 << 24; ++m) {
    const float z = static_cast<float>(m) * 0x1p-24f;
    const int64_t half_up = 256 * int64_t{m} - ((m - (1 << 15) + 65535) >> 16);
    wrong += snap_depth(kContract, z, &counted) != half_up ? 1 : 0;
    const int64_t code = m - ((m - (1 << 23) + (1 << 24) - 1) >> 24);
    wrong_in_floats += static_cast<int64_t>(z * 16777215 + .5f) != code ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_EQ(counted.z_clamped, 0u);
  // The mutant: the formula in binary32 fails for half of them.
  EXPECT_GT(wrong_in_floats, uint64_t{1} << 21);
}

ScreenTriangle small_triangle() {
  ScreenTriangle t;
  t.v[0] = {1, 1, 0, 1, {255, 0, 128, 7}};
  t.v[1] = {5, 1, .5, 1, {0, 255, 1, 254}};
  t.v[2] = {1, 5, 1, 1, {3, 4, 5, 6}};
  return t;
}

TEST(SnappedSource, NanInEachComponentDropsTheTriangleAndKeepsTheNumbers) {
  std::vector<ScreenTriangle> list(13, small_triangle());
  for (size_t i = 0; i < 12; ++i) {
    auto& v = list[i].v[i / 4];
    (i % 4 == 0 ? v.x : i % 4 == 1 ? v.y : i % 4 == 2 ? v.z : v.w) = kNan;
    v.rgba = {};
    list[i].v[(i / 4 + 1) % 3].x = kInf;  // not counted: the triangle is gone
  }
  list[12].id = 12;
  SnappedSource source(kContract, std::make_unique<ListReader>(list));
  for (int pass = 0; pass < 2; ++pass) {
    const auto kept = all_triangles(&source);
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(kept[0].id, 12u);
    EXPECT_EQ(source.counters().triangles, 13u);
    EXPECT_EQ(source.counters().nan_dropped, 12u);
    EXPECT_EQ(source.counters().saturated, 0u);
    source.rewind();
    EXPECT_EQ(source.counters().triangles, 0u);
  }
}

// Any bits at all, NaNs and infinities among them, but for W, which a reader refuses.
std::vector<ScreenTriangle> any_triangles(size_t count) {
  spec::Random random(7);
  std::vector<ScreenTriangle> list(count);
  for (size_t i = 0; i < count; ++i) {
    list[i].id = static_cast<uint32_t>(i);
    for (ScreenVertex& v : list[i].v) {
      for (float* value : {&v.x, &v.y, &v.z}) {
        const bool is_usual = random.between(0, 15) > 0;
        const auto bits = static_cast<uint32_t>(random.bits());
        *value = is_usual ? random.uniform(-1, 2) : from_bits(bits);
      }
      v.w = random.coin() ? 1 : random.uniform(.1f, 10);
      for (uint8_t& byte : v.rgba) byte = static_cast<uint8_t>(random.bits());
    }
    if (i % 50 == 0) list[i].v[i % 3].z = kNan;
  }
  return list;
}

void expect_equal(const spec::Triangle& a, const spec::Triangle& b) {
  ASSERT_EQ(a.id, b.id);
  for (size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(a.v[i].x, b.v[i].x) << a.id;
    ASSERT_EQ(a.v[i].y, b.v[i].y) << a.id;
    ASSERT_EQ(a.v[i].z, b.v[i].z) << a.id;
    ASSERT_EQ(a.v[i].attr, b.v[i].attr) << a.id;
    ASSERT_EQ(a.v[i].inverse_w, b.v[i].inverse_w) << a.id;
    ASSERT_EQ(a.v[i].inverse_w_shift, b.v[i].inverse_w_shift) << a.id;
  }
}

TEST(SnappedSource, GivesManyAtOnceAsOneByOne) {
  const auto list = any_triangles(1000);
  SnappedSource source(kContract, std::make_unique<ListReader>(list));
  const auto one_by_one = all_triangles(&source);
  const Counters counted = source.counters();
  EXPECT_GT(counted.nan_dropped, 19u);
  for (const size_t count : {1u, 63u, 64u, 65u, 1000u, 5000u}) {
    source.rewind();
    // What the array held before does not show.
    spec::Triangle other;
    for (spec::Vertex& v : other.v) v.attr.fill(9);
    std::vector<spec::Triangle> chunk(count, other);
    size_t at = 0;
    for (size_t got = count; got == count; at += got) {
      got = source.next_many(chunk.data(), count);
      ASSERT_LE(at + got, one_by_one.size());
      for (size_t i = 0; i < got; ++i) expect_equal(chunk[i], one_by_one[at + i]);
    }
    EXPECT_EQ(at, one_by_one.size());
    EXPECT_EQ(source.next_many(chunk.data(), count), 0u);
    for (const auto member : {&Counters::triangles, &Counters::nan_dropped, &Counters::saturated,
                              &Counters::z_clamped, &Counters::denormals, &Counters::perspective}) {
      EXPECT_EQ(source.counters().*member, counted.*member);
    }
  }
}

TEST(SnappedSource, ColoursAreExactAtEightBitsAndScaledAtOthers) {
  const auto attributes = [](int count, int bits) {
    spec::Design design;
    design.attributes = count;
    design.attribute_bits = bits;
    SnappedSource source(spec::contract(design),
                         std::make_unique<ListReader>(std::vector{small_triangle()}));
    return all_triangles(&source).at(0).v[0].attr;
  };
  EXPECT_EQ(attributes(4, 8), (spec::Attributes{255, 0, 128, 7}));
  EXPECT_EQ(attributes(4, 16), (spec::Attributes{65535, 0, 32896, 1799}));
  EXPECT_EQ(attributes(4, 1), (spec::Attributes{1, 0, 1, 0}));
  EXPECT_EQ(attributes(1, 8), (spec::Attributes{255}));
  EXPECT_EQ(attributes(16, 8), (spec::Attributes{255, 0, 128, 7}));
}

}  // namespace
}  // namespace pineda::scene
