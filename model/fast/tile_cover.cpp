#include "model/fast/tile_cover.h"

#include <algorithm>

#include "model/fast/lanes.h"
#include "model/fast/tile_stamps.h"

namespace pineda::fast {

using spec::ceil_log2;
using spec::Design;

namespace {

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
  find_groups(shape, cover);
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
void fill(const Design& d, TileCover* cover) {
  TileSamples* const samples = &cover->covered;
  const int last = std::min(kBlockPx, 1 << d.tile_log2) - 1;
  std::fill(samples->blocks.begin(), samples->blocks.end(), box_of(0, 0, last, last));
  samples->count = 1 << stamps_log2(d);
  samples->sample_count = 1 << (2 * d.tile_log2);
  samples->first = 0;
  samples->last = samples->count - 1;
  std::fill(samples->stamps.begin(), samples->stamps.end(),
            samples->count >= 64 ? ~uint64_t{0} : (uint64_t{1} << samples->count) - 1);
  const int tests = cover->box.tests();
  cover->groups = {0, tests - 1, tests, samples->count - (1 << cover->box.group_log2)};
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
  cover->x = steps_.x();
  cover->y = steps_.y();
  const int left = cover->x << d.tile_log2, top = cover->y << d.tile_log2;
  set_box(shape_of(d), prim_->x0 - left, prim_->y0 - top, prim_->x1 - left, prim_->y1 - top, cover);
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
    if (!cover->full) fill(d, cover);
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
