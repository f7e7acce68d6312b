// Setup quickly: the bits of core's, of every design, at every level.
#include "model/fast/setup.h"

#include <gtest/gtest.h>

#include "model/fast/planes.h"
#include "model/fast/reciprocal.h"
#include "model/spec/difference.h"
#include "tests/core/hard_triangles.h"
#include "tests/fast/levels.h"

namespace pineda::test {
namespace {

using core::Drop;
using fast::Planes;

/// `prim`, with the fields that `planes` did not ask for taken from `all`.
spec::SetupPrim completed(spec::SetupPrim prim, const spec::SetupPrim& all, Planes planes) {
  if (planes == Planes::kNone) prim.planes = all.planes;
  if (planes == Planes::kDepth) {
    prim.planes.attr = all.planes.attr;
    prim.planes.flat = all.planes.flat;
    prim.planes.perspective = all.planes.perspective;
  }
  return prim;
}

struct Outcome {
  int drawn = 0;
  int different = 0;
};

Outcome compare(const spec::Design& design, int triangles, bool with_bias) {
  const spec::Contract c = spec::contract(design);
  Random random(17);
  Outcome outcome;
  for (int n = 0; n < triangles; ++n) {
    spec::FrameState frame = hard_frame(random, design);
    if (with_bias) {
      frame.bias_constant = random.between(-5000, 5000);
      frame.bias_slope = static_cast<int32_t>(random.between(-32768, 32767));
    }
    const spec::Triangle t = hard_triangle(random, design);
    spec::SetupPrim expected;
    const Drop drop = core::setup(c, frame, t, &expected);
    outcome.drawn += drop == Drop::kNone ? 1 : 0;
    for (const Planes planes : {Planes::kNone, Planes::kDepth, Planes::kAll}) {
      spec::SetupPrim prim;
      bool equal = fast::setup(c, frame, t, &prim, planes) == drop;
      if (equal && drop == Drop::kNone) {
        equal = !spec::difference(c, expected, completed(prim, expected, planes));
      }
      outcome.different += equal ? 0 : 1;
    }
  }
  return outcome;
}

TEST(FastSetup, EqualsCoreInEveryNamedDesignAndAtTheLimitsOfWords) {
  std::vector<spec::Design> all = spec::designs();
  for (const spec::Design& d : limit_designs()) all.push_back(d);
  spec::Design hidden = spec::kHighTile;
  hidden.name = "hidden";
  hidden.hierarchical_z = true;
  all.push_back(hidden);
  int narrow = 0;
  for (const spec::Design& d : all) {
    narrow += fast::has_narrow_attributes(spec::contract(d)) ? 1 : 0;
    for_each_level([&] {
      for (const bool with_bias : {false, true}) {
        const Outcome outcome = compare(d, 3000, with_bias);
        EXPECT_EQ(outcome.different, 0) << d.name << " bias " << with_bias;
        EXPECT_GT(outcome.drawn, 700) << d.name;
      }
    });
  }
  // Both ways to compute planes of attributes are tested.
  EXPECT_GE(narrow, 5);
  EXPECT_GE(static_cast<int>(all.size()) - narrow, 5);
}

spec::Design random_design(Random& random) {
  const auto in = [&](int low, int high) { return static_cast<int>(random.between(low, high)); };
  spec::Design d;
  d.subpixel_bits = in(4, 12);
  d.guard_bits = in(7, 14);
  d.depth_bits = in(16, 32);
  d.attributes = in(0, 16);
  d.flat_attributes = in(0, spec::kMaxAttributes - d.attributes);
  d.attribute_bits = in(1, 16);
  d.perspective = in(0, 4) == 0;
  d.reciprocal_scheme = static_cast<spec::ReciprocalScheme>(in(0, 4));
  d.reciprocal_lut_bits = in(4, 12);
  d.reciprocal_newton_steps = in(0, 2);
  d.reciprocal_bits = in(12, 32);
  d.gradient_fraction_bits = in(8, 20);
  d.tile_fraction_bits = in(1, d.gradient_fraction_bits);
  d.tile_log2 = in(2, 6);
  return d;
}

TEST(FastSetup, EqualsCoreInRandomDesigns) {
  Random random(23);
  int valid = 0;
  for (int i = 0; i < 2000 && valid < 120; ++i) {
    const spec::Design d = random_design(random);
    if (!spec::invalid_reason(d).empty()) continue;
    ++valid;
    for_each_level([&] { ASSERT_EQ(compare(d, 300, true).different, 0) << "design " << i; });
  }
  EXPECT_EQ(valid, 120);
}

// Planes side by side take numerators up to 32 bits and products up to 64.
TEST(FastSetup, NarrowAttributesEndWhereWordsDo) {
  const auto is_narrow = [](const spec::Design& d) {
    return fast::has_narrow_attributes(spec::contract(d));
  };
  EXPECT_TRUE(is_narrow(variant("", 8, 8, 4, 31)));
  EXPECT_FALSE(is_narrow(variant("", 8, 8, 4, 32)));
  EXPECT_FALSE(is_narrow(variant("", 8, 9, 4, 31)));
}

TEST(FastReciprocal, EqualsCoreFromOneToTheGreatestArea) {
  std::vector<spec::Design> all = spec::designs();
  for (const spec::Design& d : limit_designs()) all.push_back(d);
  Random random(29);
  for (const spec::Design& d : all) {
    if (!spec::has_reciprocal(d)) continue;
    const spec::Contract c = spec::contract(d);
    const int greatest = c.width.area2 - 2;
    std::vector<int64_t> areas;
    for (int length = 0; length <= greatest; ++length) {
      const int64_t power = int64_t{1} << length;
      for (const int64_t area :
           {power - 1, power, power + 1, power + random.between(0, power - 1)}) {
        if (area > 0) areas.push_back(area);
      }
    }
    for (int i = 0; i < 2000; ++i) {
      areas.push_back(random.between(1, int64_t{1} << random.between(1, greatest)));
    }
    for_each_level([&] {
      for (const int64_t area : areas) {
        const core::Reciprocal expected = core::reciprocal(c, area);
        const core::Reciprocal got = fast::reciprocal(c, area);
        ASSERT_EQ(got.mantissa, expected.mantissa) << d.name << " " << area;
        ASSERT_EQ(got.length, expected.length) << d.name << " " << area;
      }
    });
  }
}

}  // namespace
}  // namespace pineda::test
