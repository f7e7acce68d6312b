// The judge of a mesh: which samples a face hits, its depth and its colours there, from the corners
// in clip space. It knows nothing of clipping, triangulation or snapping: a sample is the ray of
// its pixel's centre, and a face is hit where its polygon is.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "model/exact/exact.h"

namespace exact {

/// A corner in clip space: the frame shows |x|, |y| <= w, and z is depth times w.
struct ClipCorner {
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 1;
};

/// The frame that a mesh is drawn on, and what a rasterizer may do to a corner's position.
struct MeshFrame {
  int width = 0;
  int height = 0;
  Cull cull = Cull::kNone;
  // Columns [x0, x1) and rows [y0, y1) alone are drawn, as far as they lie in the frame.
  int x0 = 0;
  int y0 = 0;
  int x1 = INT32_MAX;
  int y1 = INT32_MAX;
  bool low_cuts = true;    // only what has 0 <= z is drawn
  bool high_cuts = false;  // only what has z <= w is drawn
  // A corner may be moved by as much as this in x and in y, in units of 2^-16 px. So each edge has
  // a band in which a sample may be hit or not.
  int band = 0;

  static constexpr int kBandFractionBits = 16;
};

/// Where a sample's value may lie, rounding apart.
struct Range {
  double low = 0;
  double high = 0;
};

/// A polygon moved into its mean plane, as seen along its Newell normal.
struct FlatPolygon {
  std::vector<ClipCorner> corner;
  // The most by which that moved a corner's x or y on the frame, in px. Infinite where the polygon
  // has no normal, or where a corner that it moved does not lie in front of the eye.
  double moved_px = 0;
};
FlatPolygon flattened(const std::vector<ClipCorner>& corners, const MeshFrame& frame);

/// A face: a plane polygon without holes that does not cross itself, in any position to the eye.
///
/// Bits     a sample lies in the band of an edge where the edge function's magnitude is at most
///          band * (|a| + |b|), a and b its steps to the next pixel in x and y: there the sample's
///          square of +-band meets the edge's line. The borders of depth have bands too. All of it
///          is decided exactly: in floating point where its error bound suffices, else in integers.
/// In       finite coordinates, at least three corners; frames of 1 to 65536 px.
/// Source   M. Olano, T. Greer, "Triangle scan conversion using 2D homogeneous coordinates", 1997.
class FaceJudge {
 public:
  FaceJudge(std::vector<ClipCorner> corners, const MeshFrame& frame);
  ~FaceJudge();

  static constexpr int kEither = -1;

  /// Rows that may be hit; empty when first > last.
  Span rows() const { return box_.rows; }
  /// How often each sample of a row must be hit, from the sample of column `columns().first` on:
  /// a number, or kEither. Left out of it are samples that must not be hit.
  void row(int y, std::vector<int8_t>* hits) const;
  Span columns() const { return box_.columns; }
  /// +1: turns counter-clockwise on the screen, -1 clockwise, 0: it is seen from its side.
  int facing() const { return facing_; }

 private:
  struct Planes;  // the lines that bound the face
  struct Box {
    Span columns, rows;
  };

  /// Of a column in a row of hits.
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
  std::vector<Box> edge_box_;  // of a polygon
  int facing_ = 0;
  bool culled_ = false;
  std::unique_ptr<Planes> planes_;
};

/// The values of a triangle at a sample.
///
/// Bits     over the square of +-band around the sample, since a snapped corner carries its values
///          with it; in long doubles. Where a part of the square lies beyond the horizon of the
///          triangle's plane, and never outside of it, the range is that of the corners.
class FaceValues {
 public:
  FaceValues(const std::array<ClipCorner, 3>& corner, const MeshFrame& frame);

  /// z/w, not clamped.
  Range depth(int x, int y) const;
  /// A value that has these values at the corners, with perspective.
  Range attribute(int x, int y, const std::array<double, 3>& value) const;

 private:
  using Row = std::array<long double, 3>;  // a*x + b*y + c, x and y the pixel's numbers

  static long double at(const Row& row, long double x, long double y) {
    return row[0] * x + row[1] * y + row[2];
  }

  std::array<ClipCorner, 3> corner_;
  long double band_;
  long double area_ = 0;
  std::array<Row, 3> weight_{};  // of the corners, times area_ / w
};

}  // namespace exact
