// Compiled once for each vector unit that Highway knows on this processor: see find() at the end.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/fast/small_walks.cpp"
// The order of these is Highway's.
#include "model/fast/small_walks.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "model/fast/small_lanes.h"
#include "model/fast/tile_stamps.h"

HWY_BEFORE_NAMESPACE();
namespace pineda::fast {
namespace HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR
// No vectors: no triangle is small.
void find_lanes(const SmallCorners&, SmallFound*) {}
#else

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<int32_t, kGroup> kInts;
constexpr hn::CappedTag<uint32_t, kGroup> kWords;
using Ints = hn::Vec<decltype(kInts)>;
using Words = hn::Vec<decltype(kWords)>;
using Mask = hn::Mask<decltype(kInts)>;
constexpr size_t kN = hn::MaxLanes(kInts);
static_assert(kGroup % kN == 0);

HWY_INLINE Ints ints(int32_t value) { return hn::Set(kInts, value); }
HWY_INLINE Ints ints_where(Mask mask, int32_t value) {
  return hn::IfThenElseZero(mask, ints(value));
}
HWY_INLINE Mask is_negative(Ints v) { return hn::Lt(v, ints(0)); }
HWY_INLINE uint32_t bits_of(Mask mask) {
  uint16_t bits = 0;
  hn::StoreMaskBits(kInts, mask, reinterpret_cast<uint8_t*>(&bits));
  return bits;
}
HWY_INLINE int32_t greatest_of(Ints v) { return hn::GetLane(hn::MaxOfLanes(kInts, v)); }

struct Box {
  Ints x0, y0, x1, y1;

  HWY_INLINE Mask is_empty() const { return hn::Or(hn::Gt(x0, x1), hn::Gt(y0, y1)); }
};

struct Edge {
  Ints a, b;
  Ints e;  // at the first sample of the box
};

// The pixels whose centres lie in the box of the corners, from the least and the greatest of them; see
// core::setup().
HWY_INLINE Box box_of(Ints left, Ints top, Ints right, Ints bottom, int subpixel_bits) {
  const int half = 1 << (subpixel_bits - 1);
  const auto first = [&](Ints least) HWY_ATTR {
    return hn::ShiftRightSame(hn::Add(least, ints(half - 1)), subpixel_bits);
  };
  const auto last = [&](Ints greatest) HWY_ATTR {
    return hn::ShiftRightSame(hn::Sub(greatest, ints(half + 1)), subpixel_bits);
  };
  return {first(left), first(top), last(right), last(bottom)};
}

HWY_INLINE void test_tiles(const std::array<Edge, 3>& edges, const Box& box, size_t first,
                           SmallFound* found) {
  constexpr int kSide = 1 << kSmallTileLog2;
  const Ints left = hn::And(box.x0, ints(kSide - 1)), top = hn::And(box.y0, ints(kSide - 1));
  const auto tile_of = [](Ints px) HWY_ATTR { return hn::ShiftRight<kSmallTileLog2>(px); };
  const Mask across = hn::Gt(tile_of(box.x1), tile_of(box.x0));
  const Mask down = hn::Gt(tile_of(box.y1), tile_of(box.y0));
  const Mask never = is_negative(ints(0));
  Mask rises = never, falls = never;
  std::array<Ints, kSmallTiles> best_of{}, worst_of{};
  best_of.fill(ints(0));
  worst_of.fill(ints(0));
  for (const Edge& edge : edges) {
    const Ints across_tile = hn::ShiftLeft<kSmallTileLog2>(edge.a);
    const Ints down_tile = hn::ShiftLeft<kSmallTileLog2>(edge.b);
    const Ints to_right = hn::Sub(across_tile, edge.a), to_bottom = hn::Sub(down_tile, edge.b);
    const Ints best = hn::Add(hn::Max(to_right, ints(0)), hn::Max(to_bottom, ints(0)));
    const Ints worst = hn::Sub(hn::Add(to_right, to_bottom), best);
    const Ints at = hn::Sub(edge.e, hn::Add(hn::Mul(edge.a, left), hn::Mul(edge.b, top)));
    const Ints below = hn::Add(at, down_tile);
    const std::array<Ints, kSmallTiles> corner{at, hn::Add(at, across_tile), below,
                                               hn::Add(below, across_tile)};
    for (size_t tile = 0; tile < kSmallTiles; ++tile) {
      best_of[tile] = hn::Or(best_of[tile], hn::Add(corner[tile], best));
      worst_of[tile] = hn::Or(worst_of[tile], hn::Add(corner[tile], worst));
    }
    const Mask leftward = is_negative(edge.a), upward = hn::Lt(edge.b, ints(1));
    rises = hn::Or(rises, hn::Not(hn::Or(leftward, upward)));
    falls = hn::Or(falls, hn::And(leftward, upward));
  }
  // All are tested. The first one of the second row would not be, if an edge with a >= 0 and b <= 0
  // rejected the one above it. But at most 8 rows that reach into the second row of tiles leave out
  // the first row of samples: so the leftmost corner lies below it, and not to the right of the tile's
  // last column. From that corner, where E >= 0, this E only grows towards the tile's best sample.
  const Mask turns = hn::And(rises, falls);
  Ints tested = hn::Or(ints(1), ints_where(across, 2));
  tested = hn::Or(tested, ints_where(down, 4));
  tested = hn::Or(tested, ints_where(hn::And(across, down), 8));
  Ints rejected = ints(0), accepted = ints(0);
  for (size_t tile = 0; tile < kSmallTiles; ++tile) {
    const Mask is_rejected = is_negative(best_of[tile]);
    const Mask is_accepted = hn::Not(is_negative(worst_of[tile]));
    rejected = hn::Or(rejected, ints_where(is_rejected, 1 << tile));
    accepted = hn::Or(accepted, ints_where(is_accepted, 1 << tile));
  }
  hn::Store(tested, kInts, found->tested.data() + first);
  hn::Store(rejected, kInts, found->rejected.data() + first);
  hn::Store(accepted, kInts, found->accepted.data() + first);
  found->turns |= bits_of(turns) << first;
}

// Covers the boxes, and what lies beside them up to the greatest width and height.
HWY_INLINE void cover(const std::array<Edge, 3>& edges, int columns, int rows, size_t first,
                      SmallFound* found) {
  std::array<Ints, 3> start{edges[0].e, edges[1].e, edges[2].e};
  std::array<Ints, 2> covered{ints(0), ints(0)};
  for (int j = 0; j < rows; ++j) {
    auto [e0, e1, e2] = start;
    Ints& word = covered[static_cast<size_t>(j / 4)];
    for (int i = 0; i < columns; ++i) {
      const Ints outside = hn::BroadcastSignBit(hn::Or(e0, hn::Or(e1, e2)));
      const auto bit = static_cast<int32_t>(uint32_t{1} << (j % 4 * kBlockPx + i));
      word = hn::Or(word, hn::AndNot(outside, ints(bit)));
      e0 = hn::Add(e0, edges[0].a);
      e1 = hn::Add(e1, edges[1].a);
      e2 = hn::Add(e2, edges[2].a);
    }
    for (size_t k = 0; k < 3; ++k) start[k] = hn::Add(start[k], edges[k].b);
  }
  for (size_t half = 0; half < 2; ++half) {
    hn::Store(hn::BitCast(kWords, covered[half]), kWords, found->covered[half].data() + first);
  }
}

HWY_INLINE void find_part(const SmallCorners& c, size_t first, SmallFound* found) {
  std::array<Ints, 3> x, y;
  for (size_t k = 0; k < 3; ++k) {
    x[k] = hn::Load(kInts, c.x[k].data() + first);
    y[k] = hn::Load(kInts, c.y[k].data() + first);
  }
  const Box whole = box_of(hn::Min(x[0], hn::Min(x[1], x[2])), hn::Min(y[0], hn::Min(y[1], y[2])),
                           hn::Max(x[0], hn::Max(x[1], x[2])), hn::Max(y[0], hn::Max(y[1], y[2])),
                           c.subpixel_bits);
  const Mask small = hn::And(hn::Lt(hn::Sub(whole.x1, whole.x0), ints(kBlockPx)),
                             hn::Lt(hn::Sub(whole.y1, whole.y0), ints(kBlockPx)));
  const Box clipped{hn::Max(whole.x0, ints(c.clip_x0)), hn::Max(whole.y0, ints(c.clip_y0)),
                    hn::Min(whole.x1, ints(c.clip_x1 - 1)), hn::Min(whole.y1, ints(c.clip_y1 - 1))};
  // The corners of a small triangle are less than a pixel from its box: products fit their lanes.
  std::array<Ints, 3> dx, dy;
  for (size_t k = 0; k < 3; ++k) {
    dx[k] = hn::IfThenElseZero(small, hn::Sub(x[(k + 1) % 3], x[k]));
    dy[k] = hn::IfThenElseZero(small, hn::Sub(y[(k + 1) % 3], y[k]));
  }
  const Ints area2 = hn::Sub(hn::Mul(dx[2], dy[0]), hn::Mul(dx[0], dy[2]));
  const Mask negative = is_negative(area2);
  const Mask positive = hn::Gt(area2, ints(0));
  Ints drop = ints_where(clipped.is_empty(), static_cast<int>(core::Drop::kOutside));
  const auto drop_where = [&](Mask mask, core::Drop cause) HWY_ATTR {
    drop = hn::IfThenElse(mask, ints(static_cast<int>(cause)), drop);
  };
  drop_where(whole.is_empty(), core::Drop::kNoSample);
  if (c.culls_positive) drop_where(positive, core::Drop::kFacing);
  if (c.culls_negative) drop_where(negative, core::Drop::kFacing);
  drop_where(hn::Eq(area2, ints(0)), core::Drop::kZeroArea);
  hn::Store(drop, kInts, found->drop.data() + first);
  found->small |= bits_of(small) << first;

  // The clipped box of a triangle that is dropped may be far away from it.
  const Mask drawn = hn::And(small, hn::Eq(drop, ints(0)));
  if (hn::AllFalse(kInts, drawn)) return;
  const auto if_drawn = [&](Ints v) HWY_ATTR { return hn::IfThenElseZero(drawn, v); };
  const Box box{if_drawn(clipped.x0), if_drawn(clipped.y0), if_drawn(clipped.x1),
                if_drawn(clipped.y1)};
  hn::Store(box.x0, kInts, found->x0.data() + first);
  hn::Store(box.y0, kInts, found->y0.data() + first);
  hn::Store(box.x1, kInts, found->x1.data() + first);
  hn::Store(box.y1, kInts, found->y1.data() + first);
  const auto centre = [&](Ints px) HWY_ATTR {
    const Ints corner = hn::ShiftLeftSame(px, c.subpixel_bits);
    return hn::Add(corner, ints(1 << (c.subpixel_bits - 1)));
  };
  const Ints ref_x = centre(box.x0), ref_y = centre(box.y0);
  const Ints turned = hn::BroadcastSignBit(area2);
  std::array<Edge, 3> edges;
  // In no order: each edge goes from a corner to the next one, clockwise.
  for (size_t k = 0; k < 3; ++k) {
    const Ints across = hn::Sub(hn::Xor(dx[k], turned), turned);
    const Ints down = hn::Sub(hn::Xor(dy[k], turned), turned);
    const Ints e = hn::Sub(hn::Mul(across, if_drawn(hn::Sub(ref_y, y[k]))),
                           hn::Mul(down, if_drawn(hn::Sub(ref_x, x[k]))));
    // Neither a top nor a left edge.
    const Mask exclusive =
        hn::Or(hn::Gt(down, ints(0)), hn::And(hn::Eq(down, ints(0)), is_negative(across)));
    edges[k] = {hn::Neg(down), across,
                hn::ShiftRightSame(hn::Sub(e, ints_where(exclusive, 1)), c.subpixel_bits)};
  }
  test_tiles(edges, box, first, found);
  cover(edges, greatest_of(hn::Sub(box.x1, box.x0)) + 1, greatest_of(hn::Sub(box.y1, box.y0)) + 1,
        first, found);
}

void find_lanes(const SmallCorners& corners, SmallFound* found) {
  found->small = found->turns = 0;
  for (size_t first = 0; first < kGroup; first += kN) find_part(corners, first, found);
}

#endif
}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace pineda::fast
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pineda::fast {

using core::Drop;

HWY_EXPORT(find_lanes);

namespace {

// Fills in a tile of the i-th triangle that is kept.
PINEDA_INLINE void keep(const Shape& shape, const SmallFound& found, size_t i, int tile,
                        TileCover* cover, StampsBySamples* by_samples) {
  cover->x = (found.x0[i] >> kSmallTileLog2) + tile % 2;
  cover->y = (found.y0[i] >> kSmallTileLog2) + tile / 2;
  const int left = found.x0[i] - (cover->x << kSmallTileLog2);
  const int top = found.y0[i] - (cover->y << kSmallTileLog2);
  cover->accepted = (found.accepted[i] >> tile & 1) != 0;
  set_box(shape, left, top, found.x1[i] - (cover->x << kSmallTileLog2),
          found.y1[i] - (cover->y << kSmallTileLog2), cover);
  const uint64_t in_box = found.covered[0][i] | uint64_t{found.covered[1][i]} << 32;
  // What leaves a row at one end enters the next one outside the box.
  const int by = left + kBlockPx * top;
  const uint64_t moved = by < 0 ? in_box >> -by : in_box << by;
  const uint64_t bits = moved & box_of(cover->x0, cover->y0, cover->x1, cover->y1);
  TileSamples& samples = cover->covered;
  cover->full = bits == ~uint64_t{0};
  samples.blocks[0] = bits;
  samples.sample_count = static_cast<int>(ones(bits));
  samples.stamps[0] = 0;
  place_stamps(shape, 0, 0, stamps_of(shape, bits), &samples);
  count_stamps(shape, bits, by_samples);
  find_first_and_last(shape, &samples);
  find_groups(shape, cover);
}

// Lists the tiles of all triangles in the order of their walks.
PINEDA_INLINE void list_in_shape(const Shape& shape, const SmallFound& found, size_t count,
                                 Each<SmallWalk>* walks, TileCover* covers,
                                 StampsBySamples* by_samples) {
  for (size_t i = 0; i < count; ++i) {
    if ((found.small >> i & 1) == 0) continue;
    SmallWalk& walk = (*walks)[i];
    walk.drop = static_cast<Drop>(found.drop[i]);
    walk.tests = 0;
    walk.rejected = 0;
    walk.kept = covers;
    if (walk.drop != Drop::kNone) continue;
    const auto tested = static_cast<unsigned>(found.tested[i]);
    // In the second row the right one is first where the walk turns.
    const unsigned turns = found.turns >> i & tested >> 3 & 1;
    for (unsigned left = tested; left != 0; left &= left - 1) {
      const auto number = static_cast<unsigned>(__builtin_ctz(left));
      const auto tile = static_cast<int>(number ^ (number >> 1 & turns));
      const bool is_rejected = (found.rejected[i] >> tile & 1) != 0;
      walk.rejected |= static_cast<unsigned>(is_rejected) << walk.tests++;
      if (!is_rejected) keep(shape, found, i, tile, covers++, by_samples);
    }
  }
}

PINEDA_KERNEL(void, list_tiles,
              (const spec::Design& d, const SmallFound& found, size_t count, Each<SmallWalk>* walks,
               TileCover* covers, StampsBySamples* by_samples),
              (d, found, count, walks, covers, by_samples)) {
  with_shape(d, [&](const Shape& shape) PINEDA_INLINED {
    list_in_shape(shape, found, count, walks, covers, by_samples);
  });
}

}  // namespace

// A corner is less than 2^(guard_bits + subpixel_bits) from the first pixel; less than 9 px lie between
// two of a small triangle.
bool SmallWalks::fit(const spec::Design& d) {
  return d.tile_log2 == kSmallTileLog2 && d.subpixel_bits <= 8 &&
         d.guard_bits + d.subpixel_bits <= 28;
}

SmallWalks::SmallWalks(const spec::Contract& contract)
    : design_(contract.design), covers_(kGroup * size_t{kSmallTiles}, TileCover(contract)) {}

void SmallWalks::begin_frame(const spec::FrameState& frame) { frame_ = frame; }

void SmallWalks::find(const spec::Triangle* triangles, size_t count, StampsBySamples* by_samples) {
  SmallCorners corners;
  corners.subpixel_bits = design_.subpixel_bits;
  corners.clip_x0 = frame_.clip_x0();
  corners.clip_y0 = frame_.clip_y0();
  corners.clip_x1 = frame_.clip_x1();
  corners.clip_y1 = frame_.clip_y1();
  corners.culls_positive = frame_.cull == spec::Cull::kBack;
  corners.culls_negative = frame_.cull == spec::Cull::kFront;
  for (size_t i = 0; i < count; ++i) {
    for (size_t k = 0; k < 3; ++k) {
      corners.x[k][i] = triangles[i].v[k].x;
      corners.y[k][i] = triangles[i].v[k].y;
    }
  }
  SmallFound found;
  HWY_DYNAMIC_DISPATCH(find_lanes)(corners, &found);
  small_ = found.small;
  list_tiles(design_, found, count, &walks_, covers_.data(), by_samples);
}

}  // namespace pineda::fast
#endif
