// Triangles that are set up, drawn block by block: the quick way for designs whose codes are narrow.
#pragma once

#include "model/core/interp.h"
#include "model/fast/block_buffer.h"
#include "model/fast/highway_targets.h"
#include "model/fast/prim_group.h"

namespace pineda::fast {

/// Can a design's frames be drawn in blocks? Depths in 32-bit lanes and attributes in 16-bit lanes,
/// modulo their range: a value at a covered sample is in the range of its code, give or take the
/// error before its rounding, which must be below half a code (spec::error_bounds_before_rounding());
/// so rounded it is in the range, and neither wraps nor is clamped.
bool has_blocks(const spec::Contract& contract);
/// Can this frame? Not with a depth bias, which may take a value out of its range.
bool has_blocks(const spec::Contract& contract, const spec::FrameState& frame);

struct SmallPrims;

/// What the blocks of a frame are drawn with; the same for all triangles.
struct BlockState {
  core::TileRows rows;
  int tile_log2;
  int stamp_width_log2, stamp_height_log2;
  bool tests_depth, writes_depth, counts_hits;
  core::PassesWhen when;
  bool hides;  // a depth behind all that a block stores cannot pass: LESS and LEQUAL
  int channels;
  int depth_bits;
  // Planes: bits of the whole plane, fraction bits that a tile drops and that it keeps.
  int depth_plane_bits, dropped_bits, fraction_bits;

  BlockState(const spec::Contract& contract, const spec::FrameState& frame, core::TileRows wanted,
             bool with_hits);
};

/// Tiles, stamps and samples of the triangles drawn; as in core::FrameCounters.
struct BlockCounts {
  uint64_t tiles_tested = 0, tiles_rejected = 0, tiles_accepted = 0;
  uint64_t stamps = 0, fragments = 0, interpolated = 0, passed = 0;
};

/// Draws the triangles of a group that are not dropped, in order; those that are small as they are
/// covered already. Bits: those of core::Renderer.
void draw_blocks(const BlockState& state, const PrimGroup& group, const SmallPrims& small,
                 BlockBuffer* buffer, BlockCounts* counts);

}  // namespace pineda::fast
