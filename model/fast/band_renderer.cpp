#include "model/fast/band_renderer.h"

#include <algorithm>

namespace pineda::fast {

namespace {

template <class Work>
void for_each_band(const std::vector<std::unique_ptr<Renderer>>& bands, Work work) {
  std::vector<std::thread> others;
  for (size_t i = 1; i < bands.size(); ++i) others.emplace_back(work, bands[i].get());
  work(bands[0].get());
  for (auto& thread : others) thread.join();
}

}  // namespace

BandRenderer::BandRenderer(const spec::Contract& contract, const spec::FrameState& frame,
                           int threads, Renderer::Hits hits) {
  const int rows = ((frame.height - 1) >> contract.design.tile_log2) + 1;
  const int bands = std::min(threads, rows);
  for (int i = 0; i < bands; ++i) {
    const core::TileRows band{rows * i / bands, rows * (i + 1) / bands - 1};
    bands_.push_back(std::make_unique<Renderer>(contract, frame, band, hits));
  }
}

void BandRenderer::clear() {
  for_each_band(bands_, [](Renderer* band) { band->clear(); });
}

void BandRenderer::draw(const std::vector<spec::Triangle>& triangles) {
  for_each_band(bands_,
                [&triangles](Renderer* band) { band->draw(triangles.data(), triangles.size()); });
}

void BandRenderer::draw(const TriangleList& list) {
  for_each_band(bands_, [&list](Renderer* band) { band->draw(list); });
}

core::FrameCounters BandRenderer::counters() const {
  core::FrameCounters sum = bands_[0]->counters();  // setup's counts are the same in each band
  for (size_t i = 1; i < bands_.size(); ++i) {
    for (const core::FrameCounter& row : core::kFrameCounters) {
      const bool of_triangles = row.is_drop() || row.member == &core::FrameCounters::triangles;
      if (!of_triangles) row.of(sum) += row.of(bands_[i]->counters());
    }
  }
  return sum;
}

core::FrameBuffer BandRenderer::buffer() const {
  core::FrameBuffer frame(bands_[0]->contract(), bands_[0]->frame());
  for (const auto& band : bands_) band->copy_rows(&frame);
  return frame;
}

}  // namespace pineda::fast
