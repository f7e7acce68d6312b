// Common parts of the baselines: culling, edges, the box of samples, and the output of a sample.
#pragma once

#include <array>
#include <cstdint>

#include "model/baseline/baseline.h"

namespace pineda::baseline {

/// The interpolated values: red, green, blue, alpha, then depth.
inline constexpr size_t kParameters = 5;
inline constexpr size_t kDepth = 4;
using Parameters = std::array<double, kParameters>;

/// A box of pixels, bounds inclusive.
struct Box {
  int x0, y0, x1, y1;
  bool empty() const { return x0 > x1 || y0 > y1; }
};

/// a*x + b*y + c in units of 2^-2S px^2 at the sample of pixel (x, y), positive inside.
struct Edge {
  int64_t a = 0;
  int64_t b = 0;
  int64_t c = 0;
  bool top_left = false;  // a sample on the edge belongs to the triangle

  int64_t at(int x, int y) const { return a * x + b * y + c; }
};

/// Edge i runs from vertex i to vertex i+1. The signs are chosen so that the triangle is on the
/// positive side of all three.
struct Edges {
  std::array<Edge, 3> edge;
  int64_t area2 = 0;       // doubled area, units of 2^-2S px^2, positive
  bool clockwise = false;  // of the vertices as given, on screen
};

class Common : public Rasterizer {
 public:
  Common(const spec::Contract& contract, const spec::FrameState& frame);

 protected:
  /// Doubled area of the vertices as given, positive when clockwise on screen (y points down).
  static int64_t doubled_area(const spec::Triangle& triangle);
  /// True if a triangle of this doubled area is not drawn: no area, or culled.
  template <class Number>
  bool dropped(Number area2) const {
    return area2 == 0 || (frame_.cull == spec::Cull::kBack && area2 > 0) ||
           (frame_.cull == spec::Cull::kFront && area2 < 0);
  }
  bool dropped(const Edges& e) const { return dropped(e.clockwise ? e.area2 : -e.area2); }
  /// The three edges in exact integers: |at()| <= 2^(30+2S) inside the guard band.
  Edges edges(const spec::Triangle& triangle) const;
  /// The barycentric weight of each vertex, from the edge opposite to it; their sum is edges.area2.
  static std::array<int64_t, 3> weights(const Edges& edges, int x, int y) {
    return {edges.edge[1].at(x, y), edges.edge[2].at(x, y), edges.edge[0].at(x, y)};
  }
  /// Pixels of the frame whose centres lie in [x_low, x_high) x [y_low, y_high), in subpixels.
  Box box(int x_low, int y_low, int x_high, int y_high) const;
  Box box(const spec::Triangle& triangle) const;

  /// The values of a vertex; depth in codes.
  static Parameters parameters(const spec::Vertex& v);
  /// Weighted mean of the vertices' values.
  static Parameters mean(const std::array<Parameters, 3>& of, const std::array<double, 3>& weight) {
    Parameters value;
    for (size_t i = 0; i < kParameters; ++i) {
      value[i] = weight[0] * of[0][i] + weight[1] * of[1][i] + weight[2] * of[2][i];
    }
    return value;
  }
  static std::array<Parameters, 3> parameters(const spec::Triangle& t) {
    return {parameters(t.v[0]), parameters(t.v[1]), parameters(t.v[2])};
  }
  /// Sends a sample to the sink: values are clamped, and rounded half up if they are doubles.
  template <class Number>
  void emit(int x, int y, const std::array<Number, kParameters>& value, Sink* sink) const;

  int subpixel_bits_;
  int64_t depth_top_;      // the greatest code
  int64_t attribute_top_;  // the greatest value of an attribute
  spec::FrameState frame_;
};

}  // namespace pineda::baseline
