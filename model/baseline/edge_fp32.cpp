#include <algorithm>
#include <cmath>

#include "model/baseline/edge_equation.h"
#include "model/baseline/makers.h"

namespace pineda::baseline {

using spec::Contract;
using spec::FrameState;
using spec::Triangle;

namespace {

// To 12 fraction bits, rounded half up, clamped to +-2^61, so that sums of a few fit into 64 bits.
int64_t fixed(float value) {
  constexpr double kLimit = 0x1p61;
  const double scaled = static_cast<double>(value) * kOne;
  if (std::isnan(scaled)) return 0;
  return static_cast<int64_t>(std::floor(std::clamp(scaled, -kLimit, kLimit) + .5));
}

enum class CForm { kDeterminant, kVertex, kAverage };

// Setup in binary32, the draw loop in integers: so the errors measured are those of the setup.
//
// As printed  A, B, C from the vertices as floats, C in one of three ways; orientation and area
//             from the sum of the C's; the planes from the same coefficients.
// Mended      only the draw loop. For slivers, and far from the origin, cancellation in the sum of
//             the C's destroys the area: triangles change orientation, disappear, or cover wrong
//             samples.
class SinglePrecision final : public EdgeEquation {
 public:
  SinglePrecision(const Contract& c, const FrameState& frame, CForm form)
      : EdgeEquation(c, frame), form_(form) {}

 protected:
  bool set_up(const Triangle& t, Setup* setup) const override {
    std::array<Coefficients, 3> edge;
    for (size_t i = 0; i < 3; ++i) edge[i] = coefficients(t.v[i], t.v[(i + 1) % 3]);
    float area2 = edge[0].c + edge[1].c + edge[2].c;
    if (dropped(area2)) return false;
    if (area2 < 0) {
      for (auto& e : edge) e = {-e.a, -e.b, -e.c};
      area2 = -area2;
    }
    for (size_t i = 0; i < 3; ++i) setup->edge[i] = fixed_edge(edge[i]);
    const std::array<Parameters, 3> value = parameters(t);
    for (size_t i = 0; i < kParameters; ++i) {
      setup->plane[i] = plane(edge, 1 / area2,
                              {static_cast<float>(value[0][i]), static_cast<float>(value[1][i]),
                               static_cast<float>(value[2][i])});
    }
    return true;
  }

 private:
  struct Coefficients {
    float a, b, c;
  };

  Coefficients coefficients(const spec::Vertex& v0, const spec::Vertex& v1) const {
    const auto px = [&](int32_t v) { return std::ldexp(static_cast<float>(v), -subpixel_bits_); };
    const float x0 = px(v0.x), y0 = px(v0.y), x1 = px(v1.x), y1 = px(v1.y);
    const float a = y0 - y1;
    const float b = x1 - x0;
    switch (form_) {
      case CForm::kDeterminant:
        return {a, b, x0 * y1 - x1 * y0};
      case CForm::kVertex:
        return {a, b, -a * x0 - b * y0};
      case CForm::kAverage:
        break;
    }
    return {a, b, -.5f * (a * (x0 + x1) + b * (y0 + y1))};
  }

  static Edge fixed_edge(const Coefficients& e) {
    const bool top_left = e.a > 0 || (e.a == 0 && e.b > 0);
    const int64_t a = fixed(e.a);
    const int64_t b = fixed(e.b);
    return {a, b, fixed(e.c) + ((a + b) >> 1) - (top_left ? 0 : 1), top_left};
  }

  static Plane plane(const std::array<Coefficients, 3>& edge, float scale,
                     const std::array<float, 3>& value) {
    const auto solve = [&](float of_v0, float of_v1, float of_v2) {
      return fixed(scale * (of_v0 * value[0] + of_v1 * value[1] + of_v2 * value[2]));
    };
    const auto& [e0, e1, e2] = edge;
    const int64_t dx = solve(e1.a, e2.a, e0.a);
    const int64_t dy = solve(e1.b, e2.b, e0.b);
    return {dx, dy, solve(e1.c, e2.c, e0.c) + ((dx + dy) >> 1)};
  }

  CForm form_;
};

}  // namespace

std::unique_ptr<Rasterizer> make_edge_fp32_determinant(const Contract& c, const FrameState& frame) {
  return std::make_unique<SinglePrecision>(c, frame, CForm::kDeterminant);
}

std::unique_ptr<Rasterizer> make_edge_fp32_vertex(const Contract& c, const FrameState& frame) {
  return std::make_unique<SinglePrecision>(c, frame, CForm::kVertex);
}

std::unique_ptr<Rasterizer> make_edge_fp32_average(const Contract& c, const FrameState& frame) {
  return std::make_unique<SinglePrecision>(c, frame, CForm::kAverage);
}

}  // namespace pineda::baseline
