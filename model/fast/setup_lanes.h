// Triangle setup, many triangles side by side.
#pragma once

#include <vector>

#include "model/fast/highway_targets.h"
#include "model/fast/prim_group.h"

namespace pineda::fast {

/// Does setup fit 64-bit lanes? A design with blocks (has_blocks()) and: Newton's iteration in at most 32
/// bits, depths of at most 32 bits, and gradients as for word planes.
bool has_setup_lanes(const spec::Contract& contract);

/// What all triangles of a frame share.
struct SetupLanes {
  int subpixel_bits, tile_log2;
  int clip_x0, clip_y0, clip_x1, clip_y1;  // exclusive at the right and the bottom
  bool culls_positive, culls_negative;     // doubled areas
  bool flat_shading;
  bool has_depth, has_planes;
  int channels, attributes;
  // Reciprocal
  int working_bits, index_bits, steps, mantissa_bits;
  std::vector<int64_t> guesses;  // by the top index_bits of m, the first of which is 1
  // Planes
  int gradient_fraction_bits, depth_plane_bits;
  int depth_shift, attribute_shift;  // of a gradient, for an area of no bits

  SetupLanes(const spec::Contract& contract, const spec::FrameState& frame);
};

/// Sets up the first `count` triangles of a group. Adds those of `counted`, a bit each, to *drops by their
/// cause; what is drawn has one, too.
///
/// Bits     those of core::setup().
void set_up(const SetupLanes& lanes, const TriangleGroup& triangles, size_t count, uint32_t counted,
            PrimGroup* prims, std::array<uint64_t, core::kDropCauses>* drops);

}  // namespace pineda::fast
