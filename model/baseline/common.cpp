#include "model/baseline/common.h"

#include <algorithm>
#include <cmath>

namespace pineda::baseline {

using spec::Contract;
using spec::FrameState;
using spec::Triangle;
using spec::Vertex;

namespace {

// Rounded half up and clamped to [0, top]; a NaN fails both comparisons and becomes 0.
int64_t code(double value, int64_t top) {
  if (value >= static_cast<double>(top)) return top;
  return value > 0 ? static_cast<int64_t>(std::floor(value + .5)) : 0;
}

int64_t code(int64_t value, int64_t top) { return std::clamp<int64_t>(value, 0, top); }

}  // namespace

Common::Common(const Contract& contract, const FrameState& frame)
    : subpixel_bits_(contract.design.subpixel_bits),
      depth_top_((int64_t{1} << contract.design.depth_bits) - 1),
      attribute_top_((int64_t{1} << contract.design.attribute_bits) - 1),
      frame_(frame) {}

int64_t Common::doubled_area(const Triangle& t) {
  const auto& v = t.v;
  return (int64_t{v[1].x} - v[0].x) * (int64_t{v[2].y} - v[0].y) -
         (int64_t{v[2].x} - v[0].x) * (int64_t{v[1].y} - v[0].y);
}

Edges Common::edges(const Triangle& t) const {
  Edges out;
  out.area2 = doubled_area(t);
  out.clockwise = out.area2 > 0;
  const int sign = out.clockwise ? 1 : -1;
  out.area2 *= sign;
  const int64_t half = int64_t{1} << (subpixel_bits_ - 1);
  for (size_t i = 0; i < 3; ++i) {
    const Vertex& u = t.v[i];
    const Vertex& w = t.v[(i + 1) % 3];
    const int64_t a = sign * (int64_t{u.y} - w.y);
    const int64_t b = sign * (int64_t{w.x} - u.x);
    out.edge[i] = {2 * half * a, 2 * half * b, a * (half - u.x) + b * (half - u.y),
                   a > 0 || (a == 0 && b > 0)};
  }
  return out;
}

Box Common::box(int x_low, int y_low, int x_high, int y_high) const {
  // No sample on the right or bottom border can be on a top or left edge only.
  const int half = 1 << (subpixel_bits_ - 1);
  const auto first = [&](int low) { return std::max((low + half - 1) >> subpixel_bits_, 0); };
  const auto last = [&](int high, int size) {
    return std::min((high - half - 1) >> subpixel_bits_, size - 1);
  };
  return {first(x_low), first(y_low), last(x_high, frame_.width), last(y_high, frame_.height)};
}

Box Common::box(const Triangle& t) const {
  const auto [x_low, x_high] = std::minmax({t.v[0].x, t.v[1].x, t.v[2].x});
  const auto [y_low, y_high] = std::minmax({t.v[0].y, t.v[1].y, t.v[2].y});
  return box(x_low, y_low, x_high, y_high);
}

Parameters Common::parameters(const Vertex& v) {
  Parameters p;
  for (size_t i = 0; i < kDepth; ++i) p[i] = v.attr[i];
  p[kDepth] = static_cast<double>(v.z) / (1 << spec::kDepthInputFractionBits);
  return p;
}

template <class Number>
void Common::emit(int x, int y, const std::array<Number, kParameters>& value, Sink* sink) const {
  Sample sample;
  sample.x = x;
  sample.y = y;
  sample.z = code(value[kDepth], depth_top_);
  for (size_t i = 0; i < kDepth; ++i) {
    sample.rgba[i] = static_cast<int>(code(value[i], attribute_top_));
  }
  sink->sample(sample);
}

template void Common::emit(int, int, const std::array<double, kParameters>&, Sink*) const;
template void Common::emit(int, int, const std::array<int64_t, kParameters>&, Sink*) const;

}  // namespace pineda::baseline
