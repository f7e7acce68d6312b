#include "studies/numerics/bound_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/core/setup.h"
#include "model/core/traversal.h"
#include "model/judge/exact_terms.h"

namespace pineda::studies {
namespace {

/// The ranges of a design's coordinates and depths, and its greatest frame.
struct Range {
  explicit Range(const spec::Contract& c)
      : px(1 << c.design.subpixel_bits),
        high((1 << (c.width.coord - 1)) - 1),
        low(-high - 1),
        depth(((int64_t{1} << c.design.depth_bits) - 1) << spec::kDepthInputFractionBits),
        frame_px(1 << c.design.guard_bits) {}
  int px;    // subpixels per pixel
  int high;  // greatest coordinate
  int low;
  int64_t depth;  // greatest z of a vertex
  int frame_px;

  spec::FrameState frame() const { return {frame_px, frame_px}; }
};

// The planes at the first sample of a pixel's tile, as traversal hands them on. Jumps to that tile
// instead of walking: steps of whole tiles are exact modulo the planes' widths.
std::optional<spec::PlaneSet> planes_at(const spec::Contract& c, const spec::Triangle& t, int x,
                                        int y) {
  spec::SetupPrim prim;
  if (core::setup(c, Range(c).frame(), t, &prim) != core::Drop::kNone) return std::nullopt;
  const int log2 = c.design.tile_log2;
  if (x > prim.x1 || y > prim.y1) return std::nullopt;
  const int64_t columns = int64_t{(x >> log2) - (prim.x0 >> log2)} << log2;
  const int64_t rows = int64_t{(y >> log2) - (prim.y0 >> log2)} << log2;
  if (columns < 0 || rows < 0) return std::nullopt;
  prim.x0 = x >> log2 << log2;
  prim.y0 = y >> log2 << log2;
  for (auto& edge : prim.edge) edge.e += edge.a * columns + edge.b * rows;
  const auto jump = [&](spec::Plane* plane, int bits) {
    plane->ref = spec::wrap(plane->ref + plane->dx * columns + plane->dy * rows, bits);
  };
  jump(&prim.planes.z, c.width.depth_plane);
  jump(&prim.planes.attr[0], c.width.attr_plane);
  core::TileWalk walk(c, prim);
  core::Tile tile;
  if (walk.next(&tile) != core::TileWalk::Test::kKept) return std::nullopt;
  return tile.planes;
}

WorstCase start(Random& random, const Range& r) {
  const int reach = r.frame_px / 80 * r.px;
  const auto near = [&](int corner) {
    return std::clamp(corner + random.between(-reach, reach), r.low, r.high);
  };
  const Point first{near(r.low), near(r.low)};
  const Point far{near(r.high), near(r.high)};
  const Point third{near(random.between(0, 1) != 0 ? 0 : r.high), near(r.high)};
  WorstCase at;
  at.triangle = triangle(first, far, third);
  // The last sample of a tile.
  at.x = r.frame_px - 1 - 8 * random.between(0, 6);
  at.y = r.frame_px - 1 - 8 * random.between(0, 6);
  // Values run from one end of the range at the anchor to the other end at the other vertices, so
  // that the reciprocal's error counts in full.
  const bool up = random.between(0, 1) != 0;
  for (size_t i = 0; i < 3; ++i) {
    const bool top = (i != 0) == up;
    at.triangle.v[i].z = top ? r.depth : 0;
    at.triangle.v[i].attr[0] = top ? 255 : 0;
  }
  return at;
}

int64_t nudged(Random& random, int64_t value, int most_log2, int64_t low, int64_t high) {
  const int64_t reach = int64_t{1} << random.between(0, most_log2);
  return std::clamp(value + random.between(-reach, reach), low, high);
}

WorstCase changed(Random& random, const Range& r, WorstCase at, Value value) {
  auto& v = at.triangle.v[static_cast<size_t>(random.between(0, 2))];
  switch (random.between(0, 2)) {
    case 0:
      v.x = static_cast<int32_t>(nudged(random, v.x, 14, r.low, r.high));
      break;
    case 1:
      v.y = static_cast<int32_t>(nudged(random, v.y, 14, r.low, r.high));
      break;
    default:
      if (value == Value::kDepth) {
        v.z = nudged(random, v.z, 31, 0, r.depth);
      } else {
        v.attr[0] = static_cast<int32_t>(nudged(random, v.attr[0], 7, 0, 255));
      }
  }
  return at;
}

}  // namespace

double error_before_rounding(const spec::Contract& c, Value value, const spec::Triangle& t, int x,
                             int y) {
  const exact::Judge exact = judge::exact_judge(c.design, Range(c).frame(), t);
  if (exact.culled() || !exact.covers(x, y)) return -1;
  const auto planes = planes_at(c, t, x, y);
  if (!planes) return -1;
  const bool depth = value == Value::kDepth;
  const spec::Plane& plane = depth ? planes->z : planes->attr[0];
  const int mask = (1 << c.design.tile_log2) - 1;
  const int64_t sum = spec::wrap(plane.ref + (x & mask) * plane.dx + (y & mask) * plane.dy,
                                 depth ? c.width.depth_tile_plane : c.width.attr_tile_plane);
  const int f = c.design.tile_fraction_bits;
  const int64_t code = sum >> f;
  const double fraction = std::ldexp(static_cast<double>(sum & ((int64_t{1} << f) - 1)), -f);
  const double error = depth ? exact.depth_error(x, y, code) : exact.attribute_error(x, y, 0, code);
  return std::abs(error + fraction);
}

WorstCase search_worst(const spec::Contract& contract, Value value, int starts, int steps,
                       uint64_t seed) {
  Random random(seed);
  const Range range(contract);
  WorstCase best;
  for (int s = 0; s < starts; ++s) {
    WorstCase at = start(random, range);
    at.error = error_before_rounding(contract, value, at.triangle, at.x, at.y);
    for (int n = 0; n < steps; ++n) {
      WorstCase next = changed(random, range, at, value);
      next.error = error_before_rounding(contract, value, next.triangle, next.x, next.y);
      if (next.error > at.error) at = next;
    }
    if (at.error > best.error) best = at;
  }
  return best;
}

}  // namespace pineda::studies
