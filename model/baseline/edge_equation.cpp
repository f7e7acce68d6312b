#include "model/baseline/edge_equation.h"

#include "model/baseline/makers.h"
#include "model/spec/fixed.h"

namespace pineda::baseline {

using spec::Contract;
using spec::FrameState;
using spec::int128_t;
using spec::Triangle;

// The bounding box from the signs of the edges. Bit i of the flags says that the coordinate does
// not decrease from vertex i to vertex i+1; the table gives the vertices with the least and the
// greatest coordinate. With all bits set the three are equal, and any vertex will do.
Box EdgeEquation::sign_box(const Triangle& t) const {
  constexpr size_t kOrder[8][2] = {{0, 0}, {0, 1}, {1, 2}, {0, 2}, {2, 0}, {2, 1}, {1, 0}, {0, 0}};
  size_t x_flags = 0;
  size_t y_flags = 0;
  for (size_t i = 0; i < 3; ++i) {
    const spec::Vertex& u = t.v[i];
    const spec::Vertex& w = t.v[(i + 1) % 3];
    x_flags |= (w.x >= u.x ? size_t{1} : 0) << i;
    y_flags |= (w.y >= u.y ? size_t{1} : 0) << i;
  }
  return box(t.v[kOrder[x_flags][0]].x, t.v[kOrder[y_flags][0]].y, t.v[kOrder[x_flags][1]].x,
             t.v[kOrder[y_flags][1]].y);
}

void EdgeEquation::scan(const Setup& setup, const Box& pixels, Sink* sink) {
  const auto& edge = setup.edge;
  std::array<int64_t, 3> t;
  for (size_t i = 0; i < 3; ++i) t[i] = edge[i].at(pixels.x0, pixels.y0);
  const auto word = [](int64_t value) { return static_cast<uint64_t>(value); };
  std::array<uint64_t, kParameters> row;
  for (size_t i = 0; i < kParameters; ++i) {
    const Plane& p = setup.plane[i];
    row[i] = word(p.ref) + word(p.dx) * word(pixels.x0) + word(p.dy) * word(pixels.y0) + kOne / 2;
  }
  for (int y = pixels.y0; y <= pixels.y1; ++y) {
    auto [e0, e1, e2] = t;
    auto value = row;
    bool been_inside = false;
    for (int x = pixels.x0; x <= pixels.x1; ++x) {
      ++visited_;
      if ((e0 | e1 | e2) >= 0) {
        std::array<int64_t, kParameters> codes;
        for (size_t i = 0; i < kParameters; ++i) {
          codes[i] = static_cast<int64_t>(value[i]) >> kFractionBits;
        }
        emit(x, y, codes, sink);
        been_inside = true;
      } else if (been_inside) {
        break;
      }
      e0 += edge[0].a;
      e1 += edge[1].a;
      e2 += edge[2].a;
      for (size_t i = 0; i < kParameters; ++i) value[i] += word(setup.plane[i].dx);
    }
    for (size_t i = 0; i < 3; ++i) t[i] += edge[i].b;
    for (size_t i = 0; i < kParameters; ++i) row[i] += word(setup.plane[i].dy);
  }
}

namespace {

// Exact edges. With S <= 12 subpixel bits, a and b have at most S fraction bits, so 12 hold them
// exactly. c has 2S; rounding it down to 12, after the bias, keeps the sign at every sample.
class Exact : public EdgeEquation {
 public:
  using EdgeEquation::EdgeEquation;

 protected:
  std::array<Edge, 3> fixed_edges(const Edges& exact) const {
    const int shift = 2 * subpixel_bits_ - kFractionBits;
    const auto fixed = [&](int64_t value) {
      return shift >= 0 ? value >> shift : value * (int64_t{1} << -shift);
    };
    std::array<Edge, 3> out;
    for (size_t i = 0; i < 3; ++i) {
      const Edge& e = exact.edge[i];
      out[i] = {fixed(e.a), fixed(e.b), fixed(e.c - (e.top_left ? 0 : 1)), e.top_left};
    }
    return out;
  }
  bool exact_edges(const Triangle& t, Edges* exact) const {
    *exact = edges(t);
    return !dropped(*exact);
  }
};

// As printed  the mean of the vertices' colours; here also of their depths.
// Mended      the shifts of the channels; the mean of alpha, which was used but not declared.
class Flat final : public Exact {
 public:
  using Exact::Exact;

 protected:
  bool set_up(const Triangle& t, Setup* setup) const override {
    Edges exact;
    if (!exact_edges(t, &exact)) return false;
    setup->edge = fixed_edges(exact);
    const auto mean = [](int64_t a, int64_t b, int64_t c, int64_t one) {
      return (2 * (a + b + c) + 3 * one) / (6 * one) * kOne;
    };
    const auto& v = t.v;
    for (size_t i = 0; i < kDepth; ++i) {
      setup->plane[i].ref = mean(v[0].attr[i], v[1].attr[i], v[2].attr[i], 1);
    }
    setup->plane[kDepth].ref =
        mean(v[0].z, v[1].z, v[2].z, int64_t{1} << spec::kDepthInputFractionBits);
    return true;
  }
};

// The low 64 bits of numerator/denominator, rounded half up; denominator > 0.
int64_t divide(int128_t numerator, int128_t denominator) {
  const int128_t n = 2 * numerator + denominator;
  const int128_t d = 2 * denominator;
  const int128_t quotient = n / d - (n % d < 0 ? 1 : 0);
  return static_cast<int64_t>(quotient);
}

// As printed  the plane equation: the edges' coefficients times the vertices' values, divided by
//             twice the area, which is the sum of the edges' C's; planes start at the origin and
//             have 12 fraction bits.
// Mended      the computation itself, which was not given: exact sums and one rounding.
class Smooth final : public Exact {
 public:
  using Exact::Exact;

 protected:
  bool set_up(const Triangle& t, Setup* setup) const override {
    Edges exact;
    if (!exact_edges(t, &exact)) return false;
    setup->edge = fixed_edges(exact);
    const auto& v = t.v;
    for (size_t i = 0; i < kDepth; ++i) {
      setup->plane[i] = plane(exact, {v[0].attr[i], v[1].attr[i], v[2].attr[i]}, 0);
    }
    setup->plane[kDepth] = plane(exact, {v[0].z, v[1].z, v[2].z}, spec::kDepthInputFractionBits);
    return true;
  }

 private:
  static Plane plane(const Edges& exact, const std::array<int64_t, 3>& value, int fraction_bits) {
    const auto& [e0, e1, e2] = exact.edge;
    const int128_t denominator = int128_t{exact.area2} << fraction_bits;
    const auto solve = [&](int64_t of_v0, int64_t of_v1, int64_t of_v2) {
      const int128_t sum =
          int128_t{of_v0} * value[0] + int128_t{of_v1} * value[1] + int128_t{of_v2} * value[2];
      return divide(sum * kOne, denominator);
    };
    return {solve(e1.a, e2.a, e0.a), solve(e1.b, e2.b, e0.b), solve(e1.c, e2.c, e0.c)};
  }
};

}  // namespace

std::unique_ptr<Rasterizer> make_edge_flat(const Contract& c, const FrameState& frame) {
  return std::make_unique<Flat>(c, frame);
}

std::unique_ptr<Rasterizer> make_edge_smooth(const Contract& c, const FrameState& frame) {
  return std::make_unique<Smooth>(c, frame);
}

}  // namespace pineda::baseline
