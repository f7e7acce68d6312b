#include "model/fast/renderer.h"

#include <algorithm>
#include <stdexcept>

namespace pineda::fast {

using core::Drop;

namespace {

// Asks for the first lines of a triangle's box: all of a small one, two blocks across and down.
// Inlined, since GCC takes a function that only prefetches for one that does nothing.
PINEDA_INLINE void prefetch(const BlockBuffer& buffer, const PrimGroup& g, size_t i,
                            core::TileRows rows, int tile_log2) {
  if (g.y0[i] >> tile_log2 < rows.first || g.y0[i] >> tile_log2 > rows.last) return;
  const int last_y =
      std::min({g.y1[i], (g.y0[i] | (kBlockPx - 1)) + kBlockPx, buffer.top + buffer.rows - 1});
  const int last_x = std::min(g.x1[i], (g.x0[i] | (kBlockPx - 1)) + kBlockPx);
  for (int y = g.y0[i] & -kLineHeightPx; y <= last_y; y += kLineHeightPx) {
    const size_t row = buffer.line(0, y);
    for (int x = g.x0[i] & -kLineWidthPx; x <= last_x; x += kLineWidthPx) {
      const size_t line = row + BlockBuffer::line_in_row(x);
      __builtin_prefetch(&buffer.lines[line], 1);
      if (!buffer.hits.empty()) __builtin_prefetch(&buffer.hits[line * kLineSamples], 1);
    }
  }
}

// Takes over what setup made of one triangle.
void put(const spec::Contract& c, const spec::SetupPrim& prim, size_t i, PrimGroup* g) {
  g->x0[i] = prim.x0;
  g->y0[i] = prim.y0;
  g->x1[i] = prim.x1;
  g->y1[i] = prim.y1;
  for (size_t k = 0; k < 3; ++k) {
    g->a[k][i] = static_cast<int32_t>(prim.edge[k].a);
    g->b[k][i] = static_cast<int32_t>(prim.edge[k].b);
    g->e[k][i] = prim.edge[k].e;
  }
  g->z_dx[i] = prim.planes.z.dx;
  g->z_dy[i] = prim.planes.z.dy;
  g->z_ref[i] = prim.planes.z.ref;
  const auto attributes = static_cast<size_t>(c.design.attributes);
  for (size_t a = 0; a < static_cast<size_t>(spec::channels(c.design)); ++a) {
    const bool is_flat = a >= attributes;
    const spec::Plane plane = is_flat ? spec::Plane{0, 0,
                                                    int64_t{prim.planes.flat[a - attributes]}
                                                        << c.design.gradient_fraction_bits}
                                      : prim.planes.attr[a];
    g->color_dx[i][a] = static_cast<uint32_t>(plane.dx);
    g->color_dy[i][a] = static_cast<uint32_t>(plane.dy);
    g->color_ref[i][a] = static_cast<uint32_t>(plane.ref);
  }
  g->drawn |= 1U << i;
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
    blocks_.emplace(Blocks{BlockState(contract, frame, rows, counts_hits_),
                           {},
                           BlockBuffer(contract, frame, rows, counts_hits_),
                           {},
                           {},
                           {},
                           0});
    if (has_setup_lanes(contract)) blocks_->lanes.emplace(contract, frame);
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
    blocks_->buffer.copy_to(&all);
  } else {
    buffer_.copy_rows(0, buffer_.tile_rows - 1, &all);
  }
  return all;
}

void Renderer::copy_rows(core::FrameBuffer* to) const {
  if (blocks_) {
    blocks_->buffer.copy_to(to);
  } else {
    const int last = (frame_.height - 1) >> contract_.design.tile_log2;
    buffer_.copy_rows(rows_.first, std::min(rows_.last, last), to);
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

Drop Renderer::set_up(const spec::Triangle& triangle) {
  const Drop drop = setup(contract_, frame_, triangle, &prim_);
  ++counters_.triangles;
  ++counters_.dropped[static_cast<size_t>(drop)];
  return drop;
}

Drop Renderer::draw(const spec::Triangle& triangle) {
  if (contract_.design.reciprocal_scheme == spec::ReciprocalScheme::kNone) {
    return draw_exactly(triangle);
  }
  const Drop drop = set_up(triangle);
  if (drop != Drop::kNone) return drop;
  if (blocks_) {
    put(contract_, prim_, 0, blocks_->prims());
    draw_prims();
    draw_last_prims();
  } else {
    draw_tiles();
  }
  return drop;
}

void Renderer::draw(const TriangleList& list) {
  if (!list.is_grouped()) return draw(list.whole().data(), list.whole().size());
  if (!blocks_ || !blocks_->lanes) throw std::logic_error("a list for a frame of another state");
  for (size_t i = 0; i < list.groups().size(); ++i) {
    draw_group(list.groups()[i], list.in_group(i), list.counted()[i]);
  }
  draw_last_prims();
}

void Renderer::draw(const spec::Triangle* triangles, size_t count, bool counted) {
  const core::FrameCounters before = counters_;
  for (size_t begin = 0; begin < count; begin += kGroup) {
    const size_t n = std::min(kGroup, count - begin);
    if (blocks_ && blocks_->lanes) {
      for (size_t i = 0; i < n; ++i) {
        blocks_->triangles.set(i, triangles[begin + i], blocks_->state.channels);
      }
      draw_group(blocks_->triangles, n, counted ? ~0U : 0);
    } else if (blocks_) {
      for (size_t i = 0; i < n; ++i) {
        if (set_up(triangles[begin + i]) == Drop::kNone) put(contract_, prim_, i, blocks_->prims());
      }
      draw_prims();
    } else {
      for (size_t i = 0; i < n; ++i) draw(triangles[begin + i]);
    }
  }
  if (blocks_) draw_last_prims();
  if (counted) return;
  counters_.triangles = before.triangles;
  counters_.dropped = before.dropped;
}

void Renderer::draw_group(const TriangleGroup& triangles, size_t count, uint32_t counted) {
  counters_.triangles += static_cast<uint64_t>(__builtin_popcount(counted & ((1U << count) - 1)));
  fast::set_up(*blocks_->lanes, triangles, count, counted, blocks_->prims(), &counters_.dropped);
  draw_prims();
}

void Renderer::draw_prims() {
  Blocks& b = *blocks_;
  auto& [prims, small] = b.groups[b.current];
  cover_small(b.state, prims, b.buffer, &small, &b.counts);
  for (uint32_t left = prims.drawn & ~small.small; left != 0; left &= left - 1) {
    prefetch(b.buffer, prims, static_cast<size_t>(__builtin_ctz(left)), rows_,
             contract_.design.tile_log2);
  }
  draw_last_prims();
  b.current = 1 - b.current;
}

void Renderer::draw_last_prims() {
  Blocks& b = *blocks_;
  auto& [prims, small] = b.groups[1 - b.current];
  if (prims.drawn != 0) draw_blocks(b.state, prims, small, &b.buffer, &b.counts);
  prims.drawn = 0;
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
