// Triangles side by side, before and after setup.
#pragma once

#include <array>

#include "model/core/setup.h"

namespace pineda::fast {

inline constexpr size_t kGroup = 16;  // triangles

/// A number of each triangle of a group.
template <class T>
using Each = std::array<T, kGroup>;

/// Snapped triangles; each number as wide as a design with blocks needs it (has_blocks()).
struct alignas(64) TriangleGroup {
  std::array<Each<int32_t>, 3> x, y;    // of the three vertices, units of 2^-S px
  std::array<Each<uint32_t>, 3> z;      // units of 2^-8 depth codes
  std::array<Each<uint32_t>, 3> color;  // a byte a channel, channel 0 the lowest

  void set(size_t i, const spec::Triangle& triangle, int channels) {
    for (size_t v = 0; v < 3; ++v) {
      const spec::Vertex& vertex = triangle.v[v];
      x[v][i] = vertex.x;
      y[v][i] = vertex.y;
      z[v][i] = static_cast<uint32_t>(vertex.z);
      uint32_t bytes = 0;
      for (int a = 0; a < channels; ++a) {
        bytes |= static_cast<uint32_t>(vertex.attr[static_cast<size_t>(a)]) << (8 * a);
      }
      color[v][i] = bytes;
    }
  }
  void copy(size_t i, const TriangleGroup& from, size_t j) {
    for (size_t v = 0; v < 3; ++v) {
      x[v][i] = from.x[v][j];
      y[v][i] = from.y[v][j];
      z[v][i] = from.z[v][j];
      color[v][i] = from.color[v][j];
    }
  }
};

/// What spec::SetupPrim has of each triangle; planes without the upper bits that blocks do not need.
struct alignas(64) PrimGroup {
  Each<int32_t> x0, y0, x1, y1;       // box of samples, px, inclusive
  std::array<Each<int32_t>, 3> a, b;  // edges
  std::array<Each<int64_t>, 3> e;
  Each<int64_t> z_dx, z_dy, z_ref;
  Each<std::array<uint32_t, 4>> color_dx, color_dy, color_ref;  // by channel
  uint32_t drawn = 0;                                           // a bit each: not dropped
};

/// The box and the edges of one triangle, as TileSteps takes them.
struct EdgePrim {
  int x0, y0, x1, y1;
  std::array<spec::EdgeFunction, 3> edge;

  EdgePrim(const PrimGroup& g, size_t i) : x0(g.x0[i]), y0(g.y0[i]), x1(g.x1[i]), y1(g.y1[i]) {
    for (size_t k = 0; k < 3; ++k) edge[k] = {g.a[k][i], g.b[k][i], g.e[k][i]};
  }
};

}  // namespace pineda::fast
