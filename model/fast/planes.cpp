#include "model/fast/planes.h"

#include "model/fast/lanes.h"

namespace pineda::fast {

using spec::Contract;
using spec::FrameState;
using spec::int128_t;
using spec::Plane;
using spec::wrap;

namespace {

constexpr int kWordBits = 64;

// gradient * area2 in units of 2^-(S + fraction of the values), in x and y.
struct Numerators {
  int64_t x;
  int64_t y;
};
PINEDA_INLINE Numerators numerators(const PlaneSetup& s, const std::array<int64_t, 3>& value) {
  const int64_t d1 = value[1] - value[0];
  const int64_t d2 = value[2] - value[0];
  return {d1 * s.dy[1] - d2 * s.dy[0], d2 * s.dx[0] - d1 * s.dx[1]};
}

// The right shift that turns numerator * mantissa into numerator * 2^(S - fraction_bits) / area2 in
// units of 2^-f.
PINEDA_INLINE int gradient_shift(const Contract& c, int length, int fraction_bits, int f) {
  return c.design.reciprocal_bits + length - 1 - f - c.design.subpixel_bits + fraction_bits;
}

// Does word_plane() give the bits of core::plane()? It does if a numerator fits a word, and so do
// the significant bits of a gradient, with one more fraction bit, and of a reference before its
// shift.
PINEDA_INLINE bool has_word_planes(const Contract& c, int numerator, int fraction_bits, int bits) {
  const int longest = c.width.area2 - 1;
  return numerator <= kWordBits && bits + c.design.subpixel_bits < kWordBits &&
         gradient_shift(c, longest, fraction_bits, c.design.gradient_fraction_bits) < kWordBits;
}

// core::plane() for such a design, without branches. Rounding keeps one more fraction bit and adds
// 1 to it: (2v / 2^shift + 1) / 2, both divisions rounding down, which is right for a shift of 0,
// too.
PINEDA_INLINE Plane word_plane(const Contract& c, const PlaneSetup& s,
                               const std::array<int64_t, 3>& value, int fraction_bits, int bits) {
  const int f = c.design.gradient_fraction_bits;
  const int subpixel_bits = c.design.subpixel_bits;
  const int shift = gradient_shift(c, s.reciprocal.length, fraction_bits, f) & (kWordBits - 1);
  const auto n = numerators(s, value);
  const int64_t twice = 2 * s.reciprocal.mantissa;
  const auto gradient_of = [&](int64_t numerator) PINEDA_INLINED {
    const int128_t product = int128_t{numerator} * twice;
    return static_cast<int64_t>(static_cast<uint64_t>(product >> shift) + 1) >> 1;
  };
  const int64_t dx = gradient_of(n.x);
  const int64_t dy = gradient_of(n.y);
  const uint64_t at_ref = (static_cast<uint64_t>(value[0]) << (f - fraction_bits + subpixel_bits)) +
                          static_cast<uint64_t>(dx) * static_cast<uint64_t>(s.ref_x) +
                          static_cast<uint64_t>(dy) * static_cast<uint64_t>(s.ref_y) +
                          (uint64_t{1} << (subpixel_bits - 1));
  return {wrap(dx, bits), wrap(dy, bits),
          wrap(static_cast<int64_t>(at_ref) >> subpixel_bits, bits)};
}

// Widens to signed words. (For __builtin_convertvector GCC takes three instructions, not two.)
PINEDA_INLINE void widen(const Uint32x4& v, Int64x4* out) {
  const Uint32x8 twice = __builtin_shufflevector(v, v, 0, 0, 1, 1, 2, 2, 3, 3);
  *out = reinterpret_cast<Int64x4>(twice) >> 32;
}

// Drops the low `fraction_bits` and sign-extends the `bits` bits above them.
PINEDA_INLINE void wrap_each(const Uint64x4& v, int bits, int fraction_bits, Int64x4* out) {
  const int above = kWordBits - bits;
  const Uint64x4 raised = v << (above - fraction_bits);
  *out = reinterpret_cast<Int64x4>(raised) >> above;
}

// Stores four planes, given as a vector each of gradients and references. In memory they are dx0
// dy0 ref0 dx1 | dy1 ref1 dx2 dy2 | ref2 dx3 dy3 ref3.
PINEDA_INLINE void store_planes(const Int64x4& dx, const Int64x4& dy, const Int64x4& ref,
                                Plane* planes) {
  static_assert(sizeof(Plane) == 3 * sizeof(int64_t));
  const Int64x4 even = __builtin_shufflevector(dx, dy, 0, 4, 2, 6);   // dx0 dy0 dx2 dy2
  const Int64x4 odd = __builtin_shufflevector(dy, ref, 1, 5, 3, 7);   // dy1 ref1 dy3 ref3
  const Int64x4 rest = __builtin_shufflevector(ref, dx, 0, 5, 2, 7);  // ref0 dx1 ref2 dx3
  const Int64x4 row0 = __builtin_shufflevector(even, rest, 0, 1, 4, 5);
  const Int64x4 row1 = __builtin_shufflevector(odd, even, 0, 1, 6, 7);
  const Int64x4 row2 = __builtin_shufflevector(rest, odd, 2, 3, 6, 7);
  auto* const to = reinterpret_cast<unsigned char*>(planes);
  std::memcpy(to, &row0, sizeof row0);
  std::memcpy(to + sizeof row0, &row1, sizeof row1);
  std::memcpy(to + 2 * sizeof row0, &row2, sizeof row2);
}

// word_plane() for all attributes of a design that has narrow ones, four at a time. A numerator's
// differences and products may wrap at 32 bits, since their sum fits.
PINEDA_INLINE void narrow_planes(const Contract& c, const PlaneSetup& s,
                                 std::array<Plane, spec::kMaxAttributes>* planes) {
  static_assert(spec::kMaxAttributes % 4 == 0);
  const int f = c.design.gradient_fraction_bits;
  const int subpixel_bits = c.design.subpixel_bits;
  const int bits = c.width.attr_plane;
  const int shift = gradient_shift(c, s.reciprocal.length, 0, f);
  const auto x1 = static_cast<uint32_t>(s.dx[0]), x2 = static_cast<uint32_t>(s.dx[1]);
  const auto y1 = static_cast<uint32_t>(s.dy[0]), y2 = static_cast<uint32_t>(s.dy[1]);
  const auto gradients = [&](const Uint32x4& numerator, Int64x4* out) PINEDA_INLINED {
    Int64x4 wide;
    widen(numerator, &wide);
    *out = ((wide * (2 * s.reciprocal.mantissa) >> shift) + 1) >> 1;
  };
  for (size_t i = 0; i < static_cast<size_t>(c.design.attributes); i += 4) {
    std::array<Uint32x4, 3> value;
    for (size_t v = 0; v < 3; ++v) {
      std::memcpy(&value[v], s.painted[v]->attr.data() + i, sizeof value[v]);
    }
    const Uint32x4 d1 = value[1] - value[0], d2 = value[2] - value[0];
    Int64x4 dx, dy;
    gradients(d1 * y2 - d2 * y1, &dx);
    gradients(d2 * x1 - d1 * x2, &dy);
    Int64x4 at_anchor;
    widen(value[0], &at_anchor);
    // The terms may wrap at 64 bits: only the low bits of the sum are kept.
    const Uint64x4 at_ref = (reinterpret_cast<Uint64x4>(at_anchor) << (f + subpixel_bits)) +
                            reinterpret_cast<Uint64x4>(dx) * static_cast<uint64_t>(s.ref_x) +
                            reinterpret_cast<Uint64x4>(dy) * static_cast<uint64_t>(s.ref_y) +
                            (uint64_t{1} << (subpixel_bits - 1));
    Int64x4 ref;
    wrap_each(at_ref, bits, subpixel_bits, &ref);
    wrap_each(reinterpret_cast<Uint64x4>(dx), bits, 0, &dx);
    wrap_each(reinterpret_cast<Uint64x4>(dy), bits, 0, &dy);
    store_planes(dx, dy, ref, planes->data() + i);
  }
}

// For other designs, one attribute at a time.
[[gnu::noinline]] void wide_planes(const Contract& c, const PlaneSetup& s,
                                   std::array<Plane, spec::kMaxAttributes>* planes) {
  const int bits = c.width.attr_plane;
  const bool words = has_word_planes(c, c.width.attr_numerator, 0, bits);
  for (size_t i = 0; i < static_cast<size_t>(c.design.attributes); ++i) {
    const std::array<int64_t, 3> value{s.painted[0]->attr[i], s.painted[1]->attr[i],
                                       s.painted[2]->attr[i]};
    (*planes)[i] = words ? word_plane(c, s, value, 0, bits) : core::plane(c, s, value, 0, bits);
  }
}

PINEDA_INLINE std::array<int64_t, 3> depths(const PlaneSetup& s) {
  return {s.v[0]->z, s.v[1]->z, s.v[2]->z};
}

// Without vectors: with depths of 24 bits, numerator * mantissa has 86 bits.
PINEDA_INLINE Plane depth_plane(const Contract& c, const PlaneSetup& s) {
  const int fraction_bits = spec::kDepthInputFractionBits;
  const int bits = c.width.depth_plane;
  if (has_word_planes(c, c.width.depth_numerator, fraction_bits, bits)) {
    return word_plane(c, s, depths(s), fraction_bits, bits);
  }
  return core::plane(c, s, depths(s), fraction_bits, bits);
}

[[gnu::noinline]] void set_depth_bias(const Contract& c, const FrameState& frame,
                                      const PlaneSetup& s, spec::PlaneSet* set) {
  const int64_t magnitude = core::depth_magnitude(c, s, depths(s));
  set->z_bias = core::depth_bias(c, frame, magnitude);
  set->z_steep = c.design.hierarchical_z && magnitude >> spec::steep_log2(c.design) != 0;
}

}  // namespace

bool has_narrow_attributes(const Contract& c) {
  // The numerator fits half a word, its product with twice the mantissa a word.
  return has_word_planes(c, c.width.attr_numerator, 0, c.width.attr_plane) &&
         c.width.attr_numerator <= kWordBits / 2 &&
         c.width.attr_numerator + 1 + c.design.reciprocal_bits <= kWordBits;
}

PINEDA_KERNEL(void, make_planes,
              (const Contract& c, const FrameState& frame, const PlaneSetup& s, Planes wanted,
               spec::PlaneSet* set),
              (c, frame, s, wanted, set)) {
  if (c.design.depth_test) {
    set->z = depth_plane(c, s);
    if (frame.has_bias() || c.design.hierarchical_z) set_depth_bias(c, frame, s, set);
  }
  if (wanted != Planes::kAll || c.design.perspective) return;
  if (has_narrow_attributes(c)) {
    narrow_planes(c, s, &set->attr);
  } else {
    wide_planes(c, s, &set->attr);
  }
}

}  // namespace pineda::fast
