// A scene as a stream of snapped triangles, with counters of what was changed or dropped.
#pragma once

#include <cstddef>
#include <cstdint>

#include "model/spec/structs.h"

namespace pineda::scene {

/// Counts of what was dropped, saturated, clamped or clipped since the last rewind. Saturated,
/// clamped and denormal components are only counted in triangles that were not dropped.
struct Counters {
  uint64_t triangles = 0;      // read, those dropped below included
  uint64_t nan_dropped = 0;    // triangles with a NaN in X, Y, Z or W; in a mesh also with an Inf
  uint64_t saturated = 0;      // X, Y outside the guard band
  uint64_t z_clamped = 0;      // Z outside [0, 1]
  uint64_t denormals = 0;      // X, Y, Z that became 0
  uint64_t clipped = 0;        // mesh triangles clipped by a depth plane or the guard band
  uint64_t clipped_away = 0;   // mesh triangles that clipping removed entirely
  uint64_t perspective = 0;    // vertices with W != 1, not counted for meshes
  uint64_t affine_colors = 0;  // mesh triangles whose colours can be off by 1 LSB or more if affine
  double affine_lsb = 0;       // the greatest such error, in units of 1/255
  uint64_t rounded_slope = 0;  // 1: the depth bias's slope factor was no multiple of 2^-8
};

/// A pull stream of triangles.
///
/// Out      next(): vertices snapped and inside the guard band; id = number of the triangle in the
///          scene as read, from 0. Dropped triangles are counted in these numbers too; the pieces
///          of a clipped mesh triangle have the same number.
/// Errors   InputError when the input turns out to be wrong.
class TriangleSource {
 public:
  virtual ~TriangleSource() = default;

  /// False at the end; *triangle is then unchanged.
  virtual bool next(spec::Triangle* triangle) = 0;
  /// Up to `count` triangles, as next() would give them one by one; fewer only at the end.
  virtual size_t next_many(spec::Triangle* triangles, size_t count) = 0;

  /// Starts again from the first triangle and resets the counters.
  virtual void rewind() = 0;

  const Counters& counters() const { return counters_; }

 protected:
  Counters counters_;
};

}  // namespace pineda::scene
