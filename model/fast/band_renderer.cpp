#include "model/fast/band_renderer.h"

#include <algorithm>

namespace pineda::fast {

namespace {

// So that no thread has to wait long for the last band.
constexpr int kBandsPerThread = 8;
// Groups of triangles that are sorted before they are drawn: as many as the caches hold.
constexpr size_t kSorted = 4096;

}  // namespace

BandRenderer::BandRenderer(const spec::Contract& contract, const spec::FrameState& frame,
                           int threads, Renderer::Hits hits) {
  const int log2 = contract.design.tile_log2;
  const int rows = ((frame.height - 1) >> log2) + 1;
  const int used = std::min(threads, rows);
  const int bands = used == 1 ? 1 : std::min(used * kBandsPerThread, rows);
  for (int i = 0; i < bands; ++i) {
    const core::TileRows band{rows * i / bands, rows * (i + 1) / bands - 1};
    bands_.push_back(std::make_unique<Renderer>(contract, frame, band, hits));
    bands_of_rows_.resize(static_cast<size_t>(band.last) + 1, static_cast<uint16_t>(i));
  }
  row_shift_ = log2 + contract.design.subpixel_bits;
  crew_ = std::make_unique<Crew>(used);
  bins_.assign(static_cast<size_t>(used), Bins(bands_.size(), TriangleList(contract, frame)));
}

void BandRenderer::clear() {
  crew_->each(bands_.size(), [this](size_t band) { bands_[band]->clear(); });
}

// Triangles as they are, in all bands: the first one counts them.
void BandRenderer::draw(const std::vector<spec::Triangle>& triangles) {
  crew_->each(bands_.size(), [&](size_t band) {
    bands_[band]->draw(triangles.data(), triangles.size(), band == 0);
  });
}

void BandRenderer::draw(const TriangleList& list) {
  if (!list.is_grouped()) return draw(list.whole());
  if (bands_.size() == 1) return bands_[0]->draw(list);
  const size_t groups = list.groups().size();
  for (size_t first = 0; first < groups; first += kSorted) {
    draw_groups(list, first, std::min(first + kSorted, groups));
  }
}

void BandRenderer::draw_groups(const TriangleList& list, size_t first, size_t last) {
  const size_t parts = bins_.size(), n = last - first;
  crew_->each(parts, [&](size_t part) {
    sort(list, first + n * part / parts, first + n * (part + 1) / parts, &bins_[part]);
  });
  crew_->each(bands_.size(), [this](size_t band) {
    for (const Bins& bins : bins_) bands_[band]->draw(bins[band]);
  });
}

// Puts triangles into the bands of their topmost to their lowest vertex; each counts in the first one.
void BandRenderer::sort(const TriangleList& list, size_t first, size_t last, Bins* bins) const {
  for (TriangleList& bin : *bins) bin.clear();
  const auto last_row = static_cast<int32_t>(bands_of_rows_.size()) - 1;
  for (size_t g = first; g < last; ++g) {
    const TriangleGroup& group = list.groups()[g];
    Each<int32_t> top, bottom;  // rows; what is above or below the frame counts with its border
    for (size_t i = 0; i < kGroup; ++i) {
      const auto [y0, y1, y2] = std::array{group.y[0][i], group.y[1][i], group.y[2][i]};
      top[i] = std::clamp(std::min(std::min(y0, y1), y2) >> row_shift_, 0, last_row);
      bottom[i] = std::clamp(std::max(std::max(y0, y1), y2) >> row_shift_, 0, last_row);
    }
    for (size_t i = 0; i < list.in_group(g); ++i) {
      const size_t top_band = bands_of_rows_[static_cast<size_t>(top[i])];
      const size_t bottom_band = bands_of_rows_[static_cast<size_t>(bottom[i])];
      const bool counted = (list.counted()[g] >> i & 1) != 0;
      for (size_t band = top_band; band <= bottom_band; ++band) {
        (*bins)[band].push_back(group, i, counted && band == top_band);
      }
    }
  }
}

core::FrameCounters BandRenderer::counters() const {
  core::FrameCounters sum;
  for (const auto& band : bands_) {
    const core::FrameCounters of_band = band->counters();
    for (const core::FrameCounter& row : core::kFrameCounters) row.of(sum) += row.of(of_band);
  }
  return sum;
}

core::FrameBuffer BandRenderer::buffer() const {
  core::FrameBuffer frame(bands_[0]->contract(), bands_[0]->frame());
  for (const auto& band : bands_) band->copy_rows(&frame);
  return frame;
}

}  // namespace pineda::fast
