// The memories of a frame in the order in which tiles are drawn.
#pragma once

#include <new>

#include "model/core/frame_buffer.h"
#include "model/fast/tile_cover.h"

namespace pineda::fast {

inline constexpr size_t kLineBytes = 64;  // of a cache
inline constexpr size_t kLargePageBytes = size_t{2} << 20;

/// Asks the system for large pages where the memory has room for one.
void use_large_pages(void* memory, size_t bytes);

/// Begins on a cache line, so that a row of a block crosses none; large memories on a large page, which
/// the system is asked for, so that few addresses are translated.
template <class T>
struct CacheLineAllocator {
  using value_type = T;  // NOLINT(readability-identifier-naming): the standard's name
  static constexpr std::align_val_t alignment(size_t bytes) {
    return std::align_val_t{bytes < kLargePageBytes ? kLineBytes : kLargePageBytes};
  }

  CacheLineAllocator() = default;
  template <class Other>
  explicit CacheLineAllocator(const CacheLineAllocator<Other>&) {}
  T* allocate(size_t n) {
    const size_t bytes = n * sizeof(T);
    void* const p = ::operator new(bytes, alignment(bytes));
    use_large_pages(p, bytes);
    return static_cast<T*>(p);
  }
  void deallocate(T* p, size_t n) { ::operator delete(p, alignment(n * sizeof(T))); }
  bool operator==(const CacheLineAllocator&) const { return true; }
  bool operator!=(const CacheLineAllocator&) const { return false; }
};

inline constexpr size_t kBlockSamples = size_t{kBlockPx} * kBlockPx;

/// The order of samples in the memories: row by row in a block, the blocks of a tile together,
/// tiles row by row. Tiles at the frame's border are stored whole, and so is a block where tiles
/// are smaller than one.
struct Tiled {
  template <class T>
  using Samples = std::vector<T, CacheLineAllocator<T>>;

  int width = 0;
  int height = 0;
  int tile_log2 = 0;
  int tile_columns = 0;
  int tile_rows = 0;
  size_t tile_blocks_across = 0;
  size_t tile_samples = 0;

  Tiled() = default;
  Tiled(const spec::Design& design, const spec::FrameState& frame);
  size_t samples() const {
    return static_cast<size_t>(tile_columns) * static_cast<size_t>(tile_rows) * tile_samples;
  }
  /// The first sample of the tile in column x, row y.
  size_t tile_index(int x, int y) const {
    return (static_cast<size_t>(y) * static_cast<size_t>(tile_columns) + static_cast<size_t>(x)) *
           tile_samples;
  }
  /// As block_of().
  size_t block_in_tile(int x, int y) const {
    return static_cast<size_t>(y) / kBlockPx * tile_blocks_across +
           static_cast<size_t>(x) / kBlockPx;
  }
  /// Of the sample in column x, row y of a tile, from the tile's first one.
  size_t index_in_tile(int x, int y) const {
    const auto u = static_cast<size_t>(x), v = static_cast<size_t>(y);
    return block_in_tile(x, y) * kBlockSamples + v % kBlockPx * kBlockPx + u % kBlockPx;
  }
  size_t index(int x, int y) const {
    const int in_tile = (1 << tile_log2) - 1;
    return tile_index(x >> tile_log2, y >> tile_log2) + index_in_tile(x & in_tile, y & in_tile);
  }
};

/// core::FrameBuffer's memories in that order.
struct TiledBuffer : Tiled {
  int channels = 0;
  uint32_t clear_depth = 0;
  Samples<uint32_t> depth;
  Samples<uint16_t> color;
  Samples<uint16_t> hits;

  TiledBuffer() = default;
  TiledBuffer(const spec::Contract& contract, const spec::FrameState& frame);
  void clear();

  /// As core::FrameBuffer's.
  template <class Visitor>
  void for_each_lane(const spec::Contract& contract, int x, int y, uint32_t mask,
                     Visitor&& visit) const {
    const spec::Design& d = contract.design;
    const size_t first = index(x << d.stamp_width_log2, y << d.stamp_height_log2);
    for (; mask != 0; mask &= mask - 1) {
      const auto lane = static_cast<size_t>(__builtin_ctz(mask));
      const size_t row = lane >> d.stamp_width_log2;
      visit(lane, first + row * kBlockPx + lane - (row << d.stamp_width_log2));
    }
  }
  spec::DepthData read(const spec::Contract& contract, int x, int y, uint32_t mask) const;
  void write(const spec::Contract& contract, const spec::DepthWrite& write);
  void write(const spec::Contract& contract, const spec::ColorWrite& write);
  void count_hits(const spec::Contract& contract, const spec::Stamp& stamp);

  /// Prefetches the blocks in the box of `cover`, ahead of a draw.
  void prefetch(const TileCover& cover, bool with_color) const;
  /// Copies the samples of rows of tiles, first to last, as far as the frame goes, to a
  /// buffer of this frame.
  void copy_rows(int first, int last, core::FrameBuffer* to) const;
  core::FrameBuffer by_rows(const spec::Contract& contract) const;
};

}  // namespace pineda::fast
