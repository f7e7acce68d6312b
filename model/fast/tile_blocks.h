// What the loops over the blocks of a tile share; internal.
#pragma once

#include "model/fast/lanes.h"
#include "model/fast/tile_values.h"

namespace pineda::fast {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__);

/// The bits of two rows of a block, one bit for each lane.
inline constexpr Uint32x16 kPairBits = {1,       2,       4,       8,      1 << 4,  1 << 5,
                                        1 << 6,  1 << 7,  1 << 8,  1 << 9, 1 << 10, 1 << 11,
                                        1 << 12, 1 << 13, 1 << 14, 1 << 15};

/// Turns plane values at the top of lanes of Int into codes: one rounding and the clamp.
template <class Int>
struct Coder {
  int shift;
  Int half, top;

  explicit Coder(const Format& f)
      : shift(8 * static_cast<int>(sizeof(Int)) - f.plane_bits + f.fraction_bits),
        half(Int{1} << (shift - 1)),
        top(static_cast<Int>((uint64_t{1} << f.code_bits) - 1)) {}

  // A plane has more integer bits than a code, so adding half a code to its greatest value cannot
  // wrap an unsigned number.
  template <class Signed, class Unsigned>
  PINEDA_INLINE void operator()(Unsigned* v) const {
    const auto plane = reinterpret_cast<Signed>(*v);
    const Unsigned sum = (reinterpret_cast<Unsigned>(plane > 0 ? plane : Signed{}) + half) >> shift;
    *v = sum < top ? sum : Unsigned{} + top;
  }
};

/// Calls visit(x, y, sample, block) for the blocks in the box of `cover`: px from the tile's
/// corner, the block's first sample in the memories, its number in the tile.
template <class Visitor>
PINEDA_INLINE void for_each_block(const TileCover& cover, const TiledBuffer& buffer,
                                  Visitor&& visit) {
  const size_t tile = buffer.tile_index(cover.x, cover.y);
  for (int y = cover.y0 & -kBlockPx; y <= cover.y1; y += kBlockPx) {
    for (int x = cover.x0 & -kBlockPx; x <= cover.x1; x += kBlockPx) {
      const size_t block = buffer.block_in_tile(x, y);
      visit(x, y, tile + block * kBlockSamples, block);
    }
  }
}

}  // namespace pineda::fast
