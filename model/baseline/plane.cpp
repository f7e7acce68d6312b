#include <cmath>

#include "model/baseline/common.h"
#include "model/baseline/makers.h"

namespace pineda::baseline {

using spec::Triangle;

namespace {

// a*x + b*y + c, x and y in px.
template <class Real>
struct Linear {
  Real a, b, c;
  Real at(Real x, Real y) const { return a * x + b * y + c; }
};

// Edge functions and planes in one floating-point format, evaluated at each sample of the box.
//
// As printed  C = x0*y1 - x1*y0; doubled area as the sum of the C's; planes from the origin.
// Mended      the top-left rule. In double precision edges are exact up to 11 subpixel bits, but
//             planes are not: a sliver's are steep, and they are evaluated from the origin. In
//             single precision only A and B are exact; that is left as it is.
template <class Real>
class FloatingPoint final : public Common {
 public:
  using Common::Common;

  void draw(const Triangle& t, Sink* sink) override {
    std::array<Linear<Real>, 3> edge;
    for (size_t i = 0; i < 3; ++i) edge[i] = edge_of(t.v[i], t.v[(i + 1) % 3]);
    Real area2 = edge[0].c + edge[1].c + edge[2].c;
    if (dropped(area2)) return;
    if (area2 < 0) {
      for (auto& e : edge) e = {-e.a, -e.b, -e.c};
      area2 = -area2;
    }
    const std::array<Parameters, 3> value = parameters(t);
    std::array<Linear<Real>, kParameters> plane;
    for (size_t i = 0; i < kParameters; ++i) {
      plane[i] = plane_of(edge, area2,
                          {static_cast<Real>(value[0][i]), static_cast<Real>(value[1][i]),
                           static_cast<Real>(value[2][i])});
    }
    scan(edge, plane, box(t), sink);
  }

 private:
  Linear<Real> edge_of(const spec::Vertex& v0, const spec::Vertex& v1) const {
    const auto px = [&](int32_t v) { return std::ldexp(static_cast<Real>(v), -subpixel_bits_); };
    const Real x0 = px(v0.x), y0 = px(v0.y), x1 = px(v1.x), y1 = px(v1.y);
    return {y0 - y1, x1 - x0, x0 * y1 - x1 * y0};
  }

  static Linear<Real> plane_of(const std::array<Linear<Real>, 3>& edge, Real area2,
                               const std::array<Real, 3>& value) {
    const auto solve = [&](Real of_v0, Real of_v1, Real of_v2) {
      return (of_v0 * value[0] + of_v1 * value[1] + of_v2 * value[2]) / area2;
    };
    const auto& [e0, e1, e2] = edge;
    return {solve(e1.a, e2.a, e0.a), solve(e1.b, e2.b, e0.b), solve(e1.c, e2.c, e0.c)};
  }

  static bool inside(const Linear<Real>& edge, Real x, Real y) {
    const Real e = edge.at(x, y);
    return e > 0 || (e == 0 && (edge.a > 0 || (edge.a == 0 && edge.b > 0)));
  }

  void scan(const std::array<Linear<Real>, 3>& edge,
            const std::array<Linear<Real>, kParameters>& plane, const Box& pixels, Sink* sink) {
    for (int j = pixels.y0; j <= pixels.y1; ++j) {
      const Real y = static_cast<Real>(j) + Real{.5};
      for (int i = pixels.x0; i <= pixels.x1; ++i) {
        ++visited_;
        const Real x = static_cast<Real>(i) + Real{.5};
        if (!inside(edge[0], x, y) || !inside(edge[1], x, y) || !inside(edge[2], x, y)) continue;
        Parameters value;
        for (size_t k = 0; k < kParameters; ++k) value[k] = plane[k].at(x, y);
        emit(i, j, value, sink);
      }
    }
  }
};

}  // namespace

std::unique_ptr<Rasterizer> make_fp64(const spec::Contract& c, const spec::FrameState& frame) {
  return std::make_unique<FloatingPoint<double>>(c, frame);
}

std::unique_ptr<Rasterizer> make_fp32(const spec::Contract& c, const spec::FrameState& frame) {
  return std::make_unique<FloatingPoint<float>>(c, frame);
}

}  // namespace pineda::baseline
