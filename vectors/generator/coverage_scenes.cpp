// Hard cases of coverage: which samples belong to a triangle.
#include "vectors/generator/draw.h"

namespace pineda::vectors {
namespace {

// 2 x 2 quads, their corners moved by up to `jitter` subpixels and put on multiples of `lattice`.
// Every sample inside must be hit exactly once.
void mesh(Draw& d, int64_t jitter, int64_t lattice) {
  const int64_t spacing = d.random().between(3, 4) * d.px() + d.half();
  const auto corner = [&](int i, int j) {
    const Point p{i * spacing + d.half(), j * spacing + d.half()};
    return lattice * (d.near(p, jitter) / lattice);
  };
  d.frame(10, 10);
  for (const auto& quad : figures::mesh(2, 2, corner)) {
    for (const Corners& half : figures::halves(quad, d.random().coin())) d.add(half);
  }
}
void mesh_jittered(Draw& d) { mesh(d, d.px() * 4 / 5, 1); }
void mesh_half_pixel(Draw& d) { mesh(d, d.px() * 4 / 5, d.half()); }

// A vertex on the snapped middle of a neighbour's edge: the crack is legal, and exact.
void t_junction(Draw& d) {
  d.frame(12, 12);
  const Point a = d.point(1, 1, 5, 4), b = d.point(7, 8, 11, 11);
  const Point split = d.point(0, 8, 4, 11), whole = d.point(8, 0, 11, 4);
  for (const Corners& t : figures::TJunction{a, b, whole, split}.triangles()) d.add(t);
}

// A ring of triangles around a sample: the sample is hit exactly once.
void fan(Draw& d) {
  static const std::vector<Point> kDirections{{1, 0},  {2, 1},   {1, 2},  {-1, 1},
                                              {-2, 0}, {-1, -2}, {0, -1}, {1, -1}};
  d.frame(11, 11);
  const Point apex = d.center(5, 5);
  const auto ring = figures::ring(d, apex, kDirections, d.half() / 2, 2 * d.px());
  // In every other scene the middle lies at most a subpixel off the sample.
  const Point middle = d.index() % 2 == 0 ? apex : d.near(apex, 1);
  for (const Corners& triangle : figures::fan(middle, ring)) d.add(triangle);
}

// Slivers of doubled area 1 to 6 units through a sample: they must draw what they cover.
void slivers(Draw& d, int64_t reach) {
  d.frame(12, 12);
  for (int i = 0; i < 8; ++i) {
    const Point along = figures::coprime(d, reach);
    const Point sample = d.any_center(2, 9);
    const int e1 = d.random().between(-2, 2);
    d.add(figures::sliver(sample, along, e1, d.random().between(-2, 2)));
  }
}
void sliver(Draw& d) { slivers(d, 5 * d.px()); }
void sliver_long(Draw& d) { slivers(d, d.reach(5000)); }

// Zero area after snapping, between triangles that are drawn.
void zero_area(Draw& d) {
  d.frame(10, 10);
  const Point p = d.point(1, 1, 8, 8), step = d.near({0, 0}, d.px());
  d.add(figures::point(p));
  d.add({d.point(0, 0, 9, 3), d.point(0, 5, 4, 9), d.point(6, 5, 9, 9)});
  d.add(figures::doubled(p, d.point(0, 0, 9, 9)));
  d.add(figures::line(p, step));
  d.add({d.center(1, 4), d.center(8, 4), d.center(5, 4)});
  d.add({d.center(1, 1), d.center(8, 1), d.center(5, 8)});
}

// All vertices on the half-pixel lattice: edges run through sample centres.
void through_centers(Draw& d) {
  d.frame(9, 9);
  const auto lattice = [&] {
    return Point{d.random().between(0, 17) * d.half(), d.random().between(0, 17) * d.half()};
  };
  for (int i = 0; i < 4; ++i) d.add({lattice(), lattice(), lattice()});
}

// Horizontal and vertical edges through centres: two triangles fill a rectangle.
void axis_aligned(Draw& d) {
  d.frame(10, 10);
  const int64_t offset = d.index() % 3 == 0 ? 1 : 0;  // or one subpixel off
  const Point a = d.any_center(0, 3);
  const Point c = d.any_center(4, 8) + Point{offset, -offset};
  for (const Corners& half : figures::halves(figures::rectangle(a, c), true)) d.add(half);
}

// The greatest (and the least) vertex lies exactly on a centre: right and bottom are exclusive.
void box_on_center(Draw& d) {
  d.frame(8, 8);
  for (int i = 0; i < 3; ++i) {
    const Point low = d.any_center(0, 3);
    const Point high = d.any_center(4, 6);
    const auto x = [&] { return d.random().between(low.x, high.x); };
    const auto y = [&] { return d.random().between(low.y, high.y); };
    d.add({Point{low.x, y()}, Point{high.x, y()}, Point{x(), i == 0 ? low.y : high.y}});
  }
}

// Three of the four corners of the guard band, in all orders; the frame is a small window.
void huge_corners(Draw& d) {
  d.frame(5, 4);
  const auto left_out = static_cast<size_t>(d.index()) % 4;
  const Corners corner = figures::three_of(figures::guard_band(d), left_out + 1);
  for (size_t first = 0; first < 3; ++first) {
    std::array<spec::Vertex, 3> v;
    for (size_t i = 0; i < 3; ++i) v[i] = d.vertex(corner[(first + i) % 3]);
    d.add_ordered(v);
    std::swap(v[1], v[2]);
    d.add_ordered(v);
  }
}

// Huge triangles whose edges pass through a small window.
void huge_window(Draw& d) {
  d.frame(7, 7);
  for (int i = 0; i < 3; ++i) {
    const int64_t reach = d.reach(8000);
    const Point q = d.point(1, 1, 6, 6), along = d.in_box({-reach, -reach}, {reach, reach});
    d.add(figures::through(q, along, d.point(-16384, -16384, 16384, 16384)));
  }
}

// The frame is as large as the guard band, so that the box uses all of its bits.
void huge_frame(Draw& d) {
  const int side = 1 << d.contract().design.guard_bits;
  d.frame(side, side);
  const auto coordinate = [&] {
    return d.random().coin() ? d.greatest() : d.random().between(0, 99);
  };
  for (int i = 0; i < 3; ++i) {
    d.add({Point{coordinate(), coordinate()}, Point{coordinate(), coordinate()},
           d.point(-side, -side, side, side)});
  }
}

// Frames that cut stamps and tiles, with triangles over the right and bottom border.
void odd_frame(Draw& d) {
  const int side = 1 << d.contract().design.guard_bits;
  const std::array<std::array<int, 2>, 10> sizes{{{1, 1},
                                                  {1, 7},
                                                  {9, 1},
                                                  {3, 5},
                                                  {13, 7},
                                                  {15, 9},
                                                  {641, 479},
                                                  {side, 1},
                                                  {1, side},
                                                  {side, side}}};
  const auto& size = sizes[static_cast<size_t>(d.index()) % sizes.size()];
  const int width = size[0];
  const int height = size[1];
  d.frame(width, height);
  for (int i = 0; i < 4; ++i) {
    const Point corner = d.px() * Point{width, height};
    d.add(figures::within(d, corner - d.px() * Point{4, 4}, corner + d.px() * Point{3, 3}));
  }
}

// Triangles that hang over each border, and triangles wholly beyond it.
void outside(Draw& d) {
  d.frame(8, 6);
  static constexpr std::array<Point, 8> kSides{
      {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
  for (const Point side : kSides) {
    const Point p{4 + 5 * side.x, 3 + 4 * side.y};  // px, about the middle
    d.add(figures::around(d, d.px() * p, (d.random().coin() ? 1 : 3) * d.px()));
  }
}

// Boxes that hold no sample: between centres, and just short of one.
void no_sample(Draw& d) {
  d.frame(6, 6);
  for (int i = 0; i < 4; ++i) {
    const Point sample = d.any_center(1, 4);
    d.add(figures::between_samples(d, sample));
  }
  d.add({d.center(1, 1), d.center(4, 1), d.center(2, 5)});
}

// Vertices in the corners of tiles: no stamp is lost or sent twice.
void tile_corner(Draw& d) {
  d.frame(20, 20);
  const auto corner = [&] {
    const Point p{d.random().between(0, 2) * d.tile(), d.random().between(0, 2) * d.tile()};
    const int64_t radius = d.random().coin() ? 1 : d.half();
    return d.near(p, radius);
  };
  for (int i = 0; i < 2; ++i) d.add({corner(), corner(), corner()});
}

// Edges along tile borders, on them and half a pixel to either side.
void tile_border(Draw& d) {
  d.frame(18, 18);
  const auto border = [&](int64_t n) { return figures::tile_border(d, n); };
  const Point a{border(1), d.random().between(0, 2 * d.tile())}, b{a.x, border(2)};
  d.add({a, b, Point{border(2), border(1)}});
  d.add({a, b, Point{border(0), border(1)}});
}

// 100 to 8000 px long, 1/16 to 2 px wide.
void needle(Draw& d) {
  d.frame(24, 8);
  const int64_t longest =
      std::min<int64_t>(8000, int64_t{1} << (d.contract().design.guard_bits - 1));
  for (int i = 0; i < 3; ++i) {
    const int64_t length =
        d.random().between(std::min<int64_t>(100, longest / 2), longest) * d.px();
    const int64_t across = d.random().between(-length, length);
    const bool is_steep = d.random().coin();
    const int64_t width = d.random().between(d.px() / 16, 2 * d.px());
    const figures::Needle needle{length, across, width, is_steep};
    d.add(needle.from(d.point(2, 1, 22, 7) - needle.along() / 8));
  }
}

// Areas of .01 to 16 px^2.
void micro(Draw& d) {
  d.frame(8, 8);
  for (int i = 0; i < 12; ++i) {
    const Point p = d.point(1, 1, 7, 7);
    const int64_t reach = d.random().between(1, 20) * d.px() / 8;
    d.add(figures::around(d, p, reach));
  }
}

// Both windings under each cull state.
void cull(Draw& d) {
  d.frame(7, 7);
  d.scene().frame.cull = static_cast<spec::Cull>(d.index() % 3);
  for (int i = 0; i < 3; ++i) {
    std::array<spec::Vertex, 3> v{d.vertex(d.point(0, 0, 7, 7)), d.vertex(d.point(0, 0, 7, 7)),
                                  d.vertex(d.point(0, 0, 7, 7))};
    d.add_ordered(v);
    std::swap(v[0], v[2]);
    d.add_ordered(v);
  }
}

}  // namespace

std::vector<SceneClass> coverage_classes() {
  return {{"mesh_jittered", 6, mesh_jittered},
          {"mesh_half_pixel", 6, mesh_half_pixel},
          {"t_junction", 4, t_junction},
          {"fan", 4, fan},
          {"sliver", 6, sliver},
          {"sliver_long", 6, sliver_long},
          {"zero_area", 3, zero_area},
          {"through_centers", 8, through_centers},
          {"axis_aligned", 6, axis_aligned},
          {"box_on_center", 6, box_on_center},
          {"huge_corners", 8, huge_corners},
          {"huge_window", 6, huge_window},
          {"huge_frame", 6, huge_frame},
          {"odd_frame", 20, odd_frame},
          {"outside", 4, outside},
          {"no_sample", 3, no_sample},
          {"tile_corner", 6, tile_corner},
          {"tile_border", 6, tile_border},
          {"needle", 8, needle},
          {"micro", 6, micro},
          {"cull", 6, cull}};
}

}  // namespace pineda::vectors
