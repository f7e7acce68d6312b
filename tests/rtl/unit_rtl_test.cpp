// Setup, traversal and interpolation with depth test: the RTL's bits against the model's, on the
// shared vectors and on 100,000 random triangles a unit, under every stall mode.
#include "tests/rtl/support.h"

namespace pineda::tb {
namespace {

constexpr int kTrianglesPerMode = 25'000;  // times four stall modes
constexpr int kTrianglesPerRun = 1'000;

class SetupRtl : public StallTest {};
class TraversalRtl : public StallTest {};
class InterpZtestRtl : public StallTest {};
INSTANTIATE_TEST_SUITE_P(, SetupRtl, testing::ValuesIn(kStallModes), stall_test_name);
INSTANTIATE_TEST_SUITE_P(, TraversalRtl, testing::ValuesIn(kStallModes), stall_test_name);
INSTANTIATE_TEST_SUITE_P(, InterpZtestRtl, testing::ValuesIn(kStallModes), stall_test_name);

template <class Bench, class Case>
void expect_vectors(const RtlLibrary& library, StallMode mode) {
  BenchOptions options;
  options.stall_mode = mode;
  options.seed = 1;
  Bench bench(library, options);
  for (const Case& expected : committed_cases<Case>()) {
    EXPECT_EQ(first_difference(&bench, expected), "");
  }
}

template <class Bench, class Case>
int caught_by_vectors() {
  Bench bench(mutant(), BenchOptions());
  int caught = 0;
  for (const Case& expected : committed_cases<Case>()) {
    caught += first_difference(&bench, expected).empty() ? 0 : 1;
  }
  return caught;
}

// The inputs of the random runs: triangles from a pixel to the whole guard band for setup, small
// ones where all stamps are drawn.
vectors::SetupCase random_setup(spec::Random* random, int max_size_px) {
  vectors::SetupCase c;
  c.name = "random";
  c.frame = random_state(random, random->between(1, 300), random->between(1, 300));
  const auto size = random->between(1, max_size_px);
  c.in = random_triangles(random, c.frame, size, kTrianglesPerRun);
  return vectors::run_model(rtl().contract(), c);
}

TEST_P(SetupRtl, ReproducesTheVectors) {
  expect_vectors<SetupBench, vectors::SetupCase>(rtl(), GetParam());
}

TEST_P(SetupRtl, MatchesModel) {
  spec::Random random(101 + static_cast<uint64_t>(GetParam()));
  BenchOptions options;
  options.stall_mode = GetParam();
  SetupBench bench(rtl(), options);
  for (int done = 0; done < kTrianglesPerMode; done += kTrianglesPerRun) {
    static constexpr int kSizes[] = {4, 64, 2048, 32767};
    const auto expected = random_setup(&random, kSizes[done / kTrianglesPerRun % 4]);
    ASSERT_EQ(first_difference(&bench, expected), "") << "after " << done << " triangles";
  }
}

TEST(SetupRtlMutant, InclusiveRuleIsCaught) {
  const int caught = caught_by_vectors<SetupBench, vectors::SetupCase>();
  EXPECT_GT(caught, 0);
}

TEST_P(TraversalRtl, ReproducesTheVectors) {
  expect_vectors<TraversalBench, vectors::TraversalCase>(rtl(), GetParam());
}

TEST_P(TraversalRtl, MatchesModel) {
  spec::Random random(202 + static_cast<uint64_t>(GetParam()));
  BenchOptions options;
  options.stall_mode = GetParam();
  TraversalBench bench(rtl(), options);
  for (int done = 0; done < kTrianglesPerMode; done += kTrianglesPerRun) {
    const auto setup = random_setup(&random, done % 5000 == 0 ? 120 : 16);
    vectors::TraversalCase inputs{"random", setup.frame, setup.out, {}};
    const auto expected = vectors::run_model(rtl().contract(), inputs);
    ASSERT_EQ(first_difference(&bench, expected), "") << "after " << done << " triangles";
  }
}

TEST(TraversalRtlMutant, RejectingATileWhoseCornerLiesOnAnEdgeIsCaught) {
  const int caught = caught_by_vectors<TraversalBench, vectors::TraversalCase>();
  EXPECT_GT(caught, 0);
}

TEST_P(InterpZtestRtl, ReproducesTheVectors) {
  expect_vectors<InterpZtestBench, vectors::InterpZtestCase>(rtl(), GetParam());
}

TEST_P(InterpZtestRtl, MatchesModel) {
  spec::Random random(303 + static_cast<uint64_t>(GetParam()));
  static constexpr int kLatencies[] = {1, 2, 5, 8, 64};
  for (int done = 0; done < kTrianglesPerMode; done += kTrianglesPerRun) {
    BenchOptions options;
    options.stall_mode = GetParam();
    options.seed = random.bits();
    options.depth_latency_cycles = kLatencies[done / kTrianglesPerRun % 5];
    InterpZtestBench bench(rtl(), options);
    // Small frames: a thousand triangles overlap many times on every stamp.
    vectors::SetupCase setup;
    setup.frame = random_state(&random, random.between(1, 40), random.between(1, 40));
    setup.in = random_triangles(&random, setup.frame, random.between(1, 24), kTrianglesPerRun);
    vectors::TraversalCase traversal{
        "", setup.frame, vectors::run_model(rtl().contract(), setup).out, {}};
    vectors::InterpZtestCase inputs{
        "random", setup.frame, vectors::run_model(rtl().contract(), traversal).out, {}, {}};
    const auto expected = vectors::run_model(rtl().contract(), inputs);
    ASSERT_EQ(first_difference(&bench, expected), "") << "after " << done << " triangles";
  }
}

TEST(InterpZtestRtlMutant, LessThatPassesEqualIsCaught) {
  const int caught = caught_by_vectors<InterpZtestBench, vectors::InterpZtestCase>();
  EXPECT_GT(caught, 0);
}

}  // namespace
}  // namespace pineda::tb
