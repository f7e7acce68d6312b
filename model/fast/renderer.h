// A whole frame, or some rows of its tiles, drawn quickly.
#pragma once

#include <optional>

#include "model/core/frame.h"
#include "model/fast/blocks.h"
#include "model/fast/setup.h"
#include "model/fast/small_prims.h"
#include "model/fast/tile_shader.h"
#include "model/fast/triangle_list.h"

namespace pineda::fast {

/// Draws triangles, or the part of them that lies in some rows of tiles.
///
/// Bits     those of core::Renderer, and its counters; no hits unless they are wanted. Where codes are
///          narrow (has_blocks()) blocks are drawn; else tiles, as the timing model does. A design
///          without a reciprocal has no planes: core draws it.
class Renderer {
 public:
  enum class Hits : uint8_t { kUncounted, kCounted };

  Renderer(const spec::Contract& contract, const spec::FrameState& frame, core::TileRows rows = {},
           Hits hits = Hits::kCounted);

  const spec::Contract& contract() const { return contract_; }
  const spec::FrameState& frame() const { return frame_; }
  core::FrameCounters counters() const;
  /// The memories after the triangles so far.
  core::FrameBuffer buffer() const;
  /// Copies this renderer's rows of tiles to a buffer of the whole frame.
  void copy_rows(core::FrameBuffer* to) const;

  void clear();
  core::Drop draw(const spec::Triangle& triangle);
  /// Not `counted`: the triangles are in no count, though their tiles, stamps and samples are.
  void draw(const spec::Triangle* triangles, size_t count, bool counted = true);
  void draw(const TriangleList& list);

 private:
  // What draws blocks.
  struct Blocks {
    BlockState state;
    std::optional<SetupLanes> lanes;  // or else triangles are set up one by one
    BlockBuffer buffer;
    BlockCounts counts;
    TriangleGroup triangles;
    // One is set up and covered, then the one before it is drawn: meanwhile the memories' lines arrive.
    struct Group {
      PrimGroup prims;
      SmallPrims small;
    };
    std::array<Group, 2> groups;
    size_t current = 0;

    PrimGroup* prims() { return &groups[current].prims; }
  };
  core::Drop set_up(const spec::Triangle& triangle);
  void draw_group(const TriangleGroup& triangles, size_t count, uint32_t counted);
  void draw_prims();
  void draw_last_prims();
  void draw_tiles();
  core::Drop draw_exactly(const spec::Triangle& triangle);

  spec::Contract contract_;
  spec::FrameState frame_;
  core::TileRows rows_;
  std::optional<Blocks> blocks_;
  TiledBuffer buffer_;  // empty if there are blocks
  core::FrameCounters counters_;
  spec::SetupPrim prim_;
  TileCoverWalk tiles_;
  TileCover cover_;
  StampCounts covered_;  // of one triangle
  TileShader shader_;
  StampCounts passed_;  // shader_.counts() before the triangle
  bool counts_hits_;
};

}  // namespace pineda::fast
