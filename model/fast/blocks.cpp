// Compiled once for each vector unit that Highway knows on this processor: see draw_blocks() at the end.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/fast/blocks.cpp"
// The order of these is Highway's.
#include "model/fast/blocks.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "model/fast/small_prims.h"
#include "model/fast/tile_steps.h"
#include "model/spec/bounds.h"

HWY_BEFORE_NAMESPACE();
namespace pineda::fast {
namespace HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR
// No vectors: has_blocks() says so.
void draw_all(const BlockState&, const PrimGroup&, const SmallPrims&, BlockBuffer*, BlockCounts*) {}
#else

namespace hn = hwy::HWY_NAMESPACE;

// Samples side by side: two lines of a block, which lie side by side too, one line or a row of it.
constexpr size_t kPair = size_t{2} * kLineSamples;
constexpr hn::CappedTag<int32_t, kPair> kLanes;
constexpr hn::CappedTag<uint32_t, kPair> kCodes;
constexpr hn::Repartition<uint16_t, decltype(kCodes)> kHalves;
using Lanes = hn::Vec<decltype(kLanes)>;
using Codes = hn::Vec<decltype(kCodes)>;
using Halves = hn::Vec<decltype(kHalves)>;
using Mask = hn::Mask<decltype(kCodes)>;
constexpr int kN = static_cast<int>(hn::MaxLanes(kLanes));
static_assert(kN == 4 || kN == 8 || kN == 16);
constexpr int kParts = static_cast<int>(kPair) / kN;  // vectors of two lines side by side
constexpr uint64_t kAllBits = (uint64_t{1} << kN) - 1;

// Where a vector's samples lie, px from its first one.
HWY_INLINE Codes columns() {
  const Codes i = hn::Iota(kCodes, 0);
  return hn::Add(hn::And(i, hn::Set(kCodes, 3)), hn::ShiftLeft<2>(hn::ShiftRight<3>(i)));
}
// All ones in a line's lower row.
HWY_INLINE Codes lower_row() {
  const Codes row = hn::And(hn::ShiftRight<2>(hn::Iota(kCodes, 0)), hn::Set(kCodes, 1));
  return hn::Sub(hn::Zero(kCodes), row);
}
// Where the parts of two lines begin.
constexpr int part_x(int part) { return part * kN / kLineSamples * kLineWidthPx; }
constexpr int part_y(int part) { return part * kN % kLineSamples / kLineWidthPx; }

HWY_INLINE uint64_t bits_of(Mask mask) {
  uint16_t bits = 0;
  hn::StoreMaskBits(kCodes, mask, reinterpret_cast<uint8_t*>(&bits));
  return bits & kAllBits;
}
HWY_INLINE Mask mask_of(uint64_t bits) {
  const auto word = static_cast<uint16_t>(bits);
  return hn::LoadMaskBits(kCodes, reinterpret_cast<const uint8_t*>(&word));
}

// Depths and colours of a vector of samples; `at` is its first one in its line.
HWY_INLINE Codes load_depths(const SampleLine* line, int at) {
  if constexpr (kN == 16) {
    const hn::Half<decltype(kCodes)> half;
    return hn::Combine(kCodes, hn::Load(half, line[1].depth.data()),
                       hn::Load(half, line[0].depth.data()));
  } else {
    return hn::Load(kCodes, line->depth.data() + at);
  }
}
HWY_INLINE void store_depths(Codes v, SampleLine* line, int at) {
  if constexpr (kN == 16) {
    const hn::Half<decltype(kCodes)> half;
    hn::Store(hn::LowerHalf(half, v), half, line[0].depth.data());
    hn::Store(hn::UpperHalf(half, v), half, line[1].depth.data());
  } else {
    hn::Store(v, kCodes, line->depth.data() + at);
  }
}
HWY_INLINE void store_colors(Codes v, uint64_t lanes, SampleLine* line, int at) {
  if constexpr (kN == 16) {
    const hn::Half<decltype(kCodes)> half;
    const auto low = static_cast<uint8_t>(lanes), high = static_cast<uint8_t>(lanes >> 8);
    hn::BlendedStore(hn::LowerHalf(half, v), hn::LoadMaskBits(half, &low), half,
                     line[0].color.data());
    hn::BlendedStore(hn::UpperHalf(half, v), hn::LoadMaskBits(half, &high), half,
                     line[1].color.data());
  } else {
    hn::BlendedStore(v, mask_of(lanes), kCodes, line->color.data() + at);
  }
}

// A function a*x + b*y of the samples of a vector, modulo its lanes.
template <class D, class V = hn::Vec<D>, class T = hn::TFromD<D> >
struct Slope {
  T a, b;
  V lanes;
  V down;  // what it changes by to the lines below

  HWY_INLINE Slope(T of_x, T of_y)
      : a(of_x),
        b(of_y),
        lanes(hn::Add(hn::Mul(hn::BitCast(D(), columns()), hn::Set(D(), a)),
                      hn::And(hn::BitCast(D(), lower_row()), hn::Set(D(), b)))),
        down(hn::Set(D(), static_cast<T>(b * kLineHeightPx))) {}
  // In a part, with the value at the first sample of part 0.
  HWY_INLINE V in_part(V first, int part) const {
    if (part == 0) return first;
    return hn::Add(first, hn::Set(D(), static_cast<T>(a * static_cast<T>(part_x(part)) +
                                                      b * static_cast<T>(part_y(part)))));
  }
};
using EdgeSlope = Slope<decltype(kLanes)>;
using CodeSlope = Slope<decltype(kCodes)>;

// The same for two channels of each sample, 16 bits each.
struct PairSlope {
  Halves a, b;
  Halves lanes, down;

  static HWY_INLINE Halves both(Codes v) {
    return hn::BitCast(kHalves, hn::Or(v, hn::ShiftLeft<16>(v)));
  }
  static HWY_INLINE Halves repeat(uint32_t pair) {
    return hn::BitCast(kHalves, hn::Set(kCodes, pair));
  }
  HWY_INLINE PairSlope(uint32_t of_x, uint32_t of_y)
      : a(repeat(of_x)),
        b(repeat(of_y)),
        lanes(hn::Add(hn::Mul(both(columns()), a), hn::And(hn::BitCast(kHalves, lower_row()), b))),
        down(hn::Add(b, b)) {}
  static HWY_INLINE Halves times(Halves v, int n) {
    return hn::Mul(v, hn::Set(kHalves, static_cast<uint16_t>(n)));
  }
  HWY_INLINE Halves in_part(Halves first, int part) const {
    if (part == 0) return first;
    return hn::Add(first, hn::Add(times(a, part_x(part)), times(b, part_y(part))));
  }
};

// ---- A triangle's planes

// Sign-extends the low bits, without the lowest ones.
HWY_INLINE int64_t kept(uint64_t value, int plane_bits, int dropped_bits) {
  const uint64_t half = (uint64_t{1} << dropped_bits) >> 1;
  const int above = 64 - plane_bits;
  return static_cast<int64_t>((value + half) << above) >> (above + dropped_bits);
}

// Channels 0 and 2, 1 and 3 of four numbers of 16 bits.
struct Pairs {
  uint32_t low, high;
};
// The same of some triangles, side by side: the first two of each four lanes.
template <class D, class V>
HWY_INLINE V pairs_of(D d, V v) {
  const V back = hn::ShiftRightLanes<2>(d, v);
  return hn::Or(hn::And(v, hn::Set(d, 0xffff)), hn::ShiftLeft<16>(back));
}

// Colours as in a tile: without the fraction bits that it drops; the code is the upper byte of 16 bits.
template <class State, class D, class V>
HWY_INLINE V in_tile(const State& s, D d, V v) {
  const V half = hn::Set(d, (1U << s.dropped_bits) >> 1);
  return hn::ShiftLeftSame(hn::ShiftRightSame(hn::Add(v, half), s.dropped_bits),
                           8 - s.fraction_bits);
}

// What planes change by in the tiles of a group's triangles.
struct TileSlopes {
  alignas(64) Each<int64_t> z_dx, z_dy;
  alignas(64) Each<int64_t> z_fall;  // from a block's first sample to its least one, at most 0
  // Depths of a tile do not wrap, wherever in it one is in range.
  alignas(64) Each<int64_t> z_is_flat;
  alignas(64) Each<std::array<uint32_t, 4> > color_dx, color_dy;  // Pairs

  template <class State>
  HWY_INLINE void set(const State& s, const PrimGroup& g) {
    const hn::Repartition<int64_t, decltype(kLanes)> d;
    using Words = hn::Vec<decltype(d)>;
    const Words half = hn::Set(d, (int64_t{1} << s.dropped_bits) >> 1);
    const int above = 64 - s.depth_plane_bits;
    const auto kept_of = [&](const int64_t* from) HWY_ATTR {
      const Words raised = hn::ShiftLeftSame(hn::Add(hn::Load(d, from), half), above);
      return hn::ShiftRightSame(raised, above + s.dropped_bits);
    };
    // A value in range and one less than a quarter of the plane's range away: neither has wrapped,
    // since of the four quarters a code has the first one above 0, and one is below it.
    const Words quarter = hn::Set(d, int64_t{1} << (s.depth_plane_bits - s.dropped_bits - 2));
    const Words zero = hn::Zero(d);
    for (size_t i = 0; i < kGroup; i += hn::Lanes(d)) {
      const Words dx = kept_of(g.z_dx.data() + i), dy = kept_of(g.z_dy.data() + i);
      const Words fall = hn::Add(hn::Min(dx, zero), hn::Min(dy, zero));
      const Words reach = hn::ShiftLeftSame(hn::Add(hn::Abs(dx), hn::Abs(dy)), s.tile_log2);
      hn::Store(dx, d, z_dx.data() + i);
      hn::Store(dy, d, z_dy.data() + i);
      hn::Store(hn::Sub(hn::ShiftLeft<3>(fall), fall), d, z_fall.data() + i);
      hn::Store(hn::VecFromMask(d, hn::Lt(reach, quarter)), d, z_is_flat.data() + i);
    }
    constexpr size_t kTriangles = hn::MaxLanes(kCodes) / 4;
    for (size_t i = 0; i < kGroup; i += kTriangles) {
      const auto pairs_at = [&](const std::array<uint32_t, 4>& from) HWY_ATTR {
        return pairs_of(kCodes, in_tile(s, kCodes, hn::Load(kCodes, from.data())));
      };
      hn::Store(pairs_at(g.color_dx[i]), kCodes, color_dx[i].data());
      hn::Store(pairs_at(g.color_dy[i]), kCodes, color_dy[i].data());
    }
  }
};
static_assert(kBlockPx == 8);

// ---- Blocks

// What a triangle is drawn with, all of its blocks.
struct Triangle {
  const PrimGroup& group;
  const TileSlopes& tile;
  size_t i;  // of the group
  std::array<EdgeSlope, 3> edge;
  CodeSlope z;
  PairSlope low, high;

  template <class State>
  HWY_INLINE Triangle(const State& s, const PrimGroup& g, const TileSlopes& slopes, size_t number)
      : group(g),
        tile(slopes),
        i(number),
        edge{EdgeSlope(g.a[0][i], g.b[0][i]), EdgeSlope(g.a[1][i], g.b[1][i]),
             EdgeSlope(g.a[2][i], g.b[2][i])},
        z(top_of(s, tile.z_dx[i]), top_of(s, tile.z_dy[i])),
        low(tile.color_dx[i][0], tile.color_dy[i][0]),
        high(tile.color_dx[i][1], tile.color_dy[i][1]) {}

  // A depth with its code at the top of a lane.
  template <class State>
  static HWY_INLINE uint32_t top_of(const State& s, int64_t value) {
    return static_cast<uint32_t>(value) << (32 - s.depth_bits - s.fraction_bits);
  }
  // Depth and colours at the first sample of the tile across, down px from the first one.
  template <class State>
  HWY_INLINE int64_t depth_at(const State& s, int across, int down) const {
    const auto x = static_cast<uint64_t>(across), y = static_cast<uint64_t>(down);
    return kept(static_cast<uint64_t>(group.z_ref[i]) + static_cast<uint64_t>(group.z_dx[i]) * x +
                    static_cast<uint64_t>(group.z_dy[i]) * y,
                s.depth_plane_bits, s.dropped_bits);
  }
  template <class State>
  HWY_INLINE Pairs colors_at(const State& s, int across, int down) const {
    const hn::FixedTag<uint32_t, 4> d;
    auto v = hn::Load(d, group.color_ref[i].data());
    if ((across | down) != 0) {
      const auto x = hn::Set(d, static_cast<uint32_t>(across));
      const auto y = hn::Set(d, static_cast<uint32_t>(down));
      v = hn::Add(v, hn::Add(hn::Mul(hn::Load(d, group.color_dx[i].data()), x),
                             hn::Mul(hn::Load(d, group.color_dy[i].data()), y)));
    }
    // Half a code is added, since the code is rounded.
    const auto pairs = pairs_of(d, hn::Add(in_tile(s, d, v), hn::Set(d, 0x80)));
    return {hn::GetLane(pairs), hn::ExtractLane(pairs, 1)};
  }
};

// A block of a tile: E' and values at the block's first sample.
struct Block {
  std::array<int32_t, 3> e;
  int64_t z;
  Halves low, high;  // colours
  uint64_t box;      // the samples in the triangle's box
  bool is_inside;    // all of them are covered
};

// Samples of a block are bits of a word, in the order of its lines.
struct Borders {
  std::array<uint64_t, kBlockPx> from_x{}, to_x{}, from_y{}, to_y{};

  constexpr Borders() {
    for (int y = 0; y < kBlockPx; ++y) {
      for (int x = 0; x < kBlockPx; ++x) {
        const int line = y / kLineHeightPx * (kBlockPx / kLineWidthPx) + x / kLineWidthPx;
        const int bit = line * kLineSamples + y % kLineHeightPx * kLineWidthPx + x % kLineWidthPx;
        for (int i = 0; i < kBlockPx; ++i) {
          const auto at = static_cast<size_t>(i);
          const uint64_t one = uint64_t{1} << bit;
          from_x[at] |= x >= i ? one : 0;
          to_x[at] |= x <= i ? one : 0;
          from_y[at] |= y >= i ? one : 0;
          to_y[at] |= y <= i ? one : 0;
        }
      }
    }
  }
};
constexpr Borders kBorders;

HWY_INLINE uint64_t box_of(int x0, int y0, int x1, int y1) {
  return kBorders.from_x[static_cast<size_t>(x0)] & kBorders.from_y[static_cast<size_t>(y0)] &
         kBorders.to_x[static_cast<size_t>(x1)] & kBorders.to_y[static_cast<size_t>(y1)];
}

struct Outcome {
  uint64_t covered = 0, passed = 0;
};

HWY_INLINE bool is_less(const core::PassesWhen& when) {
  return when.less && !when.equal && !when.greater;
}
HWY_INLINE Mask passes(const core::PassesWhen& when, Codes code, Codes stored) {
  if (is_less(when)) return hn::Lt(code, stored);
  const auto all = [](bool value) HWY_ATTR { return mask_of(value ? kAllBits : 0); };
  return hn::Or(hn::And(hn::Lt(code, stored), all(when.less)),
                hn::Or(hn::And(hn::Eq(code, stored), all(when.equal)),
                       hn::And(hn::Gt(code, stored), all(when.greater))));
}

HWY_INLINE void count_hits(uint64_t bits, uint16_t* hits) {
  const hn::Rebind<uint16_t, decltype(kCodes)> d;
  const auto word = static_cast<uint16_t>(bits);
  const auto mask = hn::LoadMaskBits(d, reinterpret_cast<const uint8_t*>(&word));
  hn::StoreU(hn::SaturatedAdd(hn::LoadU(d, hits), hn::IfThenElseZero(mask, hn::Set(d, 1))), d,
             hits);
}

// A block's values at two lines side by side, then at those below.
struct Cursor {
  Lanes e0, e1, e2;
  Codes z;  // the code is at the top of a lane, half a code is added
  Halves low, high;

  // `above`: rows of the block that are left out.
  template <class State>
  HWY_INLINE Cursor(const State& s, const Triangle& t, const Block& block, int above)
      : e0(edge_from(t, block, 0, above)),
        e1(edge_from(t, block, 1, above)),
        e2(edge_from(t, block, 2, above)),
        low(hn::Add(block.low, t.low.lanes)),
        high(hn::Add(block.high, t.high.lanes)) {
    const int64_t half = (int64_t{1} << s.fraction_bits) >> 1;
    const uint32_t first = Triangle::top_of(s, block.z + half);
    z = hn::Add(t.z.lanes, hn::Set(kCodes, first + t.z.b * static_cast<uint32_t>(above)));
    if (above == 0) return;
    low = hn::Add(low, PairSlope::times(t.low.b, above));
    high = hn::Add(high, PairSlope::times(t.high.b, above));
  }
  static HWY_INLINE Lanes edge_from(const Triangle& t, const Block& block, size_t i, int above) {
    return hn::Add(t.edge[i].lanes, hn::Set(kLanes, block.e[i] + t.edge[i].b * above));
  }
  HWY_INLINE void step_down(const Triangle& t) {
    e0 = hn::Add(e0, t.edge[0].down);
    e1 = hn::Add(e1, t.edge[1].down);
    e2 = hn::Add(e2, t.edge[2].down);
    z = hn::Add(z, t.z.down);
    low = hn::Add(low, t.low.down);
    high = hn::Add(high, t.high.down);
  }
  HWY_INLINE uint64_t outside(const Triangle& t, int part) const {
    const Lanes any = hn::Or(t.edge[0].in_part(e0, part),
                             hn::Or(t.edge[1].in_part(e1, part), t.edge[2].in_part(e2, part)));
    return bits_of(hn::RebindMask(kCodes, hn::Lt(any, hn::Zero(kLanes))));
  }
  // Four channels, one a byte.
  HWY_INLINE Codes colors(const Triangle& t, int part) const {
    const Halves upper = hn::Set(kHalves, static_cast<uint16_t>(0xff00));
    return hn::BitCast(kCodes, hn::Or(hn::ShiftRight<8>(t.low.in_part(low, part)),
                                      hn::And(t.high.in_part(high, part), upper)));
  }
};

// Draws the covered samples of a block; Hidden: none of them passes.
template <bool Hidden, class State>
HWY_NOINLINE Outcome draw_block(const State& s, const Triangle& t, const Block& block,
                                size_t number, BlockBuffer* buffer) {
  Outcome outcome;
  constexpr int kPairBits = static_cast<int>(kPair);
  const int first = __builtin_ctzll(block.box) / kPairBits;
  const int last = (63 - __builtin_clzll(block.box)) / kPairBits;
  Cursor cursor(s, t, block, first * kLineHeightPx);
  SampleLine* const lines = buffer->lines.data() + number * kBlockLines;
  Codes greatest = hn::Zero(kCodes);
  for (int pair = first; pair <= last; ++pair, cursor.step_down(t)) {
    for (int part = 0; part < kParts; ++part) {
      const int at = pair * kPairBits + part * kN;
      uint64_t covered = block.box >> at & kAllBits;
      if (!block.is_inside) covered &= ~cursor.outside(t, part);
      outcome.covered |= covered << at;
      if (s.counts_hits) {
        count_hits(covered, buffer->hits.data() + number * kBlockSamples + at);
      }
      if (Hidden || covered == 0) continue;
      SampleLine* const line = lines + at / kLineSamples;
      uint64_t passed = covered;
      if (s.tests_depth) {
        const Codes code = hn::ShiftRightSame(t.z.in_part(cursor.z, part), 32 - s.depth_bits);
        const Codes stored = load_depths(line, at % kLineSamples);
        const Mask pass = hn::And(mask_of(covered), passes(s.when, code, stored));
        passed = bits_of(pass);
        const Codes merged = hn::IfThenElse(pass, code, stored);
        if (s.writes_depth) store_depths(merged, line, at % kLineSamples);
        greatest = hn::Max(greatest, merged);
      }
      outcome.passed |= passed << at;
      if (s.channels > 0) store_colors(cursor.colors(t, part), passed, line, at % kLineSamples);
    }
  }
  // Only a block that is seen whole tells its greatest depth.
  if (!Hidden && s.hides && s.writes_depth && outcome.covered == ~uint64_t{0}) {
    buffer->greatest[number] = hn::GetLane(hn::MaxOfLanes(kCodes, greatest));
  }
  return outcome;
}

// Is what a triangle has in a block behind all that is stored there?
template <class State>
HWY_INLINE bool is_hidden(const State& s, const Triangle& t, int64_t at_block, uint32_t greatest) {
  if (!s.hides) return false;
  const int64_t half = (int64_t{1} << s.fraction_bits) >> 1;
  const int64_t least = (at_block + t.tile.z_fall[t.i] + half) >> s.fraction_bits;
  return t.tile.z_is_flat[t.i] != 0 && (s.when.equal ? least > greatest : least >= greatest);
}

HWY_INLINE uint64_t ones(uint64_t bits) {
  return static_cast<uint64_t>(__builtin_popcountll(bits));
}

// How many stamps of a block have one of these samples.
template <class State>
HWY_INLINE uint64_t stamps_of(const State& s, uint64_t block) {
  constexpr uint64_t kColumns[] = {~uint64_t{0}, 0x5555555555555555, 0x1111111111111111};
  constexpr uint64_t kStampRows[] = {~uint64_t{0}, 0x0f0f0f0f0f0f0f0f, 0x00000f0f00000f0f};
  if (s.stamp_width_log2 >= 1) block |= block >> 1;
  if (s.stamp_width_log2 >= 2) block |= block >> 2;
  if (s.stamp_height_log2 >= 1) block |= block >> kLineWidthPx;
  if (s.stamp_height_log2 >= 2) block |= block >> (2 * kLineSamples);
  return ones(block & kColumns[s.stamp_width_log2] & kStampRows[s.stamp_height_log2]);
}

template <class StampsOf>
HWY_INLINE void count(const Outcome& outcome, StampsOf stamps_of, BlockCounts* counts) {
  counts->fragments += ones(outcome.covered);
  const uint64_t stamps = stamps_of(outcome.covered);
  counts->stamps += stamps;
  if (outcome.passed == outcome.covered) {
    counts->passed += ones(outcome.covered);
    counts->interpolated += stamps;
  } else if (outcome.passed != 0) {
    counts->passed += ones(outcome.passed);
    counts->interpolated += stamps_of(outcome.passed);
  }
}

// A tile of a triangle that no edge rejects.
struct Tile {
  const TileSteps& steps;
  bool accepted;
  int64_t z;         // at its first sample
  int left, top;     // px
  int across, down;  // px from the first tile
};

// The block i, j px from the tile's corner, of whose samples `box` are in the triangle's box.
template <class State>
HWY_INLINE void draw_block_of(const State& s, const Triangle& t, const Tile& tile, int i, int j,
                              uint64_t box, BlockBuffer* buffer, BlockCounts* counts) {
  Block block;
  block.z = tile.z;
  block.box = box;
  block.is_inside = tile.accepted;
  if (s.tile_log2 > 3) block.z += t.tile.z_dx[t.i] * i + t.tile.z_dy[t.i] * j;
  const size_t number = buffer->block(tile.left + i, tile.top + j);
  const bool hidden = is_hidden(s, t, block.z, buffer->greatest[number]);
  if (hidden && block.is_inside && !s.counts_hits) {
    counts->fragments += ones(box);
    counts->stamps += stamps_of(s, box);
    return;
  }
  const EdgeValues e = tile.steps.lowered();
  for (size_t k = 0; k < 3; ++k) {
    block.e[k] = static_cast<int32_t>(e[k]) + t.edge[k].a * i + t.edge[k].b * j;
  }
  const auto stamps = [&s](uint64_t samples) HWY_ATTR { return stamps_of(s, samples); };
  if (hidden) return count(draw_block<true>(s, t, block, number, buffer), stamps, counts);
  const Pairs color = t.colors_at(s, tile.across, tile.down);
  block.low = PairSlope::repeat(color.low);
  block.high = PairSlope::repeat(color.high);
  if (s.tile_log2 > 3) {
    const auto moved = [&](Halves v, const PairSlope& slope) HWY_ATTR {
      return hn::Add(v, hn::Add(PairSlope::times(slope.a, i), PairSlope::times(slope.b, j)));
    };
    block.low = moved(block.low, t.low);
    block.high = moved(block.high, t.high);
  }
  count(draw_block<false>(s, t, block, number, buffer), stamps, counts);
}

template <class State>
HWY_INLINE void draw_tile(const State& s, const EdgePrim& prim, const Triangle& t,
                          const TileSteps& steps, BlockBuffer* buffer, BlockCounts* counts) {
  const int side = 1 << s.tile_log2;
  Tile tile{steps,
            steps.accepted(),
            0,
            steps.x() << s.tile_log2,
            steps.y() << s.tile_log2,
            (steps.x() - (prim.x0 >> s.tile_log2)) << s.tile_log2,
            (steps.y() - (prim.y0 >> s.tile_log2)) << s.tile_log2};
  counts->tiles_accepted += tile.accepted ? 1 : 0;
  if (s.tests_depth) tile.z = t.depth_at(s, tile.across, tile.down);
  // The box, from the tile's corner.
  const int x0 = std::max(prim.x0 - tile.left, 0), x1 = std::min(prim.x1 - tile.left, side - 1);
  const int y0 = std::max(prim.y0 - tile.top, 0), y1 = std::min(prim.y1 - tile.top, side - 1);
  if (s.tile_log2 == 3) {
    return draw_block_of(s, t, tile, 0, 0, box_of(x0, y0, x1, y1), buffer, counts);
  }
  for (int j = y0 & -kBlockPx; j <= y1; j += kBlockPx) {
    for (int i = x0 & -kBlockPx; i <= x1; i += kBlockPx) {
      const uint64_t box = box_of(std::max(x0 - i, 0), std::max(y0 - j, 0),
                                  std::min(x1 - i, kBlockPx - 1), std::min(y1 - j, kBlockPx - 1));
      draw_block_of(s, t, tile, i, j, box, buffer, counts);
    }
  }
}

// ---- Rows of tiles of one block each

// What the tests of tiles side by side say, a bit each.
struct RowTest {
  uint32_t rejected = 0, accepted = 0, hidden = 0;
  uint32_t ends = 0, follows = 0;  // where they reject: see TileSteps
};

// The tiles of a triangle as TileSteps walks through them, tested side by side. A tile that is drawn waits
// for a few others, so that its memory's lines arrive meanwhile.
template <class State>
class BlockRows {
 public:
  HWY_INLINE BlockRows(const State& state, const EdgePrim& prim, const Triangle& triangle,
                       BlockBuffer* memories, BlockCounts* all)
      : s(state), p(prim), t(triangle), buffer(memories), counts(all) {
    first_x = p.x0 / kBlockPx;
    last_x = p.x1 / kBlockPx;
    constexpr int64_t kToLast = kBlockPx - 1;
    for (size_t k = 0; k < 3; ++k) {
      const spec::EdgeFunction& edge = p.edge[k];
      best[k] = (std::max<int64_t>(edge.a, 0) + std::max<int64_t>(edge.b, 0)) * kToLast;
      worst[k] = (edge.a + edge.b) * kToLast - best[k];
      across[k] = edge.a * kBlockPx;
      at[k] = edge.e;
      fill(across[k], &steps[k]);
      falls_rightward |= edge.a < 0 ? 1U << k : 0;
      falls_downward |= edge.b <= 0 ? 1U << k : 0;
    }
    if (!s.tests_depth) return;
    z_at = static_cast<uint64_t>(t.group.z_ref[t.i]);
    z_across = static_cast<uint64_t>(t.group.z_dx[t.i]) * kBlockPx;
    z_down = static_cast<uint64_t>(t.group.z_dy[t.i]) * kBlockPx;
    fill(static_cast<int64_t>(z_across), &z_steps);
  }

  HWY_INLINE void draw() {
    const bool turns =
        (falls_rightward | falls_downward) != 7 && (falls_rightward & falls_downward) != 0;
    const int first_y = p.y0 / kBlockPx;
    const int last_y = std::min(p.y1 / kBlockPx, s.rows.last);
    if (last_y < s.rows.first) return;
    int start = first_x;
    for (y = first_y; y <= last_y; ++y) {
      const bool leftward = turns && y > first_y;
      start = walk(start, leftward, turns && !leftward);
      for (size_t k = 0; k < 3; ++k) at[k] += p.edge[k].b * kBlockPx;
      z_at += z_down;
    }
    while (next_drawn != next) draw_oldest();
  }

 private:
  static constexpr int kSide = 16;  // tiles tested side by side
  static constexpr hn::CappedTag<int64_t, 8> kWords{};
  static constexpr int kWordLanes = static_cast<int>(hn::MaxLanes(kWords));
  using Words = hn::Vec<decltype(kWords)>;
  using Each = std::array<int64_t, kSide>;
  static constexpr size_t kWaiting = 16, kAhead = 12;

  struct Waiting {
    std::array<int32_t, 3> e;
    int64_t z;
    uint64_t box;
    size_t number;
    int x;
    int y;
    bool is_inside, is_hidden;
  };

  static HWY_INLINE void fill(int64_t step, Each* steps) {
    int64_t value = 0;
    for (int64_t& each : *steps) {
      each = value;
      value = static_cast<int64_t>(static_cast<uint64_t>(value) + static_cast<uint64_t>(step));
    }
  }
  static HWY_INLINE uint32_t bits(hn::Mask<decltype(kWords)> mask) {
    uint8_t byte = 0;
    hn::StoreMaskBits(kWords, mask, &byte);
    return byte & ((1U << kWordLanes) - 1);
  }
  static HWY_INLINE uint32_t ones_below(int n) { return static_cast<uint32_t>((1U << n) - 1); }

  // The tiles of this row from x on.
  HWY_INLINE RowTest test(int x, uint32_t ends, uint32_t follows) {
    RowTest test;
    const int64_t columns = x - first_x;
    for (int i = 0; i < kSide; i += kWordLanes) {
      const Words zero = hn::Zero(kWords);
      Words worst_of_all = zero;
      uint32_t rejected = 0;
      for (size_t k = 0; k < 3; ++k) {
        const Words e = hn::Add(hn::Set(kWords, at[k] + across[k] * columns),
                                hn::Load(kWords, steps[k].data() + i));
        const uint32_t rejects = bits(hn::Lt(hn::Add(e, hn::Set(kWords, best[k])), zero));
        rejected |= rejects;
        if ((ends >> k & 1) != 0) test.ends |= rejects << i;
        if ((follows >> k & 1) != 0) test.follows |= rejects << i;
        worst_of_all = hn::Or(worst_of_all, hn::Add(e, hn::Set(kWords, worst[k])));
        // As TileSteps::lowered().
        hn::Store(hn::Min(e, hn::Set(kWords, -worst[k])), kWords, lowered[k].data() + i);
      }
      test.rejected |= rejected << i;
      test.accepted |= bits(hn::Not(hn::Lt(worst_of_all, zero))) << i;
      if (s.tests_depth) {
        const Words z = hn::Add(
            hn::Set(kWords, static_cast<int64_t>(z_at + z_across * static_cast<uint64_t>(columns))),
            hn::Load(kWords, z_steps.data() + i));
        const Words half = hn::Set(kWords, (int64_t{1} << s.dropped_bits) >> 1);
        const int above = 64 - s.depth_plane_bits;
        const Words kept =
            hn::ShiftRightSame(hn::ShiftLeftSame(hn::Add(z, half), above), above + s.dropped_bits);
        hn::Store(kept, kWords, depths.data() + i);
        // Rows above those that are wanted have no memory.
        if (s.hides && y >= s.rows.first) {
          const int64_t rounded = t.tile.z_fall[t.i] + ((int64_t{1} << s.fraction_bits) >> 1);
          const Words least =
              hn::ShiftRightSame(hn::Add(kept, hn::Set(kWords, rounded)), s.fraction_bits);
          const hn::Rebind<uint32_t, decltype(kWords)> d;
          const size_t number = buffer->block(x * kBlockPx, y * kBlockPx) + static_cast<size_t>(i);
          const Words greatest =
              hn::BitCast(kWords, hn::PromoteTo(hn::RebindToUnsigned<decltype(kWords)>(),
                                                hn::LoadU(d, buffer->greatest.data() + number)));
          test.hidden |=
              bits(s.when.equal ? hn::Lt(greatest, least) : hn::Not(hn::Lt(least, greatest))) << i;
        }
      }
    }
    if (t.tile.z_is_flat[t.i] == 0) test.hidden = 0;
    return test;
  }

  // One row; where the next one starts.
  HWY_INLINE int walk(int start, bool leftward, bool to_the_end) {
    const uint32_t ahead = leftward ? ~falls_rightward : falls_rightward;
    const uint32_t ends = to_the_end ? 0 : ahead;
    const uint32_t follows = to_the_end ? 0 : ~ahead & falls_downward;
    const int end = leftward ? first_x : last_x;
    int next_start = start;
    bool past = false, follows_on = true;
    for (int x = start; leftward ? x >= end : x <= end;) {
      const int n = std::min((leftward ? x - end : end - x) + 1, kSide);
      const int left = leftward ? x - n + 1 : x;
      const RowTest row = test(left, ends, follows);
      // Tiles by their number in the walk.
      const auto ordered = [n, leftward](uint32_t tiles) HWY_ATTR {
        return leftward ? reversed(tiles) >> (kSide - n) : tiles;
      };
      const uint32_t ending = ordered(row.ends) & ones_below(n);
      const int last = ending != 0 ? __builtin_ctz(ending) : n;  // after it there is one more
      const int tested = past ? 1 : std::min(last + 2, n);
      if (follows_on && !past) {
        // The start moves on from each tile but the end.
        const int until = std::min({n, last + 1, leftward ? x - end : end - x});
        const int moves = std::min(__builtin_ctz(~ordered(row.follows)), until);
        next_start += leftward ? -moves : moves;
        follows_on = moves == n;
      }
      if (y >= s.rows.first) {
        take(row, left, leftward ? ones_below(tested) << (n - tested) : ones_below(tested));
      }
      if (past || last + 1 < n || (y < s.rows.first && !follows_on)) break;
      past = last + 1 == n;
      x += leftward ? -n : n;
    }
    return to_the_end ? end : next_start;
  }
  static HWY_INLINE uint32_t reversed(uint32_t tiles) {
    tiles = (tiles >> 1 & 0x5555) | (tiles & 0x5555) << 1;
    tiles = (tiles >> 2 & 0x3333) | (tiles & 0x3333) << 2;
    tiles = (tiles >> 4 & 0x0f0f) | (tiles & 0x0f0f) << 4;
    return (tiles >> 8 & 0xff) | (tiles & 0xff) << 8;
  }

  HWY_INLINE void take(const RowTest& row, int left, uint32_t tested) {
    counts->tiles_tested += ones(tested);
    counts->tiles_rejected += ones(tested & row.rejected);
    uint32_t kept = tested & ~row.rejected;
    counts->tiles_accepted += ones(kept & row.accepted);
    // The box, from the row's corner.
    const int y0 = std::max(p.y0 - y * kBlockPx, 0);
    const int y1 = std::min(p.y1 - y * kBlockPx, kBlockPx - 1);
    const uint32_t left_out = row.hidden & row.accepted;
    for (; kept != 0; kept &= kept - 1) {
      const int i = __builtin_ctz(kept);
      const int x = (left + i) * kBlockPx;
      const bool is_inside = (row.accepted >> i & 1) != 0;
      const uint64_t box = box_of(std::max(p.x0 - x, 0), y0, std::min(p.x1 - x, kBlockPx - 1), y1);
      if ((left_out >> i & 1) != 0 && !s.counts_hits) {
        counts->fragments += ones(box);
        counts->stamps += stamps_of(s, box);
        continue;
      }
      const size_t at_tile = static_cast<size_t>(i);
      const size_t number = buffer->block(x, y * kBlockPx);
      const bool is_hidden = (row.hidden >> i & 1) != 0;
      if (!is_hidden) prefetch(number, y0, y1);
      waiting[next++ % kWaiting] = {
          {static_cast<int32_t>(lowered[0][at_tile]), static_cast<int32_t>(lowered[1][at_tile]),
           static_cast<int32_t>(lowered[2][at_tile])},
          depths[at_tile],
          box,
          number,
          x,
          y * kBlockPx,
          is_inside,
          is_hidden};
      if (next - next_drawn > kAhead) draw_oldest();
    }
  }
  HWY_INLINE void prefetch(size_t number, int y0, int y1) const {
    const SampleLine* const lines = buffer->lines.data() + number * kBlockLines;
    for (int line = y0 / kLineHeightPx * 2; line <= y1 / kLineHeightPx * 2 + 1; ++line) {
      __builtin_prefetch(lines + line, 1);
    }
  }

  HWY_NOINLINE void draw_oldest() {
    const Waiting& w = waiting[next_drawn++ % kWaiting];
    Block block;
    block.e = w.e;
    block.z = w.z;
    block.box = w.box;
    block.is_inside = w.is_inside;
    const auto stamps = [this](uint64_t samples) HWY_ATTR { return stamps_of(s, samples); };
    if (w.is_hidden) {
      return count(draw_block<true>(s, t, block, w.number, buffer), stamps, counts);
    }
    const Pairs color = t.colors_at(s, w.x - first_x * kBlockPx, w.y - p.y0 / kBlockPx * kBlockPx);
    block.low = PairSlope::repeat(color.low);
    block.high = PairSlope::repeat(color.high);
    count(draw_block<false>(s, t, block, w.number, buffer), stamps, counts);
  }

  const State& s;
  const EdgePrim& p;
  const Triangle& t;
  BlockBuffer* const buffer;
  BlockCounts* const counts;
  int first_x, last_x;  // tiles
  int y = 0;
  uint32_t falls_rightward = 0, falls_downward = 0;  // edges
  std::array<int64_t, 3> at, best, worst, across;    // E' in the row's first tile; as in TileSteps
  uint64_t z_at = 0, z_across = 0, z_down = 0;
  alignas(64) std::array<Each, 3> steps;  // from tile to tile
  alignas(64) Each z_steps;
  alignas(64) std::array<Each, 3> lowered;  // of the tiles tested last
  alignas(64) Each depths{};
  std::array<Waiting, kWaiting> waiting;
  size_t next = 0, next_drawn = 0;
};

// ---- Small triangles

// How many stamps have one of these samples, x + 8y from a stamp's corner.
template <class State>
HWY_INLINE uint64_t small_stamps_of(const State& s, uint64_t samples) {
  constexpr uint64_t kColumns[] = {~uint64_t{0}, 0x5555555555555555, 0x1111111111111111};
  constexpr uint64_t kStampRows[] = {~uint64_t{0}, 0x00ff00ff00ff00ff, 0x000000ff000000ff};
  if (s.stamp_width_log2 >= 1) samples |= samples >> 1;
  if (s.stamp_width_log2 >= 2) samples |= samples >> 2;
  if (s.stamp_height_log2 >= 1) samples |= samples >> kSmallPx;
  if (s.stamp_height_log2 >= 2) samples |= samples >> (2 * kSmallPx);
  return ones(samples & kColumns[s.stamp_width_log2] & kStampRows[s.stamp_height_log2]);
}

HWY_INLINE bool passes(const core::PassesWhen& when, uint32_t code, uint32_t stored) {
  if (is_less(when)) return code < stored;
  return (when.less && code < stored) || (when.equal && code == stored) ||
         (when.greater && code > stored);
}

// Draws some samples of one triangle.
template <class State>
HWY_INLINE void draw_small(const State& s, const PrimGroup& group, const SmallPrims& small,
                           size_t i, uint32_t begin, BlockBuffer* buffer, BlockCounts* counts) {
  Outcome outcome{small.covered[i], 0};
  for (uint32_t k = begin; k < small.end[i]; ++k) {
    const SmallPrims::Sample& sample = small.samples[k];
    constexpr uint32_t kLineWords = sizeof(SampleLine) / sizeof(uint32_t);
    const uint32_t number = sample.place / kLineWords, at = sample.place % kLineWords;
    SampleLine& line = buffer->lines[number];
    if (s.counts_hits) {
      uint16_t& hits = buffer->hits[size_t{number} * kLineSamples + at];
      hits = static_cast<uint16_t>(hits + (hits != 0xffff ? 1 : 0));
    }
    bool pass = true;
    if (s.tests_depth) {
      const uint32_t stored = line.depth[at];
      pass = passes(s.when, sample.depth, stored);
      if (s.writes_depth) line.depth[at] = pass ? sample.depth : stored;
    }
    if (s.channels > 0) {
      // No branch: whether a sample passes cannot be predicted.
      const uint32_t changed = pass ? ~uint32_t{0} : 0;
      line.color[at] ^= (line.color[at] ^ sample.color) & changed;
    }
    outcome.passed |= uint64_t{pass} << sample.bit;
  }
  const int to_stamp = (group.x0[i] & ((1 << s.stamp_width_log2) - 1)) +
                       (group.y0[i] & ((1 << s.stamp_height_log2) - 1)) * kSmallPx;
  const auto stamps = [&](uint64_t samples)
                          HWY_ATTR { return small_stamps_of(s, samples << to_stamp); };
  count(outcome, stamps, counts);
}

template <class State>
HWY_INLINE void draw(const State& s, const PrimGroup& group, const SmallPrims& small,
                     BlockBuffer* buffer, BlockCounts* counts) {
  TileSlopes slopes;
  if (group.drawn != small.small) slopes.set(s, group);
  uint32_t drawn_samples = 0;  // of small triangles
  for (uint32_t left = group.drawn; left != 0; left &= left - 1) {
    const auto i = static_cast<size_t>(__builtin_ctz(left));
    if ((small.small >> i & 1) != 0) {
      draw_small(s, group, small, i, drawn_samples, buffer, counts);
      drawn_samples = small.end[i];
      continue;
    }
    const EdgePrim prim(group, i);
    const Triangle t(s, group, slopes, i);
    if (s.tile_log2 == 3 && prim.x1 / kBlockPx - prim.x0 / kBlockPx >= 3) {
      BlockRows<State>(s, prim, t, buffer, counts).draw();
      continue;
    }
    TileSteps tile;
    tile.begin(prim, s.tile_log2, s.rows);
    while (!tile.ended()) {
      const int rejects = tile.rejects();
      ++counts->tiles_tested;
      if (rejects != 0) {
        ++counts->tiles_rejected;
      } else {
        draw_tile(s, prim, t, tile, buffer, counts);
      }
      tile.step(rejects);
    }
  }
}

// What most frames are drawn with, as constants: the default design's.
struct CommonState {
  // NOLINTBEGIN(readability-identifier-naming): those of BlockState
  static constexpr const spec::Design& kDesign = spec::kHighTile;
  static constexpr int tile_log2 = kDesign.tile_log2;
  static constexpr int stamp_width_log2 = kDesign.stamp_width_log2;
  static constexpr int stamp_height_log2 = kDesign.stamp_height_log2;
  static constexpr bool tests_depth = true, hides = true, writes_depth = true, counts_hits = false;
  static constexpr core::PassesWhen when{true, false, false};  // LESS
  static constexpr int channels = spec::channels(kDesign);
  static constexpr int depth_bits = kDesign.depth_bits;
  static constexpr int depth_plane_bits = spec::kHighTileWidths.depth_plane;
  static constexpr int fraction_bits = kDesign.tile_fraction_bits;
  static constexpr int dropped_bits = kDesign.gradient_fraction_bits - fraction_bits;
  // NOLINTEND(readability-identifier-naming)
  core::TileRows rows;

  static bool holds(const BlockState& s) {
    return s.tile_log2 == tile_log2 && s.stamp_width_log2 == stamp_width_log2 &&
           s.stamp_height_log2 == stamp_height_log2 && s.tests_depth && is_less(s.when) &&
           s.writes_depth && !s.counts_hits && s.channels == channels &&
           s.depth_bits == depth_bits && s.depth_plane_bits == depth_plane_bits &&
           s.dropped_bits == dropped_bits && s.fraction_bits == fraction_bits;
  }
};

void draw_all(const BlockState& s, const PrimGroup& group, const SmallPrims& small,
              BlockBuffer* buffer, BlockCounts* counts) {
  if (CommonState::holds(s)) return draw(CommonState{s.rows}, group, small, buffer, counts);
  draw(s, group, small, buffer, counts);
}

#endif
}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace pineda::fast
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pineda::fast {

bool has_blocks(const spec::Contract& c) {
  if ((HWY_SUPPORTED_TARGETS & ~int64_t{HWY_SCALAR}) == 0) return false;
  const spec::Design& d = c.design;
  const spec::ErrorBounds error = spec::error_bounds_before_rounding(d);
  const bool depth = !d.depth_test || (d.depth_bits + d.tile_fraction_bits <= 32 &&
                                       d.tile_fraction_bits > 0 && error.depth_ulp < .5);
  const bool color = spec::channels(d) <= 4 && d.attribute_bits == 8 && d.tile_fraction_bits <= 8 &&
                     d.tile_fraction_bits > 0 && c.width.attr_plane <= 32 &&
                     error.attribute_lsb < .5;
  // |E'| <= 2(T - 1)(|a| + |b|) in a block of a tile, and |a|, |b| < 2^coord.
  const bool edges = d.tile_log2 >= 3 && 2 + d.tile_log2 + c.width.coord <= 32;
  return d.reciprocal_scheme != spec::ReciprocalScheme::kNone && !d.perspective && depth && color &&
         edges;
}

bool has_blocks(const spec::Contract& c, const spec::FrameState& frame) {
  return has_blocks(c) && !frame.has_bias();
}

BlockState::BlockState(const spec::Contract& contract, const spec::FrameState& frame,
                       core::TileRows wanted, bool with_hits)
    : rows(wanted),
      tile_log2(contract.design.tile_log2),
      stamp_width_log2(contract.design.stamp_width_log2),
      stamp_height_log2(contract.design.stamp_height_log2),
      tests_depth(core::tests_depth(contract, frame)),
      writes_depth(tests_depth && frame.depth_write),
      counts_hits(with_hits),
      when(core::passes_when(frame.depth)),
      hides(tests_depth && when.less && !when.greater),
      channels(spec::channels(contract.design)),
      depth_bits(contract.design.depth_test ? contract.design.depth_bits : 1),
      depth_plane_bits(contract.width.depth_plane),
      dropped_bits(contract.design.gradient_fraction_bits - contract.design.tile_fraction_bits),
      fraction_bits(contract.design.tile_fraction_bits) {}

HWY_EXPORT(draw_all);

void draw_blocks(const BlockState& state, const PrimGroup& group, const SmallPrims& small,
                 BlockBuffer* buffer, BlockCounts* counts) {
  HWY_DYNAMIC_DISPATCH(draw_all)(state, group, small, buffer, counts);
}

}  // namespace pineda::fast
#endif
