#include "model/core/setup.h"

#include <algorithm>

#include "model/core/lanes.h"

namespace pineda::core {

using spec::Contract;
using spec::FrameState;
using spec::int128_t;
using spec::Plane;
using spec::round_half_up;
using spec::SetupPrim;
using spec::Triangle;
using spec::Vertex;
using spec::wrap;

namespace {

// Doubled area, positive when clockwise on screen (y points down).
int64_t doubled_area(const Triangle& t) {
  const auto& v = t.v;
  return (int64_t{v[1].x} - v[0].x) * (int64_t{v[2].y} - v[0].y) -
         (int64_t{v[2].x} - v[0].x) * (int64_t{v[1].y} - v[0].y);
}

// Pixels whose centres lie in [low, high): the right and bottom borders are exclusive, since no
// sample on them can be on a top or left edge only.
struct Range {
  int first;
  int last;
};
Range samples(int low, int high, int subpixel_bits) {
  const int half = 1 << (subpixel_bits - 1);
  return {(low + half - 1) >> subpixel_bits, (high - half - 1) >> subpixel_bits};
}

// The box of samples, clipped to the frame.
Drop clip_box(const Contract& c, const FrameState& frame, const Triangle& t, SetupPrim* prim) {
  const auto [x_low, x_high] = std::minmax({t.v[0].x, t.v[1].x, t.v[2].x});
  const auto [y_low, y_high] = std::minmax({t.v[0].y, t.v[1].y, t.v[2].y});
  const Range x = samples(x_low, x_high, c.design.subpixel_bits);
  const Range y = samples(y_low, y_high, c.design.subpixel_bits);
  if (x.first > x.last || y.first > y.last) return Drop::kNoSample;
  prim->x0 = std::max(x.first, frame.clip_x0());
  prim->y0 = std::max(y.first, frame.clip_y0());
  prim->x1 = std::min(x.last, frame.clip_x1() - 1);
  prim->y1 = std::min(y.last, frame.clip_y1() - 1);
  return prim->x0 > prim->x1 || prim->y0 > prim->y1 ? Drop::kOutside : Drop::kNone;
}

// Index of the topmost, then leftmost vertex: the anchor of the planes. Anchoring there makes the
// codes independent of the order in which the vertices came.
size_t anchor(const Triangle& t) {
  size_t best = 0;
  for (size_t i = 1; i < 3; ++i) {
    const bool higher = t.v[i].y < t.v[best].y;
    const bool level = t.v[i].y == t.v[best].y;
    if (higher || (level && t.v[i].x < t.v[best].x)) best = i;
  }
  return best;
}

// E of the edge u -> w at (x, y), biased so that inside means >= 0.
int64_t biased_edge(const Vertex& u, const Vertex& w, int64_t x, int64_t y) {
  const int64_t dx = int64_t{w.x} - u.x;
  const int64_t dy = int64_t{w.y} - u.y;
  const bool top_left = dy < 0 || (dy == 0 && dx > 0);
  return -dy * (x - u.x) + dx * (y - u.y) - (top_left ? 0 : 1);
}

// The same in steps of whole pixels, and what that cuts off.
spec::EdgeFunction edge_function(const Contract& c, const Vertex& u, const Vertex& w, int64_t x,
                                 int64_t y) {
  // The bias comes before the shift: the other way round leaves holes on shared edges.
  return {int64_t{u.y} - w.y, int64_t{w.x} - u.x,
          biased_edge(u, w, x, y) >> c.design.subpixel_bits};
}
int32_t edge_low(const Contract& c, const Vertex& u, const Vertex& w, int64_t x, int64_t y) {
  return static_cast<int32_t>(biased_edge(u, w, x, y) &
                              ((int64_t{1} << c.design.subpixel_bits) - 1));
}

// In canonical order.
using Vertices = std::array<const Vertex*, 3>;
using VertexAttributes = std::array<const spec::Attributes*, 3>;

// What the planes of one triangle share.
struct PlaneSetup {
  Reciprocal reciprocal;
  std::array<int64_t, 2> dx;  // vertices 1 and 2 from the anchor, subpixels
  std::array<int64_t, 2> dy;
  int64_t ref_x;  // first sample from the anchor, subpixels
  int64_t ref_y;
};

// gradient * area2 in units of 2^-(S + fraction of the values), in x and y.
template <class Integer>
struct Numerators {
  Integer x;
  Integer y;
};
template <class Integer>
Numerators<Integer> numerators(const PlaneSetup& s, const std::array<int64_t, 3>& value) {
  const Integer d1 = value[1] - value[0];
  const Integer d2 = value[2] - value[0];
  return {d1 * s.dy[1] - d2 * s.dy[0], d2 * s.dx[0] - d1 * s.dx[1]};
}

// What numerator * mantissa is shifted by to be numerator * 2^(S - fraction_bits) / area2 in units
// of 2^-f.
int gradient_shift(const Contract& c, const Reciprocal& reciprocal, int fraction_bits, int f) {
  return c.design.reciprocal_bits + reciprocal.length - 1 - f - c.design.subpixel_bits +
         fraction_bits;
}
int128_t gradient(const Contract& c, const Reciprocal& reciprocal, int128_t numerator,
                  int fraction_bits, int f) {
  return round_half_up(numerator * reciprocal.mantissa,
                       gradient_shift(c, reciprocal, fraction_bits, f));
}

// Plane through (0, value[0]) at the anchor and the two other vertices; values have
// `fraction_bits`, the plane has F and wraps at `bits`.
template <class Integer>
Plane plane(const Contract& c, const PlaneSetup& s, const std::array<int64_t, 3>& value,
            int fraction_bits, int bits) {
  const int f = c.design.gradient_fraction_bits;
  const int subpixel_bits = c.design.subpixel_bits;
  const auto n = numerators<Integer>(s, value);
  // The reference has up to 92 bits, which wrap only in the end. Of them bits + S <= 66 matter; the
  // two that are more than 64 with 32 bits of depth and 12 subpixel bits need the wide sum.
  const int128_t dx = gradient(c, s.reciprocal, n.x, fraction_bits, f);
  const int128_t dy = gradient(c, s.reciprocal, n.y, fraction_bits, f);
  Plane p;
  p.dx = wrap(dx, bits);
  p.dy = wrap(dy, bits);
  const int scale = f - fraction_bits + subpixel_bits;
  if (bits + subpixel_bits <= 64) {
    const auto at_ref = static_cast<uint64_t>(value[0]) * (uint64_t{1} << scale) +
                        static_cast<uint64_t>(dx) * static_cast<uint64_t>(s.ref_x) +
                        static_cast<uint64_t>(dy) * static_cast<uint64_t>(s.ref_y) +
                        (uint64_t{1} << (subpixel_bits - 1));
    p.ref = wrap(static_cast<int64_t>(at_ref) >> subpixel_bits, bits);
  } else {
    const int128_t at_ref =
        int128_t{value[0]} * (int128_t{1} << scale) + dx * s.ref_x + dy * s.ref_y;
    p.ref = wrap(round_half_up(at_ref, subpixel_bits), bits);
  }
  return p;
}

// Whether 64 bits hold all of a gradient of an attribute before it wraps, and what the reference
// needs; length <= 2 * span.
bool has_narrow_attributes(const Contract& c) {
  const Reciprocal longest{0, c.width.area2 - 1};
  return c.width.attr_numerator + c.design.reciprocal_bits <= 62 &&
         gradient_shift(c, longest, 0, c.design.gradient_fraction_bits) <= 62 &&
         c.width.attr_plane + c.design.subpixel_bits <= 64;
}

PINEDA_INLINE void wrap_each(int bits, Int64x4* v) {
  *v = reinterpret_cast<Int64x4>(reinterpret_cast<Uint64x4>(*v) << (64 - bits)) >> (64 - bits);
}

// plane() of all attributes of such a design, four at a time.
PINEDA_CLONES void narrow_planes(const Contract& c, const PlaneSetup& s,
                                 const VertexAttributes& attr,
                                 std::array<Plane, spec::kMaxAttributes>* planes) {
  const int f = c.design.gradient_fraction_bits;
  const int subpixel_bits = c.design.subpixel_bits;
  const int bits = c.width.attr_plane;
  const int shift = gradient_shift(c, s.reciprocal, 0, f);
  const int64_t half = shift == 0 ? 0 : int64_t{1} << (shift - 1);
  const auto n = static_cast<size_t>(c.design.attributes);
  for (size_t i = 0; i < n; i += 4) {
    std::array<Int64x4, 3> value;
    for (size_t v = 0; v < 3; ++v) {
      Int32x4 narrow;
      std::memcpy(&narrow, attr[v]->data() + i, sizeof narrow);
      value[v] = __builtin_convertvector(narrow, Int64x4);
    }
    const Int64x4 d1 = value[1] - value[0], d2 = value[2] - value[0];
    Int64x4 dx = ((d1 * s.dy[1] - d2 * s.dy[0]) * s.reciprocal.mantissa + half) >> shift;
    Int64x4 dy = ((d2 * s.dx[0] - d1 * s.dx[1]) * s.reciprocal.mantissa + half) >> shift;
    // The reference may wrap on the way.
    const auto at_ref = (reinterpret_cast<Uint64x4>(value[0]) << (f + subpixel_bits)) +
                        reinterpret_cast<Uint64x4>(dx) * static_cast<uint64_t>(s.ref_x) +
                        reinterpret_cast<Uint64x4>(dy) * static_cast<uint64_t>(s.ref_y) +
                        (uint64_t{1} << (subpixel_bits - 1));
    Int64x4 ref = reinterpret_cast<Int64x4>(at_ref) >> subpixel_bits;
    wrap_each(bits, &dx);
    wrap_each(bits, &dy);
    wrap_each(bits, &ref);
    for (size_t j = 0; j < std::min<size_t>(4, n - i); ++j) {
      (*planes)[i + j] = {dx[j], dy[j], ref[j]};
    }
  }
}

// max(|dz/dx|, |dz/dy|) in units of 2^-8 codes/px, saturated.
int128_t depth_magnitude(const Contract& c, const PlaneSetup& s, const std::array<int64_t, 3>& z) {
  const auto n = numerators<int128_t>(s, z);
  const int128_t limit = int128_t{1} << (c.width.bias_magnitude - 1);
  const auto magnitude = [&](int128_t numerator) {
    const int128_t g = gradient(c, s.reciprocal, numerator, spec::kDepthInputFractionBits,
                                spec::kBiasFactorFractionBits);
    return g < 0 ? std::min(-g, limit) : std::min(g, limit - 1);
  };
  return std::max(magnitude(n.x), magnitude(n.y));
}

// The bias of a triangle's depth, in units of 2^-16 codes.
int64_t depth_bias(const Contract& c, const FrameState& frame, int128_t magnitude) {
  const int128_t bias =
      int128_t{frame.bias_constant} * (1 << spec::kBiasFractionBits) + frame.bias_slope * magnitude;
  const int128_t greatest = (int128_t{1} << (c.width.depth_bias - 1)) - 1;
  return static_cast<int64_t>(std::clamp(bias, -greatest - 1, greatest));
}

spec::PerspectiveSet perspective_set(const Contract& c, const Vertices& v,
                                     const VertexAttributes& attr, int64_t x, int64_t y) {
  spec::PerspectiveSet p;
  for (size_t i = 0; i < 3; ++i) {
    p.e_low[i] = edge_low(c, *v[i], *v[(i + 1) % 3], x, y);
    p.inverse_w[i] = v[i]->inverse_w;
    p.inverse_w_shift[i] = v[i]->inverse_w_shift;
    std::copy_n(attr[i]->begin(), c.design.attributes, p.attr[i].begin());
  }
  return p;
}

// Planes of depth and of affine attributes.
void make_planes(const Contract& c, const FrameState& frame, const Vertices& v,
                 const VertexAttributes& attr, const PlaneSetup& s, Planes wanted,
                 spec::PlaneSet* set) {
  if (c.design.depth_test) {
    const std::array<int64_t, 3> z{v[0]->z, v[1]->z, v[2]->z};
    const auto of = c.width.depth_numerator < 64 ? plane<int64_t> : plane<int128_t>;
    set->z = of(c, s, z, spec::kDepthInputFractionBits, c.width.depth_plane);
    if (frame.has_bias() || c.design.hierarchical_z) {
      const int128_t magnitude = depth_magnitude(c, s, z);
      set->z_bias = depth_bias(c, frame, magnitude);
      set->z_steep = c.design.hierarchical_z && magnitude >> steep_log2(c.design) != 0;
    }
  }
  if (wanted != Planes::kAll || c.design.perspective) return;
  if (has_narrow_attributes(c)) return narrow_planes(c, s, attr, &set->attr);
  for (size_t i = 0; i < static_cast<size_t>(c.design.attributes); ++i) {
    set->attr[i] =
        plane<int64_t>(c, s, {(*attr[0])[i], (*attr[1])[i], (*attr[2])[i]}, 0, c.width.attr_plane);
  }
}

}  // namespace

const char* drop_name(Drop drop) {
  static constexpr const char* kNames[kDropCauses] = {"", "zero area", "facing", "no sample",
                                                      "outside"};
  return kNames[static_cast<int>(drop)];
}

Drop setup(const Contract& c, const FrameState& frame, const Triangle& triangle, SetupPrim* out,
           Planes planes) {
  int64_t area2 = doubled_area(triangle);
  if (area2 == 0) return Drop::kZeroArea;
  if ((frame.cull == spec::Cull::kBack && area2 > 0) ||
      (frame.cull == spec::Cull::kFront && area2 < 0)) {
    return Drop::kFacing;
  }
  SetupPrim& prim = *out;
  if (const Drop drop = clip_box(c, frame, triangle, &prim); drop != Drop::kNone) return drop;

  // Canonical order: the anchor first, then clockwise.
  const size_t first = anchor(triangle);
  const bool clockwise = area2 > 0;
  const Vertices v{&triangle.v[first], &triangle.v[(first + (clockwise ? 1 : 2)) % 3],
                   &triangle.v[(first + (clockwise ? 2 : 1)) % 3]};
  if (!clockwise) area2 = -area2;

  const int tile = c.design.tile_log2;
  const int s = c.design.subpixel_bits;
  const int64_t half = int64_t{1} << (s - 1);
  const int64_t x = (int64_t{prim.x0 >> tile} << (tile + s)) + half;
  const int64_t y = (int64_t{prim.y0 >> tile} << (tile + s)) + half;
  prim.id = triangle.id;
  for (size_t i = 0; i < 3; ++i) {
    prim.edge[i] = edge_function(c, *v[i], *v[(i + 1) % 3], x, y);
  }
  if (planes == Planes::kNone) return Drop::kNone;

  // Of each vertex in canonical order, or of the one that gives its own to all.
  const bool flat = frame.shade == spec::Shade::kFlat;
  VertexAttributes attr;
  for (size_t i = 0; i < 3; ++i) attr[i] = flat ? &triangle.v[0].attr : &v[i]->attr;
  std::copy_n(triangle.v[0].attr.begin() + c.design.attributes, c.design.flat_attributes,
              prim.planes.flat.begin());
  if (c.design.perspective && planes == Planes::kAll)
    prim.planes.perspective = perspective_set(c, v, attr, x, y);
  if (c.design.reciprocal_scheme == spec::ReciprocalScheme::kNone ||
      spec::plane_count(c.design) == 0) {
    return Drop::kNone;
  }

  const PlaneSetup shared{reciprocal(c, area2),
                          {int64_t{v[1]->x} - v[0]->x, int64_t{v[2]->x} - v[0]->x},
                          {int64_t{v[1]->y} - v[0]->y, int64_t{v[2]->y} - v[0]->y},
                          x - v[0]->x,
                          y - v[0]->y};
  make_planes(c, frame, v, attr, shared, planes, &prim.planes);
  return Drop::kNone;
}

}  // namespace pineda::core
