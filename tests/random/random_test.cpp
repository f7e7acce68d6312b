// Any design on any scene: the cycle model in its three modes, and the RTL of a random design. More
// designs: scripts/random-designs.
#include <gtest/gtest.h>

#include <set>

#include "tests/random/compare.h"
#include "tests/scene/scratch.h"

namespace pineda::test {
namespace {

std::string folder_of(const scene::Scratch& scratch) {
  const std::string any = scratch.path("x");
  return any.substr(0, any.size() - 2);
}

/// With latencies that can be made longer by a cycle.
Trial mutable_trial(const spec::Design& design, uint64_t seed, const std::string& folder) {
  Trial trial = random_trial(design, seed, folder);
  trial.bench.depth_latency_cycles = 3;  // a latency of 2 is hidden
  trial.memory = memory::Kind::kIdeal;
  return trial;
}

TEST(RandomDesigns, EveryKindOfPartIsDrawn) {
  std::set<spec::ReciprocalScheme> schemes;
  std::set<spec::SetupStyle> styles;
  std::set<int> tiles;
  std::set<int> stamps;
  std::set<std::array<bool, 3>> parts;
  for (uint64_t seed = 1; seed <= 400; ++seed) {
    const spec::Design d = random_design(seed);
    ASSERT_EQ(spec::invalid_reason(d), "") << seed;
    schemes.insert(d.reciprocal_scheme);
    styles.insert(d.setup_style);
    tiles.insert(d.tile_log2);
    stamps.insert(4 * d.stamp_width_log2 + d.stamp_height_log2);
    parts.insert({d.depth_test, d.perspective, d.hierarchical_z});
  }
  EXPECT_EQ(schemes.size(), 4u);  // all with RTL
  EXPECT_EQ(styles.size(), 3u);
  EXPECT_EQ(tiles.size(), 5u);
  EXPECT_EQ(stamps.size(), 9u);
  EXPECT_EQ(parts.size(), 6u);  // hierarchical z needs depth
}

TEST(RandomDesigns, ModesOfTheCycleModelAgreeWithEachOtherAndWithCore) {
  const scene::Scratch scratch;
  uint64_t samples = 0;
  std::set<memory::Kind> memories;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    const auto contract = spec::contract(random_design(seed));
    for (uint64_t i = 0; i < 3; ++i) {
      const Trial trial = random_trial(contract.design, 1000 * seed + i, folder_of(scratch));
      const Found found = model_against_itself(contract, trial);
      samples += found.compared;
      memories.insert(trial.memory);
      EXPECT_EQ(found.difference(), "")
          << "r" << seed << ": " << summary_of(contract.design) << ": " << trial.arguments();
    }
  }
  EXPECT_GT(samples, 500000u);
  EXPECT_EQ(memories.size(), std::size(memory::kKinds));
}

TEST(RandomDesigns, ModeThatIsACycleLaterIsSeen) {
  const scene::Scratch scratch;
  int unseen = 0;
  for (uint64_t i = 0; i < 8; ++i) {
    const Trial trial = mutable_trial(spec::kHighTile, i, folder_of(scratch));
    const Found found = model_against_itself(spec::contract(spec::kHighTile), trial, 1);
    unseen += found.difference().empty() ? 1 : 0;
  }
  EXPECT_LE(unseen, 2);  // no depth is read in some scenes
}

class RandomRtl : public testing::Test {
 protected:
  Found compare(const Trial& trial, int late = 0) const {
    return model_against_rtl(contract_, trial, PINEDA_RANDOM_PLUGIN, late);
  }

  const scene::Scratch scratch_;
  const spec::Contract contract_ = spec::contract(random_design(PINEDA_RANDOM_SEED));
};

TEST_F(RandomRtl, EveryTokenInItsCycleAndEveryCounterEqual) {
  uint64_t tokens = 0;
  for (uint64_t i = 0; i < 5; ++i) {
    const Trial trial = random_trial(contract_.design, i, folder_of(scratch_));
    const Found found = compare(trial);
    tokens += found.compared;
    EXPECT_EQ(found.difference(), "") << trial.arguments();
  }
  EXPECT_GT(tokens, 5000u);
}

TEST_F(RandomRtl, MemoryOfTheModelThatIsACycleLateIsSeen) {
  int unseen = 0;
  for (uint64_t i = 0; i < 4; ++i) {
    const Trial trial = mutable_trial(contract_.design, i, folder_of(scratch_));
    unseen += compare(trial, 1).difference().empty() ? 1 : 0;
  }
  EXPECT_LE(unseen, 1);
}

}  // namespace
}  // namespace pineda::test
