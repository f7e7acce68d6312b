// A frame drawn by several threads.
#pragma once

#include <memory>
#include <vector>

#include "model/fast/crew.h"
#include "model/fast/renderer.h"

namespace pineda::fast {

/// Draws a frame in bands of tile rows, each by the first thread that is free. Triangles are sorted into
/// the bands that they may touch, in their order, before any band is drawn.
///
/// Bits     those of core::Renderer, and its counters, whatever the number of threads.
class BandRenderer {
 public:
  /// threads >= 1; more than there are rows of tiles are not used.
  BandRenderer(const spec::Contract& contract, const spec::FrameState& frame, int threads,
               Renderer::Hits hits = Renderer::Hits::kCounted);

  void clear();
  void draw(const std::vector<spec::Triangle>& triangles);
  void draw(const TriangleList& list);
  core::FrameCounters counters() const;
  core::FrameBuffer buffer() const;

 private:
  using Bins = std::vector<TriangleList>;  // by band

  void draw_groups(const TriangleList& list, size_t first, size_t last);
  void sort(const TriangleList& list, size_t first, size_t last, Bins* bins) const;

  std::vector<std::unique_ptr<Renderer>> bands_;
  std::vector<uint16_t> bands_of_rows_;  // by row of tiles
  int row_shift_ = 0;                    // from subpixels to rows of tiles
  std::vector<Bins> bins_;               // of each part of a list, in order
  std::unique_ptr<Crew> crew_;
};

}  // namespace pineda::fast
