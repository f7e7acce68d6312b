// Hard cases of coverage: which samples belong to a triangle.
#include <cmath>
#include <numeric>

#include "model/scene/hard/draw.h"

namespace pineda::scene::hard {

std::vector<ScreenTriangle> grid(uint64_t seed, int spacing, int lattice) {
  Drawing d(seed);
  const int columns = kGridFrame.width * kPx / spacing + 4;
  const int rows = kGridFrame.height * kPx / spacing + 4;
  std::vector<Point> corners;
  for (int i = 0; i < columns * rows; ++i) {
    const Point p = spacing * Point{i % columns - 1, i / columns - 1};
    const Point moved = d.near({0, 0}, spacing / 5);
    corners.push_back({p.x + moved.x / lattice * lattice, p.y + moved.y / lattice * lattice});
  }
  for (int i = 0; i < columns * (rows - 1); ++i) {
    if (i % columns == columns - 1) continue;
    const auto at = [&](int place) { return corners[static_cast<size_t>(place)]; };
    const Point a = at(i), b = at(i + 1), c = at(i + columns + 1), e = at(i + columns);
    const bool falling = d.coin();
    d.add_shuffled(a, b, falling ? c : e);
    d.add_shuffled(falling ? a : b, c, e);
  }
  return d.triangles();
}

namespace {

std::vector<ScreenTriangle> shared_edges() { return grid(1, 1733, 1); }
std::vector<ScreenTriangle> half_pixel_lattice() { return grid(2, 11 * kHalfPx, kHalfPx); }

// In each cell an edge p q with a whole triangle on one side; the two on the other side meet at the
// middle of the edge, which snaps half a subpixel to the left, onto a sample. That sample lies
// inside the sliver p, middle, q. Where the two lie on the right they take it too, where they lie
// on the left nobody does.
std::vector<ScreenTriangle> t_junction() {
  Drawing d(3);
  for (int i = 0; i < 32; ++i) {
    const Point sample = cell(i, 8) + center(7, 7);
    const Point along = d.in_box({-2 * kPx, 3 * kPx}, {2 * kPx, 6 * kPx});
    const Point p = sample - along;
    const Point q = sample + along + Point{1, 0};
    const Point left = sample + d.in_box({-7 * kPx, -2 * kPx}, {-4 * kPx, 2 * kPx});
    const Point right = sample + d.in_box({4 * kPx, -2 * kPx}, {7 * kPx, 2 * kPx});
    const bool split_right = d.coin();
    const ScreenVertex far = d.vertex(split_right ? right : left);
    ScreenVertex middle = d.vertex(sample);
    middle.x = static_cast<float>(p.x + q.x) / (2 * kPx);
    d.add(p, q, split_right ? left : right);
    d.add({d.vertex(p), middle, far});
    d.add({middle, d.vertex(q), far});
  }
  return d.triangles();
}

// In each cell a ring of four or eight triangles around a sample. In every other one the middle
// lies a subpixel off the sample at the most.
std::vector<ScreenTriangle> fan() {
  static constexpr std::array<Point, 8> kDirections{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  Drawing d(4);
  for (int i = 0; i < 24; ++i) {
    const Point sample = cell(i, 6) + center(7, 7);
    const Point middle = i % 2 == 0 ? sample : d.near(sample, 1);
    const int corners = d.coin() ? 8 : 4;
    std::vector<Point> ring;
    for (int k = 0; k < corners; ++k) {
      const Point direction = kDirections[static_cast<size_t>(k * (8 / corners) + i % 3) % 8];
      ring.push_back(sample + d.random().between(2, 7 * kPx) * direction);
    }
    for (size_t k = 0; k < ring.size(); ++k) {
      d.add_shuffled(middle, ring[k], ring[(k + 1) % ring.size()]);
    }
  }
  return d.triangles();
}

// w with cross(d, w) = 1, by Euclid's algorithm; d coprime. Source: Bezout's identity.
Point unit_partner(Point d) {
  Point r = d, s{1, 0}, t{0, 1};  // r.x = s.x*d.x + t.x*d.y, and the same for y
  while (r.y != 0) {
    const int q = r.x / r.y;
    r = {r.y, r.x - q * r.y};
    s = {s.y, s.x - q * s.y};
    t = {t.y, t.x - q * t.y};
  }
  return {-t.x * r.x, s.x * r.x};  // r.x = +-1
}

// Doubled areas of one to four units of 2^-16 px^2, through a sample. At one unit a corner is all
// that can be covered, so it often lies on the sample.
std::vector<ScreenTriangle> sliver() {
  Drawing d(5);
  for (int i = 0; i < 96; ++i) {
    const int reach = (i % 2 == 0 ? 5 : 1500) * kPx;
    Point along;
    do {
      along = d.near({0, 0}, reach);
    } while (std::gcd(along.x, along.y) != 1);
    const Point w = unit_partner(along);
    const Point p = d.center_in_box({2, 2}, {29, 29});
    const int e2 = std::max(0, d.random().between(-3, 1));
    const int sign = d.coin() ? 1 : -1;
    const int area = sign * std::max(1, d.random().between(-2, 4));
    d.add_shuffled(p + along, p - along + (2 * e2 + area) * w, p + e2 * w);
  }
  return d.triangles();
}

// Nothing to draw, between triangles that are drawn: points, doubled points, lines in any
// direction, a line through samples, and a triangle that snapping makes a line.
std::vector<ScreenTriangle> zero_area() {
  Drawing d(6);
  const auto anywhere = [&] { return d.in_box({0, 0}, {32 * kPx, 24 * kPx}); };
  for (int i = 0; i < 8; ++i) {
    const Point p = anywhere();
    const Point q = anywhere();
    const Point step = d.near({0, 0}, 3 * kPx);
    d.add_shuffled(p, p, p);
    d.add_shuffled(p, p, q);
    d.add_shuffled(p, p + 2 * step, p - 3 * step);
    d.add_shuffled(center(2, i), center(20, i), center(9, i));
    const ScreenVertex a = d.vertex(p), b = d.vertex(p);
    ScreenVertex off = d.vertex(q);
    off.x = b.x + .25f / kPx;
    off.y = b.y - .25f / kPx;
    d.add_shuffled({a, off, d.vertex(q)});
    const Point r = anywhere();
    d.add_shuffled(p, q, r);
  }
  return d.triangles();
}

// In each cell a rectangle from one sample to another, cut along a diagonal; a third are squares,
// whose diagonals run through samples too.
std::vector<ScreenTriangle> edges_through_centers() {
  Drawing d(7);
  for (int i = 0; i < 24; ++i) {
    const Point a = cell(i, 6) + d.center_in_box({0, 0}, {4, 4});
    const int width = d.random().between(1, 10);
    const int height = i % 3 == 0 ? width : d.random().between(1, 10);
    const Point c = a + kPx * Point{width, height};
    const Point b{c.x, a.y}, e{a.x, c.y};
    const bool falling = d.coin();
    d.add_shuffled(a, b, falling ? c : e);
    d.add_shuffled(falling ? a : b, c, e);
  }
  return d.triangles();
}

// In each cell a triangle whose box reaches from sample to sample; in every fourth the box is
// smaller than a pixel, so that it holds but the sample in its lower right corner.
std::vector<ScreenTriangle> box_on_centers() {
  Drawing d(8);
  for (int i = 0; i < 48; ++i) {
    const Point high = cell(i, 8) + d.center_in_box({8, 8}, {13, 13});
    const Point low = i % 4 == 0
                          ? high - d.in_box({1, 1}, {kPx - 1, kPx - 1})
                          : high - kPx * Point{d.random().between(1, 8), d.random().between(1, 8)};
    const Point mid = d.in_box(low, high);
    if (d.coin()) {
      d.add_shuffled({low.x, mid.y}, {high.x, low.y}, {mid.x, high.y});
    } else {
      d.add_shuffled(low, {mid.x, high.y}, {high.x, mid.y});
    }
  }
  return d.triangles();
}

// 400 equilateral triangles each of .01, .2, .5, 1 and 16 px^2, turned and placed anywhere.
std::vector<ScreenTriangle> micro_triangles() {
  Drawing d(9);
  for (const double area_px2 : {.01, .2, .5, 1., 16.}) {
    const double radius_px = std::sqrt(area_px2 / (.75 * std::sqrt(3.)));
    for (int i = 0; i < 400; ++i) {
      // A direction without trigonometry, whose last bits differ among libraries.
      const double t = static_cast<double>(d.random().uniform(-1, 1));
      const double c = radius_px * (1 - t * t) / (1 + t * t);
      const double s = radius_px * 2 * t / (1 + t * t);
      const double h = std::sqrt(.75);
      const double x = static_cast<double>(d.random().uniform(4, 60));
      const double y = static_cast<double>(d.random().uniform(4, 60));
      const auto corner = [&](double dx, double dy) {
        return Point{static_cast<int>(std::lround((x + dx) * kPx)),
                     static_cast<int>(std::lround((y + dy) * kPx))};
      };
      d.add_shuffled(corner(c, s), corner(-.5 * c - h * s, h * c - .5 * s),
                     corner(-.5 * c + h * s, -h * c - .5 * s));
    }
  }
  return d.triangles();
}

}  // namespace

std::vector<HardCase> coverage_cases() {
  return {
      {"shared_edges", "grid of jittered quads in any winding and vertex order",
       "every sample of the frame is hit exactly once", kGridFrame, shared_edges},
      {"half_pixel_lattice", "the same with vertices on the half-pixel lattice",
       "every sample is hit once; an inclusive rule doubles some, a strict one loses some",
       kGridFrame, half_pixel_lattice},
      {"t_junction", "triangles that meet on the snapped middle of a neighbour's edge",
       "hits differ from those of whole triangles only inside the slivers, by one", frame(128, 64),
       t_junction},
      {"fan", "rings of triangles around samples", "the sample in the middle is hit exactly once",
       frame(96, 64), fan},
      {"sliver", "doubled areas of one to four units of 2^-16 px^2, through samples",
       "the samples that they cover are drawn, also at one unit", frame(32, 32), sliver},
      {"zero_area", "points, lines, and what snapping makes a line",
       "they draw nothing and are counted as of zero area", frame(32, 24), zero_area},
      {"edges_through_centers", "rectangles from sample to sample, cut along a diagonal",
       "left and top borders belong to them, right and bottom ones do not; no sample twice",
       frame(96, 64), edges_through_centers},
      {"box_on_centers", "triangles whose greatest x and y are those of samples",
       "right and bottom are exclusive; a box that holds no other sample is dropped",
       frame(128, 96), box_on_centers},
      {"micro_triangles", "400 equilateral triangles each of .01, .2, .5, 1 and 16 px^2",
       "99, 80, 51, 16 and 0 % of them hit no sample", frame(64, 64), micro_triangles},
  };
}

}  // namespace pineda::scene::hard
