// The stamps of a tile's blocks of samples, for the kernels that cover tiles.
#pragma once

#include <algorithm>

#include "model/fast/tile_cover.h"

namespace pineda::fast {

// The sizes of tiles and stamps: kernels have a version each for the common ones.
struct Shape {
  int tile_log2;
  int w_log2, h_log2;  // of a stamp

  constexpr int stamps_log2() const { return 2 * tile_log2 - w_log2 - h_log2; }
};
constexpr Shape shape_of(const spec::Design& d) {
  return {d.tile_log2, d.stamp_width_log2, d.stamp_height_log2};
}

// Repeats a byte in all eight bytes.
constexpr uint64_t in_each_byte(uint64_t byte) { return byte * 0x0101010101010101u; }

// The bits of columns x0 to x1 in rows y0 to y1 of a block.
PINEDA_INLINE uint64_t box_of(int x0, int y0, int x1, int y1) {
  const uint64_t columns = in_each_byte((0xffu << x0) & (0xffu >> (7 - x1)));
  return columns & (~uint64_t{0} << (8 * y0)) & (~uint64_t{0} >> (8 * (7 - y1)));
}

// The stamps of a block that have a covered sample, each marked at the bit of its first sample.
PINEDA_INLINE uint64_t stamps_of(const Shape& shape, uint64_t block) {
  if (shape.w_log2 >= 1) block |= block >> 1;
  if (shape.w_log2 >= 2) block |= block >> 2;
  if (shape.h_log2 >= 1) block |= block >> 8;
  if (shape.h_log2 >= 2) block |= block >> 16;
  constexpr uint64_t kColumns[] = {in_each_byte(0xff), in_each_byte(0x55), in_each_byte(0x11)};
  constexpr uint64_t kRows[] = {~uint64_t{0}, 0x00ff00ff00ff00ff, 0x000000ff000000ff};
  return block & kColumns[shape.w_log2] & kRows[shape.h_log2];
}

// Adds the stamps of the block at x, y to samples->stamps.
PINEDA_INLINE void place_stamps(const Shape& shape, int x, int y, uint64_t stamps,
                                TileSamples* samples) {
  // Packs a row's stamps into the low end of its byte.
  if (shape.w_log2 == 1) {
    stamps = (stamps | stamps >> 1) & in_each_byte(0x33);
    stamps = (stamps | stamps >> 2) & in_each_byte(0x0f);
  } else if (shape.w_log2 == 2) {
    stamps = (stamps | stamps >> 3) & in_each_byte(0x03);
  }
  const int columns_log2 = shape.tile_log2 - shape.w_log2;
  const int rows = std::min(kBlockPx, 1 << shape.tile_log2) >> shape.h_log2;
  const int place = ((y >> shape.h_log2) << columns_log2) + (x >> shape.w_log2);
  // A tile of one block has its stamps in one word; a block of a larger tile fills parts of
  // several.
  uint64_t bits = 0;
  for (int row = 0; row < rows; ++row) {
    const int at = place + (row << columns_log2);
    bits |= (stamps >> (row * (8 << shape.h_log2)) & 0xff) << (at % 64);
    if (row + 1 == rows || (at + (1 << columns_log2)) / 64 != at / 64) {
      samples->stamps[static_cast<size_t>(at) / 64] |= bits;
      bits = 0;
    }
  }
}

PINEDA_INLINE uint64_t ones(uint64_t bits) {
  return static_cast<uint64_t>(__builtin_popcountll(bits));
}

// Counts stamps of 2x2 by their samples, all of a block at once, in digits of four bits.
PINEDA_INLINE void count_quads(uint64_t block, StampsBySamples* by_samples) {
  constexpr uint64_t kPairs = in_each_byte(0x33), kDigits = in_each_byte(0x11);
  constexpr uint64_t kEvenRows = 0x00ff00ff00ff00ff;
  const uint64_t pairs = block - (block >> 1 & in_each_byte(0x55));
  const uint64_t even = (pairs & kPairs) + (pairs >> 8 & kPairs);
  const uint64_t odd = (pairs >> 2 & kPairs) + (pairs >> 10 & kPairs);
  const uint64_t n = (even & kEvenRows) | (odd & kEvenRows) << 8;
  const uint64_t bit0 = n & kDigits, bit1 = n >> 1 & kDigits, bit2 = n >> 2 & kDigits;
  const uint64_t threes = ones(bit0 & bit1);
  (*by_samples)[1] += ones(bit0) - threes;
  (*by_samples)[2] += ones(bit1) - threes;
  (*by_samples)[3] += threes;
  (*by_samples)[4] += ones(bit2);
}

PINEDA_INLINE void count_stamps(const Shape& shape, uint64_t block, StampsBySamples* by_samples) {
  if (shape.w_log2 == 1 && shape.h_log2 == 1) return count_quads(block, by_samples);
  const int w = 1 << shape.w_log2, h = 1 << shape.h_log2;
  const uint64_t stamp = box_of(0, 0, w - 1, h - 1);
  for (int first = 0; first < 64; first += kBlockPx * h) {
    for (int x = 0; x < kBlockPx; x += w) ++(*by_samples)[ones(block >> (first + x) & stamp)];
  }
  (*by_samples)[0] = 0;
}

PINEDA_INLINE void clear_stamps(const Shape& shape, TileSamples* samples) {
  if (shape.stamps_log2() <= 6) {
    samples->stamps[0] = 0;
  } else {
    std::fill(samples->stamps.begin(), samples->stamps.end(), 0);
  }
  samples->sample_count = 0;
}

PINEDA_INLINE void find_first_and_last(const Shape& shape, TileSamples* samples) {
  const int words = shape.stamps_log2() <= 6 ? 1 : 1 << (shape.stamps_log2() - 6);
  int first = 0, last = 0, count = 0;
  for (int word = 0; word < words; ++word) {
    const uint64_t bits = samples->stamps[static_cast<size_t>(word)];
    if (bits == 0) continue;
    if (count == 0) first = word * 64 + __builtin_ctzll(bits);
    last = word * 64 + 63 - __builtin_clzll(bits);
    count += static_cast<int>(ones(bits));
  }
  samples->first = first;
  samples->last = last;
  samples->count = count;
}

// Sets the box, given from the tile's corner and not clipped to it.
PINEDA_INLINE void set_box(const Shape& shape, int x0, int y0, int x1, int y1, TileCover* cover) {
  const int last = (1 << shape.tile_log2) - 1;
  cover->x0 = std::max(x0, 0);
  cover->y0 = std::max(y0, 0);
  cover->x1 = std::min(x1, last);
  cover->y1 = std::min(y1, last);
  GroupBox& box = cover->box;
  const int group_px_log2 = shape.w_log2 + box.group_log2;
  box.column0 = cover->x0 >> group_px_log2;
  box.columns = (cover->x1 >> group_px_log2) - box.column0 + 1;
  box.row0 = cover->y0 >> shape.h_log2;
  box.rows = (cover->y1 >> shape.h_log2) - box.row0 + 1;
}

PINEDA_INLINE void find_groups(const Shape& shape, TileCover* cover) {
  const TileSamples& samples = cover->covered;
  const GroupBox& box = cover->box;
  constexpr uint64_t kFirst[] = {~uint64_t{0},
                                 in_each_byte(0x55),
                                 in_each_byte(0x11),
                                 in_each_byte(0x01),
                                 0x0001000100010001,
                                 0x0000000100000001,
                                 1};
  const int last_group = samples.last >> box.group_log2 << box.group_log2;
  const int words = shape.stamps_log2() <= 6 ? 1 : 1 << (shape.stamps_log2() - 6);
  uint64_t groups = 0, in_last = 0;
  for (int word = 0; word < words; ++word) {
    const uint64_t stamps = samples.stamps[static_cast<size_t>(word)];
    uint64_t bits = stamps;
    for (int log2 = 0; log2 < box.group_log2; ++log2) bits |= bits >> (1 << log2);
    groups += ones(bits & kFirst[box.group_log2]);
    if (word == last_group / 64) in_last = ones(stamps >> (last_group % 64));
  }
  cover->groups.first = box.test_of(samples.first);
  cover->groups.last = box.test_of(samples.last);
  cover->groups.count = static_cast<int>(groups);
  cover->groups.before_last = samples.count - static_cast<int>(in_last);
}

// Calls work(shape); for the shapes of most designs with compile-time constants.
template <class Work>
PINEDA_INLINE void with_shape(const spec::Design& d, Work&& work) {
  constexpr Shape kQuads{3, 1, 1}, kLarge{3, 2, 2};
  const Shape shape = shape_of(d);
  const auto is = [&](const Shape& s) PINEDA_INLINED {
    return shape.tile_log2 == s.tile_log2 && shape.w_log2 == s.w_log2 && shape.h_log2 == s.h_log2;
  };
  if (is(kQuads)) return work(kQuads);
  if (is(kLarge)) return work(kLarge);
  work(shape);
}

}  // namespace pineda::fast
