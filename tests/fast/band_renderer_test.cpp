// A frame in bands: the bits and counters of the whole, whatever the number of threads.
#include "model/fast/band_renderer.h"

#include <gtest/gtest.h>

#include "tests/core/support.h"

namespace pineda::test {
namespace {

TEST(BandRenderer, EqualsCoreForEveryNumberOfThreads) {
  Random random(37);
  std::vector<spec::Triangle> triangles;
  for (int n = 0; n < 300; ++n) {
    triangles.push_back(random_triangle(random, static_cast<Shape>(random.between(0, 4))));
    randomize_values(random, &triangles.back());
  }
  fast::TriangleList list(kContract, kWindow);
  for (const auto& t : triangles) list.push_back(t);
  EXPECT_TRUE(list.is_grouped());
  EXPECT_EQ(list.size(), triangles.size());
  core::Renderer whole(kContract, kWindow);
  for (const auto& t : triangles) whole.draw(t);
  const core::FrameCounters& expected = whole.counters();
  EXPECT_GT(expected.passed, 1000u);
  for (const int threads : {1, 2, 3, 5, 6, 100}) {  // the window has 6 rows of tiles
    fast::BandRenderer bands(kContract, kWindow, threads);
    bands.draw(triangles);
    bands.clear();
    bands.draw(list);
    const core::FrameCounters got = bands.counters();
    for (const core::FrameCounter& row : core::kFrameCounters) {
      EXPECT_EQ(row.of(got), row.of(expected)) << row.name << ' ' << threads;
    }
    EXPECT_EQ(bands.buffer().depth, whole.buffer().depth) << threads;
    EXPECT_EQ(bands.buffer().color, whole.buffer().color) << threads;
    EXPECT_EQ(bands.buffer().hits, whole.buffer().hits) << threads;
  }
}

}  // namespace
}  // namespace pineda::test
