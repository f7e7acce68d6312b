#include "model/core/setup.h"

#include <algorithm>

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
  if (x.last < 0 || y.last < 0 || x.first >= frame.width || y.first >= frame.height) {
    return Drop::kOutside;
  }
  prim->x0 = std::max(x.first, 0);
  prim->y0 = std::max(y.first, 0);
  prim->x1 = std::min(x.last, frame.width - 1);
  prim->y1 = std::min(y.last, frame.height - 1);
  return Drop::kNone;
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

// Edge u -> w at the sample (x, y), biased so that inside means >= 0, in steps of whole pixels.
spec::EdgeFunction edge_function(const Contract& c, const Vertex& u, const Vertex& w, int64_t x,
                                 int64_t y) {
  const int64_t dx = int64_t{w.x} - u.x;
  const int64_t dy = int64_t{w.y} - u.y;
  const bool top_left = dy < 0 || (dy == 0 && dx > 0);
  const int64_t e = -dy * (x - u.x) + dx * (y - u.y);
  // The bias comes before the shift: the other way round leaves holes on shared edges.
  return {-dy, dx, (e - (top_left ? 0 : 1)) >> c.design.subpixel_bits};
}

// What the planes of one triangle share.
struct PlaneSetup {
  Reciprocal reciprocal;
  std::array<int64_t, 2> dx;  // vertices 1 and 2 from the anchor, subpixels
  std::array<int64_t, 2> dy;
  int64_t ref_x;  // first sample from the anchor, subpixels
  int64_t ref_y;
};

// Plane through (0, value[0]) at the anchor and the two other vertices; values have
// `fraction_bits`, the plane has F and wraps at `bits`.
Plane plane(const Contract& c, const PlaneSetup& s, const std::array<int64_t, 3>& value,
            int fraction_bits, int bits) {
  const int f = c.design.gradient_fraction_bits;
  const int subpixel_bits = c.design.subpixel_bits;
  const int64_t d1 = value[1] - value[0];
  const int64_t d2 = value[2] - value[0];
  const int64_t numerator_x = d1 * s.dy[1] - d2 * s.dy[0];
  const int64_t numerator_y = d2 * s.dx[0] - d1 * s.dx[1];
  // gradient = numerator * 2^(S - fraction) / area2, in units of 2^-F.
  const int shift =
      c.design.reciprocal_bits + s.reciprocal.length - 1 - f - subpixel_bits + fraction_bits;
  // The reference lies a fraction of a pixel from the anchor, so there the gradients need S more
  // high bits before they wrap; steps of whole pixels need no more than the plane's own width.
  const auto gradient = [&](int64_t numerator) {
    return wrap(round_half_up(int128_t{numerator} * s.reciprocal.mantissa, shift),
                bits + subpixel_bits);
  };
  const int64_t dx = gradient(numerator_x);
  const int64_t dy = gradient(numerator_y);
  const int128_t at_ref = (int128_t{value[0]} << (f - fraction_bits + subpixel_bits)) +
                          int128_t{dx} * s.ref_x + int128_t{dy} * s.ref_y;
  Plane p;
  p.dx = wrap(dx, bits);
  p.dy = wrap(dy, bits);
  p.ref = wrap(round_half_up(at_ref, subpixel_bits), bits);
  return p;
}

}  // namespace

const char* drop_name(Drop drop) {
  static constexpr const char* kNames[kDropCauses] = {"", "zero area", "facing", "no sample",
                                                      "outside"};
  return kNames[static_cast<int>(drop)];
}

Drop setup(const Contract& c, const FrameState& frame, const Triangle& triangle, SetupPrim* out) {
  int64_t area2 = doubled_area(triangle);
  if (area2 == 0) return Drop::kZeroArea;
  if ((frame.cull == spec::Cull::kBack && area2 > 0) ||
      (frame.cull == spec::Cull::kFront && area2 < 0)) {
    return Drop::kFacing;
  }
  SetupPrim prim;
  if (const Drop drop = clip_box(c, frame, triangle, &prim); drop != Drop::kNone) return drop;

  // Canonical order: the anchor first, then clockwise.
  const size_t first = anchor(triangle);
  const bool clockwise = area2 > 0;
  const std::array<const Vertex*, 3> v{&triangle.v[first],
                                       &triangle.v[(first + (clockwise ? 1 : 2)) % 3],
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

  if (c.design.reciprocal_scheme == spec::ReciprocalScheme::kNone) {
    *out = prim;
    return Drop::kNone;
  }
  const PlaneSetup planes{reciprocal(c, area2),
                          {int64_t{v[1]->x} - v[0]->x, int64_t{v[2]->x} - v[0]->x},
                          {int64_t{v[1]->y} - v[0]->y, int64_t{v[2]->y} - v[0]->y},
                          x - v[0]->x,
                          y - v[0]->y};
  prim.planes.z = plane(c, planes, {v[0]->z, v[1]->z, v[2]->z}, spec::kDepthInputFractionBits,
                        c.width.depth_plane);
  for (size_t i = 0; i < static_cast<size_t>(c.design.attributes); ++i) {
    prim.planes.attr[i] =
        plane(c, planes, {v[0]->attr[i], v[1]->attr[i], v[2]->attr[i]}, 0, c.width.attr_plane);
  }
  *out = prim;
  return Drop::kNone;
}

}  // namespace pineda::core
