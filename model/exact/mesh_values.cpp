// A triangle's values at a sample, and whether a polygon is plane.
#include <algorithm>
#include <cmath>
#include <limits>

#include "model/exact/lines.h"
#include "model/exact/mesh.h"

namespace exact {

bool is_plane(const std::vector<ClipCorner>& corners) {
  using Point = Vector<long double>;
  Point origin{corners[0].x, corners[0].y, corners[0].w}, normal{};
  long double greatest = 0;
  const auto from_origin = [&](const ClipCorner& c) {
    return Corner<long double>{c.x - origin[0], c.y - origin[1], 0, c.w - origin[2]};
  };
  for (size_t i = 0; i < corners.size(); ++i) {
    const ClipCorner& c = corners[i];
    greatest = std::max({greatest, std::abs<long double>(c.x), std::abs<long double>(c.y),
                         std::abs<long double>(c.w)});
    const auto n = cross(from_origin(c), from_origin(corners[(i + 1) % corners.size()]));
    for (size_t k = 0; k < normal.size(); ++k) normal[k] += n[k];
  }
  const long double length = std::hypot(normal[0], normal[1], normal[2]);
  return std::all_of(corners.begin(), corners.end(), [&](const ClipCorner& c) {
    return std::abs(dot(normal, from_origin(c))) <= std::ldexp(length * greatest, -22);
  });
}

FaceValues::FaceValues(const std::array<ClipCorner, 3>& corner, const MeshFrame& frame)
    : corner_(corner),
      band_(std::ldexp(static_cast<long double>(frame.band), -MeshFrame::kBandFractionBits)) {
  const long double w = frame.width, h = frame.height;
  const auto point = [&](size_t i) {
    const ClipCorner& c = corner[i % 3];
    return Corner<long double>{c.x, c.y, c.z, c.w};
  };
  area_ = determinant(point(0), point(1), point(2));
  for (size_t i = 0; i < 3; ++i) {
    const auto n = cross(point(i + 1), point(i + 2));
    weight_[i] = {2 * n[0] / w, -2 * n[1] / h, n[0] * (1 - w) / w + n[1] * (h - 1) / h + n[2]};
  }
}

Range FaceValues::depth(int x, int y) const {
  Row sum{};
  bool is_in_front = true;
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (size_t i = 0; i < 3; ++i) {
    for (size_t k = 0; k < sum.size(); ++k) sum[k] += weight_[i][k] * corner_[i].z;
    is_in_front = is_in_front && corner_[i].w > 0;
    least = std::min(least, corner_[i].z / corner_[i].w);
    greatest = std::max(greatest, corner_[i].z / corner_[i].w);
  }
  Range range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  if (area_ != 0) {
    const long double middle = at(sum, x, y) / area_;
    const long double reach = band_ * (std::abs(sum[0]) + std::abs(sum[1])) / std::abs(area_);
    range = {static_cast<double>(middle - reach), static_cast<double>(middle + reach)};
  }
  if (!is_in_front) return range;
  return {std::clamp(range.low, least, greatest), std::clamp(range.high, least, greatest)};
}

Range FaceValues::attribute(int x, int y, const std::array<double, 3>& value) const {
  const auto [least, greatest] = std::minmax_element(value.begin(), value.end());
  Range range{*greatest, *least};
  for (const long double dx : {-band_, band_}) {
    for (const long double dy : {-band_, band_}) {
      long double sum = 0, weights = 0;
      for (size_t i = 0; i < 3; ++i) {
        const long double weight = at(weight_[i], x + dx, y + dy);
        sum += weight * value[i];
        weights += weight;
      }
      if (!(weights * area_ > 0)) return {*least, *greatest};
      const auto here = std::clamp(static_cast<double>(sum / weights), *least, *greatest);
      range = {std::min(range.low, here), std::max(range.high, here)};
    }
  }
  return range;
}

}  // namespace exact
