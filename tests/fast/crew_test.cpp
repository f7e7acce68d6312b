// Threads that work together.
#include "model/fast/crew.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

namespace pineda::test {
namespace {

TEST(Crew, DoesEachPieceOnce) {
  for (const int threads : {1, 2, 5}) {
    fast::Crew crew(threads);
    for (size_t count = 0; count < 40; ++count) {
      std::vector<std::atomic<int>> done(count);
      crew.each(count, [&](size_t i) { ++done[i]; });
      for (size_t i = 0; i < count; ++i) EXPECT_EQ(done[i], 1) << threads << ' ' << count;
    }
  }
}

TEST(Crew, ThrowsWhatAPieceThrewAndGoesOn) {
  fast::Crew crew(3);
  std::atomic<int> done{0};
  const auto fail = [&](size_t i) {
    ++done;
    if (i == 7) throw std::runtime_error("seven");
  };
  EXPECT_THROW(crew.each(20, fail), std::runtime_error);
  EXPECT_EQ(done, 20);
  crew.each(20, [&](size_t) { ++done; });
  EXPECT_EQ(done, 40);
}

}  // namespace
}  // namespace pineda::test
