// The values of a triangle at a sample, and flattening of a polygon.
#include <algorithm>
#include <cmath>
#include <limits>

#include "model/exact/lines.h"
#include "model/exact/mesh.h"

namespace exact {

FlatPolygon flattened(const std::vector<ClipCorner>& corners, const MeshFrame& frame) {
  using Point = Vector<long double>;
  FlatPolygon flat{corners, 0};
  const ClipCorner& origin = corners[0];
  const auto from_origin = [&](const ClipCorner& c) {
    const long double x = origin.x, y = origin.y, w = origin.w;
    return Corner<long double>{c.x - x, c.y - y, 0, c.w - w};
  };
  Point normal{}, middle{};
  for (size_t i = 0; i < corners.size(); ++i) {
    const auto p = from_origin(corners[i]);
    const auto n = cross(p, from_origin(corners[(i + 1) % corners.size()]));
    for (size_t k = 0; k < normal.size(); ++k) normal[k] += n[k];
    middle = {middle[0] + p.x, middle[1] + p.y, middle[2] + p.w};
  }
  const long double length = std::hypot(normal[0], normal[1], normal[2]);
  const auto count = static_cast<long double>(corners.size());
  const long double plane =
      (normal[0] * middle[0] + normal[1] * middle[1] + normal[2] * middle[2]) / count;
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  for (ClipCorner& c : flat.corner) {
    const long double off = (dot(normal, from_origin(c)) - plane) / length;
    const long double greatest = std::max(
        {std::abs<long double>(c.x), std::abs<long double>(c.y), std::abs<long double>(c.w)});
    if (std::abs(off) <= std::ldexp(greatest, -40)) continue;  // off the plane only by rounding
    const ClipCorner from = c;
    c.x = static_cast<double>(c.x - off * normal[0] / length);
    c.y = static_cast<double>(c.y - off * normal[1] / length);
    c.w = static_cast<double>(c.w - off * normal[2] / length);
    const double dx = (c.x / c.w - from.x / from.w) * frame.width / 2;
    const double dy = (c.y / c.w - from.y / from.w) * frame.height / 2;
    const double moved = std::max(std::abs(dx), std::abs(dy));
    const bool is_seen = from.w > 0 && c.w > 0 && std::isfinite(moved);
    flat.moved_px = std::max(flat.moved_px, is_seen ? moved : kNowhere);
  }
  if (!(length > 0)) flat.moved_px = kNowhere;
  return flat;
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
