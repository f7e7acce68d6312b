#include "model/baseline/common.h"
#include "model/baseline/makers.h"
#include "model/spec/fixed.h"

namespace pineda::baseline {

using spec::int128_t;
using spec::Triangle;

namespace {

// Does a sample on an edge belong to this triangle? A shared edge belongs to the triangle that lies
// on the same side of it as a fixed point off the screen.
//
// As printed  f(opposite vertex) * f(point) > 0.
// Mended      the point. The printed (-1, -1) lies on the lines of some edges, and samples on those
//             would belong to no triangle. This point lies below the guard band and so far to the
//             right that no edge's line passes through it: a line that is not horizontal rises at
//             least 2^-S px in 2^15 px, so there it is 2^21 px off the rows of its vertices. The
//             result is the top-left rule.
bool owns(const Edge& e, int subpixel_bits) {
  const int128_t x = int128_t{1} << (36 + subpixel_bits);  // px
  const int128_t y = int128_t{1} << 15;
  return e.a * x + e.b * y + e.c > 0;  // f(opposite vertex) > 0, see Edges
}

class Barycentric : public Common {
 public:
  using Common::Common;

  void draw(const Triangle& t, Sink* sink) final {
    Prim prim{edges(t), {}, parameters(t), box(t), sink};
    if (dropped(prim.exact)) return;
    for (size_t i = 0; i < 3; ++i) prim.owned[i] = owns(prim.exact.edge[i], subpixel_bits_);
    scan(prim);
  }

 protected:
  struct Prim {
    Edges exact;
    std::array<bool, 3> owned;  // samples on the edge belong to the triangle
    std::array<Parameters, 3> value;
    Box pixels;
    Sink* sink;
  };
  virtual void scan(const Prim& prim) = 0;
};

// As printed  the bounding rectangle column by column; three divisions a pixel; only >= 0 is
//             tested, since <= 1 follows from it; colours by weights. Slow, but not wrong.
// Mended      the off-screen point, see owns(); f(opposite vertex) is the exact doubled area.
class Plain final : public Barycentric {
 public:
  using Barycentric::Barycentric;

 protected:
  void scan(const Prim& prim) override {
    const Box& pixels = prim.pixels;
    const auto area2 = static_cast<double>(prim.exact.area2);
    for (int x = pixels.x0; x <= pixels.x1; ++x) {
      for (int y = pixels.y0; y <= pixels.y1; ++y) {
        ++visited_;
        const auto [f_bc, f_ca, f_ab] = weights(prim.exact, x, y);
        const double alpha = static_cast<double>(f_bc) / area2;
        const double beta = static_cast<double>(f_ca) / area2;
        const double gamma = static_cast<double>(f_ab) / area2;
        if (alpha < 0 || beta < 0 || gamma < 0) continue;
        if ((alpha > 0 || prim.owned[1]) && (beta > 0 || prim.owned[2]) &&
            (gamma > 0 || prim.owned[0])) {
          emit(x, y, mean(prim.value, {alpha, beta, gamma}), prim.sink);
        }
      }
    }
  }
};

// As printed  the optimization advised beside the loop: weights and colours are stepped, no test of
//             the upper bound.
// Mended      the off-screen point; row by row; weights are integers without the division, since
//             only their sign is needed, so steps add no error to coverage. Colours are stepped in
//             doubles from the corner of the box, and their errors accumulate.
class Incremental final : public Barycentric {
 public:
  using Barycentric::Barycentric;

 protected:
  void scan(const Prim& prim) override {
    const auto& edge = prim.exact.edge;
    const Box& pixels = prim.pixels;
    if (pixels.empty()) return;
    auto row = weights(prim.exact, pixels.x0, pixels.y0);
    const Parameters right = combine(prim, {edge[1].a, edge[2].a, edge[0].a});
    const Parameters down = combine(prim, {edge[1].b, edge[2].b, edge[0].b});
    Parameters row_value = combine(prim, row);
    for (int y = pixels.y0; y <= pixels.y1; ++y) {
      auto [f_bc, f_ca, f_ab] = row;
      Parameters value = row_value;
      for (int x = pixels.x0; x <= pixels.x1; ++x) {
        ++visited_;
        if (f_bc >= 0 && f_ca >= 0 && f_ab >= 0 && (f_bc > 0 || prim.owned[1]) &&
            (f_ca > 0 || prim.owned[2]) && (f_ab > 0 || prim.owned[0])) {
          emit(x, y, value, prim.sink);
        }
        f_bc += edge[1].a;
        f_ca += edge[2].a;
        f_ab += edge[0].a;
        for (size_t i = 0; i < kParameters; ++i) value[i] += right[i];
      }
      for (size_t i = 0; i < 3; ++i) row[i] += edge[(i + 1) % 3].b;
      for (size_t i = 0; i < kParameters; ++i) row_value[i] += down[i];
    }
  }

 private:
  static Parameters combine(const Prim& prim, const std::array<int64_t, 3>& weight) {
    const auto area2 = static_cast<double>(prim.exact.area2);
    return mean(prim.value,
                {static_cast<double>(weight[0]) / area2, static_cast<double>(weight[1]) / area2,
                 static_cast<double>(weight[2]) / area2});
  }
};

}  // namespace

std::unique_ptr<Rasterizer> make_barycentric(const spec::Contract& c,
                                             const spec::FrameState& frame) {
  return std::make_unique<Plain>(c, frame);
}

std::unique_ptr<Rasterizer> make_barycentric_incremental(const spec::Contract& c,
                                                         const spec::FrameState& frame) {
  return std::make_unique<Incremental>(c, frame);
}

}  // namespace pineda::baseline
