#include "examples/llvmpipe/exact_triangle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace pineda::llvmpipe {
namespace {

constexpr int64_t kPx = 256;
constexpr double kTopCode = 0xffffff;

/// Twice the area of an edge and a point.
int64_t edge(const spec::Vertex& from, const spec::Vertex& to, int64_t x, int64_t y) {
  return (int64_t{to.x} - from.x) * (y - from.y) - (int64_t{to.y} - from.y) * (x - from.x);
}

/// max(|dz/dx|, |dz/dy|) in codes a px.
double steepness(const std::array<spec::Vertex, 3>& v, int64_t area) {
  const auto along = [&](int32_t spec::Vertex::*at) {
    const auto z1 = static_cast<double>(v[1].z - v[0].z), z2 = static_cast<double>(v[2].z - v[0].z);
    return std::fabs(z1 * (v[2].*at - v[0].*at) - z2 * (v[1].*at - v[0].*at));
  };
  // Depths have 8 fraction bits, as positions have.
  return std::max(along(&spec::Vertex::x), along(&spec::Vertex::y)) /
         static_cast<double>(std::llabs(area));
}

}  // namespace

ExactTriangle::ExactTriangle(const spec::Triangle& snapped, const scene::ScreenTriangle& stated,
                             const spec::FrameState& frame)
    : v_(snapped.v), stated_(stated), frame_(frame), area_(edge(v_[0], v_[1], v_[2].x, v_[2].y)) {
  is_drawn_ = area_ != 0 && frame.cull != (area_ > 0 ? spec::Cull::kBack : spec::Cull::kFront);
  if (!is_drawn_) return;
  bias_codes_ =
      static_cast<double>(frame.bias_constant) + frame.bias_slope / 256. * steepness(v_, area_);
  const auto [left, right] = std::minmax({v_[0].x, v_[1].x, v_[2].x});
  const auto [top, bottom] = std::minmax({v_[0].y, v_[1].y, v_[2].y});
  box_ = {std::max((left >> 8) - 1, 0), std::min((right >> 8) + 1, frame.width - 1),
          std::max((top >> 8) - 1, 0), std::min((bottom >> 8) + 1, frame.height - 1)};
}

int64_t ExactTriangle::inside(size_t corner, int x, int y) const {
  const int64_t e = edge(v_[corner], v_[(corner + 1) % 3], kPx * x + kPx / 2, kPx * y + kPx / 2);
  return area_ > 0 ? e : -e;
}

bool ExactTriangle::is_top_left(size_t corner) const {
  const spec::Vertex &from = v_[corner], &to = v_[(corner + 1) % 3];
  const int64_t dx = area_ > 0 ? to.x - from.x : from.x - to.x;
  const int64_t dy = area_ > 0 ? to.y - from.y : from.y - to.y;
  return dy < 0 || (dy == 0 && dx > 0);
}

bool ExactTriangle::covers(int x, int y) const {
  if (!is_drawn_ || x < frame_.clip_x0() || x >= frame_.clip_x1() || y < frame_.clip_y0() ||
      y >= frame_.clip_y1()) {
    return false;
  }
  for (size_t i = 0; i < 3; ++i) {
    const int64_t e = inside(i, x, y);
    if (e < 0 || (e == 0 && !is_top_left(i))) return false;
  }
  return true;
}

Values ExactTriangle::values(int x, int y) const {
  std::array<long double, 3> weight{}, by_w{};
  for (size_t i = 0; i < 3; ++i) {
    weight[i] = static_cast<long double>(inside((i + 1) % 3, x, y));
    by_w[i] = weight[i] / static_cast<long double>(stated_.v[i].w);
  }
  const auto mean = [](const std::array<long double, 3>& by, const auto& value) {
    return static_cast<double>((by[0] * value(0) + by[1] * value(1) + by[2] * value(2)) /
                               (by[0] + by[1] + by[2]));
  };
  Values values;
  const double z = mean(weight, [&](size_t i) { return static_cast<long double>(v_[i].z); }) / 256;
  values.depth = std::clamp(z + bias_codes_, 0., kTopCode);
  for (size_t k = 0; k < 4; ++k) {
    values.rgba[k] = frame_.shade == spec::Shade::kFlat
                         ? stated_.v[0].rgba[k]
                         : mean(by_w, [&](size_t i) { return stated_.v[i].rgba[k]; });
  }
  return values;
}

std::pair<double, size_t> ExactTriangle::inside_px(int x, int y) const {
  std::pair<double, size_t> least{HUGE_VAL, 0};
  for (size_t i = 0; i < 3; ++i) {
    const spec::Vertex &from = v_[i], &to = v_[(i + 1) % 3];
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    least = std::min(least, {static_cast<double>(inside(i, x, y)) / length / kPx, i});
  }
  return least;
}

}  // namespace pineda::llvmpipe
