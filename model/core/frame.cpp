#include "model/core/frame.h"

#include <algorithm>

namespace pineda::core {

using spec::Contract;

namespace {

struct NoSink {
  void prim(const spec::SetupPrim&) {}
  void stamp(const spec::Stamp&) {}
  void depth(const spec::DepthWrite&) {}
  void color(const spec::ColorWrite&) {}
};

}  // namespace

uint32_t Renderer::test(const spec::Stamp& stamp, const spec::Fragment& fragment) {
  if (!tests_depth(contract_, frame_)) return stamp.mask;
  const auto stored = buffer_.read(contract_, stamp.x, stamp.y, stamp.mask);
  return depth_test(contract_, frame_.depth, stamp.mask, fragment.z, stored.z);
}

Renderer::Renderer(const Contract& contract, const spec::FrameState& frame, TileRows rows)
    : contract_(contract),
      frame_(frame),
      rows_(rows),
      buffer_(contract, frame),
      tiles_(contract),
      cover_(contract),
      shader_(contract, frame, TileShader::Values::kAll) {}

void Renderer::clear() {
  by_rows_.reset();
  buffer_.clear();
  counters_ = {};
}

const FrameBuffer& Renderer::buffer() const {
  if (!by_rows_) by_rows_ = buffer_.by_rows(contract_);
  return *by_rows_;
}

void Renderer::copy_rows(FrameBuffer* to) const {
  buffer_.copy_rows(rows_.first, std::min(rows_.last, buffer_.tile_rows - 1), to);
}

Drop Renderer::draw(const spec::Triangle& triangle) {
  // Exact planes are made for stamps only.
  if (contract_.design.reciprocal_scheme == spec::ReciprocalScheme::kNone) {
    return draw(triangle, NoSink{});
  }
  by_rows_.reset();
  const Drop drop = setup(contract_, frame_, triangle, &prim_);
  ++counters_.triangles;
  ++counters_.dropped[static_cast<size_t>(drop)];
  if (drop != Drop::kNone) return drop;
  if (!clip_rows(contract_, rows_.first, rows_.last, &prim_)) return drop;
  tiles_.begin(prim_);
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

}  // namespace pineda::core
