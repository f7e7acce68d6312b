#include "model/fast/setup.h"

#include <algorithm>
#include <cstddef>

#include "model/fast/lanes.h"
#include "model/fast/planes.h"
#include "model/fast/reciprocal.h"

namespace pineda::fast {

using core::Drop;
using spec::Contract;
using spec::FrameState;
using spec::SetupPrim;
using spec::Triangle;
using spec::Vertex;

// What depends on the triangle is branch-free: a processor cannot predict which vertex is topmost,
// or why a triangle is dropped.
namespace {

// A triangle's second and third vertex from its first, in subpixels.
struct Differences {
  int64_t x1, y1, x2, y2;
};
PINEDA_INLINE Differences differences(const Vertex& a, const Vertex& b, const Vertex& c) {
  return {int64_t{b.x} - a.x, int64_t{b.y} - a.y, int64_t{c.x} - a.x, int64_t{c.y} - a.y};
}

// Doubled area, positive when clockwise on screen (y points down).
PINEDA_INLINE int64_t doubled_area(const Differences& d) { return d.x1 * d.y2 - d.x2 * d.y1; }

// 1 or 0.
PINEDA_INLINE unsigned is_negative(int64_t value) {
  return static_cast<unsigned>(static_cast<uint64_t>(value) >> 63);
}

// Is a triangle with an area culled? Cull::kBack is bit 0, for area2 > 0, Cull::kFront is bit 1.
PINEDA_INLINE bool is_culled(const FrameState& frame, int64_t area2) {
  static_assert(static_cast<int>(spec::Cull::kBack) == 1);
  static_assert(static_cast<int>(spec::Cull::kFront) == 2);
  return (static_cast<unsigned>(frame.cull) >> is_negative(area2) & 1) != 0;
}

// Boxes are vectors x0 y0 ~x1 ~y1: the box around two boxes is the least of each lane, their
// intersection is the greatest.
typedef int64_t Int64x2 __attribute__((vector_size(16)));
constexpr Int32x4 kComplement = {0, 0, -1, -1};
PINEDA_INLINE Int32x4 around(const Int32x4& a, const Int32x4& b) { return a < b ? a : b; }
PINEDA_INLINE Int32x4 common(const Int32x4& a, const Int32x4& b) { return a > b ? a : b; }

PINEDA_INLINE bool is_empty(const Int32x4& box) {
  const Int32x4 last = __builtin_shufflevector(~box, ~box, 2, 3, 2, 3);
  return reinterpret_cast<Int64x2>(box > last)[0] != 0;
}

// Loads two adjacent coordinates, twice.
PINEDA_INLINE Int32x4 load_twice(const int32_t* xy) {
  int64_t both;
  std::memcpy(&both, xy, sizeof both);
  return reinterpret_cast<Int32x4>(Int64x2{both, both});
}

PINEDA_INLINE Int32x4 point_box(const Vertex& v) {
  static_assert(offsetof(Vertex, y) == offsetof(Vertex, x) + sizeof v.x);
  return load_twice(&v.x) ^ kComplement;
}

// The pixels whose centres lie in a box of subpixels. The right and bottom borders are exclusive,
// since a sample on them is never on top or left edges only.
//   (x0 + half - 1) >> S,  (x1 - half - 1) >> S = ~((~x1 + half + 1) >> S)
PINEDA_INLINE Int32x4 sample_box(const Int32x4& box, int subpixel_bits) {
  const int half = 1 << (subpixel_bits - 1);
  return (box + half + Int32x4{-1, -1, 1, 1}) >> subpixel_bits;
}

// The scissor clipped to the frame; ~(x1 - 1) = -x1.
PINEDA_INLINE Int32x4 frame_box(const FrameState& frame) {
  static_assert(offsetof(FrameState, height) == offsetof(FrameState, width) + sizeof frame.width);
  static_assert(offsetof(FrameState, scissor_y1) ==
                offsetof(FrameState, scissor_x0) + 3 * sizeof frame.scissor_x0);
  Int32x4 scissor;
  std::memcpy(&scissor, &frame.scissor_x0, sizeof scissor);
  const Int32x4 size = load_twice(&frame.width);
  return ((scissor < size ? scissor : size) ^ kComplement) - kComplement;
}

[[gnu::noinline]] Drop first_cause(const FrameState& frame, int64_t area2, bool has_samples) {
  const int causes = int{area2 == 0} << static_cast<int>(Drop::kZeroArea) |
                     int{is_culled(frame, area2)} << static_cast<int>(Drop::kFacing) |
                     int{!has_samples} << static_cast<int>(Drop::kNoSample) |
                     1 << static_cast<int>(Drop::kOutside);
  return static_cast<Drop>(__builtin_ctz(static_cast<unsigned>(causes)));
}

// Writes the box of samples, clipped to the frame.
PINEDA_INLINE Drop clip_box(const Contract& c, const FrameState& frame, const Triangle& t,
                            int64_t area2, SetupPrim* prim) {
  const Int32x4 box = around(around(point_box(t.v[0]), point_box(t.v[1])), point_box(t.v[2]));
  const Int32x4 samples = sample_box(box, c.design.subpixel_bits);
  const Int32x4 clipped = common(samples, frame_box(frame));
  const Int32x4 corners = clipped ^ kComplement;
  static_assert(offsetof(SetupPrim, y1) == offsetof(SetupPrim, x0) + 3 * sizeof prim->x0);
  std::memcpy(&prim->x0, &corners, sizeof corners);
  const int dropped = int{area2 == 0} | int{is_culled(frame, area2)} | int{is_empty(clipped)};
  return __builtin_expect(dropped, 0) != 0 ? first_cause(frame, area2, !is_empty(samples))
                                           : Drop::kNone;
}

// Canonical order: clockwise from the topmost, then leftmost vertex, the anchor of the planes.
// Anchoring there makes the codes independent of the order in which the vertices came.
struct Order {
  std::array<uint16_t, 4> offset;  // of the vertices, in bytes; the last one is unused
};

// Indexed by four bits: vertex 1 is before 0, 2 before 0, 2 before 1; counter-clockwise.
constexpr std::array<Order, 16> make_orders() {
  constexpr unsigned kAnchor[8] = {0, 1, 2, 1, 0, 0, 2, 2};
  std::array<Order, 16> orders{};
  for (unsigned i = 0; i < 16; ++i) {
    const unsigned first = kAnchor[i % 8];
    const unsigned step = i < 8 ? 1 : 2;
    for (unsigned k = 0; k < 3; ++k) {
      orders[i].offset[k] = static_cast<uint16_t>(sizeof(Vertex) * ((first + k * step) % 3));
    }
  }
  return orders;
}
constexpr auto kOrders = make_orders();

using Vertices = std::array<const Vertex*, 3>;
PINEDA_INLINE Vertices canonical(const Triangle& t, const Differences& d, int64_t area2) {
  // Negative if the second of the two vertices comes before the first.
  const int64_t from_0_to_1 = d.y1 * (int64_t{1} << 32) + d.x1;
  const int64_t from_0_to_2 = d.y2 * (int64_t{1} << 32) + d.x2;
  const int64_t from_1_to_2 = from_0_to_2 - from_0_to_1;
  const Order& order = kOrders[is_negative(from_0_to_1) + 2 * is_negative(from_0_to_2) +
                               4 * is_negative(from_1_to_2) + 8 * is_negative(area2)];
  const auto vertex = [&](size_t i) PINEDA_INLINED {
    const auto* const bytes = reinterpret_cast<const unsigned char*>(t.v.data());
    return reinterpret_cast<const Vertex*>(bytes + order.offset[i]);
  };
  return {vertex(0), vertex(1), vertex(2)};
}

// E of each edge at (x, y), counted from the anchor, biased so that inside means >= 0: by 0 on a
// top or left edge, by -1 on others. The first edge goes down, or along the top; the second one may
// go up, the last one always does. At every point the three E add up to the doubled area.
PINEDA_INLINE std::array<int64_t, 3> biased_edges(const Differences& d, int64_t area2, int64_t x,
                                                  int64_t y) {
  const int64_t e0 = d.x1 * y - d.y1 * x;
  const int64_t e2 = d.y2 * x - d.x2 * y;
  return {e0 - int64_t{d.y1 > 0}, area2 - e0 - e2 - int64_t{d.y2 >= d.y1}, e2};
}

// Edge functions in steps of whole pixels. The bias is added before the shift: added after it there
// would be holes on shared edges.
PINEDA_INLINE void write_edges(const Differences& d, const std::array<int64_t, 3>& biased,
                               int subpixel_bits, std::array<spec::EdgeFunction, 3>* edge) {
  (*edge)[0] = {-d.y1, d.x1, biased[0] >> subpixel_bits};
  (*edge)[1] = {d.y1 - d.y2, d.x2 - d.x1, biased[1] >> subpixel_bits};
  (*edge)[2] = {d.y2, -d.x2, biased[2] >> subpixel_bits};
}

[[gnu::noinline]] void perspective_set(const Contract& c, const PlaneSetup& s,
                                       const std::array<int64_t, 3>& biased,
                                       spec::PerspectiveSet* set) {
  for (size_t i = 0; i < 3; ++i) {
    set->e_low[i] = static_cast<int32_t>(biased[i] & ((int64_t{1} << c.design.subpixel_bits) - 1));
    set->inverse_w[i] = s.v[i]->inverse_w;
    set->inverse_w_shift[i] = s.v[i]->inverse_w_shift;
    std::memcpy(&set->attr[i], &s.painted[i]->attr, sizeof set->attr[i]);
  }
}

// Sets up planes, weights and flat values. x, y: the first sample, counted from the anchor.
PINEDA_INLINE void set_up_values(const Contract& c, const FrameState& frame, const Triangle& t,
                                 const Vertices& v, const Differences& d, int64_t area2, int64_t x,
                                 int64_t y, Planes planes, spec::PlaneSet* set) {
  if (c.design.flat_attributes > 0) {
    std::copy_n(t.v[0].attr.begin() + c.design.attributes, c.design.flat_attributes,
                set->flat.begin());
  }
  PlaneSetup s;
  s.dx = {d.x1, d.x2};
  s.dy = {d.y1, d.y2};
  s.ref_x = x;
  s.ref_y = y;
  const bool flat = frame.shade == spec::Shade::kFlat;
  for (size_t i = 0; i < 3; ++i) {
    s.v[i] = v[i];
    s.painted[i] = flat ? t.v.data() : v[i];
  }
  if (c.design.perspective && planes == Planes::kAll) {
    perspective_set(c, s, biased_edges(d, area2, x, y), &set->perspective);
  }
  if (c.design.reciprocal_scheme == spec::ReciprocalScheme::kNone ||
      spec::plane_count(c.design) == 0) {
    return;
  }
  s.reciprocal = reciprocal(c, area2);
  make_planes(c, frame, s, planes, set);
}

}  // namespace

PINEDA_KERNEL(Drop, setup,
              (const Contract& c, const FrameState& frame, const Triangle& triangle, SetupPrim* out,
               Planes planes),
              (c, frame, triangle, out, planes)) {
  SetupPrim& prim = *out;
  const Differences from_first = differences(triangle.v[0], triangle.v[1], triangle.v[2]);
  const int64_t signed_area2 = doubled_area(from_first);
  if (const Drop drop = clip_box(c, frame, triangle, signed_area2, &prim); drop != Drop::kNone) {
    return drop;
  }
  const int tile = c.design.tile_log2;
  const int subpixel_bits = c.design.subpixel_bits;
  const int64_t half = int64_t{1} << (subpixel_bits - 1);
  const auto centre = [&](int px) PINEDA_INLINED {
    return (int64_t{px >> tile} << (tile + subpixel_bits)) + half;
  };
  const int64_t area2 = signed_area2 < 0 ? -signed_area2 : signed_area2;
  const auto v = canonical(triangle, from_first, signed_area2);
  const Differences d = differences(*v[0], *v[1], *v[2]);
  const int64_t x = centre(prim.x0) - v[0]->x;
  const int64_t y = centre(prim.y0) - v[0]->y;
  const auto biased = biased_edges(d, area2, x, y);
  prim.id = triangle.id;
  write_edges(d, biased, subpixel_bits, &prim.edge);
  if (planes != Planes::kNone) {
    set_up_values(c, frame, triangle, v, d, area2, x, y, planes, &prim.planes);
  }
  return Drop::kNone;
}

}  // namespace pineda::fast
