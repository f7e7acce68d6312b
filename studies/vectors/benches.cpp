#include "studies/vectors/benches.h"

#include <algorithm>
#include <utility>

#include "model/spec/clear_depth.h"

namespace pineda::vectors {

SetupCase run(tb::SetupBench* bench, const SetupCase& inputs) {
  SetupCase got = inputs;
  bench->set_frame(inputs.frame);
  bench->set_deadlock_cycles(tb::deadlock_cycles(inputs.frame));
  got.out = bench->run(inputs.in).tokens;
  return got;
}

TraversalCase run(tb::TraversalBench* bench, const TraversalCase& inputs) {
  TraversalCase got = inputs;
  bench->set_deadlock_cycles(tb::deadlock_cycles(inputs.frame));
  got.out = bench->run(inputs.in).tokens;
  return got;
}

InterpZtestCase run(tb::InterpZtestBench* bench, const InterpZtestCase& inputs) {
  InterpZtestCase got = inputs;
  auto writes = bench->run(inputs.frame, inputs.in);
  got.depth = std::move(writes.depth.tokens);
  got.color = std::move(writes.color.tokens);
  return got;
}

tb::NextTriangle each_of(const std::vector<spec::Triangle>& triangles) {
  return [&triangles, next = size_t{0}](spec::Triangle* triangle) mutable {
    if (next == triangles.size()) return false;
    *triangle = triangles[next++];
    return true;
  };
}

void begin(tb::FrameBench* bench, const FrameCase& inputs) {
  if (!inputs.reset_cycle) return;
  const std::vector<spec::Triangle> begun = begun_triangles(bench->contract(), inputs);
  bench->run_into_reset(inputs.frame, each_of(begun), static_cast<tb::Cycle>(*inputs.reset_cycle));
}

FrameCase run(tb::FrameBench* bench, const FrameCase& inputs) {
  FrameCase got = inputs;
  begin(bench, inputs);
  bench->wait(1);  // a frame that follows another need not come at once
  timing::Listener hits_are_counted;
  got.counters = bench->run(inputs.frame, each_of(inputs.in), &hits_are_counted).counters;
  got.samples = samples_of(*bench, inputs.frame);
  return got;
}

std::vector<Sample> samples_of(const tb::FrameBench& bench, const spec::FrameState& frame) {
  const uint32_t cleared = spec::cleared_depth(bench.contract().design, frame);
  const auto channels = static_cast<size_t>(spec::channels(bench.contract().design));
  constexpr auto kSide = static_cast<size_t>(tb::PagedBuffer::kSide);
  std::vector<Sample> samples;
  for (const tb::PagedBuffer::Page* page : bench.memories().pages()) {
    for (size_t i = 0; i < kSide * kSide; ++i) {
      const int x = page->x + static_cast<int>(i % kSide);
      const int y = page->y + static_cast<int>(i / kSide);
      if (x >= frame.width || y >= frame.height) continue;
      const uint16_t* const color = page->color.data() + i * channels;
      const bool is_cleared =
          page->hits[i] == 0 && page->depth[i] == cleared &&
          std::all_of(color, color + channels, [](uint16_t v) { return v == 0; });
      if (is_cleared) continue;
      Sample sample{x, y, page->depth[i], {}, page->hits[i]};
      std::copy(color, color + channels, sample.color.begin());
      samples.push_back(sample);
    }
  }
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
    return std::pair(a.y, a.x) < std::pair(b.y, b.x);
  });
  return samples;
}

}  // namespace pineda::vectors
