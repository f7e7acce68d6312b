// What the scene classes draw with: random points, vertices and triangles in subpixels.
//
// Random numbers are drawn in braces or in separate statements only: the order in which a call's
// arguments are evaluated differs among compilers, the order in braces does not.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "model/figures/coverage.h"
#include "model/figures/limits.h"
#include "vectors/generator/scenes.h"

namespace pineda::vectors {

using figures::Corners;
using figures::Point;

/// One scene being drawn. `index` counts the scenes of its class.
class Draw : public figures::Pen {
 public:
  Draw(const spec::Contract& contract, uint64_t seed, int index)
      : Pen(contract.design, seed), contract_(contract), index_(index) {}

  int index() const { return index_; }
  Scene& scene() { return scene_; }
  const spec::Contract& contract() const { return contract_; }

  /// Greatest depth and attribute of a vertex.
  int64_t far() const;
  int32_t full() const { return (1 << contract_.design.attribute_bits) - 1; }

  /// A length of so many px, or half the guard band's if that is less; in subpixels.
  int64_t reach(int64_t length_px) const {
    return px() * std::min(length_px, int64_t{1} << (contract_.design.guard_bits - 1));
  }
  /// A frame of that size, or of the design's greatest.
  void frame(int width, int height) {
    const int greatest = 1 << contract_.design.guard_bits;
    scene_.frame.width = std::min(width, greatest);
    scene_.frame.height = std::min(height, greatest);
  }
  /// A point of the box [low, high] in px, both included.
  Point point(int64_t low_x, int64_t low_y, int64_t high_x, int64_t high_y) {
    return in_box(px() * Point{low_x, low_y}, px() * Point{high_x, high_y});
  }
  /// The centre of a pixel low .. high, in both directions.
  Point any_center(int64_t low, int64_t high) { return center_in_box({low, low}, {high, high}); }
  /// A vertex with random depth and attributes; with perspective also 1/w, whose ratio within a
  /// triangle is up to 2^20, now and then the greatest possible.
  spec::Vertex vertex(Point p);

  /// Adds a triangle whose vertices start anywhere and run either way round.
  void add(const Corners& p) { add_shuffled({vertex(p[0]), vertex(p[1]), vertex(p[2])}); }
  void add_shuffled(std::array<spec::Vertex, 3> v);
  /// Adds the triangle as it stands.
  void add_ordered(const std::array<spec::Vertex, 3>& v);

 private:
  spec::Contract contract_;
  int index_;
  Scene scene_;
};

/// A kind of scene and how many of it level 1 holds.
struct SceneClass {
  const char* name;
  int scenes;
  void (*draw)(Draw& d);
};

/// Each hard case of coverage, of values and of order, of raster state, of single bits; then the random classes, and
/// those that are drawn from when a level is done and bins are left.
std::vector<SceneClass> coverage_classes();
std::vector<SceneClass> value_classes();
std::vector<SceneClass> state_classes();
std::vector<SceneClass> bit_classes();
std::vector<SceneClass> random_classes();
std::vector<SceneClass> any_classes();

}  // namespace pineda::vectors
