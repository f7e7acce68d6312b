#include "studies/numerics/random_triangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/figures/coverage.h"

namespace pineda::studies {

namespace {

constexpr int kPx = 256;
constexpr int kHalfPx = kPx / 2;
constexpr int kGuardLow = -(kPx << 14);
constexpr int kGuardHigh = -kGuardLow - 1;
constexpr int64_t kMaxDepthInput = ((int64_t{1} << 24) - 1) << 8;
constexpr spec::FrameState kHugeFrame{16384, 16384, spec::Cull::kNone, spec::DepthFunc::kLess};
constexpr spec::FrameState kWindow{67, 45, spec::Cull::kNone, spec::DepthFunc::kLess};

int inside_guard(double coordinate) {
  return static_cast<int>(std::lround(std::clamp<double>(coordinate, kGuardLow, kGuardHigh)));
}

Point point(double x, double y) { return {inside_guard(x), inside_guard(y)}; }

Point in_window(Random& random) {
  return {random.between(0, kWindow.width * kPx), random.between(0, kWindow.height * kPx)};
}

// Draws y before x, and around_three() its last corner first: this order gives the figures in
// docs/.
Point around(Random& random, Point centre, int reach) {
  const int y = random.between(-reach, reach);
  return point(centre.x + random.between(-reach, reach), centre.y + y);
}

spec::Triangle around_three(Random& random, Point centre, int reach) {
  const Point c = around(random, centre, reach);
  const Point b = around(random, centre, reach);
  return triangle(around(random, centre, reach), b, c);
}

// Corners within `reach` of the window; the line between two of them passes through it.
spec::Triangle crossing(Random& random, int reach) {
  const Point q = in_window(random);
  const Point a = around(random, q, reach);
  const double s = random.unit();
  return triangle(a, point(q.x - s * (a.x - q.x), q.y - s * (a.y - q.y)), around(random, q, reach));
}

spec::Triangle needle(Random& random) {
  const double pi = std::acos(-1.0);
  const double angle = 2 * pi * random.unit();
  const double dx = std::cos(angle);
  const double dy = std::sin(angle);
  const double length = kPx * 100 * std::pow(80.0, random.unit());
  const double width = kPx / 16.0 * std::pow(32.0, random.unit());
  const double before = length * random.unit();
  const double along = length * random.unit() - before;
  const Point q = in_window(random);
  return triangle(point(q.x - before * dx, q.y - before * dy),
                  point(q.x + (length - before) * dx, q.y + (length - before) * dy),
                  point(q.x + along * dx - width * dy, q.y + along * dy + width * dx));
}

spec::Triangle sliver(Random& random) {
  const auto [d, w] = unit_lattice(random, 20 * kPx);
  const Point p{random.between(40, 16340) * kPx + kHalfPx,
                random.between(40, 16340) * kPx + kHalfPx};
  // The doubled area is |e1 - 2*e2|.
  const int e2 = random.between(-1, 1);
  const int e1 = 2 * e2 + random.between(1, 4) * (random.between(0, 1) != 0 ? 1 : -1);
  return triangle({p.x + d.x, p.y + d.y}, {p.x - d.x + e1 * w.x, p.y - d.y + e1 * w.y},
                  {p.x + e2 * w.x, p.y + e2 * w.y});
}

}  // namespace

spec::Triangle triangle(Point a, Point b, Point c) {
  spec::Triangle t;
  const std::array<Point, 3> corners{a, b, c};
  for (size_t i = 0; i < 3; ++i) {
    t.v[i].x = corners[i].x;
    t.v[i].y = corners[i].y;
  }
  return t;
}

void randomize_values(Random& random, spec::Triangle* t) {
  const auto draw = [&random](int64_t top) {
    const int kind = random.between(0, 3);
    return kind == 0 ? 0 : kind == 1 ? top : random.between(0, top);
  };
  for (auto& v : t->v) {
    v.z = draw(kMaxDepthInput);
    for (size_t i = 0; i < 4; ++i) v.attr[i] = static_cast<int32_t>(draw(255));
  }
}

const char* shape_name(Shape shape) {
  static constexpr const char* kNames[] = {"16 px",      "256 px",  "8192 px",
                                           "guard band", "needles", "slivers"};
  return kNames[static_cast<int>(shape)];
}

spec::FrameState frame_of(Shape shape) {
  return shape == Shape::k16Px || shape == Shape::kSliver ? kHugeFrame : kWindow;
}

spec::Triangle random_triangle(Random& random, Shape shape) {
  switch (shape) {
    case Shape::k16Px: {
      const int edge = 16384 * kPx;
      constexpr int low = -4 * kPx;
      const Point centre{random.between(low, edge), random.between(low, edge)};
      return around_three(random, centre, 8 * kPx);
    }
    case Shape::k256Px: {
      const Point q = in_window(random);
      return around_three(random, q, 128 * kPx);
    }
    case Shape::k8192Px:
      return crossing(random, 4096 * kPx);
    case Shape::kGuardBand:
      return crossing(random, 16384 * kPx);
    case Shape::kNeedle:
      return needle(random);
    case Shape::kSliver:
      break;
  }
  return sliver(random);
}

Lattice unit_lattice(Random& random, int reach) {
  int a = 0;
  int b = 0;
  while (std::gcd(a, b) != 1) {
    a = random.between(-reach, reach);
    b = random.between(-reach, reach);
  }
  const figures::Point w = figures::unit_partner({a, b});
  return {{a, b}, {static_cast<int>(w.x), static_cast<int>(w.y)}};
}

}  // namespace pineda::studies
