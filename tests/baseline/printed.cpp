#include "tests/baseline/printed.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pineda::test::printed {

namespace {

// Java's int arithmetic.
int32_t wrap(int64_t value) { return static_cast<int32_t>(static_cast<uint32_t>(value)); }
int32_t multiply(int32_t a, int32_t b) { return wrap(int64_t{a} * b); }
int32_t add(int32_t a, int32_t b) { return wrap(int64_t{a} + b); }

double cross(const Vertex2D& u, const Vertex2D& w, double x, double y) {
  return (double{u.y} - w.y) * x + (double{w.x} - u.x) * y + double{u.x} * w.y - double{w.x} * u.y;
}

}  // namespace

Corners corners(const spec::Triangle& t) {
  Corners out;
  for (size_t i = 0; i < 3; ++i) {
    const spec::Vertex& v = t.v[i];
    const auto channel = [&](size_t k) { return static_cast<uint32_t>(v.attr[k]); };
    out[i].x = static_cast<float>(v.x) / 256 - .5f;
    out[i].y = static_cast<float>(v.y) / 256 - .5f;
    out[i].argb = channel(3) << 24 | channel(0) << 16 | channel(1) << 8 | channel(2);
  }
  return out;
}

int32_t to_int(double value) {
  if (std::isnan(value)) return 0;
  constexpr double kLow = std::numeric_limits<int32_t>::min();
  constexpr double kHigh = std::numeric_limits<int32_t>::max();
  return static_cast<int32_t>(std::clamp(value, kLow, kHigh));
}

EdgeEqn::EdgeEqn(const Vertex2D& v0, const Vertex2D& v1) {
  const double a_exact = v0.y - v1.y;
  const double b_exact = v1.x - v0.x;
  const double c_exact = -0.5f * (a_exact * (v0.x + v1.x) + b_exact * (v0.y + v1.y));
  a = to_int(a_exact * (1 << kFractionBits));
  b = to_int(b_exact * (1 << kFractionBits));
  c = to_int(c_exact * (1 << kFractionBits));
  flag = 0;
  if (a >= 0) flag += 8;
  if (b >= 0) flag += 1;
}

void EdgeEqn::flip() {
  a = wrap(-int64_t{a});
  b = wrap(-int64_t{b});
  c = wrap(-int64_t{c});
}

int32_t EdgeEqn::evaluate(int x, int y) const {
  return add(add(multiply(a, x), multiply(b, y)), c);
}

float c_determinant(const Vertex2D& v0, const Vertex2D& v1) { return v0.x * v1.y - v1.x * v0.y; }

float c_vertex(const Vertex2D& v0, const Vertex2D& v1) {
  const float a = v0.y - v1.y;
  const float b = v1.x - v0.x;
  return -a * v0.x - b * v0.y;
}

float c_average(const Vertex2D& v0, const Vertex2D& v1) {
  const float a = v0.y - v1.y;
  const float b = v1.x - v0.x;
  return -(a * (v0.x + v1.x) + b * (v0.y + v1.y)) / 2;
}

bool triangle_setup(const Corners& v, int width, int height, Setup* s) {
  constexpr size_t kSort[6][2] = {{0, 1}, {1, 2}, {0, 2}, {2, 0}, {2, 1}, {1, 0}};
  for (size_t i = 0; i < 3; ++i) s->edge[i] = EdgeEqn(v[i], v[(i + 1) % 3]);
  s->area = add(add(s->edge[0].c, s->edge[1].c), s->edge[2].c);
  if (s->area == 0) return false;
  if (s->area < 0) {
    for (EdgeEqn& e : s->edge) e.flip();
    s->area = wrap(-int64_t{s->area});
  }
  s->x_flag = s->edge[0].flag + 2 * s->edge[1].flag + 4 * s->edge[2].flag;
  s->y_flag = (s->x_flag >> 3) - 1;
  s->x_flag = (s->x_flag & 7) - 1;
  if (!s->in_table()) return true;  // here the Java program throws
  const auto x = [&](int entry) { return v[kSort[s->x_flag][entry]].x; };
  const auto y = [&](int entry) { return v[kSort[s->y_flag][entry]].y; };
  s->x_min = std::max(to_int(x(0)), 0);
  s->x_max = std::min(to_int(x(1) + 1), width - 1);
  s->y_min = std::max(to_int(y(0)), 0);
  s->y_max = std::min(to_int(y(1) + 1), height - 1);
  return true;
}

Setup with_right_box(const Corners& v, int size_px) {
  Setup s;
  if (!triangle_setup(v, size_px, size_px, &s)) {
    s.x_max = s.y_max = -1;
    return s;
  }
  const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
  s.x_min = std::max(to_int(left), 0);
  s.y_min = std::max(to_int(top), 0);
  s.x_max = std::min(to_int(right + 1), size_px - 1);
  s.y_max = std::min(to_int(bottom + 1), size_px - 1);
  return s;
}

Pixels draw(const Setup& s, int width) {
  const auto& edge = s.edge;
  std::array<int32_t, 3> t;
  for (size_t i = 0; i < 3; ++i) t[i] = edge[i].evaluate(s.x_min, s.y_min);
  Pixels out;
  for (int y = s.y_min * width; y <= s.y_max * width; y += width) {
    std::array<int32_t, 3> e = t;
    bool been_inside = false;
    for (int x = s.x_min; x <= s.x_max; ++x) {
      if ((e[0] | e[1] | e[2]) >= 0) {
        out.push_back({y, x});
        been_inside = true;
      } else if (been_inside) {
        break;
      }
      for (size_t i = 0; i < 3; ++i) e[i] = add(e[i], edge[i].a);
    }
    for (size_t i = 0; i < 3; ++i) e[i] = add(e[i], edge[i].b);
  }
  return out;
}

uint32_t flat_color(const Corners& v) {
  const auto sum = [&](int shift) {
    return (v[0].argb >> shift & 255) + (v[1].argb >> shift & 255) + (v[2].argb >> shift & 255);
  };
  uint32_t a = 0;
  uint32_t r = sum(24);
  uint32_t g = sum(16);
  uint32_t b = sum(8);
  a = (a + a + 3) / 6;
  r = (r + r + 3) / 6;
  g = (g + g + 3) / 6;
  b = (b + b + 3) / 6;
  return a << 24 | r << 16 | g << 8 | b;
}

std::array<int32_t, 3> plane(const Corners& v, const std::array<int, 3>& value) {
  double area2 = 0;
  std::array<double, 3> sum{};
  for (size_t i = 0; i < 3; ++i) {  // row i of the matrix holds the edge opposite to vertex i
    const Vertex2D& u = v[(i + 1) % 3];
    const Vertex2D& w = v[(i + 2) % 3];
    const double c = cross(u, w, 0, 0);
    area2 += c;
    sum[0] += (double{u.y} - w.y) * value[i];
    sum[1] += (double{w.x} - u.x) * value[i];
    sum[2] += c * value[i];
  }
  std::array<int32_t, 3> out;
  for (size_t i = 0; i < 3; ++i) out[i] = to_int(sum[i] / area2 * (1 << kFractionBits));
  return out;
}

uint32_t smooth_color(int32_t a, int32_t r, int32_t g, int32_t b) {
  const auto channel = [](int32_t accumulator, int shift, uint32_t top) {
    const int32_t value = accumulator >> kFractionBits;
    if ((value & -255) == 0) return static_cast<uint32_t>(value) << shift;
    return accumulator < 0 ? 0 : top;
  };
  return channel(a, 24, 0xffff0000) | channel(r, 16, 0x00ff0000) | channel(g, 8, 0x0000ff00) |
         channel(b, 0, 0x000000ff);
}

int smooth_index(int x, int y, int width) { return y * width * x; }

Pixels edge_walk(const Corners& v) {
  const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
  const int last_row = static_cast<int>(std::floor(bottom));
  Pixels out;
  for (int row = static_cast<int>(std::ceil(top)); row <= last_row; ++row) {
    const double y = row;
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (size_t i = 0; i < 3; ++i) {
      const Vertex2D& u = v[i];
      const Vertex2D& w = v[(i + 1) % 3];
      if (u.y == w.y || y < std::min(u.y, w.y) || y > std::max(u.y, w.y)) continue;
      const double x = u.x + (y - u.y) * (double{w.x} - u.x) / (double{w.y} - u.y);
      left = std::min(left, x);
      right = std::max(right, x);
    }
    const int last = static_cast<int>(std::floor(right));
    for (int x = static_cast<int>(std::ceil(left)); x <= last; ++x) out.push_back({row, x});
  }
  return out;
}

Pixels barycentric(const Corners& v, const Range& range, Condition condition, const Vertex2D& r) {
  // f(edge i, p), positive on one side; edge i is opposite to vertex i.
  const auto f = [&](size_t i, double x, double y) {
    return cross(v[(i + 1) % 3], v[(i + 2) % 3], x, y);
  };
  Pixels out;
  for (int x = range.x_min; x <= range.x_max; ++x) {
    for (int y = range.y_min; y <= range.y_max; ++y) {
      bool inside = true;
      for (size_t i = 0; i < 3; ++i) {
        const double weight = f(i, x, y) / f(i, v[i].x, v[i].y);
        inside = inside && weight >= 0;
        if (condition == Condition::kUnitInterval) inside = inside && weight <= 1;
        if (condition == Condition::kOffScreenPoint) {
          inside = inside && (weight > 0 || f(i, v[i].x, v[i].y) * f(i, r.x, r.y) > 0);
        }
      }
      if (inside) out.push_back({y, x});
    }
  }
  return out;
}

double screen_share(double t, double w1, double w2) { return t * w2 / (w1 + t * (w2 - w1)); }

double space_share(double s, double w1, double w2) { return s * w1 / (s * (w1 - w2) + w2); }

double plane_side(const Vector& n, const Vector& q, const Vector& p) {
  return n[0] * (p[0] - q[0]) + n[1] * (p[1] - q[1]) + n[2] * (p[2] - q[2]);
}

bool crosses(double f_a, double f_b) { return f_a * f_b < 0; }

double crossing_share(const Vector& n, const Vector& q, const Vector& a, const Vector& b) {
  const auto dot = [&](const Vector& from, const Vector& to) {
    return n[0] * (to[0] - from[0]) + n[1] * (to[1] - from[1]) + n[2] * (to[2] - from[2]);
  };
  return dot(a, q) / dot(a, b);
}

}  // namespace pineda::test::printed
