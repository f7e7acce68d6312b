// Hard cases of coverage: which samples belong to a triangle.
#include <cmath>

#include "model/scene/hard/draw.h"

namespace pineda::scene::hard {

std::vector<ScreenTriangle> grid(uint64_t seed, int64_t spacing, int64_t lattice) {
  Drawing d(seed);
  const auto columns = static_cast<int>(kGridFrame.width * kPx / spacing) + 3;
  const auto rows = static_cast<int>(kGridFrame.height * kPx / spacing) + 3;
  const auto corner = [&](int i, int j) {
    return spacing * Point{i - 1, j - 1} + lattice * (d.near({0, 0}, spacing / 5) / lattice);
  };
  for (const auto& quad : figures::mesh(columns, rows, corner)) {
    for (const Corners& half : figures::halves(quad, d.coin())) d.add_shuffled(half);
  }
  return d.triangles();
}

namespace {

std::vector<ScreenTriangle> shared_edges() { return grid(1, 1733, 1); }
std::vector<ScreenTriangle> half_pixel_lattice() { return grid(2, 11 * kHalfPx, kHalfPx); }

// In each cell a T-junction whose midpoint lies half a subpixel right of a sample and snaps onto
// it. If the two halves lie right of the edge the sample is hit twice, otherwise not at all.
std::vector<ScreenTriangle> t_junction() {
  Drawing d(3);
  for (int i = 0; i < 32; ++i) {
    const Point sample = cell(i, 8) + d.center(7, 7);
    const Point along = d.in_box({-2 * kPx, 3 * kPx}, {2 * kPx, 6 * kPx});
    const Point left = sample + d.in_box({-7 * kPx, -2 * kPx}, {-4 * kPx, 2 * kPx});
    const Point right = sample + d.in_box({4 * kPx, -2 * kPx}, {7 * kPx, 2 * kPx});
    const bool split_right = d.coin();
    const figures::TJunction t{sample - along, sample + along + Point{1, 0},
                               split_right ? left : right, split_right ? right : left};
    const ScreenVertex split = d.vertex(t.split);
    ScreenVertex middle = d.vertex(t.middle());
    middle.x = static_cast<float>(t.a.x + t.b.x) / (2 * kPx);
    d.add({t.a, t.b, t.whole});
    d.add({d.vertex(t.a), middle, split});
    d.add({middle, d.vertex(t.b), split});
  }
  return d.triangles();
}

// In each cell a fan of four or eight triangles around a sample. In every other cell the middle of
// the fan is moved off the sample by up to one subpixel.
std::vector<ScreenTriangle> fan() {
  static constexpr std::array<Point, 8> kDirections{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  Drawing d(4);
  for (size_t i = 0; i < 24; ++i) {
    const Point sample = cell(static_cast<int>(i), 6) + d.center(7, 7);
    const Point middle = i % 2 == 0 ? sample : d.near(sample, 1);
    const size_t step = d.coin() ? 1 : 2;
    std::vector<Point> directions;
    for (size_t k = 0; k < 8; k += step) directions.push_back(kDirections[(k + i % 3) % 8]);
    const auto ring = figures::ring(d, sample, directions, 2, 7 * kPx);
    for (const Corners& triangle : figures::fan(middle, ring)) d.add_shuffled(triangle);
  }
  return d.triangles();
}

// Slivers with doubled areas of one to four units of 2^-16 px^2, through a sample. With an area of
// one unit only a corner can be covered, so corners often lie on the sample.
std::vector<ScreenTriangle> sliver() {
  Drawing d(5);
  for (int i = 0; i < 96; ++i) {
    const Point along = figures::coprime(d, (i % 2 == 0 ? 5 : 1500) * kPx);
    const Point sample = d.center_in_box({2, 2}, {29, 29});
    const int e2 = std::max(0, d.random().between(-3, 1));
    const int sign = d.coin() ? 1 : -1;
    const int area = sign * std::max(1, d.random().between(-2, 4));
    d.add_shuffled(figures::sliver(sample, along, 2 * e2 + area, e2));
  }
  return d.triangles();
}

// Triangles without area, between others: points, double points, lines in any direction, a line
// through samples, and a triangle that becomes a line when it is snapped.
std::vector<ScreenTriangle> zero_area() {
  Drawing d(6);
  const auto anywhere = [&] { return d.in_box({0, 0}, {32 * kPx, 24 * kPx}); };
  for (int i = 0; i < 8; ++i) {
    const Point p = anywhere();
    const Point q = anywhere();
    const Point step = d.near({0, 0}, 3 * kPx);
    d.add_shuffled(figures::point(p));
    d.add_shuffled(figures::doubled(p, q));
    d.add_shuffled(figures::line(p, step));
    d.add_shuffled({d.center(2, i), d.center(20, i), d.center(9, i)});
    const ScreenVertex a = d.vertex(p), b = d.vertex(p);
    ScreenVertex off = d.vertex(q);
    off.x = b.x + .25f / kPx;
    off.y = b.y - .25f / kPx;
    d.add_shuffled({a, off, d.vertex(q)});
    const Point r = anywhere();
    d.add_shuffled({p, q, r});
  }
  return d.triangles();
}

// In each cell a rectangle from one sample to another, cut along a diagonal. A third of them are
// squares, whose diagonals pass through samples too.
std::vector<ScreenTriangle> edges_through_centers() {
  Drawing d(7);
  for (int i = 0; i < 24; ++i) {
    const Point a = cell(i, 6) + d.center_in_box({0, 0}, {4, 4});
    const int width = d.random().between(1, 10);
    const int height = i % 3 == 0 ? width : d.random().between(1, 10);
    const Point c = a + kPx * Point{width, height};
    for (const Corners& half : figures::halves(figures::rectangle(a, c), d.coin())) {
      d.add_shuffled(half);
    }
  }
  return d.triangles();
}

// In each cell a triangle whose box reaches from one sample to another. In every fourth cell the
// box is smaller than a pixel and contains only the sample at its lower right corner.
std::vector<ScreenTriangle> box_on_centers() {
  Drawing d(8);
  for (int i = 0; i < 48; ++i) {
    const Point high = cell(i, 8) + d.center_in_box({8, 8}, {13, 13});
    const Point low = i % 4 == 0
                          ? high - d.in_box({1, 1}, {kPx - 1, kPx - 1})
                          : high - kPx * Point{d.random().between(1, 8), d.random().between(1, 8)};
    const Point mid = d.in_box(low, high);
    if (d.coin()) {
      d.add_shuffled(Corners{{{low.x, mid.y}, {high.x, low.y}, {mid.x, high.y}}});
    } else {
      d.add_shuffled(Corners{{low, {mid.x, high.y}, {high.x, mid.y}}});
    }
  }
  return d.triangles();
}

// 400 equilateral triangles each of .01, .2, .5, 1 and 16 px^2, with random rotation and position.
std::vector<ScreenTriangle> micro_triangles() {
  Drawing d(9);
  for (const double area_px2 : {.01, .2, .5, 1., 16.}) {
    const double radius_px = std::sqrt(area_px2 / (.75 * std::sqrt(3.)));
    for (int i = 0; i < 400; ++i) {
      const double direction = static_cast<double>(d.random().uniform(-1, 1));
      const double x = static_cast<double>(d.random().uniform(4, 60));
      const double y = static_cast<double>(d.random().uniform(4, 60));
      d.add_shuffled(figures::equilateral(d, x, y, radius_px, direction));
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
