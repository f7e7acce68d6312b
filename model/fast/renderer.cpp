#include "model/fast/renderer.h"

#include <algorithm>

namespace pineda::fast {

using core::Drop;

Renderer::Renderer(const spec::Contract& contract, const spec::FrameState& frame,
                   core::TileRows rows)
    : contract_(contract),
      frame_(frame),
      rows_(rows),
      buffer_(contract, frame),
      tiles_(contract),
      cover_(contract),
      shader_(contract, frame, TileShader::Values::kAll) {}

void Renderer::clear() {
  buffer_.clear();
  counters_ = {};
}

core::FrameBuffer Renderer::buffer() const {
  core::FrameBuffer all(contract_, frame_);
  buffer_.copy_rows(0, buffer_.tile_rows - 1, &all);
  return all;
}

void Renderer::copy_rows(core::FrameBuffer* to) const {
  buffer_.copy_rows(rows_.first, std::min(rows_.last, buffer_.tile_rows - 1), to);
}

Drop Renderer::draw(const spec::Triangle& triangle) {
  if (contract_.design.reciprocal_scheme == spec::ReciprocalScheme::kNone) {
    return draw_exactly(triangle);
  }
  const Drop drop = setup(contract_, frame_, triangle, &prim_);
  ++counters_.triangles;
  ++counters_.dropped[static_cast<size_t>(drop)];
  if (drop != Drop::kNone) return drop;
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
    shader_.count_hits(cover_, &buffer_);
    shader_.draw(cover_, &buffer_);
  }
  counters_.stamps += covered_.stamps;
  counters_.fragments += covered_.samples;
  counters_.interpolated += shader_.counts().stamps - passed_.stamps;
  counters_.passed += shader_.counts().samples - passed_.samples;
  covered_ = {};
  passed_ = shader_.counts();
  return drop;
}

Drop Renderer::draw_exactly(const spec::Triangle& triangle) {
  core::Sink none;
  return core::draw_triangle(
      contract_, frame_, rows_, triangle, &counters_,
      core::FrameWriter<TiledBuffer, core::Sink>{contract_, frame_, &buffer_, &counters_, none});
}

}  // namespace pineda::fast
