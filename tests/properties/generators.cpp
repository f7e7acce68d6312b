#include "tests/properties/generators.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pineda::properties {

namespace {

using rc::gen::inRange;
using test::kGuardHigh;
using test::kGuardLow;
using test::kHalfPx;
using test::kPx;
using test::Shape;

// rapidcheck grows ranges from case to case; here the full range is wanted from the first one on.
rc::Gen<int> in(int low, int high) {
  return rc::gen::resize(rc::kNominalSize, inRange<int>(low, high + 1));
}

Point in_guard_band(Point p) {
  return {std::clamp(p.x, kGuardLow, kGuardHigh), std::clamp(p.y, kGuardLow, kGuardHigh)};
}

Point point_in(const spec::FrameState& frame) {
  const int x = *in(0, frame.width * kPx);
  return {x, *in(0, frame.height * kPx)};
}

Point near(Point p, int reach) {
  const int x = *offset(reach);
  return in_guard_band({p.x + x, p.y + *offset(reach)});
}

spec::Triangle around(Point p, int reach) {
  const Point a = near(p, reach);
  const Point b = near(p, reach);
  return test::triangle(a, b, near(p, reach));
}

// The line between two corners passes through the frame.
spec::Triangle crossing(const spec::FrameState& frame, int reach) {
  const Point q = point_in(frame);
  const Point a = near(q, reach);
  const int64_t part = *in(0, 256);  // of the way from q to a, on the other side
  const Point b{static_cast<int>(q.x - part * (a.x - q.x) / 256),
                static_cast<int>(q.y - part * (a.y - q.y) / 256)};
  return test::triangle(a, in_guard_band(b), near(q, reach));
}

// 100 to 8000 px long, 1/16 to 2 px wide.
spec::Triangle needle(const spec::FrameState& frame) {
  const Point q = point_in(frame);
  const int length = *in(100, 8000) * kPx;
  const int across = *offset(length);
  const int width = *in(kPx / 16, 2 * kPx);
  const int before = *in(0, 16);
  const bool steep = *rc::gen::arbitrary<bool>();
  const Point along = steep ? Point{across, length} : Point{length, across};
  const Point start{q.x - along.x / 16 * before, q.y - along.y / 16 * before};
  const Point aside{start.x + (steep ? width : 0), start.y + (steep ? 0 : width)};
  return test::triangle(in_guard_band(start), in_guard_band({start.x + along.x, start.y + along.y}),
                        in_guard_band(aside));
}

// Doubled area of 1 to 4 units, a vertex on a sample or next to it.
spec::Triangle sliver(const spec::FrameState& frame) {
  test::Random random(*rc::gen::arbitrary<uint32_t>());
  const auto [d, w] = test::unit_lattice(random, 20 * kPx);
  const int column = *in(0, frame.width - 1);
  const Point p{column * kPx + kHalfPx, *in(0, frame.height - 1) * kPx + kHalfPx};
  const int e2 = *offset(1);
  const int area = *rc::gen::element(1, -1, 2, -2, 3, -3, 4, -4);
  const int e1 = 2 * e2 + area;
  return test::triangle(in_guard_band({p.x + d.x, p.y + d.y}),
                        in_guard_band({p.x - d.x + e1 * w.x, p.y - d.y + e1 * w.y}),
                        in_guard_band({p.x + e2 * w.x, p.y + e2 * w.y}));
}

spec::Triangle shaped(Shape shape, const spec::FrameState& frame) {
  switch (shape) {
    case Shape::k16Px:
      return around(point_in(frame), 8 * kPx);
    case Shape::k256Px:
      return around(point_in(frame), 128 * kPx);
    case Shape::k8192Px:
      return crossing(frame, 4096 * kPx);
    case Shape::kGuardBand:
      return crossing(frame, 16384 * kPx);
    case Shape::kNeedle:
      return needle(frame);
    case Shape::kSliver:
      break;
  }
  return sliver(frame);
}

rc::Gen<int64_t> value(int64_t top) {
  return rc::gen::oneOf(rc::gen::just<int64_t>(0), rc::gen::just(top),
                        rc::gen::resize(rc::kNominalSize, inRange<int64_t>(0, top + 1)));
}

rc::Gen<Figure> figure(bool in_window) {
  return rc::gen::exec([in_window] {
    Figure f;
    f.shape = *rc::gen::element(Shape::k16Px, Shape::k256Px, Shape::k8192Px, Shape::kGuardBand,
                                Shape::kNeedle, Shape::kSliver);
    f.frame = in_window ? test::kWindow : test::frame_of(f.shape);
    f.t = shaped(f.shape, f.frame);
    for (spec::Vertex& v : f.t.v) {
      v.z = *value(test::kMaxDepthInput);
      for (size_t i = 0; i < 4; ++i) v.attr[i] = static_cast<int32_t>(*value(255));
    }
    return f;
  });
}

// Replaces the triangle that holds p by three that meet there, or does nothing.
void insert(std::vector<spec::Triangle>* mesh, Point p) {
  for (size_t i = 0; i < mesh->size(); ++i) {
    const spec::Triangle t = (*mesh)[i];
    if (side(t, p) <= 0) continue;
    spec::Vertex middle;
    middle.x = p.x;
    middle.y = p.y;
    (*mesh)[i].v[2] = middle;
    mesh->push_back({0, {t.v[1], t.v[2], middle}});
    mesh->push_back({0, {t.v[2], t.v[0], middle}});
    return;
  }
}

void show(std::ostream& to, const spec::Triangle& t) {
  for (const spec::Vertex& v : t.v) to << "(" << v.x << ", " << v.y << "; z " << v.z << ") ";
}

}  // namespace

rc::Gen<int> offset(int reach) {
  return rc::gen::map(in(0, 2 * reach), [](int n) { return n % 2 == 0 ? n / 2 : -(n + 1) / 2; });
}

rc::Gen<Figure> figure() { return figure(false); }
rc::Gen<Figure> figure_in_window() { return figure(true); }

rc::Gen<Mesh> mesh() {
  return rc::gen::exec([] {
    const spec::FrameState& window = test::kWindow;
    // From just the window to the guard band.
    const int margin = *rc::gen::element(0, 3 * kHalfPx, 1000 * kPx, 16000 * kPx);
    const Point low{-margin, -margin};
    const Point high{window.width * kPx + margin, window.height * kPx + margin};
    Mesh mesh{
        {test::triangle(low, {high.x, low.y}, high), test::triangle(low, high, {low.x, high.y})}};
    // Half of the points lie on the half-pixel lattice, where samples lie on edges.
    const int points = *in(0, 40);
    for (int i = 0; i < points; ++i) {
      const int lattice = *rc::gen::element(1, kHalfPx);
      const Point p = point_in(window);
      insert(&mesh.triangles, {p.x / lattice * lattice, p.y / lattice * lattice});
    }
    for (spec::Triangle& t : mesh.triangles) {
      const int order = *in(0, 5);
      std::rotate(t.v.begin(), t.v.begin() + order / 2, t.v.end());
      if (order % 2 != 0) std::swap(t.v[1], t.v[2]);
    }
    return mesh;
  });
}

std::ostream& operator<<(std::ostream& to, const Figure& figure) {
  show(to, figure.t);
  return to << "/256 px in " << figure.frame.width << "x" << figure.frame.height;
}

std::ostream& operator<<(std::ostream& to, const Mesh& mesh) {
  for (const spec::Triangle& t : mesh.triangles) {
    show(to, t);
    to << "\n";
  }
  return to;
}

int side(const spec::Triangle& t, Point p) {
  const auto cross = [](const spec::Vertex& o, const spec::Vertex& a, Point b) {
    return (int64_t{a.x} - o.x) * (int64_t{b.y} - o.y) -
           (int64_t{b.x} - o.x) * (int64_t{a.y} - o.y);
  };
  const auto& v = t.v;
  const int64_t sign = cross(v[0], v[1], {v[2].x, v[2].y}) < 0 ? -1 : 1;
  const int64_t least = std::min(
      {sign * cross(v[0], v[1], p), sign * cross(v[1], v[2], p), sign * cross(v[2], v[0], p)});
  return least > 0 ? 1 : least == 0 ? 0 : -1;
}

std::vector<Sample> samples(const spec::FrameState& frame, const spec::Triangle& t) {
  std::vector<Sample> all;
  spec::SetupPrim prim;
  if (core::setup(test::kContract, frame, t, &prim) != core::Drop::kNone) return all;
  core::for_each_stamp(test::kContract, prim, [&](const spec::Stamp& stamp) {
    spec::Fragment fragment;
    core::interpolate(test::kContract, stamp, &fragment);
    test::for_each_sample(stamp, [&](int x, int y, size_t lane) {
      all.push_back({x, y, fragment.z[lane], fragment.attr[lane]});
    });
  });
  return all;
}

void sort(std::vector<Sample>* samples) {
  std::sort(samples->begin(), samples->end(), [](const Sample& a, const Sample& b) {
    return std::pair(a.y, a.x) < std::pair(b.y, b.x);
  });
}

Moved move(const Figure& figure, int dx, int dy) {
  spec::Triangle t = figure.t;
  for (spec::Vertex& v : t.v) {
    v.x += dx * kPx;
    v.y += dy * kPx;
    RC_PRE(std::min(v.x, v.y) >= kGuardLow && std::max(v.x, v.y) <= kGuardHigh);
  }
  const auto in_frame = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < figure.frame.width && y < figure.frame.height;
  };
  Moved moved;
  for (Sample s : samples(figure.frame, figure.t)) {
    s.x += dx;
    s.y += dy;
    if (in_frame(s.x, s.y)) moved.before.push_back(s);
  }
  for (const Sample& s : samples(figure.frame, t)) {
    if (in_frame(s.x - dx, s.y - dy)) moved.after.push_back(s);
  }
  sort(&moved.before);
  sort(&moved.after);
  return moved;
}

}  // namespace pineda::properties
