// The judge of a mesh: which samples a face covers, and its depth and colours there, from its
// corners in clip space. It does no clipping, triangulation or snapping: it intersects the ray
// through a pixel's centre with the polygon.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "model/exact/exact.h"

namespace exact {

/// A corner in clip space: the frame shows |x|, |y| <= w, and depth is z/w.
struct ClipCorner {
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 1;
};

/// The frame that a mesh is drawn on, and how far a rasterizer may move a corner.
struct MeshFrame {
  int width = 0;
  int height = 0;
  Cull cull = Cull::kNone;
  // Scissor: only columns [x0, x1) and rows [y0, y1) are drawn. It may reach beyond the frame.
  int x0 = 0;
  int y0 = 0;
  int x1 = INT32_MAX;
  int y1 = INT32_MAX;
  bool low_cuts = true;    // only parts with 0 <= z are drawn
  bool high_cuts = false;  // only parts with z <= w are drawn
  // A rasterizer may move a corner by up to this much in x and in y (snapping), in units of 2^-16
  // px. So each edge has a band around it in which a sample may be covered or not.
  int band = 0;

  static constexpr int kBandFractionBits = 16;
};

/// The range in which a sample's value may lie, before its final rounding.
struct Range {
  double low = 0;
  double high = 0;
};

/// A polygon that is not quite plane, projected along its Newell normal into its mean plane.
struct FlatPolygon {
  std::vector<ClipCorner> corner;
  // The greatest change of a corner's x or y on the frame, in px. Infinite if the polygon has no
  // normal, or if a corner that was moved does not lie in front of the eye.
  double moved_px = 0;
};
FlatPolygon flattened(const std::vector<ClipCorner>& corners, const MeshFrame& frame);

/// A face: a plane polygon without holes that does not cross itself, anywhere relative to the eye.
///
/// Bits     a sample lies in the band of an edge where the magnitude of the edge function is at
///          most band * (|a| + |b|), with a and b its steps per pixel in x and y: there the square
///          of +-band around the sample touches the edge's line. The depth planes have bands too.
///          All decisions are exact: in floating point where the error bound suffices, else in
///          integers.
/// In       finite coordinates, at least three corners; frames of 1 to 65536 px.
/// Source   M. Olano, T. Greer, "Triangle scan conversion using 2D homogeneous coordinates", 1997.
class FaceJudge {
 public:
  FaceJudge(std::vector<ClipCorner> corners, const MeshFrame& frame);
  ~FaceJudge();

  static constexpr int kEither = -1;

  /// Rows that may have covered samples; empty when first > last.
  Span rows() const { return box_.rows; }
  /// How many times each sample of a row must be hit, from column `columns().first` on: a number,
  /// or kEither if it may be hit or not. Samples outside columns() must not be hit.
  void row(int y, std::vector<int8_t>* hits) const;
  Span columns() const { return box_.columns; }
  /// +1: counter-clockwise on the screen, -1: clockwise, 0: seen edge-on.
  int facing() const { return facing_; }

 private:
  struct Planes;  // the line functions that bound the face
  struct Box {
    Span columns, rows;
  };

  /// The index of a column in a row of hits.
  size_t place_of(int column) const { return static_cast<size_t>(column - box_.columns.first); }
  Box box_of(const std::vector<ClipCorner>& corners) const;
  Span where(size_t i, int way, int y, int margin, bool strictly) const;
  Span band(size_t i, int y) const;
  void convex_row(int y, std::vector<int8_t>* hits) const;
  std::vector<int> windings(int y) const;
  void polygon_row(int y, std::vector<int8_t>* hits) const;
  void fill(Span columns, int8_t value, std::vector<int8_t>* hits) const;

  std::vector<ClipCorner> corner_;
  MeshFrame frame_;
  Box box_;
  std::vector<Box> edge_box_;  // of each edge; only for more than three corners
  int facing_ = 0;
  bool culled_ = false;
  std::unique_ptr<Planes> planes_;
};

/// The possible values of a triangle at a sample.
///
/// Bits     the range over the square of +-band around the sample, since a corner that is moved
///          takes its values along; in long doubles. An attribute's range never exceeds that of the
///          corners, and equals it where part of the square lies beyond the horizon of the
///          triangle's plane. Depth is limited to the corners' range if all have w > 0.
class FaceValues {
 public:
  FaceValues(const std::array<ClipCorner, 3>& corner, const MeshFrame& frame);

  /// z/w, not clamped.
  Range depth(int x, int y) const;
  /// An attribute with these values at the corners, interpolated with perspective.
  Range attribute(int x, int y, const std::array<double, 3>& value) const;

 private:
  using Row = std::array<long double, 3>;  // {a, b, c} of a*x + b*y + c, for pixel (x, y)

  static long double at(const Row& row, long double x, long double y) {
    return row[0] * x + row[1] * y + row[2];
  }

  std::array<ClipCorner, 3> corner_;
  long double band_;
  long double area_ = 0;
  std::array<Row, 3> weight_{};  // of each corner, times area_ / w
};

}  // namespace exact
