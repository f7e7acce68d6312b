// Every bit of setup, of every design, against a plain definition in 128-bit integers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "model/core/reciprocal.h"
#include "tests/core/hard_triangles.h"

namespace pineda::test {
namespace {

using core::Drop;
using spec::int128_t;

/// Faults planted in the definition, which the comparison must catch.
enum class Fault {
  kNone,
  kHalvesDown,      // gradients round halves down
  kNarrowProduct,   // numerator by mantissa in 61 bits
  kBiasAfterShift,  // of edges
  kInclusiveBox,
  kFirstVertexFirst,
};

int128_t floor_div(int128_t value, int128_t by) {
  const int128_t quotient = value / by;
  return value % by < 0 ? quotient - 1 : quotient;
}

// The definition of setup: a triangle in canonical order and its derived values.
struct Definition {
  const spec::Contract& c;
  const spec::FrameState& frame;
  const spec::Triangle& t;
  Fault fault;
  std::array<const spec::Vertex*, 3> v{};
  int128_t area2 = 0;  // in the scene's vertex order, positive when clockwise
  std::array<int, 4> box{};
  int64_t x = 0;  // the first sample of the box's first tile, subpixels
  int64_t y = 0;

  Definition(const spec::Contract& contract, const spec::FrameState& state,
             const spec::Triangle& triangle, Fault f)
      : c(contract), frame(state), t(triangle), fault(f) {
    v = {&t.v[0], &t.v[1], &t.v[2]};
    area2 = cross(*v[0], *v[1], *v[2]);
    if (fault != Fault::kFirstVertexFirst) {
      std::sort(v.begin(), v.end(), [](const auto* a, const auto* b) {
        return std::pair(a->y, a->x) < std::pair(b->y, b->x);
      });
    }
    if (cross(*v[0], *v[1], *v[2]) < 0) std::swap(v[1], v[2]);
  }

  static int128_t cross(const spec::Vertex& a, const spec::Vertex& b, const spec::Vertex& d) {
    return int128_t{b.x - a.x} * (d.y - a.y) - int128_t{d.x - a.x} * (b.y - a.y);
  }

  int px() const { return 1 << c.design.subpixel_bits; }

  // Pixels whose centre is in [low, high).
  std::pair<int, int> centres(int low, int high) const {
    const auto ceil_of = [&](int at) {
      return -static_cast<int>(floor_div(-(int128_t{at} - px() / 2), px()));
    };
    return {ceil_of(low), ceil_of(high) - (fault == Fault::kInclusiveBox ? 0 : 1)};
  }

  Drop drop() {
    if (area2 == 0) return Drop::kZeroArea;
    if (frame.cull == (area2 > 0 ? spec::Cull::kBack : spec::Cull::kFront)) return Drop::kFacing;
    const auto xs = std::minmax({t.v[0].x, t.v[1].x, t.v[2].x});
    const auto ys = std::minmax({t.v[0].y, t.v[1].y, t.v[2].y});
    const auto [x0, x1] = centres(xs.first, xs.second);
    const auto [y0, y1] = centres(ys.first, ys.second);
    if (x0 > x1 || y0 > y1) return Drop::kNoSample;
    box = {std::max(x0, frame.clip_x0()), std::max(y0, frame.clip_y0()),
           std::min(x1, frame.clip_x1() - 1), std::min(y1, frame.clip_y1() - 1)};
    if (box[0] > box[2] || box[1] > box[3]) return Drop::kOutside;
    const int tile_px = 1 << c.design.tile_log2;
    x = int64_t{box[0] / tile_px * tile_px} * px() + px() / 2;
    y = int64_t{box[1] / tile_px * tile_px} * px() + px() / 2;
    return Drop::kNone;
  }

  // Biased E of an edge at the first sample.
  int128_t biased(size_t i) const {
    const spec::Vertex& u = *v[i];
    const spec::Vertex& w = *v[(i + 1) % 3];
    const int128_t dx = w.x - u.x, dy = w.y - u.y;
    const bool top_left = dy < 0 || (dy == 0 && dx > 0);
    const int128_t e = dx * (y - u.y) - dy * (x - u.x);
    if (fault == Fault::kBiasAfterShift) return (floor_div(e, px()) - (top_left ? 0 : 1)) * px();
    return e - (top_left ? 0 : 1);
  }

  int128_t gradient(int128_t numerator, const core::Reciprocal& r, int fraction_bits) const {
    const spec::Design& d = c.design;
    const int shift = d.reciprocal_bits + r.length - 1 - d.gradient_fraction_bits -
                      d.subpixel_bits + fraction_bits;
    int128_t product = numerator * r.mantissa;
    if (fault == Fault::kNarrowProduct) product = spec::wrap(product, 61);
    const int128_t unit = int128_t{1} << shift;
    const int down = fault == Fault::kHalvesDown && shift > 0 ? 1 : 0;
    return floor_div(2 * product + unit - down, 2 * unit);
  }

  spec::Plane plane(const std::array<int64_t, 3>& value, int fraction_bits, int bits) const {
    const core::Reciprocal r =
        core::reciprocal(c, static_cast<int64_t>(area2 < 0 ? -area2 : area2));
    const int128_t d1 = value[1] - value[0], d2 = value[2] - value[0];
    const int128_t x1 = v[1]->x - v[0]->x, x2 = v[2]->x - v[0]->x;
    const int128_t y1 = v[1]->y - v[0]->y, y2 = v[2]->y - v[0]->y;
    const int128_t dx = gradient(d1 * y2 - d2 * y1, r, fraction_bits);
    const int128_t dy = gradient(d2 * x1 - d1 * x2, r, fraction_bits);
    const int128_t scale = int128_t{px()} << (c.design.gradient_fraction_bits - fraction_bits);
    const int128_t at_ref = value[0] * scale + dx * (x - v[0]->x) + dy * (y - v[0]->y);
    return {spec::wrap(dx, bits), spec::wrap(dy, bits),
            spec::wrap(floor_div(at_ref + px() / 2, px()), bits)};
  }

  // The attribute of the vertex or, with flat shading, of the scene's first vertex.
  int64_t attribute(size_t vertex, size_t i) const {
    return frame.shade == spec::Shade::kFlat ? t.v[0].attr[i] : v[vertex]->attr[i];
  }
};

bool same(const spec::Plane& a, const spec::Plane& b) {
  return a.dx == b.dx && a.dy == b.dy && a.ref == b.ref;
}

bool same_edges(const Definition& d, const spec::SetupPrim& prim) {
  bool equal = true;
  for (size_t i = 0; i < 3; ++i) {
    const spec::Vertex& u = *d.v[i];
    const spec::Vertex& w = *d.v[(i + 1) % 3];
    const int128_t biased = d.biased(i);
    equal &= prim.edge[i].a == u.y - w.y && prim.edge[i].b == w.x - u.x &&
             prim.edge[i].e == floor_div(biased, d.px());
    if (!d.c.design.perspective) continue;
    const spec::PerspectiveSet& p = prim.planes.perspective;
    equal &= p.e_low[i] == biased - floor_div(biased, d.px()) * d.px() &&
             p.inverse_w[i] == u.inverse_w && p.inverse_w_shift[i] == u.inverse_w_shift;
    for (size_t a = 0; a < static_cast<size_t>(d.c.design.attributes); ++a) {
      equal &= p.attr[i][a] == d.attribute(i, a);
    }
  }
  return equal;
}

bool same_values(const Definition& d, const spec::SetupPrim& prim) {
  const spec::Design& design = d.c.design;
  bool equal = true;
  for (size_t i = 0; i < static_cast<size_t>(design.flat_attributes); ++i) {
    equal &= prim.planes.flat[i] == d.t.v[0].attr[static_cast<size_t>(design.attributes) + i];
  }
  if (design.reciprocal_scheme == spec::ReciprocalScheme::kNone) return equal;
  if (design.depth_test) {
    const std::array<int64_t, 3> z{d.v[0]->z, d.v[1]->z, d.v[2]->z};
    equal &= same(prim.planes.z, d.plane(z, spec::kDepthInputFractionBits, d.c.width.depth_plane));
  }
  if (design.perspective) return equal;
  for (size_t i = 0; i < static_cast<size_t>(design.attributes); ++i) {
    const std::array<int64_t, 3> value{d.attribute(0, i), d.attribute(1, i), d.attribute(2, i)};
    equal &= same(prim.planes.attr[i], d.plane(value, 0, d.c.width.attr_plane));
  }
  return equal;
}

struct Comparison {
  std::array<int, core::kDropCauses> drops{};
  int different = 0;
};

Comparison compare(const spec::Design& design, int triangles, Fault fault = Fault::kNone) {
  const spec::Contract c = spec::contract(design);
  Random random(91);
  Comparison result;
  for (int n = 0; n < triangles; ++n) {
    const spec::FrameState frame = hard_frame(random, design);
    const spec::Triangle t = hard_triangle(random, design);
    Definition definition(c, frame, t, fault);
    spec::SetupPrim prim;
    const Drop drop = core::setup(c, frame, t, &prim);
    ++result.drops[static_cast<size_t>(drop)];
    bool equal = drop == definition.drop();
    if (equal && drop == Drop::kNone) {
      equal = std::array{prim.x0, prim.y0, prim.x1, prim.y1} == definition.box &&
              same_edges(definition, prim) && same_values(definition, prim);
    }
    result.different += equal ? 0 : 1;
  }
  return result;
}

TEST(SetupBits, EqualThePlainDefinitionInEveryDesign) {
  std::vector<spec::Design> all = spec::designs();
  for (const spec::Design& d : limit_designs()) {
    ASSERT_EQ(spec::invalid_reason(d), "") << d.name;
    all.push_back(d);
  }
  for (const spec::Design& d : all) {
    const Comparison result = compare(d, 8000);
    EXPECT_EQ(result.different, 0) << d.name;
    for (const int drops : result.drops) EXPECT_GT(drops, 50) << d.name;
    EXPECT_GT(result.drops[0], 2000) << d.name;
  }
}

TEST(SetupBits, MutantsOfTheDefinitionAreCaught) {
  for (const Fault fault : {Fault::kHalvesDown, Fault::kNarrowProduct, Fault::kBiasAfterShift,
                            Fault::kInclusiveBox, Fault::kFirstVertexFirst}) {
    EXPECT_GT(compare(spec::kHighTile, 8000, fault).different, 5) << static_cast<int>(fault);
  }
}

}  // namespace
}  // namespace pineda::test
