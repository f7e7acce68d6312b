// The structs that the units pass on: Triangle -> SetupPrim -> Tile -> Stamp -> Fragment ->
// DepthWrite, ColorWrite. Their formats are in fields.cpp, one table for each. y points down.
#pragma once

#include <array>
#include <cstdint>

#include "model/spec/raster_state.h"
#include "model/spec/widths.h"

namespace pineda::spec {

inline constexpr int kNoScissorPx = 1 << 24;  // beyond every frame

/// Raster state, sampled when a frame starts.
struct FrameState {
  int width = 1;   // px
  int height = 1;  // px
  Cull cull = Cull::kNone;
  DepthFunc depth = DepthFunc::kLess;
  bool depth_write = true;  // of the samples that pass
  Shade shade = Shade::kSmooth;
  // Only samples in columns [x0, x1) and rows [y0, y1) are drawn, px. It may reach beyond the
  // frame.
  int scissor_x0 = 0;
  int scissor_y0 = 0;
  int scissor_x1 = kNoScissorPx;
  int scissor_y1 = kNoScissorPx;
  // Depth bias = constant + slope * max(|dz/dx|, |dz/dy|)
  int64_t bias_constant = 0;  // depth codes
  int32_t bias_slope = 0;     // units of 2^-8, -2^15 to 2^15 - 1
  // The clear depth, 0 to 1; a scene states it as a binary32. For its code see clear_depth.h.
  double clear_depth = 1;

  /// The scissor clipped to the frame.
  int clip_x0() const { return scissor_x0 < width ? scissor_x0 : width; }
  int clip_y0() const { return scissor_y0 < height ? scissor_y0 : height; }
  int clip_x1() const { return scissor_x1 < width ? scissor_x1 : width; }
  int clip_y1() const { return scissor_y1 < height ? scissor_y1 : height; }
  bool has_bias() const { return bias_constant != 0 || bias_slope != 0; }
};

using Attributes = std::array<int32_t, kMaxAttributes>;

/// A snapped vertex: x, y in units of 2^-S px, z in units of 2^-8 depth codes.
struct Vertex {
  int32_t x = 0;
  int32_t y = 0;
  int64_t z = 0;
  Attributes attr{};  // interpolated ones first, then flat ones, which only vertex 0 needs
  // 1/w = inverse_w * 2^-inverse_w_shift * f, with a common factor f for the three vertices, chosen
  // so that the greatest 1/w has shift 0. 2^(bits-1) <= inverse_w < 2^bits.
  int32_t inverse_w = 0;
  int32_t inverse_w_shift = 0;
};

/// Three snapped vertices, in the order of the scene.
struct Triangle {
  uint32_t id = 0;  // number of the triangle in the frame
  std::array<Vertex, 3> v;
};

/// value(x, y) = ref + x*dx + y*dy, modulo its width; x, y in px from the reference sample.
struct Plane {
  int64_t dx = 0;
  int64_t dy = 0;
  int64_t ref = 0;
};

/// inside(sample) = all three a*x + b*y + e >= 0, with x, y in px from the reference sample.
struct EdgeFunction {
  int64_t a = 0;  // per px to the right, units of 2^-S px (E' of a pixel step)
  int64_t b = 0;  // per px down
  int64_t e = 0;  // E' at the reference sample, top-left bias folded in
};

/// What perspective-correct attributes need beside the edge functions. In canonical order, the
/// weight of vertex (i + 2) % 3 is E of edge i times that vertex's 1/w.
struct PerspectiveSet {
  std::array<int32_t, 3> e_low{};      // (E - bias) mod 2^S of each edge, the same at every sample
  std::array<int32_t, 3> inverse_w{};  // of each vertex, as in Vertex
  std::array<int32_t, 3> inverse_w_shift{};
  std::array<Attributes, 3> attr{};
};

/// All that a triangle's depth and attributes are computed from. All planes have the same reference
/// sample. A design uses only some of the members.
struct PlaneSet {
  Plane z;
  bool z_steep = false;  // hierarchical z: the plane may wrap within a tile, outside the triangle
  int64_t z_bias = 0;    // units of 2^-16 codes, saturated to twice the range of depth
  std::array<Plane, kMaxAttributes> attr;
  Attributes flat{};
  PerspectiveSet perspective;
};

/// A triangle set up: edges and planes at the first sample of the box's first tile.
struct SetupPrim {
  uint32_t id = 0;
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // box of samples that can be covered, px, inclusive
  std::array<EdgeFunction, 3> edge;
  PlaneSet planes;
};

/// A tile that no edge rejects.
struct Tile {
  uint32_t id = 0;
  int x = 0, y = 0;                    // column and row, in tiles
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // box clipped to the tile, px from the tile's corner
  std::array<EdgeFunction, 3> edge;    // e at the tile's first sample
  // Bit i: edge i accepts every sample of the tile. Its e is then not tested, and without
  // perspective it may have wrapped.
  uint32_t accepted = 0;
  PlaneSet planes;  // referred to the tile's first sample, F' fraction bits
};

/// The samples of one cycle: lane i is pixel (x*W + i%W, y*H + i/W) of a stamp of W x H px.
struct Stamp {
  uint32_t id = 0;
  int x = 0, y = 0;   // column and row, in stamps
  uint32_t mask = 0;  // bit i: lane i is covered
  bool first = true;  // of its tile: interpolation keeps its planes for the tile's other stamps
  PlaneSet planes;    // referred to the first sample of the stamp's tile, F' fraction bits
  std::array<EdgeFunction, 3> edge;  // perspective: at the first sample of the stamp's tile
};

/// A stamp's values at some of its lanes; 0 in the others.
struct Fragment {
  std::array<uint32_t, kMaxLanes> z{};       // depth codes
  std::array<Attributes, kMaxLanes> attr{};  // interpolated attributes
};

/// Request for the stored depths of a stamp. With hierarchical z the mask has all of the stamp's
/// samples inside the frame, not only the covered ones.
struct DepthRead {
  uint32_t id = 0;
  int x = 0, y = 0;
  uint32_t mask = 0;
};

/// Response to a DepthRead: the stored codes of a stamp; lanes that were not requested are 0.
struct DepthData {
  std::array<uint32_t, kMaxLanes> z{};
};

/// Hierarchical z: the top bits of the greatest depth stored in a stamp after a write.
struct DepthMax {
  int x = 0, y = 0;  // column and row, in stamps
  uint32_t z = 0;
};

/// Lanes outside the mask are 0.
struct DepthWrite {
  uint32_t id = 0;
  int x = 0, y = 0;
  uint32_t mask = 0;
  std::array<uint32_t, kMaxLanes> z{};
};

/// Lanes outside the mask are 0.
struct ColorWrite {
  uint32_t id = 0;
  int x = 0, y = 0;
  uint32_t mask = 0;
  std::array<Attributes, kMaxLanes> attr{};  // interpolated attributes
  Attributes flat{};                         // of every lane of the mask
};

}  // namespace pineda::spec
