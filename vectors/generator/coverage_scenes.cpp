// Hard cases of coverage: which samples belong to a triangle.
#include <numeric>

#include "vectors/generator/draw.h"

namespace pineda::vectors {
namespace {

// A grid of 2 x 2 cells of two triangles each, vertices moved by up to `jitter` subpixels and put
// on multiples of `lattice`. Every sample inside must be hit exactly once.
void mesh(Draw& d, int64_t jitter, int64_t lattice) {
  constexpr int kCells = 2;
  const int64_t spacing = d.random().between(3, 4) * d.px() + d.half();
  std::array<std::array<Point, kCells + 1>, kCells + 1> at;
  for (int j = 0; j <= kCells; ++j) {
    for (int i = 0; i <= kCells; ++i) {
      const Point p = d.point_near({i * spacing + d.half(), j * spacing + d.half()}, jitter);
      at[static_cast<size_t>(j)][static_cast<size_t>(i)] = {p.x / lattice * lattice,
                                                            p.y / lattice * lattice};
    }
  }
  d.frame(10, 10);
  for (size_t j = 0; j < kCells; ++j) {
    for (size_t i = 0; i < kCells; ++i) {
      const Point a = at[j][i], b = at[j][i + 1], c = at[j + 1][i + 1], e = at[j + 1][i];
      if (d.random().coin()) {
        d.add({a, b, c});
        d.add({a, c, e});
      } else {
        d.add({a, b, e});
        d.add({b, c, e});
      }
    }
  }
}
void mesh_jittered(Draw& d) { mesh(d, d.px() * 4 / 5, 1); }
void mesh_half_pixel(Draw& d) { mesh(d, d.px() * 4 / 5, d.half()); }

// A vertex on the snapped middle of a neighbour's edge: the crack is legal, and exact.
void t_junction(Draw& d) {
  d.frame(12, 12);
  const Point a = d.point(1, 1, 5, 4), b = d.point(7, 8, 11, 11);
  const Point middle{(a.x + b.x) >> 1, (a.y + b.y) >> 1};
  const Point e = d.point(0, 8, 4, 11);
  d.add({a, b, d.point(8, 0, 11, 4)});
  d.add({a, middle, e});
  d.add({middle, b, e});
}

// A ring of triangles around a sample: the sample is hit exactly once.
void fan(Draw& d) {
  static constexpr std::array<Point, 8> kRing{
      {{1, 0}, {2, 1}, {1, 2}, {-1, 1}, {-2, 0}, {-1, -2}, {0, -1}, {1, -1}}};
  d.frame(11, 11);
  const Point apex = d.center(5, 5);
  std::array<Point, kRing.size()> ring;
  for (size_t i = 0; i < ring.size(); ++i) {
    ring[i] = apex + d.random().between(d.half() / 2, 2 * d.px()) * kRing[i];
  }
  // In every other scene the middle lies at most a subpixel off the sample.
  const Point middle = d.index() % 2 == 0 ? apex : d.point_near(apex, 1);
  for (size_t i = 0; i < ring.size(); ++i) d.add({middle, ring[i], ring[(i + 1) % ring.size()]});
}

// w with cross(d, w) = 1, by Euclid's algorithm; d coprime.
Point unit_partner(Point d) {
  Point r{d.x, d.y}, s{1, 0}, t{0, 1};  // r.x = s.x*dx + t.x*dy, and the same for y
  while (r.y != 0) {
    const int64_t q = r.x / r.y;
    r = {r.y, r.x - q * r.y};
    s = {s.y, s.x - q * s.y};
    t = {t.y, t.x - q * t.y};
  }
  return {-t.x * r.x, s.x * r.x};  // r.x = +-1
}

// Slivers of doubled area 1 to 6 units through a sample: they must draw what they cover.
void slivers(Draw& d, int64_t reach) {
  d.frame(12, 12);
  for (int i = 0; i < 8; ++i) {
    Point along;
    do {
      along = d.point_near({0, 0}, reach);
    } while (std::gcd(along.x, along.y) != 1);
    const Point w = unit_partner(along);
    const Point p = d.any_center(2, 9);
    d.add(
        {p + along, p - along + d.random().between(-2, 2) * w, p + d.random().between(-2, 2) * w});
  }
}
void sliver(Draw& d) { slivers(d, 5 * d.px()); }
void sliver_long(Draw& d) { slivers(d, 5000 * d.px()); }

// Zero area after snapping, between triangles that are drawn.
void zero_area(Draw& d) {
  d.frame(10, 10);
  const Point p = d.point(1, 1, 8, 8), step = d.point_near({0, 0}, d.px());
  d.add({p, p, p});
  d.add({d.point(0, 0, 9, 3), d.point(0, 5, 4, 9), d.point(6, 5, 9, 9)});
  d.add({p, p, d.point(0, 0, 9, 9)});
  d.add({p, p + 2 * step, p - 3 * step});
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
  d.add({a, Point{c.x, a.y}, c});
  d.add({a, c, Point{a.x, c.y}});
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
  const int64_t low = d.least(), high = d.greatest();
  const std::array<Point, 4> corner{{{low, low}, {high, low}, {high, high}, {low, high}}};
  const auto left_out = static_cast<size_t>(d.index()) % 4;
  for (size_t first = 0; first < 3; ++first) {
    std::array<spec::Vertex, 3> v;
    for (size_t i = 0; i < 3; ++i) v[i] = d.vertex(corner[(left_out + 1 + (first + i) % 3) % 4]);
    d.add_ordered(v);
    std::swap(v[1], v[2]);
    d.add_ordered(v);
  }
}

// Huge triangles whose edges pass through a small window.
void huge_window(Draw& d) {
  d.frame(7, 7);
  for (int i = 0; i < 3; ++i) {
    const Point q = d.point(1, 1, 6, 6), along = d.point(-8000, -8000, 8000, 8000);
    d.add({q + along, q - along, d.point(-16384, -16384, 16384, 16384)});
  }
}

// The whole guard band as the frame: no window hides a high bit of the box.
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
    const auto near_border = [&] { return d.point(width - 4, height - 4, width + 3, height + 3); };
    d.add({near_border(), near_border(), near_border()});
  }
}

// Triangles that hang over each border, and triangles wholly beyond it.
void outside(Draw& d) {
  d.frame(8, 6);
  static constexpr std::array<Point, 8> kSides{
      {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
  for (const Point side : kSides) {
    const int64_t x = 4 + 5 * side.x, y = 3 + 4 * side.y;  // px, about the middle
    const int64_t reach = d.random().coin() ? 1 : 3;
    const auto near = [&] { return d.point(x - reach, y - reach, x + reach, y + reach); };
    d.add({near(), near(), near()});
  }
}

// Boxes that hold no sample: between centres, and just short of one.
void no_sample(Draw& d) {
  d.frame(6, 6);
  for (int i = 0; i < 4; ++i) {
    const Point c = d.any_center(1, 4);
    const auto between = [&] {
      return c + Point{d.random().between(1, d.px()), d.random().between(-3, 3)};
    };
    d.add({between(), between(), between()});
  }
  d.add({d.center(1, 1), d.center(4, 1), d.center(2, 5)});
}

// Vertices in the corners of tiles: no stamp is lost or sent twice.
void tile_corner(Draw& d) {
  d.frame(20, 20);
  const auto corner = [&] {
    const Point p{d.random().between(0, 2) * d.tile(), d.random().between(0, 2) * d.tile()};
    const int64_t radius = d.random().coin() ? 1 : d.half();
    return d.point_near(p, radius);
  };
  for (int i = 0; i < 2; ++i) d.add({corner(), corner(), corner()});
}

// Edges along tile borders, on them and half a pixel to either side.
void tile_border(Draw& d) {
  d.frame(18, 18);
  const auto border = [&](int64_t n) {
    return n * d.tile() + d.random().between(-1, 1) * d.half();
  };
  const Point a{border(1), d.random().between(0, 2 * d.tile())}, b{a.x, border(2)};
  d.add({a, b, Point{border(2), border(1)}});
  d.add({a, b, Point{border(0), border(1)}});
}

// 100 to 8000 px long, 1/16 to 2 px wide.
void needle(Draw& d) {
  d.frame(24, 8);
  for (int i = 0; i < 3; ++i) {
    const int64_t length = d.random().between(100, 8000) * d.px();
    const int64_t across = d.random().between(-length, length);
    const bool steep = d.random().coin();
    const Point along = steep ? Point{across, length} : Point{length, across};
    const int64_t width = d.random().between(d.px() / 16, 2 * d.px());
    const Point q = d.point(2, 1, 22, 7);
    const Point start = q - Point{along.x / 8, along.y / 8};
    d.add({start, start + along, start + (steep ? Point{width, 0} : Point{0, width})});
  }
}

// Areas of .01 to 16 px^2.
void micro(Draw& d) {
  d.frame(8, 8);
  for (int i = 0; i < 12; ++i) {
    const Point p = d.point(1, 1, 7, 7);
    const int64_t reach = d.random().between(1, 20) * d.px() / 8;
    d.add({d.point_near(p, reach), d.point_near(p, reach), d.point_near(p, reach)});
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
