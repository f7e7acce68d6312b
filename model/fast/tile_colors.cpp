#include <cstddef>

#include "model/fast/tile_blocks.h"

namespace pineda::fast {

using spec::Design;
using spec::Plane;

namespace {

// The rows of a block that have a sample.
struct RowsOf {
  int first, last;
  explicit RowsOf(uint64_t block)
      : first(__builtin_ctzll(block) / kBlockPx), last((63 - __builtin_clzll(block)) / kBlockPx) {}
};

// ---- Colours of four channels: a sample is 64 bits, a row of a block a cache line.

// Writes a row's words where its samples passed: eight words of all ones, or zeros.
PINEDA_INLINE void merge_row(const Uint64x8& words, const Uint64x8& passed, uint16_t* color) {
  Uint64x8 stored;
  std::memcpy(&stored, color, sizeof stored);
  const Uint64x8 merged = (words & passed) | (stored & ~passed);
  std::memcpy(color, &merged, sizeof merged);
}

constexpr std::ptrdiff_t kRowChannels = std::ptrdiff_t{4} * kBlockPx;

// Calls visit(passed, color) for the rows of a block from the first to the last with a sample.
template <class Visitor>
PINEDA_INLINE void for_each_row(uint64_t block, uint16_t* color, Visitor&& visit) {
  const RowsOf rows(block);
  color += static_cast<std::ptrdiff_t>(rows.first) * kRowChannels;
  uint64_t rest = block >> (kBlockPx * rows.first);
  for (int row = rows.first; row <= rows.last; ++row, color += kRowChannels) {
    const auto bit = __builtin_convertvector(kLaneBits, Uint64x8);
    visit(reinterpret_cast<Uint64x8>((bit & rest) == bit), color);
    rest >>= kBlockPx;
  }
}

PINEDA_KERNEL(void, write_constant,
              (const TileColors& colors, const TileCover& cover, const TileSamples& passed,
               TiledBuffer* buffer),
              (colors, cover, passed, buffer)) {
  uint64_t word = 0;
  for (size_t a = 0; a < 4; ++a) {
    word |= uint64_t{static_cast<uint16_t>(colors.flat[a])} << (16 * a);
  }
  const Uint64x8 words = Uint64x8{} + word;
  for_each_block(cover, *buffer, [&](int, int, size_t sample, size_t block) PINEDA_INLINED {
    if (passed.blocks[block] == 0) return;
    for_each_row(passed.blocks[block], buffer->color.data() + 4 * sample,
                 [&](const Uint64x8& lanes, uint16_t* color)
                     PINEDA_INLINED { merge_row(words, lanes, color); });
  });
}

constexpr Uint32x16 kSampleNumbers = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7};

// One member of each of four planes, in the order 0, 2, 1, 3: 0 for `dx`, 1 for `dy`, 2 for `ref`.
static_assert(sizeof(Plane) == 3 * sizeof(int64_t) && offsetof(Plane, dx) == 0 &&
              offsetof(Plane, dy) == sizeof(int64_t));
template <int Member>
PINEDA_INLINE void gather(const Plane* planes, Uint64x4* values) {
  Uint64x8 front, back;  // the first and the last eight of twelve numbers
  std::memcpy(&front, planes, sizeof front);
  std::memcpy(&back, reinterpret_cast<const char*>(planes) + 4 * sizeof(int64_t), sizeof back);
  constexpr int k = Member;
  *values = __builtin_shufflevector(front, back, k, 8 + 2 + k, 3 + k, 8 + 5 + k);
}

// Four planes inside a tile, of 32 bits at most. Lanes 2*i and 2*i + 1 of an even vector are
// attributes 0 and 2 of sample i, of an odd vector 1 and 3: combined they are a row of a block as
// it is stored.
struct FourPlanes {
  Uint32x16 even, odd;  // in the tile's first row
  Uint32x16 even_dx, odd_dx;
  Uint32x16 even_dy, odd_dy;

  PINEDA_INLINE explicit FourPlanes(const TileColors& colors) {
    Uint64x4 ref, dx, dy;
    gather<2>(colors.planes, &ref);
    gather<0>(colors.planes, &dx);
    gather<1>(colors.planes, &dy);
    const TileOffset& tile = colors.tile;
    const Format& format = colors.format;
    repeat(ref + dx * tile.right + dy * tile.down, format, &even, &odd);
    repeat(dx, format, &even_dx, &odd_dx);
    repeat(dy, format, &even_dy, &odd_dy);
    even += even_dx * kSampleNumbers;
    odd += odd_dx * kSampleNumbers;
  }

 private:
  PINEDA_INLINE static void repeat(const Uint64x4& values, const Format& format, Uint32x16* evens,
                                   Uint32x16* odds) {
    const uint64_t half = (uint64_t{1} << format.dropped_bits) >> 1;
    const auto kept = __builtin_convertvector((values + half) >> format.dropped_bits, Uint32x4);
    const auto pairs = reinterpret_cast<Uint64x2>(kept << (32 - format.plane_bits));
    *evens = reinterpret_cast<Uint32x16>(Uint64x8{} + pairs[0]);
    *odds = reinterpret_cast<Uint32x16>(Uint64x8{} + pairs[1]);
  }
};

PINEDA_KERNEL(void, write_four,
              (const Design& d, const TileColors& colors, const TileCover& cover,
               const TileSamples& passed, TiledBuffer* buffer),
              (d, colors, cover, passed, buffer)) {
  const FourPlanes planes(colors);
  const Coder<uint32_t> coder(colors.format);
  for_each_block(cover, *buffer, [&](int x, int y, size_t sample, size_t block) PINEDA_INLINED {
    if (passed.blocks[block] == 0) return;
    const RowsOf rows(passed.blocks[block]);
    const auto u = static_cast<uint32_t>(x), v = static_cast<uint32_t>(y + rows.first);
    Uint32x16 row_even = planes.even + planes.even_dy * v;
    Uint32x16 row_odd = planes.odd + planes.odd_dy * v;
    if (d.tile_log2 > 3) {
      row_even += planes.even_dx * u;
      row_odd += planes.odd_dx * u;
    }
    for_each_row(passed.blocks[block], buffer->color.data() + 4 * sample,
                 [&](const Uint64x8& lanes, uint16_t* color) PINEDA_INLINED {
                   Uint32x16 even = row_even, odd = row_odd;
                   coder.operator()<Int32x16>(&even);
                   coder.operator()<Int32x16>(&odd);
                   merge_row(reinterpret_cast<Uint64x8>(even | odd << 16), lanes, color);
                   row_even += planes.even_dy;
                   row_odd += planes.odd_dy;
                 });
  });
}

// ---- Any number of channels

uint32_t row_of(uint64_t block, int row) {
  return static_cast<uint32_t>(block >> (kBlockPx * row) & 0xff);
}

// Writes the colours of a row's samples that passed.
PINEDA_INLINE void write_row(const Design& d, const Coder<uint64_t>& coder, const TilePlane* planes,
                             const int32_t* flat, int x, int y, uint32_t passed, uint16_t* color) {
  const auto attributes = static_cast<size_t>(d.attributes);
  const auto n = static_cast<size_t>(spec::channels(d));
  const auto i = static_cast<uint64_t>(x), j = static_cast<uint64_t>(y);
  const Uint64x8 numbers = __builtin_convertvector(kLaneNumbers, Uint64x8) + i;
  for (size_t a = 0; a < n; ++a) {
    Uint64x8 v = {};
    if (a < attributes) {
      const TilePlane& p = planes[a];
      v = numbers * p.dx + (p.ref + j * p.dy);
      coder.operator()<Int64x8>(&v);
    } else {
      v += static_cast<uint16_t>(flat[a - attributes]);
    }
    std::array<uint64_t, kBlockPx> codes;
    std::memcpy(codes.data(), &v, sizeof v);
    for (uint32_t lanes = passed; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<size_t>(__builtin_ctz(lanes));
      color[lane * n + a] = static_cast<uint16_t>(codes[lane]);
    }
  }
}

PINEDA_KERNEL(void, write_any,
              (const Design& d, const TileColors& colors, const TileCover& cover,
               const TileSamples& passed, TiledBuffer* buffer),
              (d, colors, cover, passed, buffer)) {
  std::array<TilePlane, spec::kMaxAttributes> planes;
  for (size_t a = 0; a < static_cast<size_t>(d.attributes); ++a) {
    planes[a] = plane_in_tile(colors.planes[a], colors.format, colors.tile);
  }
  const Coder<uint64_t> coder(colors.format);
  const auto n = static_cast<size_t>(buffer->channels);
  for_each_block(cover, *buffer, [&](int x, int y, size_t sample, size_t block) PINEDA_INLINED {
    for (int row = 0; row < kBlockPx; ++row) {
      const uint32_t lanes = row_of(passed.blocks[block], row);
      if (lanes == 0) continue;
      const size_t first = sample + static_cast<size_t>(row) * kBlockPx;
      write_row(d, coder, planes.data(), colors.flat, x, y + row, lanes,
                buffer->color.data() + first * n);
    }
  });
}

PINEDA_KERNEL(void, count_blocks, (const TileCover& cover, TiledBuffer* buffer), (cover, buffer)) {
  for_each_block(cover, *buffer, [&](int, int, size_t sample, size_t block) PINEDA_INLINED {
    uint16_t* samples = buffer->hits.data() + sample;
    for (uint64_t rest = cover.covered.blocks[block]; rest != 0; rest >>= 16) {
      Uint16x16 hits;
      std::memcpy(&hits, samples, sizeof hits);
      const auto bits = __builtin_convertvector(kPairBits, Uint16x16);
      const auto covered = (bits & static_cast<uint16_t>(rest)) == bits;
      hits += reinterpret_cast<Uint16x16>(covered & (hits != UINT16_MAX)) & 1;
      std::memcpy(samples, &hits, sizeof hits);
      samples += std::ptrdiff_t{2} * kBlockPx;
    }
  });
}

}  // namespace

void write_tile(const Design& d, const TileColors& colors, const TileCover& cover,
                const TileSamples& passed, TiledBuffer* buffer) {
  if (d.attributes == 0 && d.flat_attributes == 4) {
    write_constant(colors, cover, passed, buffer);
  } else if (d.attributes == 4 && d.flat_attributes == 0 && colors.format.plane_bits <= 32) {
    write_four(d, colors, cover, passed, buffer);
  } else {
    write_any(d, colors, cover, passed, buffer);
  }
}

void count_tile(const TileCover& cover, TiledBuffer* buffer) { count_blocks(cover, buffer); }

}  // namespace pineda::fast
