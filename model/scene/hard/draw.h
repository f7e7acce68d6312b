// Helpers for drawing the hard cases. Positions are in units of 1/256 px, which a float holds
// exactly everywhere in the guard band: with 8 subpixel bits snapping does not move them.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include "model/figures/coverage.h"
#include "model/figures/limits.h"
#include "model/scene/hard/cases.h"
#include "model/scene/mesh_reader.h"

namespace pineda::scene::hard {

using figures::Corners;
using figures::Point;

inline constexpr figures::Lattice kLattice(spec::kHighTile);
inline constexpr int64_t kPx = kLattice.px();
inline constexpr int64_t kHalfPx = kLattice.half();
inline constexpr int kCellPx = 16;  // size of a cell, for cases with one small figure in each cell

/// A scene being drawn.
class Drawing : public figures::Pen {
 public:
  explicit Drawing(uint64_t seed) : Pen(spec::kHighTile, seed) {}

  bool coin() { return random().between(0, 1) == 1; }
  std::vector<ScreenTriangle>& triangles() { return triangles_; }

  /// A vertex of random depth and colour.
  ScreenVertex vertex(Point p) {
    ScreenVertex v;
    v.x = static_cast<float>(p.x) / kPx;
    v.y = static_cast<float>(p.y) / kPx;
    v.z = random().uniform(0, 1);
    v.rgba = color();
    return v;
  }
  std::array<uint8_t, 4> color() {
    const uint64_t bits = random().bits();
    return {static_cast<uint8_t>(bits), static_cast<uint8_t>(bits >> 8),
            static_cast<uint8_t>(bits >> 16), 255};
  }

  /// Adds the triangle as it stands.
  void add(const std::array<ScreenVertex, 3>& v) {
    triangles_.push_back({static_cast<uint32_t>(triangles_.size()), v});
  }
  void add(const Corners& p) { add({vertex(p[0]), vertex(p[1]), vertex(p[2])}); }
  /// Adds the triangle with a random first vertex and random winding.
  void add_shuffled(std::array<ScreenVertex, 3> v) {
    if (coin()) std::swap(v[1], v[2]);
    std::rotate(v.begin(), v.begin() + random().between(0, 2), v.end());
    add(v);
  }
  void add_shuffled(const Corners& p) { add_shuffled({vertex(p[0]), vertex(p[1]), vertex(p[2])}); }
  /// A triangle of one depth and one colour.
  void add_flat(const Corners& p, float z) {
    const auto rgba = color();
    std::array<ScreenVertex, 3> v{vertex(p[0]), vertex(p[1]), vertex(p[2])};
    for (ScreenVertex& corner : v) {
      corner.z = z;
      corner.rgba = rgba;
    }
    add_shuffled(v);
  }

 private:
  std::vector<ScreenTriangle> triangles_;
};

/// The upper left corner of cell `i` of a frame that is `columns` cells wide.
inline Point cell(int i, int columns) { return kCellPx * kPx * Point{i % columns, i / columns}; }

/// A frame without culling.
inline constexpr spec::FrameState frame(int width, int height,
                                        spec::DepthFunc depth = spec::DepthFunc::kLess) {
  return {width, height, spec::Cull::kNone, depth};
}

/// A grid of quads, larger than kGridFrame. Its corners are moved by up to a fifth of the spacing
/// and rounded to multiples of `lattice`; triangles have random winding and vertex order.
inline constexpr spec::FrameState kGridFrame = frame(64, 48);
std::vector<ScreenTriangle> grid(uint64_t seed, int64_t spacing, int64_t lattice);

/// The cases of each file; hard_cases() joins them.
std::vector<HardCase> coverage_cases();
std::vector<HardCase> limit_cases();
std::vector<HardCase> value_cases();
std::vector<HardCase> perspective_cases();
std::vector<HardCase> state_cases();

/// The screen triangles of a mesh as a camera sees it, after clipping.
inline std::vector<ScreenTriangle> seen_mesh(Mesh mesh, const Camera& camera,
                                             const spec::FrameState& frame) {
  const View view = camera_view(camera, mesh, frame.width, frame.height);
  MeshReader reader(std::make_shared<const ClipMesh>(clip_mesh(std::move(mesh), view)), frame,
                    spec::contract(spec::kHighTile));
  std::vector<ScreenTriangle> triangles;
  Counters counters;
  for (ScreenTriangle t; reader.read(&t, &counters);) triangles.push_back(t);
  return triangles;
}

}  // namespace pineda::scene::hard
