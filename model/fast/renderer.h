// A whole frame, or some rows of its tiles, drawn quickly.
#pragma once

#include <optional>

#include "model/core/frame.h"
#include "model/fast/setup.h"
#include "model/fast/tile_shader.h"

namespace pineda::fast {

/// Draws triangles one by one, or the part of them that lies in some rows of tiles.
///
/// Bits     those of core::Renderer, and its counters. A design without a reciprocal has no planes:
///          core draws it.
class Renderer {
 public:
  Renderer(const spec::Contract& contract, const spec::FrameState& frame, core::TileRows rows = {});

  const spec::Contract& contract() const { return contract_; }
  const spec::FrameState& frame() const { return frame_; }
  const core::FrameCounters& counters() const { return counters_; }
  /// The memories after the triangles so far.
  core::FrameBuffer buffer() const;
  /// Copies this renderer's rows of tiles to a buffer of the whole frame.
  void copy_rows(core::FrameBuffer* to) const;

  void clear();
  core::Drop draw(const spec::Triangle& triangle);

 private:
  core::Drop draw_exactly(const spec::Triangle& triangle);

  spec::Contract contract_;
  spec::FrameState frame_;
  core::TileRows rows_;
  TiledBuffer buffer_;
  core::FrameCounters counters_;
  spec::SetupPrim prim_;
  TileCoverWalk tiles_;
  TileCover cover_;
  StampCounts covered_;  // of one triangle
  TileShader shader_;
  StampCounts passed_;  // shader_.counts() before the triangle
};

}  // namespace pineda::fast
