#include "tests/core/support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace pineda::test {

namespace {

int inside_guard(double coordinate) {
  return static_cast<int>(std::lround(std::clamp<double>(coordinate, kGuardLow, kGuardHigh)));
}

Point point(double x, double y) { return {inside_guard(x), inside_guard(y)}; }

Point in_window(Random& random) {
  return {random.coordinate(0, kWindow.width * kPx), random.coordinate(0, kWindow.height * kPx)};
}

Point around(Random& random, Point centre, int reach) {
  return point(centre.x + random.coordinate(-reach, reach),
               centre.y + random.coordinate(-reach, reach));
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
  const Point p{random.coordinate(40, 16340) * kPx + kHalfPx,
                random.coordinate(40, 16340) * kPx + kHalfPx};
  // The doubled area is |e1 - 2*e2|.
  const int e2 = random.coordinate(-1, 1);
  const int e1 = 2 * e2 + random.coordinate(1, 4) * (random.in(0, 1) != 0 ? 1 : -1);
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
    const int64_t kind = random.in(0, 3);
    return kind == 0 ? 0 : kind == 1 ? top : random.in(0, top);
  };
  for (auto& v : t->v) {
    v.z = draw(kMaxDepthInput);
    for (size_t i = 0; i < 4; ++i) v.attr[i] = static_cast<int32_t>(draw(255));
  }
}

spec::FrameState frame_of(Shape shape) {
  return shape == Shape::k16Px || shape == Shape::kSliver ? kHugeFrame : kWindow;
}

spec::Triangle random_triangle(Random& random, Shape shape) {
  switch (shape) {
    case Shape::k16Px: {
      const int edge = 16384 * kPx;
      const Point centre{random.coordinate(-4 * kPx, edge), random.coordinate(-4 * kPx, edge)};
      return triangle(around(random, centre, 8 * kPx), around(random, centre, 8 * kPx),
                      around(random, centre, 8 * kPx));
    }
    case Shape::k256Px: {
      const Point q = in_window(random);
      return triangle(around(random, q, 128 * kPx), around(random, q, 128 * kPx),
                      around(random, q, 128 * kPx));
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
    a = random.coordinate(-reach, reach);
    b = random.coordinate(-reach, reach);
  }
  // Extended Euclid: s*a + t*b = 1, so that cross((a, b), (-t, s)) = a*s + b*t = 1.
  int64_t r0 = a, r1 = b, s0 = 1, s1 = 0, t0 = 0, t1 = 1;
  while (r1 != 0) {
    const int64_t q = r0 / r1;
    r0 = std::exchange(r1, r0 - q * r1);
    s0 = std::exchange(s1, s0 - q * s1);
    t0 = std::exchange(t1, t0 - q * t1);
  }
  return {{a, b}, {static_cast<int>(-t0 * r0), static_cast<int>(s0 * r0)}};
}

exact::Judge judge(const spec::FrameState& frame, const spec::Triangle& t) {
  exact::Triangle v;
  for (size_t i = 0; i < 3; ++i) {
    const auto& attr = t.v[i].attr;
    v[i] = {t.v[i].x, t.v[i].y, t.v[i].z, {attr.begin(), attr.begin() + 4}};
  }
  const auto cull = frame.cull == spec::Cull::kNone   ? exact::Cull::kNone
                    : frame.cull == spec::Cull::kBack ? exact::Cull::kBack
                                                      : exact::Cull::kFront;
  return {v, kContract.design.subpixel_bits, frame.width, frame.height, cull};
}

std::string coverage_difference(const spec::SetupPrim& prim, const exact::Judge& judge) {
  const auto at = [](int x, int y) { return std::to_string(x) + "," + std::to_string(y); };
  const int width = prim.x1 - prim.x0 + 1;
  std::vector<char> hit(static_cast<size_t>(width) * static_cast<size_t>(prim.y1 - prim.y0 + 1));
  std::string difference;
  int64_t samples = 0;
  for_each_stamp(prim, [&](const core::Tile&, const spec::Stamp& stamp) {
    for_each_sample(stamp, [&](int x, int y, size_t) {
      ++samples;
      if (x < prim.x0 || x > prim.x1 || y < prim.y0 || y > prim.y1) {
        difference = "outside the box: " + at(x, y);
      } else if (char& h = hit[static_cast<size_t>((y - prim.y0) * width + x - prim.x0)]; h != 0) {
        difference = "sent twice: " + at(x, y);
      } else {
        h = 1;
      }
    });
  });
  if (!difference.empty()) return difference;
  for (int y = prim.y0; y <= prim.y1; ++y) {
    const exact::Span span = judge.span(y);
    for (int x = prim.x0; x <= prim.x1; ++x) {
      const bool wanted = span.first <= x && x <= span.last;
      const bool got = hit[static_cast<size_t>((y - prim.y0) * width + x - prim.x0)] != 0;
      if (got != wanted) return (wanted ? "missing: " : "extra: ") + at(x, y);
    }
  }
  // The box held all that was wanted.
  if (samples == judge.samples()) return {};
  return "outside the box: " + std::to_string(judge.samples() - samples) + " samples missing";
}

std::string coverage_difference(const spec::FrameState& frame, const spec::Triangle& t) {
  const exact::Judge exact = judge(frame, t);
  spec::SetupPrim prim;
  const core::Drop drop = core::setup(kContract, frame, t, &prim);
  const bool culled = drop == core::Drop::kZeroArea || drop == core::Drop::kFacing;
  if (culled != exact.culled()) return culled ? "culled" : "not culled";
  if (drop == core::Drop::kNone) return coverage_difference(prim, exact);
  return exact.samples() == 0 ? "" : std::string("dropped: ") + core::drop_name(drop);
}

void measure(const spec::FrameState& frame, const spec::Triangle& t, Errors* errors, int stride) {
  spec::SetupPrim prim;
  if (core::setup(kContract, frame, t, &prim) != core::Drop::kNone) return;
  const exact::Judge exact = judge(frame, t);
  int turn = 0;
  for_each_stamp(prim, [&](const core::Tile&, const spec::Stamp& stamp) {
    if (turn++ % stride != 0) return;
    spec::Fragment fragment;
    core::interpolate(kContract, stamp, &fragment);
    for_each_sample(stamp, [&](int x, int y, size_t lane) {
      ++errors->samples;
      errors->depth_codes =
          std::max(errors->depth_codes, std::abs(exact.depth_error(x, y, fragment.z[lane])));
      for (int a = 0; a < kContract.design.attributes; ++a) {
        const double error =
            exact.attribute_error(x, y, a, fragment.attr[lane][static_cast<size_t>(a)]);
        errors->attr_lsb = std::max(errors->attr_lsb, std::abs(error));
      }
    });
  });
}

spec::SetupPrim with_rule(spec::SetupPrim prim, const spec::Triangle& t, Rule rule) {
  std::array<spec::Vertex, 3> v = t.v;
  const auto cross = [](const spec::Vertex& o, const spec::Vertex& p, int64_t x, int64_t y) {
    return (int64_t{p.x} - o.x) * (y - o.y) - (x - o.x) * (int64_t{p.y} - o.y);
  };
  if (cross(v[0], v[1], v[2].x, v[2].y) < 0) std::swap(v[1], v[2]);
  const int64_t x = (prim.x0 & ~7) * int64_t{kPx} + kHalfPx;
  const int64_t y = (prim.y0 & ~7) * int64_t{kPx} + kHalfPx;
  for (size_t i = 0; i < 3; ++i) {
    const spec::Vertex& from = v[i];
    const spec::Vertex& to = v[(i + 1) % 3];
    const bool top_left = to.y < from.y || (to.y == from.y && to.x > from.x);
    const int64_t e = cross(from, to, x, y);
    const int64_t bias = rule == Rule::kInclusive || (rule != Rule::kStrict && top_left) ? 0 : 1;
    prim.edge[i].a = int64_t{from.y} - to.y;
    prim.edge[i].b = int64_t{to.x} - from.x;
    prim.edge[i].e = rule == Rule::kShiftFirst ? (e >> 8) - bias : (e - bias) >> 8;
  }
  return prim;
}

HitMap::HitMap(const spec::FrameState& frame)
    : frame_(frame), hits_(static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height)) {}

void HitMap::draw(const spec::Triangle& t, Rule rule) {
  spec::SetupPrim prim;
  if (core::setup(kContract, frame_, t, &prim) != core::Drop::kNone) return;
  if (rule != Rule::kTopLeft) {
    // A rule that counts samples on right and bottom edges needs the box to reach them.
    prim = with_rule(prim, t, rule);
    prim.x1 = std::min(prim.x1 + 1, frame_.width - 1);
    prim.y1 = std::min(prim.y1 + 1, frame_.height - 1);
  }
  for_each_stamp(prim, [&](const core::Tile&, const spec::Stamp& stamp) {
    for_each_sample(stamp, [&](int x, int y, size_t) {
      ++hits_[static_cast<size_t>(y) * static_cast<size_t>(frame_.width) + static_cast<size_t>(x)];
    });
  });
}

int HitMap::count(int hits) const {
  return static_cast<int>(std::count_if(hits_.begin(), hits_.end(),
                                        [=](int h) { return hits < 0 ? h > 1 : h == hits; }));
}

}  // namespace pineda::test
