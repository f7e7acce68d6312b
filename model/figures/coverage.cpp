#include "model/figures/coverage.h"

#include <cmath>
#include <numeric>

namespace pineda::figures {

std::vector<Point> ring(Pen& pen, Point center, const std::vector<Point>& directions, int64_t least,
                        int64_t greatest) {
  std::vector<Point> points;
  for (const Point direction : directions) {
    points.push_back(center + pen.random().between(least, greatest) * direction);
  }
  return points;
}

std::vector<Corners> fan(Point middle, const std::vector<Point>& ring) {
  std::vector<Corners> triangles;
  for (size_t i = 0; i < ring.size(); ++i) {
    triangles.push_back({middle, ring[i], ring[(i + 1) % ring.size()]});
  }
  return triangles;
}

Point coprime(Pen& pen, int64_t reach) {
  Point p;
  do {
    p = pen.near({0, 0}, reach);
  } while (std::gcd(p.x, p.y) != 1);
  return p;
}

Point unit_partner(Point d) {
  Point r = d, s{1, 0}, t{0, 1};  // r.x = s.x*d.x + t.x*d.y, and the same for y
  while (r.y != 0) {
    const int64_t q = r.x / r.y;
    r = {r.y, r.x - q * r.y};
    s = {s.y, s.x - q * s.y};
    t = {t.y, t.x - q * t.y};
  }
  return {-t.x * r.x, s.x * r.x};  // r.x = +-1
}

Corners sliver(Point sample, Point along, int64_t e1, int64_t e2) {
  const Point w = unit_partner(along);
  return {{sample + along, sample - along + e1 * w, sample + e2 * w}};
}

Corners between_samples(Pen& pen, Point sample) {
  const auto beside = [&] {
    return sample + Point{pen.random().between(1, pen.px()), pen.random().between(-3, 3)};
  };
  return {{beside(), beside(), beside()}};
}

Corners equilateral(const Lattice& lattice, double x_px, double y_px, double radius_px,
                    double half_angle_tangent) {
  const double t = half_angle_tangent;
  const double c = radius_px * (1 - t * t) / (1 + t * t);
  const double s = radius_px * 2 * t / (1 + t * t);
  const double h = std::sqrt(.75);
  const auto px = static_cast<double>(lattice.px());
  const auto corner = [&](double dx, double dy) {
    return Point{std::lround((x_px + dx) * px), std::lround((y_px + dy) * px)};
  };
  return {{corner(c, s), corner(-.5 * c - h * s, h * c - .5 * s),
           corner(-.5 * c + h * s, -h * c - .5 * s)}};
}

Corners within(Pen& pen, Point low, Point high) {
  return {{pen.in_box(low, high), pen.in_box(low, high), pen.in_box(low, high)}};
}

Corners around(Pen& pen, Point p, int64_t reach) {
  return {{pen.near(p, reach), pen.near(p, reach), pen.near(p, reach)}};
}

}  // namespace pineda::figures
