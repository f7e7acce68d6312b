// Hard cases of values and of order: depth, attributes, the depth test, stamps back to back.
#include <algorithm>

#include "vectors/generator/draw.h"

namespace pineda::vectors {
namespace {

using spec::DepthFunc;
using spec::Vertex;

DepthFunc less_or_lequal(const Draw& d) {
  return d.index() % 2 == 0 ? DepthFunc::kLess : DepthFunc::kLequal;
}

Vertex with_depth(Vertex v, int64_t z) {
  v.z = z;
  return v;
}

// Depths and attributes 0 or greatest in all combinations, on triangles of a few pixels: the
// steepest planes that a scene can ask for.
void value_extremes(Draw& d) {
  d.frame(7, 7);
  for (int i = 0; i < 8; ++i) {
    std::array<Vertex, 3> v;
    for (int k = 0; k < 3; ++k) {
      Vertex& vertex = v[static_cast<size_t>(k)];
      vertex = d.vertex(d.point(0, 0, 7, 7));
      vertex.z = (i >> k & 1) != 0 ? d.far() : 0;
      // In every other scene the attributes run against the depth.
      const bool high = ((i >> k & 1) != 0) == (d.index() % 2 == 0);
      std::fill_n(vertex.attr.begin(), d.contract().design.attributes, high ? d.full() : 0);
    }
    d.add_ordered(v);
  }
}

// Coordinates that are the formats' extremes or lie next to zero, in all sign combinations.
void format_extremes(Draw& d) {
  d.frame(4, 4);
  const auto corner = [&](int quadrant) {
    const Vertex v = d.vertex(figures::extreme_corner(d, quadrant));
    return with_depth(v, d.random().coin() ? d.far() : 0);
  };
  for (int i = 0; i < 6; ++i) d.add_shuffled({corner(i), corner(i + 1), corner(i + 2)});
  for (auto& triangle : d.scene().triangles) triangle.id += 0xfffffff0u;  // the greatest numbers
}

// A plane in whole steps a subpixel: z = base + gx*x + gy*y exactly, so a triangle inside another
// one has the same depth everywhere.
void coplanar(Draw& d) {
  d.frame(10, 10);
  d.scene().frame.depth = less_or_lequal(d);
  const int64_t limit = d.far() / (40 * d.px());
  const int64_t gx = d.random().between(-limit, limit), gy = d.random().between(-limit, limit);
  const figures::WholePlane plane{d.far() / 2, gx, gy};
  const auto on_plane = [&](Point p) { return with_depth(d.vertex(p), plane.at(p)); };
  const auto [a, b, c] = figures::right_angle({0, 0}, 10 * d.px());
  d.add_shuffled({on_plane(a), on_plane(b), on_plane(c)});
  for (int i = 0; i < 3; ++i) {
    d.add_shuffled({on_plane(d.point(0, 0, 5, 5)), on_plane(d.point(0, 0, 5, 5)),
                    on_plane(d.point(0, 0, 5, 5))});
  }
}

// The same triangle three times, its vertices in another order each time: less keeps the first,
// lequal the last, and depth is the same to the bit.
void equal_depth(Draw& d) {
  d.frame(8, 8);
  d.scene().frame.depth = less_or_lequal(d);
  const std::array<Vertex, 3> v{d.vertex(d.point(0, 0, 8, 3)), d.vertex(d.point(0, 5, 3, 8)),
                                d.vertex(d.point(5, 4, 8, 8))};
  for (size_t turn = 0; turn < 3; ++turn) {
    std::array<Vertex, 3> again;
    for (size_t i = 0; i < 3; ++i) {
      again[i] = v[(turn + i) % 3];
      again[i].attr = d.vertex({}).attr;
    }
    d.add_ordered(again);
  }
}

// Constant depths around the greatest code, to which memory is cleared, and around 0.
void depth_limits(Draw& d) {
  d.frame(6, 6);
  d.scene().frame.depth = less_or_lequal(d);
  constexpr int64_t kCode = int64_t{1} << spec::kDepthInputFractionBits;
  for (const int64_t z :
       {d.far(), d.far() - kCode / 2, d.far() - kCode, kCode, kCode / 2, int64_t{0}}) {
    const auto vertex = [&] { return with_depth(d.vertex(d.point(0, 0, 6, 6)), z); };
    d.add_shuffled({vertex(), vertex(), vertex()});
  }
}

// Triangle after triangle on the same stamp: each must see what the one before wrote. Depths are
// few, so that many are equal.
void back_to_back(Draw& d) {
  d.frame(6, 6);
  d.scene().frame.depth = less_or_lequal(d);
  for (int i = 0; i < 16; ++i) {
    const int64_t z = d.random().between(1, 4) * d.far() / 5;
    const auto vertex = [&] { return with_depth(d.vertex(d.point(1, 1, 5, 5)), z); };
    d.add_shuffled({vertex(), vertex(), vertex()});
  }
}

// Triangles inside one stamp, on one to eight addresses in turn: a stamp meets the write of the
// one before, of the second before, and so on.
void alternating(Draw& d) {
  constexpr int kAddresses = 8;
  d.scene().frame.depth = d.index() / kAddresses % 2 == 0 ? DepthFunc::kLess : DepthFunc::kLequal;
  const int64_t width = int64_t{1} << d.contract().design.stamp_width_log2;
  const int64_t height = int64_t{1} << d.contract().design.stamp_height_log2;
  d.frame(static_cast<int>(kAddresses * width), 4);
  const int addresses = 1 + d.index() % kAddresses;
  for (int i = 0; i < 24; ++i) {
    const int64_t x = width * (i % addresses), z = d.random().between(0, 3) * (d.far() / 3);
    const auto in_stamp = [&] { return with_depth(d.vertex(d.point(x, 0, x + width, height)), z); };
    d.add_shuffled({in_stamp(), in_stamp(), in_stamp()});
  }
}

// Planes that cut through each other: both win somewhere.
void intersecting(Draw& d) {
  d.frame(9, 9);
  d.scene().frame.depth = less_or_lequal(d);
  for (int i = 0; i < 3; ++i) {
    d.add({d.point(0, 0, 9, 2), d.point(0, 6, 3, 9), d.point(6, 6, 9, 9)});
  }
}

// No test and no depth write: the last triangle wins.
void depth_off(Draw& d) {
  d.frame(8, 8);
  d.scene().frame.depth = DepthFunc::kOff;
  d.scene().frame.cull = static_cast<spec::Cull>(d.index() % 3);
  for (int i = 0; i < 4; ++i)
    d.add({d.point(0, 0, 8, 8), d.point(0, 0, 8, 8), d.point(0, 0, 8, 8)});
}

// Samples in the middle of two vertices of equal 1/w whose attributes differ by an odd number: half-way
// between two codes, where the last bit of a weight decides.
void midpoint(Draw& d) {
  d.frame(12, 12);
  for (int i = 0; i < 6; ++i) {
    const Point middle = d.any_center(3, 8);
    const Point step = d.px() * Point{d.random().between(-2, 2), d.random().between(1, 3)};
    std::array<Vertex, 3> v{d.vertex(middle + step), d.vertex(middle - step),
                            d.vertex(d.point(0, 0, 12, 12))};
    for (size_t k = 0; k < 3; ++k) {
      v[k].inverse_w = v[0].inverse_w;
      v[k].inverse_w_shift = v[0].inverse_w_shift;
    }
    for (size_t a = 0; a < static_cast<size_t>(d.contract().design.attributes); ++a) {
      const int32_t low = d.random().between(0, d.full() - 1);
      v[0].attr[a] = low;
      v[1].attr[a] = low + 1 + 2 * d.random().between(0, (d.full() - low - 1) / 2);
    }
    d.add_shuffled(v);
  }
}

}  // namespace

std::vector<SceneClass> value_classes() {
  return {{"value_extremes", 8, value_extremes},
          {"format_extremes", 10, format_extremes},
          {"coplanar", 6, coplanar},
          {"equal_depth", 6, equal_depth},
          {"depth_limits", 4, depth_limits},
          {"back_to_back", 6, back_to_back},
          {"alternating", 16, alternating},
          {"intersecting", 6, intersecting},
          {"midpoint", 6, midpoint},
          {"depth_off", 3, depth_off}};
}

}  // namespace pineda::vectors
