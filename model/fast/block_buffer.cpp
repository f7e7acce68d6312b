#include "model/fast/block_buffer.h"

#include <algorithm>

namespace pineda::fast {

namespace {

constexpr size_t blocks_along(int px) { return static_cast<size_t>((px - 1) / kBlockPx) + 1; }

}  // namespace

BlockBuffer::BlockBuffer(const spec::Contract& c, const spec::FrameState& frame,
                         core::TileRows wanted, bool with_hits)
    : width(frame.width),
      height(frame.height),
      channels(spec::channels(c.design)),
      across(blocks_along(frame.width)),
      clear_depth(spec::cleared_depth(c.design, frame)) {
  // Tiles are made of whole blocks.
  const int log2 = c.design.tile_log2;
  const int last = std::min(wanted.last, (height - 1) >> log2);
  top = wanted.first << log2;
  rows = std::min((last + 1) << log2, height) - top;
  const size_t blocks = across * blocks_along(rows);
  greatest.resize(blocks + kReadBeyond);
  lines.resize(blocks * kBlockLines);
  if (with_hits) hits.resize(blocks * kBlockSamples);
  clear();
}

void BlockBuffer::clear() {
  SampleLine line{};
  line.depth.fill(clear_depth);
  std::fill(lines.begin(), lines.end(), line);
  std::fill(greatest.begin(), greatest.end(), clear_depth);
  std::fill(hits.begin(), hits.end(), 0);
}

void BlockBuffer::copy_to(core::FrameBuffer* to) const {
  const auto n = static_cast<size_t>(channels);
  for (int y = top; y < top + rows; ++y) {
    for (int x = 0; x < width; ++x) {
      const size_t line = this->line(x, y);
      const int sample_in_line = y % kLineHeightPx * kLineWidthPx + x % kLineWidthPx;
      const auto sample = static_cast<size_t>(sample_in_line);
      const size_t there = to->index(x, y);
      to->depth[there] = lines[line].depth[sample];
      to->hits[there] = hits.empty() ? 0 : hits[line * kLineSamples + sample];
      const uint32_t color = lines[line].color[sample];
      for (size_t a = 0; a < n; ++a) {
        to->color[there * n + a] = static_cast<uint16_t>(color >> (8 * a) & 0xff);
      }
    }
  }
}

}  // namespace pineda::fast
