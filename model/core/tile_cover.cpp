#include "model/core/tile_cover.h"

#include <algorithm>

#include "model/core/lanes.h"

namespace pineda::core {

using spec::ceil_log2;
using spec::Design;

namespace {

// The edges of a tile as its stamps need them; one that accepts the tile is 0 everywhere.
template <class Value>
struct TileEdges {
  Value a[3], b[3], e[3];
};

// Columns x0 to x1 of a block, in all of its rows.
uint64_t columns_between(int x0, int x1) {
  const uint64_t row = (0xffu << x0) & (0xffu >> (7 - x1));
  return row * 0x0101010101010101u;
}

// The blocks in the box of `cover`. The elements of Vector hold an edge that cuts the tile, at
// every sample of it.
template <class Vector, class Value>
PINEDA_INLINE void cover_blocks(const Design& d, const TileEdges<Value>& edges, TileCover* cover) {
  for (int x = cover->x0 & -kBlockPx; x <= cover->x1; x += kBlockPx) {
    const uint64_t columns =
        columns_between(std::max(cover->x0 - x, 0), std::min(cover->x1 - x, kBlockPx - 1));
    const Vector lanes = __builtin_convertvector(kLaneNumbers, Vector) + static_cast<Value>(x);
    for (int top = cover->y0 & -kBlockPx; top <= cover->y1; top += kBlockPx) {
      const int first = std::max(cover->y0, top);
      const int last = std::min(cover->y1, top + kBlockPx - 1);
      const auto y = static_cast<Value>(first);
      Vector v0 = lanes * edges.a[0] + (edges.e[0] + edges.b[0] * y);
      Vector v1 = lanes * edges.a[1] + (edges.e[1] + edges.b[1] * y);
      Vector v2 = lanes * edges.a[2] + (edges.e[2] + edges.b[2] * y);
      BlockBits bits;
      for (int j = first; j <= last; ++j) {
        bits.add(j - top, __builtin_convertvector((v0 | v1 | v2) >= 0, Uint32x8));
        v0 += edges.b[0];
        v1 += edges.b[1];
        v2 += edges.b[2];
      }
      cover->covered.blocks[block_of(d, x, top)] = bits.bits() & columns;
    }
  }
}

PINEDA_CLONES void cover_narrow(const Design& d, const TileEdges<int32_t>& edges,
                                TileCover* cover) {
  cover_blocks<Int32x8>(d, edges, cover);
}
PINEDA_CLONES void cover_wide(const Design& d, const TileEdges<int64_t>& edges, TileCover* cover) {
  cover_blocks<Int64x8>(d, edges, cover);
}

// Every sample of the tile.
void fill(const Design& d, TileSamples* samples) {
  const int side = std::min(kBlockPx, 1 << d.tile_log2);
  const uint64_t rows = side == kBlockPx ? ~uint64_t{0} : (uint64_t{1} << (kBlockPx * side)) - 1;
  std::fill(samples->blocks.begin(), samples->blocks.end(), columns_between(0, side - 1) & rows);
  const int lanes = 1 << (d.stamp_width_log2 + d.stamp_height_log2);
  std::fill(samples->mask.begin(), samples->mask.end(), static_cast<uint16_t>((1u << lanes) - 1));
  samples->count = static_cast<int>(samples->mask.size());
  samples->sample_count = samples->count * lanes;
  samples->first = 0;
  samples->last = samples->count - 1;
  std::fill(samples->stamps.begin(), samples->stamps.end(),
            samples->count >= 64 ? ~uint64_t{0} : (uint64_t{1} << samples->count) - 1);
}

void finish(TileSamples* samples, int tests) {
  const int words = (tests + 63) / 64;
  for (int word = 0; word < words; ++word) {
    const uint64_t bits = samples->stamps[static_cast<size_t>(word)];
    if (bits == 0) continue;
    samples->last = word * 64 + 63 - __builtin_clzll(bits);
  }
  for (int word = words; word-- > 0;) {
    const uint64_t bits = samples->stamps[static_cast<size_t>(word)];
    if (bits != 0) samples->first = word * 64 + __builtin_ctzll(bits);
  }
}

// ---- Stamps of 2x2 samples in tiles of one block, all sixteen at once: a digit of four bits each,
// in the order of the walk through the whole tile.

constexpr uint64_t kOnes = 0x1111111111111111u;

// Each row of a block spread out to the lower or upper half of its stamps' digits.
uint64_t spread(uint64_t rows) {
  rows = (rows | rows << 4) & 0x0f0f0f0f0f0f0f0fu;
  return (rows | rows << 2) & 0x3333333333333333u;
}
uint64_t digits_of(uint64_t block) {
  constexpr uint64_t kEven = 0x00ff00ff00ff00ffu;
  return spread(block & kEven) | spread(block >> 8 & kEven) << 2;
}

// Digits that are 1, of digits that are 0 or 1.
uint64_t count_ones(uint64_t digits) {
  digits = (digits + (digits >> 4)) & 0x0f0f0f0f0f0f0f0fu;
  return digits * 0x0101010101010101u >> 56;
}

// The same as 16 bits.
uint64_t gather(uint64_t digits) {
  digits = (digits | digits >> 3) & 0x0303030303030303u;
  digits = (digits | digits >> 6) & 0x000f000f000f000fu;
  digits = (digits | digits >> 12) & 0x000000ff000000ffu;
  return (digits | digits >> 24) & 0xffff;
}

void find_quads(const TileCover& box, bool with_masks, TileSamples* samples,
                StampsBySamples* by_samples) {
  if (samples->blocks[0] == 0 && !with_masks) {
    samples->stamps[0] = 0;
    samples->count = samples->sample_count = 0;  // many tiles have none
    return;
  }
  const uint64_t digits = digits_of(samples->blocks[0]);
  uint64_t lanes = digits - (digits >> 1 & 5 * kOnes);
  lanes = (lanes & 3 * kOnes) + (lanes >> 2 & 3 * kOnes);
  const uint64_t bit0 = lanes & kOnes, bit1 = lanes >> 1 & kOnes, bit2 = lanes >> 2 & kOnes;
  const uint64_t n1 = count_ones(bit0 & ~bit1), n2 = count_ones(bit1 & ~bit0);
  const uint64_t n3 = count_ones(bit0 & bit1), n4 = count_ones(bit2);
  if (by_samples != nullptr) {
    (*by_samples)[1] += n1;
    (*by_samples)[2] += n2;
    (*by_samples)[3] += n3;
    (*by_samples)[4] += n4;
  }
  samples->count = static_cast<int>(n1 + n2 + n3 + n4);
  samples->sample_count = static_cast<int>(n1 + 2 * n2 + 3 * n3 + 4 * n4);

  const uint64_t places = gather(bit0 | bit1 | bit2) >> (4 * box.row0);
  uint64_t stamps = places;
  if (box.columns != 4) {
    const uint64_t row = (1u << box.columns) - 1;
    stamps = 0;
    for (int i = 0; i < box.rows; ++i) {
      stamps |= (places >> (4 * i + box.column0) & row) << (i * box.columns);
    }
  }
  samples->stamps[0] = stamps;
  if (stamps != 0) {
    samples->first = __builtin_ctzll(stamps);
    samples->last = 63 - __builtin_clzll(stamps);
  }
  if (!with_masks) return;
  uint16_t* mask = samples->mask.data();
  for (int row = box.row0; row < box.row0 + box.rows; ++row) {
    const uint64_t of_row = digits >> (16 * row + 4 * box.column0);
    for (int i = 0; i < box.columns; ++i) *mask++ = static_cast<uint16_t>(of_row >> (4 * i) & 15);
  }
}

template <class Value>
TileEdges<Value> tile_edges(const spec::SetupPrim& prim, const std::array<int64_t, 3>& e,
                            uint32_t accepted) {
  TileEdges<Value> edges;
  for (size_t i = 0; i < 3; ++i) {
    const bool cuts = (accepted >> i & 1) == 0;
    edges.a[i] = static_cast<Value>(cuts ? prim.edge[i].a : 0);
    edges.b[i] = static_cast<Value>(cuts ? prim.edge[i].b : 0);
    edges.e[i] = static_cast<Value>(cuts ? e[i] : 0);
  }
  return edges;
}

}  // namespace

TileSamples::TileSamples(const Design& d)
    : blocks(static_cast<size_t>(blocks_across(d)) * static_cast<size_t>(blocks_across(d))),
      mask(size_t{1} << (2 * d.tile_log2 - d.stamp_width_log2 - d.stamp_height_log2)) {
  stamps.resize((mask.size() + 63) / 64);
}

void find_stamps(const Design& d, const TileCover& box, bool with_masks, TileSamples* samples,
                 StampsBySamples* by_samples) {
  if (d.tile_log2 == 3 && d.stamp_width_log2 == 1 && d.stamp_height_log2 == 1) {
    return find_quads(box, with_masks, samples, by_samples);
  }
  const int w_log2 = d.stamp_width_log2;
  const int h = 1 << d.stamp_height_log2;
  const uint64_t lanes = (1u << (1 << w_log2)) - 1;
  std::fill(samples->stamps.begin(), samples->stamps.end(), 0);
  samples->count = samples->sample_count = 0;
  int test = 0;
  for (int row = box.row0; row < box.row0 + box.rows; ++row) {
    const int y = row << d.stamp_height_log2;
    const uint64_t* const blocks = &samples->blocks[block_of(d, 0, y)];
    for (int column = box.column0; column < box.column0 + box.columns; ++column, ++test) {
      const int x = column << w_log2;
      uint64_t rows = blocks[x / kBlockPx] >> (y % kBlockPx * kBlockPx + x % kBlockPx);
      uint64_t bits = rows & lanes;
      for (int j = 1; j < h; ++j) {
        rows >>= kBlockPx;
        bits |= (rows & lanes) << (j << w_log2);
      }
      samples->mask[static_cast<size_t>(test)] = static_cast<uint16_t>(bits);
      if (bits == 0) continue;
      samples->stamps[static_cast<size_t>(test) / 64] |= uint64_t{1} << (test % 64);
      ++samples->count;
      const int n = count_lanes(static_cast<uint32_t>(bits));
      samples->sample_count += n;
      if (by_samples != nullptr) ++(*by_samples)[static_cast<size_t>(n)];
    }
  }
  finish(samples, box.tests());
}

void TileCoverWalk::begin(const spec::SetupPrim& prim) {
  prim_ = &prim;
  const int log2 = contract_.design.tile_log2;
  x_ = first_x_ = prim.x0 >> log2;
  y_ = prim.y0 >> log2;
  last_x_ = prim.x1 >> log2;
  last_y_ = prim.y1 >> log2;
  const int64_t span = (1 << log2) - 1;  // first to last sample of a tile
  for (size_t i = 0; i < 3; ++i) {
    const int64_t a = span * prim.edge[i].a;
    const int64_t b = span * prim.edge[i].b;
    best_[i] = std::max<int64_t>(a, 0) + std::max<int64_t>(b, 0);
    worst_[i] = std::min<int64_t>(a, 0) + std::min<int64_t>(b, 0);
    edge_[i] = row_edge_[i] = prim.edge[i].e;
  }
}

TileWalk::Test TileCoverWalk::next(TileCover* cover) {
  if (y_ > last_y_) return TileWalk::Test::kEnd;
  const int log2 = contract_.design.tile_log2;
  const bool rejected = ((edge_[0] + best_[0]) | (edge_[1] + best_[1]) | (edge_[2] + best_[2])) < 0;
  if (!rejected) {
    const int last = (1 << log2) - 1;
    cover->x = x_;
    cover->y = y_;
    cover->x0 = std::max(prim_->x0 - (x_ << log2), 0);
    cover->y0 = std::max(prim_->y0 - (y_ << log2), 0);
    cover->x1 = std::min(prim_->x1 - (x_ << log2), last);
    cover->y1 = std::min(prim_->y1 - (y_ << log2), last);
    cover->accepted = 0;
    for (size_t i = 0; i < 3; ++i) {
      cover->accepted |= static_cast<uint32_t>(edge_[i] + worst_[i] >= 0) << i;
    }
    const Design& d = contract_.design;
    cover->column0 = cover->x0 >> d.stamp_width_log2;
    cover->columns = (cover->x1 >> d.stamp_width_log2) - cover->column0 + 1;
    cover->row0 = cover->y0 >> d.stamp_height_log2;
    cover->rows = (cover->y1 >> d.stamp_height_log2) - cover->row0 + 1;
    kept_ = edge_;
  }
  if (x_ < last_x_) {
    ++x_;
    for (size_t i = 0; i < 3; ++i) edge_[i] += prim_->edge[i].a * (int64_t{1} << log2);
  } else if (++y_ <= last_y_) {
    x_ = first_x_;
    for (size_t i = 0; i < 3; ++i) {
      row_edge_[i] += prim_->edge[i].b * (int64_t{1} << log2);
      edge_[i] = row_edge_[i];
    }
  }
  return rejected ? TileWalk::Test::kRejected : TileWalk::Test::kKept;
}

void TileCoverWalk::cover_stamps(bool with_masks, TileCover* cover,
                                 StampsBySamples* by_samples) const {
  const Design& d = contract_.design;
  const int last = (1 << d.tile_log2) - 1;
  if (cover->accepted == 7 && cover->x1 - cover->x0 == last && cover->y1 - cover->y0 == last) {
    if (!cover->full) fill(d, &cover->covered);
    cover->full = true;
    if (by_samples != nullptr) {
      (*by_samples)[static_cast<size_t>(contract_.width.lanes)] +=
          static_cast<uint64_t>(cover->covered.count);
    }
    return;
  }
  cover->full = false;
  // |E'| <= (T-1)(|a|+|b|) in a tile that an edge cuts, and |a|, |b| < 2^coord; the lanes may be
  // wider than the tile.
  const int side_log2 = std::max(d.tile_log2, ceil_log2(kBlockPx));
  if (2 + side_log2 + contract_.width.coord <= 32) {
    cover_narrow(d, tile_edges<int32_t>(*prim_, kept_, cover->accepted), cover);
  } else {
    cover_wide(d, tile_edges<int64_t>(*prim_, kept_, cover->accepted), cover);
  }
  find_stamps(d, *cover, with_masks, &cover->covered, by_samples);
}

}  // namespace pineda::core
