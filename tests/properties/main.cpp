// The seed is fixed, so that a run can be repeated; RC_PARAMS in the environment overrides it, e.g.
// RC_PARAMS="seed=7 max_success=100000" for a longer search.
#include <gtest/gtest.h>

#include <cstdlib>

int main(int argc, char** argv) {
  setenv("RC_PARAMS", "seed=1988 max_success=2000", 0);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
