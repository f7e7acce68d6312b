// Compiled once for each vector unit that Highway knows on this processor: see set_up() at the end.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/fast/setup_lanes.cpp"
// The order of these is Highway's.
#include "model/fast/setup_lanes.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "model/fast/blocks.h"
#include "model/spec/reciprocal/schemes.h"

HWY_BEFORE_NAMESPACE();
namespace pineda::fast {
namespace HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR
// No vectors: has_blocks() says so.
void set_up_lanes(const SetupLanes&, const TriangleGroup&, size_t, uint32_t, PrimGroup*,
                  std::array<uint64_t, core::kDropCauses>*) {}
#else

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<int64_t, 8> kWords;
constexpr hn::RebindToUnsigned<decltype(kWords)> kBits;
constexpr hn::Repartition<int32_t, decltype(kWords)> kInts;
constexpr hn::Repartition<uint32_t, decltype(kWords)> kUints;
constexpr hn::Rebind<int32_t, decltype(kWords)> kHalfInts;
constexpr hn::Rebind<uint32_t, decltype(kWords)> kHalfUints;
using Words = hn::Vec<decltype(kWords)>;
using Bits = hn::Vec<decltype(kBits)>;
using Mask = hn::Mask<decltype(kWords)>;
constexpr size_t kN = hn::MaxLanes(kWords);
static_assert(kGroup % kN == 0);

HWY_INLINE Words words(int64_t value) { return hn::Set(kWords, value); }
HWY_INLINE Bits bits_of(Words v) { return hn::BitCast(kBits, v); }
HWY_INLINE Words words_of(Bits v) { return hn::BitCast(kWords, v); }

// Products of numbers of 32 bits, signed and unsigned.
HWY_INLINE Words times(Words a, Words b) {
  return hn::MulEven(hn::BitCast(kInts, a), hn::BitCast(kInts, b));
}
HWY_INLINE Bits times_unsigned(Words a, Words b) {
  return hn::MulEven(hn::BitCast(kUints, a), hn::BitCast(kUints, b));
}
// The low word of a product.
HWY_INLINE Words low_times(Words a, Words b) {
#if HWY_TARGET <= HWY_AVX3
  return hn::Mul(a, b);
#else
  const Words a_high = hn::ShiftRight<32>(a), b_high = hn::ShiftRight<32>(b);
  const Bits cross = hn::Add(times_unsigned(a_high, b), times_unsigned(a, b_high));
  return words_of(hn::Add(times_unsigned(a, b), hn::ShiftLeft<32>(cross)));
#endif
}

HWY_INLINE uint32_t lanes_of(Mask mask) {
  uint8_t byte = 0;
  hn::StoreMaskBits(kWords, mask, &byte);
  return byte;
}

HWY_INLINE void store_ints(Words v, int32_t* to) {
  hn::Store(hn::BitCast(kHalfInts, hn::TruncateTo(kHalfUints, bits_of(v))), kHalfInts, to);
}

// ---- Vertices in canonical order

// Position, and depth with colour: two words a vertex, so that few are exchanged.
struct Vertices {
  std::array<Words, 3> at;  // y above x; x with its sign turned, so that words compare like (y, x)
  std::array<Words, 3> value;  // z above the colour
};

HWY_INLINE Words pair(Words upper, Words lower) {
  return hn::Or(hn::ShiftLeft<32>(upper), hn::And(lower, words(0xffffffff)));
}
HWY_INLINE Words x_of(Words at) {
  return hn::ShiftRight<32>(hn::ShiftLeft<32>(hn::Xor(at, words(0x80000000))));
}
HWY_INLINE Words y_of(Words at) { return hn::ShiftRight<32>(at); }
HWY_INLINE Words z_of(Words value) { return words_of(hn::ShiftRight<32>(bits_of(value))); }

HWY_INLINE Words load(const Each<int32_t>& from, size_t i) {
  return hn::PromoteTo(kWords, hn::Load(kHalfInts, from.data() + i));
}
HWY_INLINE Words load(const Each<uint32_t>& from, size_t i) {
  return words_of(hn::PromoteTo(kBits, hn::Load(kHalfUints, from.data() + i)));
}

HWY_INLINE Vertices load_vertices(const SetupLanes& s, const TriangleGroup& t, size_t i) {
  Vertices v;
  for (size_t k = 0; k < 3; ++k) {
    v.at[k] = hn::Xor(pair(load(t.y[k], i), load(t.x[k], i)), words(0x80000000));
    v.value[k] = pair(load(t.z[k], i), load(t.color[s.flat_shading ? 0 : k], i));
  }
  return v;
}

// The doubled area, positive when clockwise.
HWY_INLINE Words doubled_area(const Vertices& v) {
  const Words x0 = x_of(v.at[0]), y0 = y_of(v.at[0]);
  return hn::Sub(times(hn::Sub(x_of(v.at[1]), x0), hn::Sub(y_of(v.at[2]), y0)),
                 times(hn::Sub(x_of(v.at[2]), x0), hn::Sub(y_of(v.at[1]), y0)));
}

// Clockwise from the topmost, then leftmost vertex.
HWY_INLINE void order(Mask negative, Vertices* v) {
  const auto& [k0, k1, k2] = v->at;
  const Mask second_is_before_first = hn::Lt(k1, k0);
  const Mask last_is_before_second = hn::Lt(k2, k1);
  const Mask from_2 = hn::And(hn::Lt(k2, k0), last_is_before_second);
  const Mask from_1 = hn::AndNot(last_is_before_second, second_is_before_first);
  for (auto* word : {&v->at, &v->value}) {
    const auto [w0, w1, w2] = *word;
    const Words first = hn::IfThenElse(from_2, w2, hn::IfThenElse(from_1, w1, w0));
    const Words second = hn::IfThenElse(from_2, w0, hn::IfThenElse(from_1, w2, w1));
    const Words third = hn::IfThenElse(from_2, w1, hn::IfThenElse(from_1, w0, w2));
    *word = {first, hn::IfThenElse(negative, third, second),
             hn::IfThenElse(negative, second, third)};
  }
}

// The second and the third vertex from the first, and the reference sample from it; subpixels.
struct Differences {
  Words x1, y1, x2, y2;
  Words ref_x, ref_y;
};

// ---- The box

struct Box {
  Words x0, y0, x1, y1;
  Mask is_empty;    // no sample
  Mask is_outside;  // none in the frame or the scissor
};

// See core::setup(): the right and bottom borders are exclusive.
HWY_INLINE Box box_of(const SetupLanes& s, const Vertices& v) {
  const Words xa = x_of(v.at[0]), xb = x_of(v.at[1]), xc = x_of(v.at[2]);
  const Words ya = y_of(v.at[0]), yb = y_of(v.at[1]), yc = y_of(v.at[2]);
  const int64_t half = int64_t{1} << (s.subpixel_bits - 1);
  const auto first = [&](Words low) HWY_ATTR {
    return hn::ShiftRightSame(hn::Add(low, words(half - 1)), s.subpixel_bits);
  };
  const auto last = [&](Words high) HWY_ATTR {
    return hn::ShiftRightSame(hn::Sub(high, words(half + 1)), s.subpixel_bits);
  };
  const Words x0 = first(hn::Min(xa, hn::Min(xb, xc))), x1 = last(hn::Max(xa, hn::Max(xb, xc)));
  const Words y0 = first(hn::Min(ya, hn::Min(yb, yc))), y1 = last(hn::Max(ya, hn::Max(yb, yc)));
  Box box;
  box.is_empty = hn::Or(hn::Gt(x0, x1), hn::Gt(y0, y1));
  box.x0 = hn::Max(x0, words(s.clip_x0));
  box.y0 = hn::Max(y0, words(s.clip_y0));
  box.x1 = hn::Min(x1, words(s.clip_x1 - 1));
  box.y1 = hn::Min(y1, words(s.clip_y1 - 1));
  box.is_outside = hn::Or(hn::Gt(box.x0, box.x1), hn::Gt(box.y0, box.y1));
  return box;
}

// ---- Edges

HWY_INLINE Words one_where(Mask mask) { return hn::IfThenElseZero(mask, words(1)); }

// As fast::setup()'s biased_edges() and write_edges().
HWY_INLINE void store_edges(const SetupLanes& s, const Differences& d, Words area2, size_t i,
                            PrimGroup* g) {
  const Words e0 = hn::Sub(times(d.x1, d.ref_y), times(d.y1, d.ref_x));
  const Words e2 = hn::Sub(times(d.y2, d.ref_x), times(d.x2, d.ref_y));
  const Words zero = hn::Zero(kWords);
  const Words bias0 = one_where(hn::Gt(d.y1, zero));
  const Words bias1 = hn::Sub(words(1), one_where(hn::Lt(d.y2, d.y1)));
  const Words e1 = hn::Sub(hn::Sub(hn::Sub(area2, e0), e2), bias1);
  const auto store = [&](size_t k, Words a, Words b, Words e) HWY_ATTR {
    store_ints(a, g->a[k].data() + i);
    store_ints(b, g->b[k].data() + i);
    hn::Store(hn::ShiftRightSame(e, s.subpixel_bits), kWords, g->e[k].data() + i);
  };
  store(0, hn::Sub(zero, d.y1), d.x1, hn::Sub(e0, bias0));
  store(1, hn::Sub(d.y1, d.y2), hn::Sub(d.x2, d.x1), e1);
  store(2, d.y2, hn::Sub(zero, d.x2), e2);
}

// ---- The reciprocal, see core::reciprocal()

struct Reciprocal {
  Words twice;   // twice the mantissa, below 2^32
  Words length;  // bits of the doubled area
};

// Bits of a number from 1 to 2^52 - 1: the exponent of the double that it is.
HWY_INLINE Words length_of(Words v) {
  const hn::RebindToFloat<decltype(kWords)> d;
  const auto magic = hn::Set(d, 4503599627370496.0);  // 2^52
  const auto value = hn::Sub(hn::BitCast(d, hn::Or(v, hn::BitCast(kWords, magic))), magic);
  return hn::Sub(hn::ShiftRight<52>(hn::BitCast(kWords, value)), words(1022));
}

HWY_INLINE Reciprocal reciprocal_of(const SetupLanes& s, Words area2) {
  const Words length = length_of(area2);
  const Bits leading = hn::Shl(bits_of(area2), bits_of(hn::Sub(words(64), length)));
  const Words m = words_of(hn::ShiftRightSame(leading, 64 - s.working_bits));
  const Words index = hn::ShiftRightSame(m, s.working_bits - s.index_bits);
  Words x = hn::GatherIndex(kWords, s.guesses.data(), index);
  for (int i = 0; i < s.steps; ++i) {
    // x * (2 - 2mx) = x + x * (1 - 2mx); m*x is about 1/2, so it fits an unsigned word.
    const Bits mx2 = hn::ShiftRightSame(bits_of(low_times(m, x)), s.working_bits - 1);
    const Words error = hn::Sub(words(int64_t{1} << s.working_bits), words_of(mx2));
    x = hn::Add(x, hn::ShiftRightSame(low_times(x, error), s.working_bits));
  }
  const Words limit = words((int64_t{1} << s.mantissa_bits) - 1);
  const Words mantissa = hn::Min(hn::ShiftRight<2>(hn::Add(x, words(2))), limit);
  return {hn::Add(mantissa, mantissa), length};
}

// ---- Planes, see fast::word_plane()

// numerator * twice >> shift, then half of it, rounded; shift from 0 to 63.
HWY_INLINE Words gradient(Words numerator, Words twice, Words shift) {
  const Words upper = times(hn::ShiftRight<32>(numerator), twice);
  const Bits lower = times_unsigned(numerator, twice);
  const Words whole = hn::Add(upper, words_of(hn::ShiftRight<32>(lower)));
  const Words rest = hn::And(words_of(lower), words(0xffffffff));
  const Words zero = hn::Zero(kWords);
  const Words beyond = hn::Sub(shift, words(32));
  const Words far = hn::Shr(whole, hn::Max(beyond, zero));
  const Words near = hn::Or(hn::Shl(whole, hn::Max(hn::Sub(zero, beyond), zero)),
                            hn::Shr(rest, hn::Min(shift, words(32))));
  const Words shifted = hn::IfThenElse(hn::Lt(beyond, zero), near, far);
  return hn::ShiftRight<1>(hn::Add(shifted, words(1)));
}

struct Plane {
  Words dx, dy;
  Words at_ref;  // 2^-S times the value's unit, with a half added
};

HWY_INLINE Words at_ref(const SetupLanes& s, const Differences& d, Words first, int raise, Words dx,
                        Words dy) {
  const Words steps = hn::Add(low_times(dx, d.ref_x), low_times(dy, d.ref_y));
  return hn::Add(hn::Add(hn::ShiftLeftSame(first, raise), steps),
                 words(int64_t{1} << (s.subpixel_bits - 1)));
}

HWY_INLINE void store_depth(const SetupLanes& s, const Vertices& v, const Differences& d,
                            const Reciprocal& r, size_t i, PrimGroup* g) {
  const Words z0 = z_of(v.value[0]);
  const Words d1 = hn::Sub(z_of(v.value[1]), z0), d2 = hn::Sub(z_of(v.value[2]), z0);
  const Words shift = hn::Add(r.length, words(s.depth_shift));
  const Words dx = gradient(hn::Sub(low_times(d1, d.y2), low_times(d2, d.y1)), r.twice, shift);
  const Words dy = gradient(hn::Sub(low_times(d2, d.x1), low_times(d1, d.x2)), r.twice, shift);
  const int raise = s.gradient_fraction_bits - spec::kDepthInputFractionBits + s.subpixel_bits;
  const Words ref = at_ref(s, d, z0, raise, dx, dy);
  const int above = 64 - s.depth_plane_bits;
  const auto store = [&](Words value, int fraction_bits, int64_t* to) HWY_ATTR {
    const Words raised = hn::ShiftLeftSame(value, above - fraction_bits);
    hn::Store(hn::ShiftRightSame(raised, above), kWords, to);
  };
  store(dx, 0, g->z_dx.data() + i);
  store(dy, 0, g->z_dy.data() + i);
  store(ref, s.subpixel_bits, g->z_ref.data() + i);
}

using HalfUints = hn::Vec<decltype(kHalfUints)>;
HWY_INLINE HalfUints low_half(Words v) { return hn::TruncateTo(kHalfUints, bits_of(v)); }

// Numerators fit 32 bits, and the products with the mantissa 64.
HWY_INLINE void store_colors(const SetupLanes& s, const Vertices& v, const Differences& d,
                             const Reciprocal& r, Words flat, size_t i, PrimGroup* g) {
  std::array<HalfUints, 4> dx, dy, ref;
  const Words shift = hn::Add(r.length, words(s.attribute_shift));
  for (int a = 0; a < 4; ++a) {
    const auto at = static_cast<size_t>(a);
    dx[at] = dy[at] = ref[at] = hn::Zero(kHalfUints);
    if (a >= s.channels) continue;
    const auto channel = [a](Words value) HWY_ATTR {
      return hn::And(words_of(hn::ShiftRightSame(bits_of(value), 8 * a)), words(0xff));
    };
    if (a >= s.attributes) {
      ref[at] = low_half(hn::ShiftLeftSame(channel(flat), s.gradient_fraction_bits));
      continue;
    }
    const Words c0 = channel(v.value[0]);
    const Words d1 = hn::Sub(channel(v.value[1]), c0), d2 = hn::Sub(channel(v.value[2]), c0);
    const auto slope = [&](Words numerator) HWY_ATTR {
      const Words shifted = hn::Shr(times(numerator, r.twice), shift);
      return hn::ShiftRight<1>(hn::Add(shifted, words(1)));
    };
    const Words x = slope(hn::Sub(times(d1, d.y2), times(d2, d.y1)));
    const Words y = slope(hn::Sub(times(d2, d.x1), times(d1, d.x2)));
    const int raise = s.gradient_fraction_bits + s.subpixel_bits;
    dx[at] = low_half(x);
    dy[at] = low_half(y);
    ref[at] = low_half(hn::ShiftRightSame(at_ref(s, d, c0, raise, x, y), s.subpixel_bits));
  }
  const auto store = [&](const std::array<HalfUints, 4>& c, auto* to) HWY_ATTR {
    hn::StoreInterleaved4(c[0], c[1], c[2], c[3], kHalfUints, (*to)[i].data());
  };
  store(dx, &g->color_dx);
  store(dy, &g->color_dy);
  store(ref, &g->color_ref);
}

// ---- A part of a group: returns the lanes that are drawn.
HWY_INLINE uint32_t set_up_part(const SetupLanes& s, const TriangleGroup& t, size_t i,
                                uint32_t wanted, uint32_t counted, PrimGroup* g,
                                std::array<uint64_t, core::kDropCauses>* drops) {
  Vertices v = load_vertices(s, t, i);
  const Words flat = v.value[0];
  const Words signed_area2 = doubled_area(v);
  const Words zero = hn::Zero(kWords);
  const Mask negative = hn::Lt(signed_area2, zero);
  const Box box = box_of(s, v);

  uint32_t left = wanted;
  const auto drop = [&](core::Drop cause, uint32_t lanes) HWY_ATTR {
    (*drops)[static_cast<size_t>(cause)] +=
        static_cast<uint64_t>(__builtin_popcount(left & lanes & counted));
    left &= ~lanes;
  };
  drop(core::Drop::kZeroArea, lanes_of(hn::Eq(signed_area2, zero)));
  const uint32_t ccw = lanes_of(negative);
  drop(core::Drop::kFacing, (s.culls_negative ? ccw : 0) | (s.culls_positive ? ~ccw : 0));
  drop(core::Drop::kNoSample, lanes_of(box.is_empty));
  drop(core::Drop::kOutside, lanes_of(box.is_outside));
  if (left == 0) return 0;

  order(negative, &v);
  const Words area2 = hn::Abs(signed_area2);
  const Words xa = x_of(v.at[0]), ya = y_of(v.at[0]);
  const int64_t half = int64_t{1} << (s.subpixel_bits - 1);
  const auto from = [&](Words px, Words anchor) HWY_ATTR {
    const Words corner =
        hn::ShiftLeftSame(hn::ShiftRightSame(px, s.tile_log2), s.tile_log2 + s.subpixel_bits);
    return hn::Sub(hn::Add(corner, words(half)), anchor);
  };
  const Differences d{hn::Sub(x_of(v.at[1]), xa), hn::Sub(y_of(v.at[1]), ya),
                      hn::Sub(x_of(v.at[2]), xa), hn::Sub(y_of(v.at[2]), ya),
                      from(box.x0, xa),           from(box.y0, ya)};
  store_ints(box.x0, g->x0.data() + i);
  store_ints(box.y0, g->y0.data() + i);
  store_ints(box.x1, g->x1.data() + i);
  store_ints(box.y1, g->y1.data() + i);
  store_edges(s, d, area2, i, g);
  Reciprocal r{zero, zero};
  // Lanes that are dropped may have no area.
  if (s.has_planes) r = reciprocal_of(s, hn::Max(area2, words(1)));
  if (s.has_depth) store_depth(s, v, d, r, i, g);
  store_colors(s, v, d, r, flat, i, g);
  return left;
}

void set_up_lanes(const SetupLanes& s, const TriangleGroup& t, size_t count, uint32_t counted,
                  PrimGroup* g, std::array<uint64_t, core::kDropCauses>* drops) {
  const uint32_t all = (1U << count) - 1;
  g->drawn = 0;
  for (size_t i = 0; i < count; i += kN) {
    const uint32_t wanted = all >> i & ((1U << kN) - 1);
    g->drawn |= set_up_part(s, t, i, wanted, counted >> i, g, drops) << i;
  }
  (*drops)[static_cast<size_t>(core::Drop::kNone)] +=
      static_cast<uint64_t>(__builtin_popcount(g->drawn & counted));
}

#endif
}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace pineda::fast
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pineda::fast {

bool has_setup_lanes(const spec::Contract& c) {
  const spec::Design& d = c.design;
  if (!has_blocks(c) || d.reciprocal_scheme != spec::ReciprocalScheme::kNewton) return false;
  const SetupLanes s(c, spec::FrameState());
  // Coordinates' differences and offsets are factors of 32 bits; a double holds an area.
  const bool edges = c.width.edge_coeff < 32 && c.width.area2 <= 52;
  const int longest = c.width.area2 - 1;
  // A numerator is 32 bits times those of the mantissa, twice, in two parts.
  const bool depth =
      !d.depth_test ||
      (c.width.depth_in <= 32 && c.width.depth_numerator <= 63 && s.depth_shift + 1 >= 0 &&
       s.depth_shift + longest < 64 && c.width.depth_plane + d.subpixel_bits < 64 &&
       d.gradient_fraction_bits + d.subpixel_bits >= spec::kDepthInputFractionBits);
  const bool colors =
      d.attributes == 0 || (c.width.attr_numerator <= 32 && s.attribute_shift + 1 >= 0 &&
                            s.attribute_shift + longest < 64);
  return edges && depth && colors && s.working_bits <= 32 && d.reciprocal_bits <= 30;
}

SetupLanes::SetupLanes(const spec::Contract& contract, const spec::FrameState& frame)
    : subpixel_bits(contract.design.subpixel_bits),
      tile_log2(contract.design.tile_log2),
      clip_x0(frame.clip_x0()),
      clip_y0(frame.clip_y0()),
      clip_x1(frame.clip_x1()),
      clip_y1(frame.clip_y1()),
      culls_positive(frame.cull == spec::Cull::kBack),
      culls_negative(frame.cull == spec::Cull::kFront),
      flat_shading(frame.shade == spec::Shade::kFlat),
      has_depth(contract.design.depth_test),
      has_planes(spec::plane_count(contract.design) > 0),
      channels(spec::channels(contract.design)),
      attributes(contract.design.attributes),
      working_bits(spec::reciprocal_working_bits(contract.design)),
      index_bits(contract.design.reciprocal_lut_bits + 1),
      steps(contract.design.reciprocal_newton_steps),
      mantissa_bits(contract.design.reciprocal_bits),
      gradient_fraction_bits(contract.design.gradient_fraction_bits),
      depth_plane_bits(contract.width.depth_plane),
      depth_shift(mantissa_bits - 1 - gradient_fraction_bits - subpixel_bits +
                  spec::kDepthInputFractionBits),
      attribute_shift(mantissa_bits - 1 - gradient_fraction_bits - subpixel_bits) {
  const spec::Design& d = contract.design;
  if (d.reciprocal_scheme != spec::ReciprocalScheme::kNewton) return;
  const int rom_bits = spec::reciprocal_rom_bits(d);
  const auto entries = size_t{1} << d.reciprocal_lut_bits;
  guesses.resize(2 * entries);
  for (size_t i = 0; i < entries; ++i) {
    const int64_t leading = int64_t{1} << rom_bits;
    const int64_t guess = leading + spec::reciprocal_rom(d, static_cast<int>(i));
    guesses[entries + i] = guess << (working_bits - rom_bits - 1);
  }
}

HWY_EXPORT(set_up_lanes);

void set_up(const SetupLanes& lanes, const TriangleGroup& triangles, size_t count, uint32_t counted,
            PrimGroup* prims, std::array<uint64_t, core::kDropCauses>* drops) {
  HWY_DYNAMIC_DISPATCH(set_up_lanes)(lanes, triangles, count, counted, prims, drops);
}

}  // namespace pineda::fast
#endif
