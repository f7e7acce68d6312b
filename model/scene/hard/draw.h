// What the hard cases draw with. Positions are in units of 1/256 px, which a float holds exactly
// everywhere in the guard band: at 8 subpixel bits nothing moves when it is snapped.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include "model/scene/hard/cases.h"
#include "model/scene/mesh_reader.h"
#include "model/spec/random.h"

namespace pineda::scene::hard {

inline constexpr int kPx = 256;
inline constexpr int kHalfPx = kPx / 2;
inline constexpr int kGuardPx = 16384;
inline constexpr int kLeast = -kGuardPx * kPx;
inline constexpr int kGreatest = kGuardPx * kPx - 1;
inline constexpr int kCellPx = 16;  // cases of many small figures give each a cell of its own

using spec::Random;

struct Point {
  int x = 0;
  int y = 0;
};
inline Point operator+(Point p, Point q) { return {p.x + q.x, p.y + q.y}; }
inline Point operator-(Point p, Point q) { return {p.x - q.x, p.y - q.y}; }
inline Point operator*(int k, Point p) { return {k * p.x, k * p.y}; }

/// The centre of pixel (x, y).
constexpr Point center(int x, int y) { return {x * kPx + kHalfPx, y * kPx + kHalfPx}; }

/// A scene being drawn.
class Drawing {
 public:
  explicit Drawing(uint64_t seed) : random_(seed) {}

  Random& random() { return random_; }
  bool coin() { return random_.between(0, 1) == 1; }
  std::vector<ScreenTriangle>& triangles() { return triangles_; }

  /// A point of the box, its borders included.
  Point in_box(Point low, Point high) {
    return {random_.between(low.x, high.x), random_.between(low.y, high.y)};
  }
  Point near(Point p, int reach) { return p + in_box({-reach, -reach}, {reach, reach}); }

  /// A sample of the box of pixels.
  Point center_in_box(Point low, Point high) {
    const Point pixel = in_box(low, high);
    return center(pixel.x, pixel.y);
  }

  /// A vertex of random depth and colour.
  ScreenVertex vertex(Point p) {
    ScreenVertex v;
    v.x = static_cast<float>(p.x) / kPx;
    v.y = static_cast<float>(p.y) / kPx;
    v.z = random_.uniform(0, 1);
    v.rgba = color();
    return v;
  }
  std::array<uint8_t, 4> color() {
    const uint64_t bits = random_.bits();
    return {static_cast<uint8_t>(bits), static_cast<uint8_t>(bits >> 8),
            static_cast<uint8_t>(bits >> 16), 255};
  }

  /// Adds the triangle as it stands.
  void add(const std::array<ScreenVertex, 3>& v) {
    triangles_.push_back({static_cast<uint32_t>(triangles_.size()), v});
  }
  void add(Point a, Point b, Point c) { add({vertex(a), vertex(b), vertex(c)}); }
  /// Adds it from any vertex on, either way round.
  void add_shuffled(std::array<ScreenVertex, 3> v) {
    if (coin()) std::swap(v[1], v[2]);
    std::rotate(v.begin(), v.begin() + random_.between(0, 2), v.end());
    add(v);
  }
  void add_shuffled(Point a, Point b, Point c) { add_shuffled({vertex(a), vertex(b), vertex(c)}); }
  /// A triangle of one depth and one colour.
  void add_flat(Point a, Point b, Point c, float z) {
    const auto rgba = color();
    std::array<ScreenVertex, 3> v{vertex(a), vertex(b), vertex(c)};
    for (ScreenVertex& corner : v) {
      corner.z = z;
      corner.rgba = rgba;
    }
    add_shuffled(v);
  }

 private:
  Random random_;
  std::vector<ScreenTriangle> triangles_;
};

/// The upper left corner of cell `i` of a frame that is `columns` cells wide.
inline Point cell(int i, int columns) { return kCellPx * kPx * Point{i % columns, i / columns}; }

/// A frame without culling.
inline constexpr spec::FrameState frame(int width, int height,
                                        spec::DepthFunc depth = spec::DepthFunc::kLess) {
  return {width, height, spec::Cull::kNone, depth};
}

/// A grid of quads that reaches over a frame of kGridFrame's size, its corners moved by a fifth of
/// the spacing and put on multiples of `lattice`; in any winding and vertex order.
inline constexpr spec::FrameState kGridFrame = frame(64, 48);
std::vector<ScreenTriangle> grid(uint64_t seed, int spacing, int lattice);

/// The parts of the catalogue.
std::vector<HardCase> coverage_cases();
std::vector<HardCase> limit_cases();
std::vector<HardCase> value_cases();
std::vector<HardCase> perspective_cases();
std::vector<HardCase> state_cases();

/// A mesh as a camera sees it, clipped.
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
