// The generator: the same files every time, and none that the judge contradicts.
#include "vectors/generator/generate.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "model/spec/design_file.h"
#include "tests/vectors/samples.h"

namespace pineda::vectors {
namespace {

template <class Case>
std::string generated(uint64_t seed) {
  return write_text(generate<Case>(kContract, {1, seed, {}}, kBounds));
}

TEST(Generator, SameSeedGivesTheSameBytesAndAnotherSeedDoesNot) {
  EXPECT_EQ(generated<SetupCase>(7), generated<SetupCase>(7));
  EXPECT_NE(generated<SetupCase>(7), generated<SetupCase>(8));
}

// Also those with a guard band that is small; what is written is what is read.
template <class Case>
void expect_own_vectors(const spec::Design& design) {
  const auto file = generate<Case>(spec::contract(design), {}, spec::error_bounds(design));
  EXPECT_GT(file.cases.size(), 200u) << design.name;
  for (const Case& c : read_text<Case>("f.txt", write_text(file)).cases) {
    const auto text = difference(file.contract, c, run_model(file.contract, c));
    ASSERT_FALSE(text) << design.name << ": " << *text;
  }
}

TEST(Generator, EveryDesignHasVectors) {
  for (const spec::Design& design : spec::designs()) {
    if (spec::no_rtl_reason(design).empty()) expect_own_vectors<InterpZtestCase>(design);
  }
}

TEST(Generator, DesignsFromFilesHaveVectors) {
  for (const char* guard_bits : {"6", "9"}) {
    const auto design = spec::parse_design(
        std::string("base = 'tiny'\nsubpixel_bits = 5\nguard_bits = ") + guard_bits, "own");
    expect_own_vectors<SetupCase>(design);
    expect_own_vectors<TraversalCase>(design);
    expect_own_vectors<InterpZtestCase>(design);
    expect_own_vectors<FrameCase>(design);
  }
}

TEST(Generator, TallyAccountsForEveryScene) {
  uint64_t of_the_level = 0;
  const Tally tally =
      for_each_case<TraversalCase>(kContract, {1, 3, {}}, kBounds, [&](const TraversalCase& c) {
        const bool is_of_no_scene = c.name.rfind("any", 0) == 0 || c.name.rfind("raw", 0) == 0;
        of_the_level += is_of_no_scene ? 0 : 1;
      });
  EXPECT_GE(tally.cases, of_the_level);
  EXPECT_EQ(of_the_level + tally.empty + tally.large, scenes(kContract, 1, 3).size());
}

TEST(Generator, LevelTwoBeginsEachClassAsLevelOneDoes) {
  const auto small = scenes(kContract, 1, 9);
  const auto large = scenes(kContract, 2, 9);
  EXPECT_EQ(large.size(), 8 * small.size());
  EXPECT_EQ(large[0].name, small[0].name);
  EXPECT_EQ(large[0].triangles[0].v[0].z, small[0].triangles[0].v[0].z);
}

TEST(Generator, EveryVertexLiesInsideTheFormats) {
  const int64_t guard = int64_t{1} << (spec::kHighTile.guard_bits + spec::kHighTile.subpixel_bits);
  int64_t least = 0;
  int64_t greatest = 0;
  for (const Scene& scene : scenes(kContract, 1, 4)) {
    for (const auto& triangle : scene.triangles) {
      for (const auto& v : triangle.v) {
        least = std::min<int64_t>({least, v.x, v.y});
        greatest = std::max<int64_t>({greatest, v.x, v.y});
        EXPECT_TRUE(v.z >= 0 && v.z <= 0xffffff00);
      }
    }
  }
  EXPECT_EQ(least, -guard);  // reached, but not exceeded
  EXPECT_EQ(greatest, guard - 1);
}

TEST(Generator, ACountIsKeptToAndBeginsAsTheLevelDoes) {
  const auto level = generate<SetupCase>(kContract, {}, kBounds);
  for (const uint64_t count : {uint64_t{3}, uint64_t{700}}) {
    const auto file = generate<SetupCase>(kContract, {1, 1, count}, kBounds);
    ASSERT_EQ(file.cases.size(), count);
    EXPECT_EQ(file.cases[2].name, level.cases[2].name);
  }
}

TEST(Misjudged, SceneWithinTheBoundsIsBorneOut) {
  const Scene scene{"sample.0", sample_frame(), sample_triangles(), {}, {}};
  EXPECT_EQ(misjudged(kContract, scene, kBounds), std::nullopt);
}

TEST(Misjudged, BoundBelowTheLastRoundingIsRefused) {
  spec::ErrorBounds depth = kBounds;
  depth.depth_ulp = .4;
  EXPECT_THROW(generate<SetupCase>(kContract, {}, depth), Misjudged);
  spec::ErrorBounds attribute = kBounds;
  attribute.attribute_lsb = .4;
  EXPECT_THROW(generate<FrameCase>(kContract, {}, attribute), Misjudged);
}

// Mutant: a model with an edge too narrow for its values covers the wrong samples.
TEST(Misjudged, WrongCoverageIsSeen) {
  spec::Contract narrow = kContract;
  narrow.width.tile_edge = 12;
  const Scene scene{"sample.0", sample_frame(), sample_triangles(), {}, {}};
  const std::string text = misjudged(narrow, scene, kBounds).value_or("none");
  EXPECT_EQ(text.find("scene sample.0, triangle "), 0u) << text;
  EXPECT_NE(text.find("sample"), std::string::npos) << text;
}

// Mutant: depth planes a few bits too narrow give wrong codes.
TEST(Misjudged, WrongDepthIsSeen) {
  spec::Contract narrow = kContract;
  narrow.width.depth_plane -= 10;
  Scene scene{"deep.0", sample_frame(), sample_triangles(), {}, {}};
  for (auto& v : scene.triangles[0].v) v.z = 0xfffff000;
  const std::string text = misjudged(narrow, scene, kBounds).value_or("none");
  EXPECT_NE(text.find("codes off"), std::string::npos) << text;
}

}  // namespace
}  // namespace pineda::vectors
