#include "examples/llvmpipe/arithmetic.h"

#include <algorithm>
#include <cmath>
#ifdef __x86_64__
#include <xmmintrin.h>
#endif

namespace pineda::llvmpipe {
namespace {

using Position = std::array<float, 4>;

constexpr int64_t kPx = 256;

/// a*b + c, once rounded where the processor can: LLVM does so then.
float multiply_add(float a, float b, float c) {
#ifdef __x86_64__
  static const bool is_fused = __builtin_cpu_supports("fma") != 0;
  if (!is_fused) return a * b + c;
#endif
  return std::fma(a, b, c);
}

struct Viewport {
  explicit Viewport(const spec::FrameState& frame)
      : scale{static_cast<float>(frame.width) / 2, static_cast<float>(frame.height) / 2, 1},
        translation{scale[0], scale[1], 0} {}

  std::array<float, 3> scale, translation;
};

/// A corner as the vertex shader leaves it.
Corner shaded(const Vertex& vertex, const Viewport& viewport) {
  Corner corner{};
  std::copy_n(vertex.position, 4, corner.clip.begin());
  const float inverse_w = 1.f / corner.clip[3];
  for (size_t i = 0; i < 3; ++i) {
    corner.window[i] =
        multiply_add(corner.clip[i] * inverse_w, viewport.scale[i], viewport.translation[i]);
  }
  corner.window[3] = inverse_w;
  for (size_t i = 0; i < 4; ++i) {
    corner.rgba[i] = static_cast<float>(vertex.rgba[i]) * (1.f / 255.f);
  }
  return corner;
}

/// The corner at `share` of the way.
Corner between(const Corner& from, const Corner& to, float share, const Viewport& viewport) {
  Corner corner{};
  for (size_t i = 0; i < 4; ++i) {
    corner.clip[i] = from.clip[i] + share * (to.clip[i] - from.clip[i]);
    corner.rgba[i] = from.rgba[i] + share * (to.rgba[i] - from.rgba[i]);
  }
  const float inverse_w = 1.f / corner.clip[3];
  for (size_t i = 0; i < 3; ++i) {
    corner.window[i] = corner.clip[i] * inverse_w * viewport.scale[i] + viewport.translation[i];
  }
  corner.window[3] = inverse_w;
  return corner;
}

constexpr size_t kBorders = 6;

/// Negative outside of a border: right, left, bottom, top, near, far.
float distance(const Corner& corner, size_t border) {
  const auto& [x, y, z, w] = corner.clip;
  return std::array<float, kBorders>{w - x, w + x, w - y, w + y, z, w - z}[border];
}

std::vector<Corner> clipped(const std::vector<Corner>& polygon, size_t border,
                            const Viewport& viewport) {
  std::vector<Corner> result;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Corner &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const float before = distance(from, border), after = distance(to, border);
    if (before >= 0) result.push_back(from);
    if ((before >= 0) == (after >= 0)) continue;
    // From the corner that is nearer to the border, of two alike from the inner one.
    const float near = std::min(std::fabs(before), std::fabs(after));
    const float share = near / (std::fabs(before) + std::fabs(after));
    const bool is_from = std::fabs(before) < std::fabs(after) || (before == -after && before > 0);
    result.push_back(is_from ? between(from, to, share, viewport)
                             : between(to, from, share, viewport));
  }
  return result;
}

/// The plane through three values at the corners of a piece.
struct Slopes {
  float dx01, dy01, dx20, dy20;  // divided by the doubled area
  float x0, y0;

  explicit Slopes(const Piece& p) {
    const Position &a = p[0].window, &b = p[1].window, &c = p[2].window;
    dx01 = a[0] - b[0];
    dy01 = a[1] - b[1];
    dx20 = c[0] - a[0];
    dy20 = c[1] - a[1];
    const float forward = dx01 * dy20, backward = dy01 * dx20;
    const float inverse_area = 1.f / (forward - backward);
    dx01 *= inverse_area;
    dy01 *= inverse_area;
    dx20 *= inverse_area;
    dy20 *= inverse_area;
    x0 = a[0] - .5f;
    y0 = a[1] - .5f;
  }
  FloatPlane plane(float a, float b, float c) const {
    const float d01 = a - b, d20 = c - a;
    const float dx = d01 * dy20 - d20 * dy01;
    const float dy = d20 * dx01 - d01 * dx20;
    return {a - (dx * x0 + dy * y0), dx, dy};
  }
};

/// What a depth bias adds.
float offset_of(const Piece& p, const spec::FrameState& frame) {
  if (!frame.has_bias()) return 0;
  const Position &a = p[0].window, &b = p[1].window, &c = p[2].window;
  const float dx01 = a[0] - b[0], dy01 = a[1] - b[1], dz01 = a[2] - b[2];
  const float dx20 = c[0] - a[0], dy20 = c[1] - a[1], dz20 = c[2] - a[2];
  const float inverse_area = 1.f / (dx01 * dy20 - dy01 * dx20);
  const float dzdx = std::fabs((dz20 * dy01 - dy20 * dz01) * inverse_area);
  const float dzdy = std::fabs((dx20 * dz01 - dz20 * dx01) * inverse_area);
  const auto units = static_cast<float>(static_cast<double>(frame.bias_constant) * (1. / 0xffffff));
  return units + std::max(dzdx, dzdy) * (static_cast<float>(frame.bias_slope) / 256);
}

}  // namespace

#ifdef __x86_64__
DenormalsAreZero::DenormalsAreZero() : before_(_mm_getcsr()) {
  constexpr unsigned kOperands = 0x40, kResults = 0x8000;
  _mm_setcsr(before_ | kOperands | kResults);
}
DenormalsAreZero::~DenormalsAreZero() { _mm_setcsr(before_); }
#else
DenormalsAreZero::DenormalsAreZero() = default;
DenormalsAreZero::~DenormalsAreZero() = default;
#endif

float FloatPlane::at(int x, int y) const {
  return multiply_add(dy, static_cast<float>(y), multiply_add(dx, static_cast<float>(x), origin));
}

std::vector<Piece> pieces_of(const std::array<Vertex, 3>& triangle, const spec::FrameState& frame) {
  const Viewport viewport(frame);
  std::vector<Corner> polygon;
  for (const Vertex& vertex : triangle) polygon.push_back(shaded(vertex, viewport));
  const Corner first = polygon.front();
  std::array<int, kBorders> outside{};
  for (size_t border = 0; border < kBorders; ++border) {
    for (const Corner& corner : polygon) outside[border] += distance(corner, border) < 0 ? 1 : 0;
    if (outside[border] == 3) return {};
  }
  for (size_t border = 0; border < kBorders; ++border) {
    if (outside[border] != 0 && polygon.size() >= 3) polygon = clipped(polygon, border, viewport);
  }
  std::vector<Piece> pieces;
  for (size_t i = 2; i < polygon.size(); ++i) {
    pieces.push_back({polygon[0], polygon[i - 1], polygon[i]});
    if (frame.shade == spec::Shade::kFlat) pieces.back()[0].rgba = first.rgba;
  }
  return pieces;
}

Drawable::Drawable(const Piece& piece, const spec::FrameState& frame)
    : is_flat_(frame.shade == spec::Shade::kFlat) {
  for (size_t i = 0; i < 3; ++i) {
    x_[i] = std::lrint((piece[i].window[0] - .5f) * 256);
    y_[i] = std::lrint((piece[i].window[1] - .5f) * 256);
  }
  const int64_t area = (x_[1] - x_[0]) * (y_[2] - y_[0]) - (x_[2] - x_[0]) * (y_[1] - y_[0]);
  const bool is_clockwise = area > 0;
  is_drawn_ = area != 0 && frame.cull != (is_clockwise ? spec::Cull::kBack : spec::Cull::kFront);
  if (!is_drawn_) return;
  Piece turned = piece;
  if (is_clockwise) {
    std::swap(turned[1], turned[2]);
  } else {
    std::swap(x_[1], x_[2]);
    std::swap(y_[1], y_[2]);
  }
  const Slopes slopes(turned);
  const auto plane = [&](auto value) {
    return slopes.plane(value(turned[0]), value(turned[1]), value(turned[2]));
  };
  z_ = plane([](const Corner& c) { return c.window[2]; });
  inverse_w_ = plane([](const Corner& c) { return c.window[3]; });
  for (size_t i = 0; i < 4; ++i) {
    rgba_[i] = is_flat_ ? FloatPlane{turned[0].rgba[i], 0, 0}
                        : plane([i](const Corner& c) { return c.rgba[i] * c.window[3]; });
  }
  offset_ = offset_of(turned, frame);
  const auto [left, right] = std::minmax_element(x_.begin(), x_.end());
  const auto [top, bottom] = std::minmax_element(y_.begin(), y_.end());
  box_ = {static_cast<int>(std::max<int64_t>(*left >> 8, std::max(frame.clip_x0(), 0))),
          static_cast<int>(std::min<int64_t>(*right >> 8, frame.clip_x1() - 1)),
          static_cast<int>(std::max<int64_t>(*top >> 8, std::max(frame.clip_y0(), 0))),
          static_cast<int>(std::min<int64_t>(*bottom >> 8, frame.clip_y1() - 1))};
}

int64_t Drawable::inside(size_t corner, int x, int y) const {
  const size_t to = (corner + 1) % 3;
  return (x_[to] - x_[corner]) * (int64_t{y} * kPx - y_[corner]) -
         (y_[to] - y_[corner]) * (int64_t{x} * kPx - x_[corner]);
}

bool Drawable::covers(int x, int y) const {
  for (size_t i = 0; i < 3; ++i) {
    const int64_t dx = x_[(i + 1) % 3] - x_[i], dy = y_[(i + 1) % 3] - y_[i];
    const int64_t e = inside(i, x, y);
    if (e < 0 || (e == 0 && !(dy < 0 || (dy == 0 && dx > 0)))) return false;
  }
  return true;
}

double Drawable::inside_px(int x, int y) const {
  double least = HUGE_VAL;
  for (size_t i = 0; i < 3; ++i) {
    const auto dx = static_cast<double>(x_[(i + 1) % 3] - x_[i]);
    const auto dy = static_cast<double>(y_[(i + 1) % 3] - y_[i]);
    least = std::min(least, static_cast<double>(inside(i, x, y)) / std::hypot(dx, dy) / kPx);
  }
  return least;
}

uint32_t Drawable::depth(int x, int y) const {
  const float value = z_.at(x, y) + offset_;
  const float z = value < 1 ? std::max(value, 0.f) : 1;  // of no number 1
  return static_cast<uint32_t>(std::lrint(z * 16777215.f));
}

std::array<uint8_t, 4> Drawable::color(int x, int y) const {
  std::array<uint8_t, 4> rgba{};
  const float w = 1.f / inverse_w_.at(x, y);
  for (size_t i = 0; i < 4; ++i) {
    const float value = is_flat_ ? rgba_[i].origin : rgba_[i].at(x, y) * w;
    rgba[i] = static_cast<uint8_t>(std::lrint(std::clamp(value, 0.f, 1.f) * 255.f));
  }
  return rgba;
}

}  // namespace pineda::llvmpipe
