// A scene as a stream of snapped triangles, and what happened to them on the way.
#pragma once

#include <cstdint>

#include "model/spec/structs.h"

namespace pineda::scene {

/// Everything that was dropped, saturated, clamped or cut since the last rewind. Components are
/// counted in the triangles that were not dropped.
struct Counters {
  uint64_t triangles = 0;      // read, those dropped below included
  uint64_t nan_dropped = 0;    // triangles with a NaN in X, Y, Z or W; in a mesh also with an Inf
  uint64_t saturated = 0;      // X, Y outside the guard band
  uint64_t z_clamped = 0;      // Z outside [0, 1]
  uint64_t denormals = 0;      // X, Y, Z that became 0
  uint64_t clipped = 0;        // mesh triangles that the near plane or the guard band cut
  uint64_t clipped_away = 0;   // mesh triangles of which nothing was left
  uint64_t perspective = 0;    // vertices with W != 1, meshes left out
  uint64_t affine_colors = 0;  // mesh triangles whose colours an affine design can get wrong by 1
  double affine_lsb = 0;       // the most by which it can, of 255
  uint64_t rounded_slope = 0;  // 1: the depth bias's slope factor was no multiple of 2^-8
};

/// A pull stream of triangles.
///
/// Out      next(): vertices snapped and inside the guard band; id = number of the triangle in the
///          scene as read, from 0. Dropped ones keep their number; the pieces of a clipped mesh
///          triangle share theirs.
/// Errors   InputError where the input is found to be wrong.
class TriangleSource {
 public:
  virtual ~TriangleSource() = default;

  /// False at the end; *triangle is then left alone.
  virtual bool next(spec::Triangle* triangle) = 0;

  /// Starts again from the first triangle, counters included.
  virtual void rewind() = 0;

  const Counters& counters() const { return counters_; }

 protected:
  Counters counters_;
};

}  // namespace pineda::scene
