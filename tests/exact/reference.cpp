#include "tests/exact/reference.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace exact {

namespace {

Rational exactly(float value) { return Rational(static_cast<double>(value)); }

Rational power_of_two(int exponent) { return Rational(Integer(1) << exponent); }

// In px.
Rational snapped(float value, const Format& format, bool ties_up) {
  const Rational limit = power_of_two(format.guard_bits);
  const Rational unit = 1 / power_of_two(format.subpixel_bits);
  if (std::isinf(value)) return value < 0 ? Rational(-limit) : Rational(limit - unit);
  const Rational scaled = exactly(value) / unit;
  Integer nearest = floor_of(scaled);
  const Rational rest = scaled - nearest;
  const Rational half(1, 2);
  if (rest > half || (rest == half && (nearest % 2 != 0 || ties_up))) ++nearest;
  return std::clamp(Rational(nearest * unit), Rational(-limit), Rational(limit - unit));
}

// In codes.
Rational depth(float value, const Format& format, bool truncated) {
  const Rational z = exactly(std::clamp(value, 0.0f, 1.0f));
  const Rational codes = z * (power_of_two(format.depth_bits) - 1);
  return Rational(floor_of(codes * 256 + (truncated ? Rational(0) : Rational(1, 2))), 256);
}

Rational colour(int value, const Format& format) {
  const Rational codes = Rational(value, 255) * (power_of_two(format.attribute_bits) - 1);
  return Rational(floor_of(codes + Rational(1, 2)));
}

}  // namespace

Integer floor_of(const Rational& r) {
  Integer quotient = numerator(r) / denominator(r);
  if (quotient * denominator(r) > numerator(r)) --quotient;
  return quotient;
}

Reference::Reference(const ScreenTriangle& triangle, const Format& format, const Frame& frame,
                     Fault fault)
    : frame_(frame), top_code_(power_of_two(format.depth_bits) - 1), fault_(fault) {
  for (size_t i = 0; i < 3; ++i) {
    const ScreenVertex& v = triangle[i];
    Corner& c = corner_[i];
    c.p = {snapped(v.x, format, fault == Fault::kTiesUp),
           snapped(v.y, format, fault == Fault::kTiesUp)};
    c.z = depth(v.z, format, fault == Fault::kTruncatedDepth);
    c.w = exactly(v.w);
    for (size_t a = 0; a < 4 && a < static_cast<size_t>(format.attributes); ++a) {
      c.attribute[a] = colour((frame.flat ? triangle[0] : v).rgba[a], format);
    }
  }
}

Rational Reference::edge(const Point& from, const Point& to, const Point& p) {
  return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
}

Rational Reference::doubled_area() const { return edge(corner_[0].p, corner_[1].p, corner_[2].p); }

bool Reference::covers(int x, int y) const {
  const Rational area = doubled_area();
  if (area == 0) return false;
  if (x < frame_.x0 || x >= frame_.x1 || y < frame_.y0 || y >= frame_.y1) return false;
  std::array<Point, 3> v{corner_[0].p, corner_[1].p, corner_[2].p};
  if (area < 0) std::swap(v[1], v[2]);
  for (size_t i = 0; i < 3; ++i) {
    const Point& from = v[i];
    const Point& to = v[(i + 1) % 3];
    const Rational e = edge(from, to, centre(x, y));
    const bool left = to.y < from.y;
    const bool top = to.y == from.y && to.x > from.x;
    if (e < 0 || (e == 0 && !top && !left && fault_ != Fault::kInclusiveEdges)) return false;
  }
  return true;
}

Rational Reference::barycentric(size_t i, const Point& p) const {
  return edge(corner_[(i + 1) % 3].p, corner_[(i + 2) % 3].p, p) / doubled_area();
}

Rational Reference::z(int x, int y) const {
  // These samples may lie outside the triangle: the slope is that of the plane.
  const Rational dx = abs(plane(1, 0) - plane(0, 0));
  const Rational dy = abs(plane(0, 1) - plane(0, 0));
  const Rational slope = fault_ == Fault::kSlopesSummed ? Rational(dx + dy) : std::max(dx, dy);
  const Rational bias = frame_.bias_constant + Rational(frame_.bias_slope, 256) * slope;
  return std::clamp(Rational(plane(x, y) + bias), Rational(0), top_code_);
}

Rational Reference::plane(int x, int y) const {
  Rational sum = 0;
  for (size_t i = 0; i < 3; ++i) sum += barycentric(i, centre(x, y)) * corner_[i].z;
  return sum;
}

Rational Reference::affine(int x, int y, size_t attribute) const {
  Rational sum = 0;
  for (size_t i = 0; i < 3; ++i) {
    sum += barycentric(i, centre(x, y)) * corner_[i].attribute[attribute];
  }
  return sum;
}

Rational Reference::perspective(int x, int y, size_t attribute) const {
  Rational sum = 0;
  Rational weights = 0;
  for (size_t i = 0; i < 3; ++i) {
    const Rational share = barycentric(i, centre(x, y));
    const Rational weight =
        share * (fault_ == Fault::kWNotInverted ? corner_[i].w : Rational(1 / corner_[i].w));
    sum += weight * corner_[i].attribute[attribute];
    weights += weight;
  }
  return sum / weights;
}

}  // namespace exact
