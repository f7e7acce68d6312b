#include "model/core/setup.h"

#include <algorithm>

#include "model/core/planes.h"

namespace pineda::core {

using spec::Contract;
using spec::FrameState;
using spec::SetupPrim;
using spec::Triangle;
using spec::Vertex;

namespace {

// Doubled area, positive when clockwise on screen (y points down).
int64_t doubled_area(const Triangle& t) {
  const auto& v = t.v;
  return (int64_t{v[1].x} - v[0].x) * (int64_t{v[2].y} - v[0].y) -
         (int64_t{v[2].x} - v[0].x) * (int64_t{v[1].y} - v[0].y);
}

bool is_culled(const FrameState& frame, int64_t area2) {
  return frame.cull == (area2 > 0 ? spec::Cull::kBack : spec::Cull::kFront);
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

// The box of samples, clipped to the frame and the scissor.
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

// Canonical order: clockwise from the topmost, then leftmost vertex, the anchor of the planes.
// Anchoring there makes the codes independent of the order in which the vertices came.
using Vertices = std::array<const Vertex*, 3>;
Vertices canonical(const Triangle& t, bool clockwise) {
  size_t first = 0;
  for (size_t i = 1; i < 3; ++i) {
    const bool higher = t.v[i].y < t.v[first].y;
    const bool level = t.v[i].y == t.v[first].y;
    if (higher || (level && t.v[i].x < t.v[first].x)) first = i;
  }
  const size_t second = (first + (clockwise ? 1 : 2)) % 3;
  return {&t.v[first], &t.v[second], &t.v[3 - first - second]};
}

// E of the edge u -> w at (x, y), biased so that inside means >= 0.
int64_t biased_edge(const Vertex& u, const Vertex& w, int64_t x, int64_t y) {
  const int64_t dx = int64_t{w.x} - u.x;
  const int64_t dy = int64_t{w.y} - u.y;
  const bool top_left = dy < 0 || (dy == 0 && dx > 0);
  return dx * (y - u.y) - dy * (x - u.x) - (top_left ? 0 : 1);
}

// Sets up all that depth and attributes are computed from. x, y: the reference sample, subpixels.
void set_up_values(const Contract& c, const FrameState& frame, const Triangle& t, const Vertices& v,
                   int64_t area2, int64_t x, int64_t y, spec::PlaneSet* set) {
  const spec::Design& d = c.design;
  const auto attributes = static_cast<size_t>(d.attributes);
  std::copy_n(t.v[0].attr.begin() + d.attributes, d.flat_attributes, set->flat.begin());
  // The vertices that attributes are taken from.
  const bool flat = frame.shade == spec::Shade::kFlat;
  const Vertices painted = flat ? Vertices{&t.v[0], &t.v[0], &t.v[0]} : v;
  if (d.perspective) {
    spec::PerspectiveSet& p = set->perspective;
    for (size_t i = 0; i < 3; ++i) {
      p.e_low[i] = static_cast<int32_t>(biased_edge(*v[i], *v[(i + 1) % 3], x, y) &
                                        ((int64_t{1} << d.subpixel_bits) - 1));
      p.inverse_w[i] = v[i]->inverse_w;
      p.inverse_w_shift[i] = v[i]->inverse_w_shift;
      std::copy_n(painted[i]->attr.begin(), attributes, p.attr[i].begin());
    }
  }
  if (d.reciprocal_scheme == spec::ReciprocalScheme::kNone || spec::plane_count(d) == 0) return;
  const PlaneSetup planes{reciprocal(c, area2),
                          {int64_t{v[1]->x} - v[0]->x, int64_t{v[2]->x} - v[0]->x},
                          {int64_t{v[1]->y} - v[0]->y, int64_t{v[2]->y} - v[0]->y},
                          x - v[0]->x,
                          y - v[0]->y};
  if (d.depth_test) {
    const std::array<int64_t, 3> z{v[0]->z, v[1]->z, v[2]->z};
    set->z = plane(c, planes, z, spec::kDepthInputFractionBits, c.width.depth_plane);
    const int64_t magnitude = depth_magnitude(c, planes, z);
    set->z_bias = depth_bias(c, frame, magnitude);
    set->z_steep = d.hierarchical_z && magnitude >> spec::steep_log2(d) != 0;
  }
  if (d.perspective) return;
  for (size_t i = 0; i < attributes; ++i) {
    const std::array<int64_t, 3> value{painted[0]->attr[i], painted[1]->attr[i],
                                       painted[2]->attr[i]};
    set->attr[i] = plane(c, planes, value, 0, c.width.attr_plane);
  }
}

}  // namespace

Drop setup(const Contract& c, const FrameState& frame, const Triangle& t, SetupPrim* out) {
  const int64_t area2 = doubled_area(t);
  if (area2 == 0) return Drop::kZeroArea;
  if (is_culled(frame, area2)) return Drop::kFacing;
  SetupPrim prim;
  if (const Drop drop = clip_box(c, frame, t, &prim); drop != Drop::kNone) return drop;

  const int tile = c.design.tile_log2;
  const int s = c.design.subpixel_bits;
  const int64_t half = int64_t{1} << (s - 1);
  const int64_t x = (int64_t{prim.x0 >> tile} << (tile + s)) + half;
  const int64_t y = (int64_t{prim.y0 >> tile} << (tile + s)) + half;
  const Vertices v = canonical(t, area2 > 0);
  prim.id = t.id;
  for (size_t i = 0; i < 3; ++i) {
    const Vertex& from = *v[i];
    const Vertex& to = *v[(i + 1) % 3];
    // E' only needs steps of whole pixels. The bias must be applied before the shift: after it,
    // samples on shared edges would be lost.
    prim.edge[i] = {int64_t{from.y} - to.y, int64_t{to.x} - from.x,
                    biased_edge(from, to, x, y) >> s};
  }
  set_up_values(c, frame, t, v, area2 < 0 ? -area2 : area2, x, y, &prim.planes);
  *out = prim;
  return Drop::kNone;
}

}  // namespace pineda::core
