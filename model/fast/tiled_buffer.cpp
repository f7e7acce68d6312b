#include "model/fast/tiled_buffer.h"

#include <algorithm>
#include <cstddef>
#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace pineda::fast {

void use_large_pages(void* memory, size_t bytes) {
#if defined(MADV_HUGEPAGE)
  if (bytes >= kLargePageBytes) madvise(memory, bytes & ~(kLargePageBytes - 1), MADV_HUGEPAGE);
#else
  (void)memory, (void)bytes;
#endif
}

Tiled::Tiled(const spec::Design& d, const spec::FrameState& frame)
    : width(frame.width),
      height(frame.height),
      tile_log2(d.tile_log2),
      tile_columns(((frame.width - 1) >> d.tile_log2) + 1),
      tile_rows(((frame.height - 1) >> d.tile_log2) + 1),
      tile_blocks_across(static_cast<size_t>(blocks_across(d))),
      tile_samples(tile_blocks_across * tile_blocks_across * kBlockSamples) {}

TiledBuffer::TiledBuffer(const spec::Contract& c, const spec::FrameState& frame)
    : Tiled(c.design, frame),
      channels(spec::channels(c.design)),
      clear_depth(spec::cleared_depth(c.design, frame)) {
  clear();
}

void TiledBuffer::clear() {
  depth.assign(samples(), clear_depth);
  color.assign(samples() * static_cast<size_t>(channels), 0);
  hits.assign(samples(), 0);
}

spec::DepthData TiledBuffer::read(const spec::Contract& c, int x, int y, uint32_t mask) const {
  spec::DepthData data;
  for_each_lane(c, x, y, mask, [&](size_t lane, size_t sample) { data.z[lane] = depth[sample]; });
  return data;
}

void TiledBuffer::write(const spec::Contract& c, const spec::DepthWrite& w) {
  for_each_lane(c, w.x, w.y, w.mask,
                [&](size_t lane, size_t sample) { depth[sample] = w.z[lane]; });
}

void TiledBuffer::write(const spec::Contract& c, const spec::ColorWrite& w) {
  const auto n = static_cast<size_t>(channels);
  for_each_lane(c, w.x, w.y, w.mask, [&](size_t lane, size_t sample) {
    const auto to = color.begin() + static_cast<std::ptrdiff_t>(sample * n);
    const auto flat = std::copy_n(w.attr[lane].begin(), c.design.attributes, to);
    std::copy_n(w.flat.begin(), c.design.flat_attributes, flat);
  });
}

void TiledBuffer::count_hits(const spec::Contract& c, const spec::Stamp& stamp) {
  for_each_lane(c, stamp.x, stamp.y, stamp.mask, [&](size_t, size_t sample) {
    if (hits[sample] != UINT16_MAX) ++hits[sample];
  });
}

// Asks for whole blocks: to find out which rows are needed would take longer.
void TiledBuffer::prefetch(const TileCover& cover, bool with_color) const {
  constexpr size_t kDepthLine = kLineBytes / sizeof(uint32_t);
  constexpr size_t kColorLine = kLineBytes / sizeof(uint16_t);
  const size_t color_samples = with_color ? kBlockSamples * static_cast<size_t>(channels) : 0;
  const size_t tile = tile_index(cover.x, cover.y);
  for (int y = cover.y0 & -kBlockPx; y <= cover.y1; y += kBlockPx) {
    for (int x = cover.x0 & -kBlockPx; x <= cover.x1; x += kBlockPx) {
      const size_t first = tile + block_in_tile(x, y) * kBlockSamples;
      const uint32_t* const depths = depth.data() + first;
      for (size_t i = 0; i < kBlockSamples; i += kDepthLine) __builtin_prefetch(depths + i, 1);
      const uint16_t* const colors = color.data() + first * static_cast<size_t>(channels);
      for (size_t i = 0; i < color_samples; i += kColorLine) __builtin_prefetch(colors + i, 1);
    }
  }
}

void TiledBuffer::copy_rows(int first, int last, core::FrameBuffer* to) const {
  const auto n = static_cast<size_t>(channels);
  const int side = std::min(kBlockPx, 1 << tile_log2);
  const auto copy = [](const auto& from, size_t begin, size_t count, size_t at, auto* samples) {
    std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(begin), count,
                samples->begin() + static_cast<std::ptrdiff_t>(at));
  };
  for (int y = first << tile_log2; y < std::min((last + 1) << tile_log2, height); ++y) {
    for (int x = 0; x < width; x += side) {
      const auto count = static_cast<size_t>(std::min(side, width - x));
      const size_t here = index(x, y);
      const size_t there = to->index(x, y);
      copy(depth, here, count, there, &to->depth);
      copy(color, here * n, count * n, there * n, &to->color);
      copy(hits, here, count, there, &to->hits);
    }
  }
}

core::FrameBuffer TiledBuffer::by_rows(const spec::Contract& contract) const {
  spec::FrameState frame;
  frame.width = width;
  frame.height = height;
  core::FrameBuffer buffer(contract, frame);
  buffer.clear_depth = clear_depth;
  copy_rows(0, tile_rows - 1, &buffer);
  return buffer;
}

}  // namespace pineda::fast
