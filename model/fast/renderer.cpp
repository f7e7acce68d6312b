#include "model/fast/renderer.h"

#include <algorithm>

namespace pineda::fast {

using core::Drop;

namespace {

// So many triangles are set up before they are drawn: meanwhile the memories' lines arrive.
constexpr size_t kBatch = 16;

// Asks for the first lines of a triangle's box: all of a small one, two blocks across and down.
// Inlined, since GCC takes a function that only prefetches for one that does nothing.
PINEDA_INLINE void prefetch(const BlockBuffer& buffer, const spec::SetupPrim& prim,
                            core::TileRows rows, int tile_log2) {
  if (prim.y0 >> tile_log2 < rows.first || prim.y0 >> tile_log2 > rows.last) return;
  const int last_y = std::min(prim.y1, (prim.y0 | (kBlockPx - 1)) + kBlockPx);
  const int last_x = std::min(prim.x1, (prim.x0 | (kBlockPx - 1)) + kBlockPx);
  for (int y = prim.y0 & -kLineHeightPx; y <= last_y; y += kLineHeightPx) {
    for (int x = prim.x0 & -kLineWidthPx; x <= last_x; x += kLineWidthPx) {
      const size_t line = buffer.line(x, y);
      __builtin_prefetch(&buffer.lines[line], 1);
      if (!buffer.hits.empty()) __builtin_prefetch(&buffer.hits[line * kLineSamples], 1);
    }
  }
}

}  // namespace

Renderer::Renderer(const spec::Contract& contract, const spec::FrameState& frame,
                   core::TileRows rows, Hits hits)
    : contract_(contract),
      frame_(frame),
      rows_(rows),
      tiles_(contract),
      cover_(contract),
      shader_(contract, frame, TileShader::Values::kAll),
      counts_hits_(hits == Hits::kCounted) {
  if (has_blocks(contract, frame)) {
    blocks_.emplace(Blocks{BlockState(contract, frame, rows),
                           BlockBuffer(contract, frame, counts_hits_),
                           {},
                           std::vector<spec::SetupPrim>(kBatch)});
  } else {
    buffer_ = TiledBuffer(contract, frame);
  }
}

void Renderer::clear() {
  if (blocks_) {
    blocks_->buffer.clear();
    blocks_->counts = {};
  } else {
    buffer_.clear();
  }
  counters_ = {};
}

core::FrameBuffer Renderer::buffer() const {
  core::FrameBuffer all(contract_, frame_);
  if (blocks_) {
    blocks_->buffer.copy_rows(0, frame_.height - 1, &all);
  } else {
    buffer_.copy_rows(0, buffer_.tile_rows - 1, &all);
  }
  return all;
}

void Renderer::copy_rows(core::FrameBuffer* to) const {
  const int log2 = contract_.design.tile_log2;
  const int last = std::min(rows_.last, (frame_.height - 1) >> log2);
  if (blocks_) {
    blocks_->buffer.copy_rows(rows_.first << log2, ((last + 1) << log2) - 1, to);
  } else {
    buffer_.copy_rows(rows_.first, last, to);
  }
}

core::FrameCounters Renderer::counters() const {
  core::FrameCounters counters = counters_;
  if (blocks_) {
    const BlockCounts& counts = blocks_->counts;
    counters.tiles_tested = counts.tiles_tested;
    counters.tiles_rejected = counts.tiles_rejected;
    counters.tiles_accepted = counts.tiles_accepted;
    counters.stamps = counts.stamps;
    counters.fragments = counts.fragments;
    counters.interpolated = counts.interpolated;
    counters.passed = counts.passed;
  }
  return counters;
}

Drop Renderer::set_up(const spec::Triangle& triangle, spec::SetupPrim* prim) {
  const Drop drop = setup(contract_, frame_, triangle, prim);
  ++counters_.triangles;
  ++counters_.dropped[static_cast<size_t>(drop)];
  return drop;
}

Drop Renderer::draw(const spec::Triangle& triangle) {
  if (contract_.design.reciprocal_scheme == spec::ReciprocalScheme::kNone) {
    return draw_exactly(triangle);
  }
  const Drop drop = set_up(triangle, &prim_);
  if (drop != Drop::kNone) return drop;
  if (blocks_) {
    draw_blocks(blocks_->state, &prim_, 1, &blocks_->buffer, &blocks_->counts);
  } else {
    draw_tiles();
  }
  return drop;
}

void Renderer::draw(const spec::Triangle* triangles, size_t count) {
  if (!blocks_) {
    for (size_t i = 0; i < count; ++i) draw(triangles[i]);
    return;
  }
  for (size_t begin = 0; begin < count; begin += kBatch) {
    size_t kept = 0;
    for (size_t i = begin; i < std::min(begin + kBatch, count); ++i) {
      spec::SetupPrim* const prim = &blocks_->prims[kept];
      if (set_up(triangles[i], prim) != Drop::kNone) continue;
      prefetch(blocks_->buffer, *prim, rows_, contract_.design.tile_log2);
      ++kept;
    }
    draw_blocks(blocks_->state, blocks_->prims.data(), kept, &blocks_->buffer, &blocks_->counts);
  }
}

void Renderer::draw_tiles() {
  tiles_.begin(prim_, rows_);
  shader_.begin(prim_);
  for (;;) {
    int rejected = 0;
    const bool kept = tiles_.next_kept(&cover_, &rejected);
    counters_.tiles_tested += static_cast<uint64_t>(rejected);
    counters_.tiles_rejected += static_cast<uint64_t>(rejected);
    if (!kept) break;
    ++counters_.tiles_tested;
    counters_.tiles_accepted += cover_.accepted ? 1 : 0;
    tiles_.cover_stamps(&cover_, nullptr);
    covered_.add(cover_.covered);
    if (counts_hits_) shader_.count_hits(cover_, &buffer_);
    shader_.draw(cover_, &buffer_);
  }
  counters_.stamps += covered_.stamps;
  counters_.fragments += covered_.samples;
  counters_.interpolated += shader_.counts().stamps - passed_.stamps;
  counters_.passed += shader_.counts().samples - passed_.samples;
  covered_ = {};
  passed_ = shader_.counts();
}

Drop Renderer::draw_exactly(const spec::Triangle& triangle) {
  core::Sink none;
  return core::draw_triangle(
      contract_, frame_, rows_, triangle, &counters_,
      core::FrameWriter<TiledBuffer, core::Sink>{contract_, frame_, &buffer_, &counters_, none});
}

}  // namespace pineda::fast
