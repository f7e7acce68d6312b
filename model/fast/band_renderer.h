// A frame drawn by several threads.
#pragma once

#include <memory>
#include <thread>
#include <vector>

#include "model/fast/renderer.h"

namespace pineda::fast {

/// Draws a frame in bands of tile rows, one thread a band. Every band sets every triangle up again,
/// so that no thread waits for another.
///
/// Bits     those of core::Renderer, and its counters, whatever the number of bands.
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
  std::vector<std::unique_ptr<Renderer>> bands_;
};

}  // namespace pineda::fast
