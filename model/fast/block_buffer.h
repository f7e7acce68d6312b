// The memories of a frame, as narrow as its codes, in the order in which blocks are drawn.
#pragma once

#include "model/fast/tiled_buffer.h"

namespace pineda::fast {

inline constexpr int kLineWidthPx = 4;
inline constexpr int kLineHeightPx = 2;
inline constexpr int kLineSamples = kLineWidthPx * kLineHeightPx;
inline constexpr size_t kBlockLines = kBlockSamples / kLineSamples;

/// 4 x 2 samples, row by row, in a line of the cache: the small triangles of a mesh touch few lines.
struct alignas(kLineBytes) SampleLine {
  std::array<uint32_t, kLineSamples> depth;  // codes
  std::array<uint32_t, kLineSamples> color;  // channel 0 in the lowest byte
};
static_assert(sizeof(SampleLine) == kLineBytes);

/// Blocks of 8 x 8 samples, row by row; in a block, lines row by row. Blocks at the frame's border are
/// stored whole. Only the rows of tiles that are wanted are stored.
struct BlockBuffer {
  static constexpr size_t kReadBeyond = 16;
  template <class T>
  using Samples = std::vector<T, CacheLineAllocator<T>>;

  int width = 0;
  int height = 0;
  int channels = 0;   // 0 to 4
  size_t across = 0;  // blocks
  int top = 0;        // the first row of samples that is stored, and how many are
  int rows = 0;
  uint32_t clear_depth = 0;
  Samples<SampleLine> lines;
  Samples<uint16_t> hits;  // in the same order; empty unless hits are wanted
  /// No depth stored in a block is greater, as long as writes only lower depths. Behind the last one some
  /// more can be read.
  std::vector<uint32_t> greatest;

  BlockBuffer() = default;
  BlockBuffer(const spec::Contract& contract, const spec::FrameState& frame, core::TileRows wanted,
              bool with_hits);
  void clear();

  /// The block with the sample of pixel x, y.
  size_t block(int x, int y) const {
    return static_cast<size_t>((y - top) / kBlockPx) * across + static_cast<size_t>(x / kBlockPx);
  }
  /// The line with that sample.
  size_t line(int x, int y) const {
    constexpr int kAcross = kBlockPx / kLineWidthPx;
    return block(0, y) * kBlockLines + static_cast<size_t>(y % kBlockPx / kLineHeightPx * kAcross) +
           line_in_row(x);
  }
  /// From the line at the left of the frame.
  static size_t line_in_row(int x) {
    return static_cast<size_t>(x / kBlockPx) * kBlockLines +
           static_cast<size_t>(x % kBlockPx / kLineWidthPx);
  }
  /// Copies what is stored to a buffer of the whole frame.
  void copy_to(core::FrameBuffer* to) const;
};

}  // namespace pineda::fast
