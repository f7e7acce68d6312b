#include <algorithm>
#include <cstddef>

#include "model/fast/tile_blocks.h"

namespace pineda::fast {

namespace {

constexpr Uint32x16 kPairColumns = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
constexpr Uint32x16 kPairRows = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};

// Like Coder, with a bias added, which has fraction bits of its own.
struct BiasedCoder {
  int head, up, shift;
  int64_t add, top;

  BiasedCoder(const Format& f, int64_t bias)
      : head(64 - f.plane_bits), shift(std::max(f.fraction_bits, spec::kBiasFractionBits)) {
    up = shift - f.fraction_bits;
    add = (int64_t{1} << (shift - 1)) + bias * (int64_t{1} << (shift - spec::kBiasFractionBits));
    top = (int64_t{1} << f.code_bits) - 1;
  }

  template <class Signed, class Unsigned>
  PINEDA_INLINE void operator()(Unsigned* v) const {
    Signed sum = ((reinterpret_cast<Signed>(*v) >> head) << up) + add;
    sum = (sum > 0 ? sum : Signed{}) >> shift;
    *v = reinterpret_cast<Unsigned>(sum < top ? sum : Signed{} + top);
  }
};

// The top bits of 64, as many as Int has.
template <class Int>
PINEDA_INLINE Int top_of(uint64_t value) {
  return static_cast<Int>(value >> (64 - 8 * sizeof(Int)));
}

// A plane's values in a block, two rows at a time, modulo the range of Int.
template <class Int, class Lanes>
struct DepthRows {
  Lanes first;
  Int dx, dy;

  // For the block x px to the right of the tile's corner and y px below it.
  PINEDA_INLINE DepthRows(const TilePlane& plane, int x, int y)
      : dx(top_of<Int>(plane.dx)), dy(top_of<Int>(plane.dy)) {
    const Int corner = top_of<Int>(plane.ref) + static_cast<Int>(x) * dx + static_cast<Int>(y) * dy;
    if constexpr (sizeof(Int) == 4) {
      first = kPairColumns * dx + kPairRows * dy + corner;
    } else {
      first = __builtin_convertvector(kLaneNumbers, Lanes) * dx + corner;
    }
  }

  template <class CoderOf>
  PINEDA_INLINE void codes(const CoderOf& coder, int row, Uint32x16* codes) const {
    Lanes upper = first + static_cast<Int>(row) * dy;
    if constexpr (sizeof(Int) == 4) {
      coder.template operator()<Int32x16>(&upper);
      *codes = upper;
    } else {
      Lanes lower = upper + dy;
      coder.template operator()<Int64x8>(&upper);
      coder.template operator()<Int64x8>(&lower);
      *codes = __builtin_shufflevector(reinterpret_cast<Uint32x16>(upper),
                                       reinterpret_cast<Uint32x16>(lower), 0, 2, 4, 6, 8, 10, 12,
                                       14, 16, 18, 20, 22, 24, 26, 28, 30);
    }
  }
};

// Masks of all ones or zeros for the outcomes that pass.
struct Passes {
  uint32_t equal, less, greater;  // less, greater: do they differ from `equal`?
  explicit Passes(const core::PassesWhen& when)
      : equal(when.equal ? UINT32_MAX : 0),
        less(when.less != when.equal ? UINT32_MAX : 0),
        greater(when.greater != when.equal ? UINT32_MAX : 0) {}
};

// Collects the results of pairs of rows, lanes of all ones or zeros, into the 64 bits of a block.
class PairBits {
 public:
  PINEDA_INLINE void add(int pair, const Uint32x16& lanes) {
    if (pair < 2) {
      low_ |= lanes & (kPairBits << (16 * pair));
    } else {
      high_ |= lanes & (kPairBits << (16 * (pair - 2)));
    }
  }
  PINEDA_INLINE uint64_t bits() const {
    std::array<Uint32x8, 2> low, high;
    std::memcpy(low.data(), &low_, sizeof low_);
    std::memcpy(high.data(), &high_, sizeof high_);
    const Uint32x8 a = low[0] | low[1], b = high[0] | high[1];
    const auto words =
        reinterpret_cast<Uint64x4>(__builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13) |
                                   __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15));
    return words[0] | words[1] | words[2] | words[3];
  }

 private:
  Uint32x16 low_ = {};
  Uint32x16 high_ = {};
};

// Tests the covered samples of a block and writes those that pass; returns them.
template <class Rows, class CoderOf>
PINEDA_INLINE uint64_t test_block(const Rows& rows, const CoderOf& coder, const Passes& passes,
                                  bool writes, uint64_t covered, uint32_t* depth) {
  PairBits passed;
  for (int pair = 0; pair < kBlockPx / 2; ++pair, depth += std::ptrdiff_t{2} * kBlockPx) {
    const auto bits = static_cast<uint32_t>(covered >> (16 * pair)) & 0xffff;
    if (bits == 0) continue;
    Uint32x16 z, stored;
    rows.codes(coder, 2 * pair, &z);
    std::memcpy(&stored, depth, sizeof stored);
    const auto less = reinterpret_cast<Uint32x16>(z < stored);
    const auto greater = reinterpret_cast<Uint32x16>(z > stored);
    const auto lanes = reinterpret_cast<Uint32x16>((kPairBits & bits) == kPairBits);
    const Uint32x16 pass =
        lanes & ((less & passes.less) ^ (greater & passes.greater) ^ passes.equal);
    passed.add(pair, pass);
    const Uint32x16 changed = writes ? pass : Uint32x16{};
    const Uint32x16 merged = (z & changed) | (stored & ~changed);
    std::memcpy(depth, &merged, sizeof merged);
  }
  return passed.bits();
}

template <class Rows, class CoderOf>
PINEDA_INLINE Outcome test_blocks(const DepthTest& test, const CoderOf& coder,
                                  const TileCover& cover, TiledBuffer* buffer,
                                  TileSamples* samples) {
  const Passes passes(test.when);
  Outcome outcome;
  for_each_block(cover, *buffer, [&](int x, int y, size_t sample, size_t block) PINEDA_INLINED {
    const uint64_t covered = cover.covered.blocks[block];
    uint64_t passed = 0;
    if (covered != 0) {
      passed = test_block(Rows(test.plane, x, y), coder, passes, test.writes, covered,
                          buffer->depth.data() + sample);
    }
    samples->blocks[block] = passed;
    outcome.passed |= passed;
    outcome.failed |= passed ^ covered;
  });
  return outcome;
}

PINEDA_KERNEL(Outcome, test_narrow,
              (const DepthTest& test, const TileCover& cover, TiledBuffer* buffer,
               TileSamples* samples),
              (test, cover, buffer, samples)) {
  return test_blocks<DepthRows<uint32_t, Uint32x16>>(test, Coder<uint32_t>(test.format), cover,
                                                     buffer, samples);
}
PINEDA_KERNEL(Outcome, test_wide,
              (const DepthTest& test, const TileCover& cover, TiledBuffer* buffer,
               TileSamples* samples),
              (test, cover, buffer, samples)) {
  return test_blocks<DepthRows<uint64_t, Uint64x8>>(test, Coder<uint64_t>(test.format), cover,
                                                    buffer, samples);
}
PINEDA_KERNEL(Outcome, test_biased,
              (const DepthTest& test, const TileCover& cover, TiledBuffer* buffer,
               TileSamples* samples),
              (test, cover, buffer, samples)) {
  return test_blocks<DepthRows<uint64_t, Uint64x8>>(test, BiasedCoder(test.format, test.bias),
                                                    cover, buffer, samples);
}

}  // namespace

TilePlane plane_in_tile(const spec::Plane& plane, const Format& format, const TileOffset& tile) {
  // Modulo 2^64: a reference far away wraps just as steps to it would.
  const int head = 64 - format.plane_bits;
  const uint64_t half = (uint64_t{1} << format.dropped_bits) >> 1;
  const auto kept = [&](uint64_t value) { return (value + half) >> format.dropped_bits << head; };
  const auto dx = static_cast<uint64_t>(plane.dx), dy = static_cast<uint64_t>(plane.dy);
  const uint64_t ref = static_cast<uint64_t>(plane.ref) + dx * tile.right + dy * tile.down;
  return {kept(ref), kept(dx), kept(dy)};
}

Outcome test_tile(const DepthTest& test, const TileCover& cover, TiledBuffer* buffer,
                  TileSamples* samples) {
  if (test.bias != 0) return test_biased(test, cover, buffer, samples);
  if (test.format.plane_bits > 32) return test_wide(test, cover, buffer, samples);
  return test_narrow(test, cover, buffer, samples);
}

}  // namespace pineda::fast
