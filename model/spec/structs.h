// The datum on its way: Triangle -> SetupPrim -> Tile -> Stamp -> Fragment -> DepthWrite,
// ColorWrite. Formats stand in fields.h, one table a struct. y points down.
#pragma once

#include <array>
#include <cstdint>

#include "model/spec/widths.h"

namespace pineda::spec {

enum class Cull : uint8_t { kNone, kBack, kFront };
enum class DepthFunc : uint8_t { kLess, kLequal, kOff };

/// Raster state, sampled when a frame starts.
struct FrameState {
  int width = 1;   // px
  int height = 1;  // px
  Cull cull = Cull::kNone;
  DepthFunc depth = DepthFunc::kLess;
};

using Attributes = std::array<int32_t, kMaxAttributes>;

/// A snapped vertex: x, y in units of 2^-S px, z in units of 2^-8 depth codes.
struct Vertex {
  int32_t x = 0;
  int32_t y = 0;
  int64_t z = 0;
  Attributes attr{};
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

/// Depth and attribute planes that share a reference sample.
struct PlaneSet {
  Plane z;
  std::array<Plane, kMaxAttributes> attr;
};

/// inside(sample) = all three a*x + b*y + e >= 0, with x, y in px from the reference sample.
struct EdgeFunction {
  int64_t a = 0;  // per px to the right, units of 2^-S px (E' of a pixel step)
  int64_t b = 0;  // per px down
  int64_t e = 0;  // E' at the reference sample, top-left bias folded in
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
  uint32_t accepted = 0;  // bit i: edge i accepts every sample of the tile; its e is not looked at
  PlaneSet planes;        // referred to the tile's first sample, F' fraction bits
};

/// The samples of one cycle: lane i is pixel (x*W + i%W, y*H + i/W) of a stamp of W x H px.
struct Stamp {
  uint32_t id = 0;
  int x = 0, y = 0;   // column and row, in stamps
  uint32_t mask = 0;  // bit i: lane i is covered
  PlaneSet planes;    // referred to the first sample of the stamp's tile, F' fraction bits
};

/// A stamp's values at its covered lanes; 0 in the others.
struct Fragment {
  std::array<uint32_t, kMaxLanes> z{};  // depth codes
  std::array<Attributes, kMaxLanes> attr{};
};

struct DepthRead {
  uint32_t id = 0;
  int x = 0, y = 0;
  uint32_t mask = 0;
};

/// Depth codes of a stamp; lanes that were not asked for are 0.
struct DepthData {
  std::array<uint32_t, kMaxLanes> z{};
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
  std::array<Attributes, kMaxLanes> attr{};
};

}  // namespace pineda::spec
