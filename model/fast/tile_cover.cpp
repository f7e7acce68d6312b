#include "model/fast/tile_cover.h"

#include <algorithm>

#include "model/fast/lanes.h"

namespace pineda::fast {

using spec::ceil_log2;
using spec::Design;

namespace {

// The sizes of tiles and stamps: kernels have a version each for the common ones.
struct Shape {
  int tile_log2;
  int w_log2, h_log2;  // of a stamp

  constexpr int stamps_log2() const { return 2 * tile_log2 - w_log2 - h_log2; }
};
constexpr Shape shape_of(const Design& d) {
  return {d.tile_log2, d.stamp_width_log2, d.stamp_height_log2};
}

// Repeats a byte in all eight bytes.
constexpr uint64_t in_each_byte(uint64_t byte) { return byte * 0x0101010101010101u; }

// The bits of columns x0 to x1 in rows y0 to y1 of a block.
PINEDA_INLINE uint64_t box_of(int x0, int y0, int x1, int y1) {
  const uint64_t columns = in_each_byte((0xffu << x0) & (0xffu >> (7 - x1)));
  return columns & (~uint64_t{0} << (8 * y0)) & (~uint64_t{0} >> (8 * (7 - y1)));
}

// The samples of the block at x, y that are inside all edges. A lane is a row of the left or the
// right half; the loop takes the columns of both halves from right to left.
template <class Vector, class Value>
PINEDA_INLINE uint64_t cover_block(const spec::SetupPrim& prim, const EdgeValues& e, int x, int y) {
  typedef uint8_t Bytes __attribute__((vector_size(16)));
  using Unsigned = std::make_unsigned_t<Value>;
  constexpr int kHalf = kBlockPx / 2;
  Vector v[3];
  Value a[3];
  for (size_t i = 0; i < 3; ++i) {
    a[i] = static_cast<Value>(prim.edge[i].a);
    const auto b = static_cast<Value>(prim.edge[i].b);
    const Value right = static_cast<Value>(e[i]) + a[i] * static_cast<Value>(x + kBlockPx - 1) +
                        b * static_cast<Value>(y);
    v[i] = __builtin_convertvector(kRowNumbers, Vector) * b + right -
           (__builtin_convertvector(kLeftHalf, Vector) & (a[i] * kHalf));
  }
  typedef Unsigned Bits __attribute__((vector_size(sizeof(Vector))));
  Bits outside{};
  for (int column = 0; column < kHalf; ++column) {
    outside += outside;
    outside |= reinterpret_cast<Bits>(v[0] | v[1] | v[2]) >> (8 * sizeof(Value) - 1);
    for (size_t i = 0; i < 3; ++i) v[i] -= a[i];
  }
  const Bytes bytes = __builtin_convertvector(outside, Bytes);
  uint64_t half[2];
  std::memcpy(half, &bytes, sizeof half);
  return ~(half[1] | half[0] << kHalf);
}

// Calls visit(block, x, y, samples) for the blocks in the box of `cover`; `samples`: those in the
// box.
template <class Visitor>
PINEDA_INLINE void for_each_block(int tile_log2, const TileCover& cover, Visitor&& visit) {
  if (tile_log2 <= ceil_log2(kBlockPx)) {
    return visit(size_t{0}, 0, 0, box_of(cover.x0, cover.y0, cover.x1, cover.y1));
  }
  const size_t across = size_t{1} << (tile_log2 - ceil_log2(kBlockPx));
  for (int y = cover.y0 & -kBlockPx; y <= cover.y1; y += kBlockPx) {
    for (int x = cover.x0 & -kBlockPx; x <= cover.x1; x += kBlockPx) {
      visit(static_cast<size_t>(y / kBlockPx) * across + static_cast<size_t>(x / kBlockPx), x, y,
            box_of(std::max(cover.x0 - x, 0), std::max(cover.y0 - y, 0),
                   std::min(cover.x1 - x, kBlockPx - 1), std::min(cover.y1 - y, kBlockPx - 1)));
    }
  }
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

PINEDA_INLINE void find_in_blocks(const Shape& shape, const TileCover& box, TileSamples* samples) {
  clear_stamps(shape, samples);
  for_each_block(shape.tile_log2, box, [&](size_t block, int x, int y, uint64_t) PINEDA_INLINED {
    const uint64_t bits = samples->blocks[block];
    samples->sample_count += static_cast<int>(ones(bits));
    place_stamps(shape, x, y, stamps_of(shape, bits), samples);
  });
  find_first_and_last(shape, samples);
}

template <class Vector, class Value>
PINEDA_INLINE void cover_blocks(const Shape& shape, const spec::SetupPrim& prim,
                                const EdgeValues& e, TileCover* cover,
                                StampsBySamples* by_samples) {
  TileSamples& samples = cover->covered;
  clear_stamps(shape, &samples);
  const auto find = [&](size_t block, int x, int y, uint64_t box) PINEDA_INLINED {
    const uint64_t bits = cover_block<Vector, Value>(prim, e, x, y) & box;
    samples.blocks[block] = bits;
    samples.sample_count += static_cast<int>(ones(bits));
    place_stamps(shape, x, y, stamps_of(shape, bits), &samples);
    if (by_samples != nullptr) count_stamps(shape, bits, by_samples);
  };
  for_each_block(shape.tile_log2, *cover, find);
  find_first_and_last(shape, &samples);
}

// Calls work(shape); for the shapes of most designs with compile-time constants.
template <class Work>
PINEDA_INLINE void with_shape(const Design& d, Work&& work) {
  constexpr Shape kQuads{3, 1, 1}, kLarge{3, 2, 2};
  const Shape shape = shape_of(d);
  const auto is = [&](const Shape& s) PINEDA_INLINED {
    return shape.tile_log2 == s.tile_log2 && shape.w_log2 == s.w_log2 && shape.h_log2 == s.h_log2;
  };
  if (is(kQuads)) return work(kQuads);
  if (is(kLarge)) return work(kLarge);
  work(shape);
}

PINEDA_KERNEL(void, cover_narrow,
              (const Design& d, const spec::SetupPrim& prim, const EdgeValues& e, TileCover* cover,
               StampsBySamples* by_samples),
              (d, prim, e, cover, by_samples)) {
  with_shape(d, [&](const Shape& shape) PINEDA_INLINED {
    cover_blocks<Int32x16, int32_t>(shape, prim, e, cover, by_samples);
  });
}
PINEDA_KERNEL(void, cover_wide,
              (const Design& d, const spec::SetupPrim& prim, const EdgeValues& e, TileCover* cover,
               StampsBySamples* by_samples),
              (d, prim, e, cover, by_samples)) {
  cover_blocks<Int64x16, int64_t>(shape_of(d), prim, e, cover, by_samples);
}
PINEDA_KERNEL(void, find_in_tile, (const Design& d, const TileCover& box, TileSamples* samples),
              (d, box, samples)) {
  with_shape(d, [&](const Shape& shape) PINEDA_INLINED { find_in_blocks(shape, box, samples); });
}

// Sets every sample of the tile.
void fill(const Design& d, TileSamples* samples) {
  const int last = std::min(kBlockPx, 1 << d.tile_log2) - 1;
  std::fill(samples->blocks.begin(), samples->blocks.end(), box_of(0, 0, last, last));
  samples->count = 1 << stamps_log2(d);
  samples->sample_count = 1 << (2 * d.tile_log2);
  samples->first = 0;
  samples->last = samples->count - 1;
  std::fill(samples->stamps.begin(), samples->stamps.end(),
            samples->count >= 64 ? ~uint64_t{0} : (uint64_t{1} << samples->count) - 1);
}

}  // namespace

TileSamples::TileSamples(const Design& d)
    : blocks(static_cast<size_t>(blocks_across(d)) * static_cast<size_t>(blocks_across(d))) {
  stamps.resize(stamps_log2(d) <= 6 ? 1 : size_t{1} << (stamps_log2(d) - 6));
}

uint32_t lanes_of(const Design& d, const TileSamples& samples, int place) {
  const int w_log2 = d.stamp_width_log2;
  const int columns_log2 = d.tile_log2 - w_log2;
  const int x = (place & ((1 << columns_log2) - 1)) << w_log2;
  const int y = (place >> columns_log2) << d.stamp_height_log2;
  uint64_t rows = samples.blocks[block_of(d, x, y)] >> (y % kBlockPx * kBlockPx + x % kBlockPx);
  uint64_t lanes = 0;
  for (int j = 0; j < 1 << d.stamp_height_log2; ++j, rows >>= kBlockPx) {
    lanes |= (rows & ((1u << (1 << w_log2)) - 1)) << (j << w_log2);
  }
  return static_cast<uint32_t>(lanes);
}

void find_stamps(const Design& d, const TileCover& box, TileSamples* samples) {
  find_in_tile(d, box, samples);
}

void TileCoverWalk::begin(const spec::SetupPrim& prim, core::TileRows rows) {
  prim_ = &prim;
  steps_.begin(prim, contract_.design.tile_log2, rows);
}

PINEDA_INLINE void TileCoverWalk::keep(TileCover* cover) {
  const Design& d = contract_.design;
  const int last = (1 << d.tile_log2) - 1;
  const int left = steps_.x() << d.tile_log2, top = steps_.y() << d.tile_log2;
  const int x0 = std::max(prim_->x0 - left, 0), x1 = std::min(prim_->x1 - left, last);
  const int y0 = std::max(prim_->y0 - top, 0), y1 = std::min(prim_->y1 - top, last);
  cover->x = steps_.x();
  cover->y = steps_.y();
  cover->x0 = x0;
  cover->y0 = y0;
  cover->x1 = x1;
  cover->y1 = y1;
  GroupBox& box = cover->box;
  const int group_px_log2 = d.stamp_width_log2 + box.group_log2;
  box.column0 = x0 >> group_px_log2;
  box.columns = (x1 >> group_px_log2) - box.column0 + 1;
  box.row0 = y0 >> d.stamp_height_log2;
  box.rows = (y1 >> d.stamp_height_log2) - box.row0 + 1;
  cover->accepted = steps_.accepted();
  kept_ = steps_.lowered();
}

core::TileWalk::Test TileCoverWalk::next(TileCover* cover) {
  if (steps_.ended()) return core::TileWalk::Test::kEnd;
  const int rejecting = steps_.rejects();
  if (rejecting == 0) keep(cover);
  steps_.step(rejecting);
  return rejecting != 0 ? core::TileWalk::Test::kRejected : core::TileWalk::Test::kKept;
}

bool TileCoverWalk::next_kept(TileCover* cover, int* rejected) {
  for (*rejected = 0; !steps_.ended(); ++*rejected) {
    const int rejecting = steps_.rejects();
    if (rejecting == 0) keep(cover);
    steps_.step(rejecting);
    if (rejecting == 0) return true;
  }
  return false;
}

void TileCoverWalk::cover_stamps(TileCover* cover, StampsBySamples* by_samples) const {
  const Design& d = contract_.design;
  const int last = (1 << d.tile_log2) - 1;
  if (cover->accepted && cover->x1 - cover->x0 == last && cover->y1 - cover->y0 == last) {
    if (!cover->full) fill(d, &cover->covered);
    cover->full = true;
    if (by_samples != nullptr) {
      (*by_samples)[static_cast<size_t>(contract_.width.lanes)] +=
          static_cast<uint64_t>(cover->covered.count);
    }
    return;
  }
  cover->full = false;
  // |E'| <= (T-1)(|a|+|b|) in a kept tile, once lowered, and |a|, |b| < 2^coord. Lanes cover a whole
  // block, which may be larger than the tile.
  const int side_log2 = std::max(d.tile_log2, ceil_log2(kBlockPx));
  if (2 + side_log2 + contract_.width.coord <= 32) {
    cover_narrow(d, *prim_, kept_, cover, by_samples);
  } else {
    cover_wide(d, *prim_, kept_, cover, by_samples);
  }
}

}  // namespace pineda::fast
