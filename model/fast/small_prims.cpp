// Compiled once for each vector unit that Highway knows on this processor: see cover_small() at the end.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/fast/small_prims.cpp"
// The order of these is Highway's.
#include "model/fast/small_prims.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace pineda::fast {
namespace HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR
// No vectors: has_blocks() says so.
void cover_lanes(const BlockState&, const PrimGroup&, const BlockBuffer&, SmallPrims*,
                 BlockCounts*) {}
#else

namespace hn = hwy::HWY_NAMESPACE;

// One triangle a lane.
constexpr hn::CappedTag<int32_t, kGroup> kInts;
constexpr hn::CappedTag<uint32_t, kGroup> kCodes;
constexpr hn::Repartition<uint64_t, decltype(kCodes)> kWords;
constexpr hn::Repartition<uint16_t, decltype(kCodes)> kHalves;
using Ints = hn::Vec<decltype(kInts)>;
using Codes = hn::Vec<decltype(kCodes)>;
using Words = hn::Vec<decltype(kWords)>;
using Mask = hn::Mask<decltype(kInts)>;
constexpr size_t kN = hn::MaxLanes(kCodes);
static_assert(kGroup % kN == 0);

HWY_INLINE Ints ints(int32_t value) { return hn::Set(kInts, value); }
HWY_INLINE Mask at_least(Ints v, int32_t least) { return hn::Gt(v, ints(least - 1)); }
HWY_INLINE Ints load(const Each<int32_t>& from, size_t first) {
  return hn::Load(kInts, from.data() + first);
}
HWY_INLINE uint64_t count_of(Mask mask) { return hn::CountTrue(kInts, mask); }
HWY_INLINE Codes select(Mask mask, Codes yes, Codes no) {
  return hn::IfThenElse(hn::RebindMask(kCodes, mask), yes, no);
}

// 64 bits of each lane, and the lower half of them.
struct Wide {
  Words low, high;  // the lower and the upper lanes

  static HWY_INLINE Wide load(const Each<int64_t>& from, size_t first) {
    const auto* words = reinterpret_cast<const uint64_t*>(from.data() + first);
    return {hn::Load(kWords, words), hn::Load(kWords, words + kN / 2)};
  }
  template <class Function>
  HWY_INLINE Wide each(Function function) const {
    return {function(low), function(high)};
  }
  HWY_INLINE Wide plus(const Wide& other) const {
    return {hn::Add(low, other.low), hn::Add(high, other.high)};
  }
  HWY_INLINE Codes lower() const {
    return hn::ConcatEven(kCodes, hn::BitCast(kCodes, high), hn::BitCast(kCodes, low));
  }
  HWY_INLINE Codes upper() const {
    return hn::ConcatOdd(kCodes, hn::BitCast(kCodes, high), hn::BitCast(kCodes, low));
  }
};

struct Edge {
  Ints a, b;
  Ints e;  // at the first sample of the first tile
};

// The box, and where it begins in its first tile, px.
struct Box {
  Ints x0, y0, width, height;  // width and height: of the last sample from the first one
  Ints left, top;
  Mask two_across, two_down;  // tiles
};

// ---- Which are small

// No E' in two tiles across and down leaves 31 bits.
HWY_INLINE Mask is_short(const PrimGroup& g, size_t k, size_t first, int tile_log2, Edge* edge) {
  const Wide e = Wide::load(g.e[k], first);
  *edge = {load(g.a[k], first), load(g.b[k], first), hn::BitCast(kInts, e.lower())};
  const Ints sign = hn::BroadcastSignBit(edge->e);
  const Mask fits =
      hn::And(hn::Eq(sign, hn::BitCast(kInts, e.upper())), hn::Lt(hn::Abs(edge->e), ints(1 << 29)));
  const Ints steps = hn::Or(hn::Abs(edge->a), hn::Abs(edge->b));
  return hn::And(fits, hn::Lt(steps, ints(1 << (27 - tile_log2))));
}

HWY_INLINE Mask is_small(const BlockState& s, const Box& box) {
  const Ints last_x = hn::Add(hn::And(box.x0, ints((1 << s.stamp_width_log2) - 1)), box.width);
  const Ints last_y = hn::Add(hn::And(box.y0, ints((1 << s.stamp_height_log2) - 1)), box.height);
  const Ints first_row = hn::ShiftRightSame(box.y0, s.tile_log2);
  const Ints last_row = hn::ShiftRightSame(hn::Add(box.y0, box.height), s.tile_log2);
  const Mask wanted =
      hn::And(at_least(first_row, s.rows.first), hn::Not(hn::Gt(last_row, ints(s.rows.last))));
  return hn::And(wanted, hn::And(hn::Lt(last_x, ints(kSmallPx)), hn::Lt(last_y, ints(kSmallPx))));
}

// ---- Tiles

struct TileTest {
  Mask rejected, accepted;
  std::array<Mask, 3> rejects;  // by edge
};

HWY_INLINE TileTest test_tile(const std::array<Edge, 3>& edges, int tile_log2, int across,
                              int down) {
  TileTest test;
  Ints worst_of_all = ints(0);
  for (size_t k = 0; k < 3; ++k) {
    const Edge& edge = edges[k];
    const Ints a = hn::ShiftLeftSame(edge.a, tile_log2), b = hn::ShiftLeftSame(edge.b, tile_log2);
    Ints at = edge.e;
    if (across != 0) at = hn::Add(at, a);
    if (down != 0) at = hn::Add(at, b);
    const Ints to_right = hn::Sub(a, edge.a), to_bottom = hn::Sub(b, edge.b);
    const Ints best = hn::Add(hn::Max(to_right, ints(0)), hn::Max(to_bottom, ints(0)));
    const Ints worst = hn::Sub(hn::Add(to_right, to_bottom), best);
    test.rejects[k] = hn::Lt(hn::Add(at, best), ints(0));
    worst_of_all = hn::Or(worst_of_all, hn::Add(at, worst));
  }
  test.rejected = hn::Or(test.rejects[0], hn::Or(test.rejects[1], test.rejects[2]));
  test.accepted = at_least(worst_of_all, 0);
  return test;
}

// As TileSteps walks through at most two tiles across and down: all are tested, but for the first one of
// the second row where the row above lets the start follow.
HWY_INLINE void count_tiles(const std::array<Edge, 3>& edges, int tile_log2, const Box& box,
                            Mask small, BlockCounts* counts) {
  const auto count = [&](const TileTest& test, Mask tested) HWY_ATTR {
    counts->tiles_tested += count_of(tested);
    counts->tiles_rejected += count_of(hn::And(tested, test.rejected));
    counts->tiles_accepted += count_of(hn::And(tested, test.accepted));
  };
  const TileTest first = test_tile(edges, tile_log2, 0, 0);
  count(first, small);
  const Mask across = hn::And(small, box.two_across), down = hn::And(small, box.two_down);
  if (!hn::AllFalse(kInts, across)) count(test_tile(edges, tile_log2, 1, 0), across);
  if (hn::AllFalse(kInts, down)) return;
  const Mask never = hn::Lt(ints(0), ints(0));
  Mask follows = never, rises = never, falls = never;
  for (size_t k = 0; k < 3; ++k) {
    const Mask leftward = hn::Lt(edges[k].a, ints(0)), upward = hn::Lt(edges[k].b, ints(1));
    follows = hn::Or(follows, hn::And(first.rejects[k], hn::AndNot(leftward, upward)));
    rises = hn::Or(rises, hn::Not(hn::Or(leftward, upward)));
    falls = hn::Or(falls, hn::And(leftward, upward));
  }
  const Mask turns = hn::And(rises, falls);
  const Mask both = hn::And(across, down);
  const Mask skipped = hn::And(both, hn::AndNot(turns, follows));
  count(test_tile(edges, tile_log2, 0, 1), hn::AndNot(skipped, down));
  if (!hn::AllFalse(kInts, both)) count(test_tile(edges, tile_log2, 1, 1), both);
}

// ---- Values

// A value of each triangle at the first sample of its box, as each of four tiles has it, and what it
// changes by.
template <class V>
struct Plane {
  V dx, dy;
  std::array<std::array<V, 2>, 2> at;  // by tiles down and across
};

// From values at the first samples of tiles.
template <class D, class V>
HWY_INLINE void move_to_box(D d, V left, V top, int tile_log2, Plane<V>* plane) {
  for (size_t j = 0; j < 2; ++j) {
    for (size_t i = 0; i < 2; ++i) {
      const auto side = [&](size_t n) HWY_ATTR {
        return hn::Set(d, static_cast<hn::TFromD<D> >(n << tile_log2));
      };
      plane->at[j][i] =
          hn::Add(plane->at[j][i], hn::Add(hn::Mul(plane->dx, hn::Sub(left, side(i))),
                                           hn::Mul(plane->dy, hn::Sub(top, side(j)))));
    }
  }
}

// Depths with their code at the top of a lane; half a code is added.
HWY_INLINE Plane<Codes> depth_plane(const BlockState& s, const PrimGroup& g, size_t first,
                                    const Box& box) {
  const Words half = hn::Set(kWords, (uint64_t{1} << s.dropped_bits) >> 1);
  const int up = 32 - s.depth_bits - s.fraction_bits;
  const auto in_tile = [&](const Wide& wide) HWY_ATTR {
    const Wide kept = wide.each(
        [&](Words v) HWY_ATTR { return hn::ShiftRightSame(hn::Add(v, half), s.dropped_bits); });
    return hn::ShiftLeftSame(kept.lower(), up);
  };
  const auto tiles = [&](const Wide& wide) HWY_ATTR {
    return wide.each([&](Words v) HWY_ATTR { return hn::ShiftLeftSame(v, s.tile_log2); });
  };
  const Wide ref = Wide::load(g.z_ref, first);
  const Wide dx = Wide::load(g.z_dx, first), dy = Wide::load(g.z_dy, first);
  const Wide below = ref.plus(tiles(dy));
  const Codes rounded = hn::Set(kCodes, (uint32_t{1} << s.fraction_bits >> 1) << up);
  Plane<Codes> plane{in_tile(dx), in_tile(dy), {}};
  plane.at[0][0] = hn::Add(in_tile(ref), rounded);
  plane.at[0][1] = hn::Add(in_tile(ref.plus(tiles(dx))), rounded);
  plane.at[1][0] = hn::Add(in_tile(below), rounded);
  plane.at[1][1] = hn::Add(in_tile(below.plus(tiles(dx))), rounded);
  move_to_box(kCodes, hn::BitCast(kCodes, box.left), hn::BitCast(kCodes, box.top), s.tile_log2,
              &plane);
  return plane;
}

// Channels 0 and 2, 1 and 3 of colours, 16 bits each; the code is the upper byte, half a code is added.
struct ColorPlanes {
  Plane<hn::Vec<decltype(kHalves)> > low, high;
};

HWY_INLINE ColorPlanes color_planes(const BlockState& s, const PrimGroup& g, size_t first,
                                    const Box& box) {
  using Channels = std::array<Codes, 4>;
  const auto load_channels = [&](const Each<std::array<uint32_t, 4> >& from) HWY_ATTR {
    Channels c;
    hn::LoadInterleaved4(kCodes, from[first].data(), c[0], c[1], c[2], c[3]);
    return c;
  };
  const Channels ref = load_channels(g.color_ref);
  const Channels dx = load_channels(g.color_dx), dy = load_channels(g.color_dy);
  const Codes half = hn::Set(kCodes, (1U << s.dropped_bits) >> 1);
  const auto pair = [&](Codes lower, Codes upper, uint32_t added) HWY_ATTR {
    const auto in_tile = [&](Codes v) HWY_ATTR {
      const Codes kept = hn::ShiftRightSame(hn::Add(v, half), s.dropped_bits);
      return hn::Add(hn::ShiftLeftSame(kept, 8 - s.fraction_bits), hn::Set(kCodes, added));
    };
    return hn::BitCast(kHalves, hn::Or(hn::And(in_tile(lower), hn::Set(kCodes, 0xffff)),
                                       hn::ShiftLeft<16>(in_tile(upper))));
  };
  const auto both = [&](Ints v) HWY_ATTR {
    const Codes codes = hn::BitCast(kCodes, v);
    return hn::BitCast(kHalves, hn::Or(codes, hn::ShiftLeft<16>(codes)));
  };
  const auto plane_of = [&](size_t lower, size_t upper) HWY_ATTR {
    Plane<hn::Vec<decltype(kHalves)> > plane{
        pair(dx[lower], dx[upper], 0), pair(dy[lower], dy[upper], 0), {}};
    for (size_t j = 0; j < 2; ++j) {
      for (size_t i = 0; i < 2; ++i) {
        const auto at = [&](size_t c) HWY_ATTR {
          Codes v = ref[c];
          if (i != 0) v = hn::Add(v, hn::ShiftLeftSame(dx[c], s.tile_log2));
          if (j != 0) v = hn::Add(v, hn::ShiftLeftSame(dy[c], s.tile_log2));
          return v;
        };
        plane.at[j][i] = pair(at(lower), at(upper), 0x80);
      }
    }
    move_to_box(kHalves, both(box.left), both(box.top), s.tile_log2, &plane);
    return plane;
  };
  return {plane_of(0, 2), plane_of(1, 3)};
}

// ---- Samples

// What the triangles have at each place of their boxes.
struct Scratch {
  alignas(64) std::array<Each<uint32_t>, kSmallPx * kSmallPx> depth, color;  // by x + 8y
  // Words of a line's place: by x, by y.
  alignas(64) std::array<Each<uint32_t>, kSmallPx> column, row;
  alignas(64) std::array<Each<uint32_t>, 2> covered;  // the upper and the lower four rows
};

constexpr uint32_t kLineWords = kLineBytes / sizeof(uint32_t);

HWY_INLINE void place(const Box& box, const BlockBuffer& buffer, int columns, int rows,
                      size_t first, Scratch* scratch) {
  const auto store = [&](Codes v, Each<uint32_t>* to)
                         HWY_ATTR { hn::Store(v, kCodes, to->data() + first); };
  const auto bits = [](Codes v, uint32_t mask)
                        HWY_ATTR { return hn::And(v, hn::Set(kCodes, mask)); };
  constexpr uint32_t kBlockWords = kBlockLines * kLineWords;
  static_assert(kLineWidthPx == 4 && kLineHeightPx == 2 && kBlockPx == 8);
  Codes x = hn::BitCast(kCodes, box.x0);
  for (int i = 0; i < columns; ++i, x = hn::Add(x, hn::Set(kCodes, 1))) {
    const Codes block = hn::Mul(hn::ShiftRight<3>(x), hn::Set(kCodes, kBlockWords));
    const Codes line = hn::Mul(bits(hn::ShiftRight<2>(x), 1), hn::Set(kCodes, kLineWords));
    store(hn::Add(block, hn::Add(line, bits(x, 3))), &scratch->column[static_cast<size_t>(i)]);
  }
  const auto row_words = static_cast<uint32_t>(buffer.across) * kBlockWords;
  Codes y = hn::BitCast(kCodes, hn::Sub(box.y0, ints(buffer.top)));
  for (int j = 0; j < rows; ++j, y = hn::Add(y, hn::Set(kCodes, 1))) {
    const Codes block = hn::Mul(hn::ShiftRight<3>(y), hn::Set(kCodes, row_words));
    const Codes line = hn::Mul(bits(hn::ShiftRight<1>(y), 3), hn::Set(kCodes, 2 * kLineWords));
    store(hn::Add(block, hn::Add(line, hn::ShiftLeft<2>(bits(y, 1)))),
          &scratch->row[static_cast<size_t>(j)]);
  }
}

HWY_INLINE void cover(const BlockState& s, const std::array<Edge, 3>& edges, const Box& box,
                      const Plane<Codes>& z, const ColorPlanes& colors, Mask small, int columns,
                      int rows, size_t first, Scratch* scratch) {
  const auto edge_at_box = [&](const Edge& edge) HWY_ATTR {
    return hn::Add(edge.e, hn::Add(hn::Mul(edge.a, box.left), hn::Mul(edge.b, box.top)));
  };
  std::array<Ints, 3> start{edge_at_box(edges[0]), edge_at_box(edges[1]), edge_at_box(edges[2])};
  const int32_t side = 1 << s.tile_log2;
  std::array<Codes, 2> covered{hn::Zero(kCodes), hn::Zero(kCodes)};
  Codes z_down = hn::Zero(kCodes);
  auto low_down = hn::Zero(kHalves), high_down = low_down;
  for (int j = 0; j < rows; ++j) {
    const Mask is_below = at_least(hn::Add(box.top, ints(j)), side);
    const Mask in_row = hn::And(small, at_least(box.height, j));
    // By the column of tiles.
    const auto row_of = [&](const auto& plane, auto down, size_t i, auto d) HWY_ATTR {
      const Codes upper = hn::BitCast(kCodes, plane.at[0][i]);
      const Codes lower = hn::BitCast(kCodes, plane.at[1][i]);
      return hn::Add(hn::BitCast(d, select(is_below, lower, upper)), down);
    };
    auto z0 = row_of(z, z_down, 0, kCodes), z1 = row_of(z, z_down, 1, kCodes);
    auto low0 = row_of(colors.low, low_down, 0, kHalves);
    auto low1 = row_of(colors.low, low_down, 1, kHalves);
    auto high0 = row_of(colors.high, high_down, 0, kHalves);
    auto high1 = row_of(colors.high, high_down, 1, kHalves);
    auto [e0, e1, e2] = start;
    Ints x = box.left;
    for (int i = 0; i < columns; ++i) {
      const Mask inside = hn::And(in_row, at_least(box.width, i));
      const Mask hit = hn::And(inside, at_least(hn::Or(e0, hn::Or(e1, e2)), 0));
      const uint32_t bit = uint32_t{1} << (j % 4 * kSmallPx + i);
      auto& word = covered[static_cast<size_t>(j / 4)];
      word = hn::Or(word, hn::IfThenElseZero(hn::RebindMask(kCodes, hit), hn::Set(kCodes, bit)));

      const Mask is_right = at_least(x, side);
      const size_t at = static_cast<size_t>(j * kSmallPx + i);
      hn::Store(hn::ShiftRightSame(select(is_right, z1, z0), 32 - s.depth_bits), kCodes,
                scratch->depth[at].data() + first);
      const auto low = hn::BitCast(
          kHalves, select(is_right, hn::BitCast(kCodes, low1), hn::BitCast(kCodes, low0)));
      const auto high = select(is_right, hn::BitCast(kCodes, high1), hn::BitCast(kCodes, high0));
      const Codes color = hn::Or(hn::BitCast(kCodes, hn::ShiftRight<8>(low)),
                                 hn::And(high, hn::Set(kCodes, 0xff00ff00)));
      hn::Store(color, kCodes, scratch->color[at].data() + first);

      e0 = hn::Add(e0, edges[0].a);
      e1 = hn::Add(e1, edges[1].a);
      e2 = hn::Add(e2, edges[2].a);
      x = hn::Add(x, ints(1));
      z0 = hn::Add(z0, z.dx);
      z1 = hn::Add(z1, z.dx);
      low0 = hn::Add(low0, colors.low.dx);
      low1 = hn::Add(low1, colors.low.dx);
      high0 = hn::Add(high0, colors.high.dx);
      high1 = hn::Add(high1, colors.high.dx);
    }
    for (size_t k = 0; k < 3; ++k) start[k] = hn::Add(start[k], edges[k].b);
    z_down = hn::Add(z_down, z.dy);
    low_down = hn::Add(low_down, colors.low.dy);
    high_down = hn::Add(high_down, colors.high.dy);
  }
  for (size_t k = 0; k < 2; ++k) {
    hn::Store(covered[k], kCodes, scratch->covered[k].data() + first);
  }
}

// Puts the samples of all triangles behind each other.
HWY_INLINE void collect(const Scratch& scratch, const BlockBuffer& buffer, SmallPrims* small) {
  uint32_t end = 0;
  for (uint32_t left = small->small; left != 0; left &= left - 1) {
    const auto t = static_cast<size_t>(__builtin_ctz(left));
    uint64_t covered = scratch.covered[0][t] | uint64_t{scratch.covered[1][t]} << 32;
    small->covered[t] = covered;
    for (; covered != 0; covered &= covered - 1) {
      const auto bit = static_cast<size_t>(__builtin_ctzll(covered));
      const uint32_t place = scratch.column[bit % kSmallPx][t] + scratch.row[bit / kSmallPx][t];
      __builtin_prefetch(&buffer.lines[place / kLineWords], 1);
      small->samples[end++] = {place, scratch.depth[bit][t], scratch.color[bit][t],
                               static_cast<uint32_t>(bit)};
    }
    small->end[t] = end;
  }
}

void cover_lanes(const BlockState& s, const PrimGroup& g, const BlockBuffer& buffer,
                 SmallPrims* out, BlockCounts* counts) {
  out->small = 0;
  Scratch scratch;
  for (size_t first = 0; first < kGroup; first += kN) {
    const uint32_t drawn = g.drawn >> first & ((1U << kN) - 1);
    if (drawn == 0) continue;
    Box box;
    box.x0 = load(g.x0, first);
    box.y0 = load(g.y0, first);
    box.width = hn::Sub(load(g.x1, first), box.x0);
    box.height = hn::Sub(load(g.y1, first), box.y0);
    const auto bytes = static_cast<uint16_t>(drawn);
    Mask small = hn::LoadMaskBits(kInts, reinterpret_cast<const uint8_t*>(&bytes));
    small = hn::And(small, is_small(s, box));
    std::array<Edge, 3> edges;
    for (size_t k = 0; k < 3; ++k) {
      small = hn::And(small, is_short(g, k, first, s.tile_log2, &edges[k]));
    }
    if (hn::AllFalse(kInts, small)) continue;
    uint16_t bits = 0;
    hn::StoreMaskBits(kInts, small, reinterpret_cast<uint8_t*>(&bits));
    out->small |= uint32_t{bits} << first;

    const Ints in_tile = ints((1 << s.tile_log2) - 1);
    box.left = hn::And(box.x0, in_tile);
    box.top = hn::And(box.y0, in_tile);
    box.two_across = hn::Gt(hn::Add(box.left, box.width), in_tile);
    box.two_down = hn::Gt(hn::Add(box.top, box.height), in_tile);
    count_tiles(edges, s.tile_log2, box, small, counts);
    const auto greatest = [&](Ints v) HWY_ATTR {
      return hn::GetLane(hn::MaxOfLanes(kInts, hn::IfThenElseZero(small, v)));
    };
    const int columns = greatest(box.width) + 1, rows = greatest(box.height) + 1;
    place(box, buffer, columns, rows, first, &scratch);
    cover(s, edges, box, depth_plane(s, g, first, box), color_planes(s, g, first, box), small,
          columns, rows, first, &scratch);
  }
  collect(scratch, buffer, out);
}

#endif
}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace pineda::fast
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pineda::fast {

HWY_EXPORT(cover_lanes);

void cover_small(const BlockState& state, const PrimGroup& group, const BlockBuffer& buffer,
                 SmallPrims* small, BlockCounts* counts) {
  HWY_DYNAMIC_DISPATCH(cover_lanes)(state, group, buffer, small, counts);
}

}  // namespace pineda::fast
#endif
