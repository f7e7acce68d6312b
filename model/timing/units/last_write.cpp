#include "model/timing/units/last_write.h"

#include <algorithm>
#include <cstddef>

#include "model/fast/setup.h"

namespace pineda::timing {

void LastWrite::begin_frame(const spec::FrameState& frame, fast::TiledBuffer* buffer) {
  frame_ = frame;
  buffer_ = buffer;
  const int log2 = contract_.design.tile_log2;
  tile_columns_ = ((frame.width - 1) >> log2) + 1;
  const int tile_rows = ((frame.height - 1) >> log2) + 1;
  last_.assign(static_cast<size_t>(tile_columns_) * static_cast<size_t>(tile_rows), kNone);
  cleared_.assign(last_.size(), false);
  triangles_.clear();
  runs_.clear();
  irregular_.clear();
  found_ = -1;
}

void LastWrite::triangle(const spec::Triangle& t) {
  if (runs_.size() >= kKept) flush();
  triangle_ = &t;
}

void LastWrite::add(int tile_x, int tile_y, uint32_t irregular, Cycle retire) {
  if (triangle_ != nullptr) {
    const auto& v = triangle_->v;
    triangles_.push_back({Corner(v[0]), Corner(v[1]), Corner(v[2])});
    triangle_ = nullptr;
  }
  const auto tile = static_cast<uint32_t>(tile_y * tile_columns_ + tile_x);
  // Written field by field. Building a Run and copying it is slower: the copy would read back what
  // was only just stored.
  Run& run = runs_.emplace_back();
  run.triangle = static_cast<uint32_t>(triangles_.size() - 1);
  run.tile = tile;
  run.before = last_[tile];
  run.irregular = irregular;
  run.retire = retire;
  last_[tile] = static_cast<uint32_t>(runs_.size() - 1);
}

void LastWrite::run(int tile_x, int tile_y, Cycle retire) { add(tile_x, tile_y, kNone, retire); }

void LastWrite::run(int tile_x, int tile_y) {
  add(tile_x, tile_y, static_cast<uint32_t>(irregular_.size()), -1);
}

Cycle LastWrite::find() {
  for (auto i = static_cast<uint32_t>(runs_.size()); i-- > 0;) {
    if (last_[runs_[i].tile] != kNone) test_tile(last_[runs_[i].tile]);
    if (runs_[i].retire >= 0) return runs_[i].retire;
  }
  return found_;
}

// Tests every run now and forgets it. What remains is the buffer's depths and the cycle of the last
// write so far.
void LastWrite::flush() {
  for (uint32_t& last : last_) {
    if (last != kNone) test_tile(last);
  }
  for (const Run& run : runs_) found_ = std::max(found_, run.retire);
  triangles_.clear();
  runs_.clear();
  irregular_.clear();
}

// Tests all runs of a tile, in the order in which they came.
void LastWrite::test_tile(uint32_t last_run) {
  const uint32_t tile = runs_[last_run].tile;
  last_[tile] = kNone;
  if (!cleared_[tile]) clear(tile);
  std::vector<uint32_t> runs;
  for (uint32_t i = last_run; i != kNone; i = runs_[i].before) runs.push_back(i);
  for (auto i = runs.rbegin(); i != runs.rend(); ++i) test(&runs_[*i]);
}

void LastWrite::clear(uint32_t tile) {
  cleared_[tile] = true;
  const size_t samples = buffer_->tile_samples;
  std::fill_n(buffer_->depth.begin() + static_cast<std::ptrdiff_t>(tile * samples), samples,
              buffer_->clear_depth);
}

void LastWrite::test(Run* run) {
  // The tile is drawn again with a scissor that leaves nothing but it. That gives the same bits.
  const int log2 = contract_.design.tile_log2;
  const int x = static_cast<int>(run->tile) % tile_columns_ << log2;
  const int y = static_cast<int>(run->tile) / tile_columns_ << log2;
  spec::FrameState frame = frame_;
  frame.scissor_x0 = std::max(frame_.scissor_x0, x);
  frame.scissor_y0 = std::max(frame_.scissor_y0, y);
  frame.scissor_x1 = std::min(frame_.scissor_x1, x + (1 << log2));
  frame.scissor_y1 = std::min(frame_.scissor_y1, y + (1 << log2));
  spec::Triangle triangle;
  for (size_t i = 0; i < 3; ++i) {
    const Corner& corner = triangles_[run->triangle][i];
    triangle.v[i].x = corner.x;
    triangle.v[i].y = corner.y;
    triangle.v[i].z = corner.z;
  }
  spec::SetupPrim prim;
  fast::setup(contract_, frame, triangle, &prim, fast::Planes::kDepth);
  fast::TileCoverWalk walk(contract_);
  fast::TileCover cover(contract_);
  walk.begin(prim);
  walk.next(&cover);
  walk.cover_stamps(&cover, nullptr);
  fast::TileShader shader(contract_, frame, fast::TileShader::Values::kDepth);
  shader.begin(prim);
  shader.draw(cover, buffer_);

  const Cycle first = run->retire;
  run->retire = -1;
  if (shader.passed().count == 0) return;
  const int last = cover.covered.before(shader.passed().last);
  run->retire = run->irregular == kNone ? first + last
                                        : irregular_[run->irregular + static_cast<uint32_t>(last)];
}

}  // namespace pineda::timing
