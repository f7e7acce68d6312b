#include "model/scene/clip.h"

namespace pineda::scene {

// Viewport: x = (x/w + 1) * width/2, y = (1 - y/w) * height/2.
ClipVolume::ClipVolume(int width, int height, const spec::Design& design, DepthPlanes depth) {
  const double half_width = width / 2.0;
  const double half_height = height / 2.0;
  const double low = 1 << design.guard_bits;  // px, towards left and top
  const double high = low - 1. / (1 << design.subpixel_bits);
  constexpr Plane kEverywhere = {0, 0, 0, 0};
  planes_ = {{depth.low ? Plane{0, 0, 1, 0} : kEverywhere,
              depth.high ? Plane{0, 0, -1, 1} : kEverywhere,
              {half_width, 0, 0, low + half_width},
              {-half_width, 0, 0, high - half_width},
              {0, -half_height, 0, low + half_height},
              {0, half_height, 0, high - half_height}}};
}

double ClipVolume::distance(const Plane& plane, const ClipVertex& vertex) {
  double sum = 0;
  for (size_t i = 0; i < 4; ++i) sum += plane[i] * vertex.position[i];
  return sum;
}

unsigned ClipVolume::outside(const ClipVertex& vertex) const {
  unsigned mask = 0;
  for (size_t i = 0; i < kPlanes; ++i) {
    mask |= distance(planes_[i], vertex) < 0 ? 1u << i : 0u;
  }
  return mask;
}

Polygon ClipVolume::clip(const Plane& plane, const Polygon& polygon) {
  const auto cut = [](const ClipVertex& in, double d_in, const ClipVertex& out, double d_out) {
    const double t = d_in / (d_in - d_out);
    ClipVertex v;
    for (size_t i = 0; i < 4; ++i) {
      v.position[i] = in.position[i] + t * (out.position[i] - in.position[i]);
      v.rgba[i] = in.rgba[i] + t * (out.rgba[i] - in.rgba[i]);
    }
    return v;
  };
  Polygon result;
  for (size_t i = 0; i < polygon.size; ++i) {
    const ClipVertex& a = polygon.v[i];
    const ClipVertex& b = polygon.v[(i + 1) % polygon.size];
    const double d_a = distance(plane, a);
    const double d_b = distance(plane, b);
    if (d_a >= 0) result.v[result.size++] = a;
    if (d_a >= 0 && d_b < 0) result.v[result.size++] = cut(a, d_a, b, d_b);
    if (d_a < 0 && d_b >= 0) result.v[result.size++] = cut(b, d_b, a, d_a);
  }
  return result;
}

Polygon ClipVolume::clip(const std::array<ClipVertex, 3>& triangle) const {
  Polygon polygon;
  polygon.size = 3;
  for (size_t i = 0; i < 3; ++i) polygon.v[i] = triangle[i];
  for (const Plane& plane : planes_) polygon = clip(plane, polygon);
  return polygon;
}

}  // namespace pineda::scene
