// The quick model on each vector unit, equal to core on the hard cases and on the committed frames.
#include "model/fast/band_renderer.h"
#include "tests/fast/levels.h"
#include "tests/hard/support.h"
#include "vectors/grammar/cases.h"
#include "vectors/grammar/file.h"

namespace pineda::hard {
namespace {

void expect_equal(const core::Renderer& core, const core::FrameBuffer& buffer,
                  const core::FrameCounters& counters) {
  for (const core::FrameCounter& row : core::kFrameCounters) {
    EXPECT_EQ(row.of(core.counters()), row.of(counters)) << row.name;
  }
  EXPECT_EQ(core.buffer().hits, buffer.hits);
  EXPECT_EQ(core.buffer().depth, buffer.depth);
  EXPECT_EQ(core.buffer().color, buffer.color);
}

void compare(const spec::Contract& c, const spec::FrameState& frame,
             const std::vector<spec::Triangle>& triangles) {
  core::Renderer core(c, frame);
  for (const auto& t : triangles) core.draw(t);
  fast::TriangleList list(c, frame);
  for (const auto& t : triangles) list.push_back(t);
  test::for_each_level([&] {
    for (const int threads : {1, 2}) {
      fast::BandRenderer quick(c, frame, threads);
      quick.draw(list);
      expect_equal(core, quick.buffer(), quick.counters());
    }
  });
}

using OnVectorUnits = HardCaseTest;
TEST_P(OnVectorUnits, EqualsCore) {
  const spec::Contract c = spec::contract(spec::kHighTile);
  const Snapped scene = snapped(GetParam(), c);
  compare(c, scene.frame, scene.triangles);
}
INSTANTIATE_TEST_SUITE_P(Cases, OnVectorUnits, testing::ValuesIn(scene::hard_cases()), case_name);

TEST(FrameVectors, EqualCoreOnEveryVectorUnit) {
  for (const char* name : {"level1_seed1.txt", "persp_level1_seed1.txt"}) {
    const auto file =
        vectors::read<vectors::FrameCase>(std::string(PINEDA_VECTORS) + "/frame/" + name);
    int compared = 0;
    for (const vectors::FrameCase& value : file.cases) {
      SCOPED_TRACE(value.name);
      // The largest frames, for which files are sparse, would take gigabytes.
      if (int64_t{value.frame.width} * value.frame.height > 1 << 18) continue;
      compare(file.contract, value.frame, value.in);
      ++compared;
    }
    EXPECT_GT(compared, 100);
  }
}

}  // namespace
}  // namespace pineda::hard
